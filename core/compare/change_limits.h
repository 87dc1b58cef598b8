// SPDX-License-Identifier: Apache-2.0
// From when on a change counts, and how far its fits go; for two sessions and for several alike.
#pragma once

namespace handsight {

inline constexpr double ln_20 = 2.995732273553991;
/// Plausible sizes that a change is held at while it is fitted and while its size is reported.
inline constexpr double change_scale = 3;
inline constexpr double change_weight = 1 / (change_scale * change_scale);  // what a change's square costs
inline constexpr double free_change_scale = 1e6;
/// Chi-squared of a prior sigma below which a change cannot be seen at all.
inline constexpr double least_visible_change = 1e-2;
inline constexpr int most_change_iterations = 8, most_change_iterations_wide = 3;
inline constexpr double least_change_gain = 1e-4,
                        least_change_gain_wide = 1e-1;  // of chi-squared, of one more iteration
inline constexpr int learning_rounds = 3, learning_steps = 4;
/// Probability of what is left below which the model is made wider, and below which it is said to miss.
inline constexpr double in_model_uncertainty = 0.05, model_misses = 1e-3;

}  // namespace handsight
