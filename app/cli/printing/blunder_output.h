// SPDX-License-Identifier: Apache-2.0
// Blunders for people and as JSON.
#pragma once

#include "blunders/blunders_in_files.h"
#include "blunders/find_blunders.h"
#include "blunders/fixture_distance.h"
#include "blunders/target_size.h"
#include "command.h"

namespace handsight::cli {

/// Those of a session by its fit, with a bar while they are sought; none where so little is left that there is nothing
/// to look for.
std::vector<Blunder> list_blunders(const Session& session, const Fit& fit);

/// A plain fit of at most so many observations, for who looks for mistakes before a fit was asked for; nothing where
/// nothing can be fitted.
constexpr int most_in_first_fit = 100;
std::optional<Fit> first_fit(const Session& session);

/// {of, from, by, measured, text}; null where no distance is doubtful.
Json doubtful_distance_json(const std::optional<DistanceDoubt>& doubt, const Session& session);

/// "2.1 px", "a mean of 5.1 mm": as the line "Error" of `fit` has it.
std::string error_text(bool in_pixels, double error);

/// A target of another size than described (target_size.h), which is reported in place of blunders where it leaves
/// little.
bool settles_it(const std::optional<TargetSize>& size);
void print_target_size(const Output& output, const std::optional<TargetSize>& size);
/// scale, sigma, text, fix, rms_before_pixel and rms_after_pixel (or ..._m), mean_before_m and mean_after_m; null where
/// there is none.
Json target_size_json(const std::optional<TargetSize>& size);

void print_blunders(const Output& output, const std::string& session_path, const std::vector<Blunder>& blunders);

/// A list with id, where, text, fix, rms_before_pixel and rms_after_pixel (with a tracker or poses ..._m, and
/// mean_before_m and mean_after_m), ln_bayes_factor, together_with; numbers are null of those that show without a fit.
Json blunders_json(const std::vector<Blunder>& blunders);

}  // namespace handsight::cli
