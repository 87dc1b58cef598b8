// SPDX-License-Identifier: Apache-2.0
// How well a fitted position is known, and the last small step to it: with unknowns that hardly any corner needs but
// some images have (light that is added, edges that the lens bends), and with noise that is not white.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vision/corners/corner_habits.h"

namespace handsight {

/// A few pixels tell their noise badly: how many times as large the variance is that so many pixels (`weights`) tell,
/// once it is weighed against what the image's corners tell together.
double pooling(double variance, double weights, double of_image);

/// Whether light is plainly added, or an edge plainly bent.
bool is_plain(const OddSystem& system);

struct LastStep {
  bool is_needed = false;                          // by this corner or by all together: otherwise the move is chance
  Eigen::Vector2d move = Eigen::Vector2d::Zero();  // px
  Eigen::Matrix2d covariance;                      // px^2, after the move if it is needed, without it if not
};
/// Nothing where the system is singular.
std::optional<LastStep> last_step(const OddSystem& system, const Habits& habits);

}  // namespace handsight
