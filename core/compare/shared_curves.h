// SPDX-License-Identifier: Apache-2.0
// What no effect describes and both sides of a comparison share: smooth functions of the joints' angles that turn the
// joint itself or shift the hand. Internal to comparison.cpp.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// sin and cos of one joint's angle at these frequencies, each with a number of its own: two columns a frequency.
struct SharedCurve {
  std::size_t joint = 0;            // into Chain::joints
  int axis = -1;                    // of the TCP frame along which the hand shifts; -1: the joint's own angle turns
  double centre = 0;                // rad (m): where its waves are counted from
  std::vector<double> frequencies;  // per rad (m)
  std::vector<double> sizes;        // plausible, per frequency: m of a shift, rad (m) of an angle

  Eigen::Index columns() const { return 2 * static_cast<Eigen::Index>(frequencies.size()); }
};

/// For every joint that the observations of these problems move by more than 0.2 rad (m), up to 5 waves a rad.
std::vector<SharedCurve> shared_curves(const std::vector<const Problem*>& problems);

Eigen::Index column_count(const std::vector<SharedCurve>& curves);

/// The motion of the body against the sensor, in the sensor's frame, by the curves' columns in units of their plausible
/// sizes. The problem has EffectMotion filled.
Eigen::Matrix<double, 6, Eigen::Dynamic> motion_by_curves(const std::vector<SharedCurve>& curves,
                                                          const Problem& problem, const ProblemObservation& observation,
                                                          const Unknowns& unknowns);

}  // namespace handsight
