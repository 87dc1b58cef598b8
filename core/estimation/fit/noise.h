// SPDX-License-Identifier: Apache-2.0
// The noise of one coordinate, from what no motion of the body can explain.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

struct NoiseEstimate {
  double sigma = 0;           // px or m, of one coordinate
  double error = 0;           // its own standard deviation
  int degrees = 0;            // of freedom
  bool from_repeats = false;  // of poses that were measured again: how well the robot repeats is part of it
};

/// The robot-free estimate: in every observation the body may move freely (its six small motions are projected out),
/// and what is left is regressed on the marker positions and, in a stereo session, on the small errors of the cameras
/// that every observation shares (rig 6, fx fy cx cy k1 k2 p1 p2 of both). Unbiased whatever the robot does. Nothing
/// with fewer than 10 degrees of freedom, as in sessions of one or two markers.
std::optional<NoiseEstimate> estimate_noise(const Problem& problem, const Unknowns& unknowns);

/// For sessions in which that says nothing: how far the residuals of one marker differ between observations whose
/// joints all stand within 5e-3 rad (m) of each other. What follows the pose cancels; how well the robot repeats does
/// not. Nothing with fewer than 10 degrees of freedom.
std::optional<NoiseEstimate> noise_from_repeats(const Problem& problem, const Unknowns& unknowns);

/// Residual squares beside what noise alone leaves of them: chi2, in units of its variance, of so many degrees of
/// freedom, and the probability of that many or more.
struct NoiseTest {
  double chi2 = 0, degrees = 0, p = 1;
  double excess() const { return chi2 - degrees; }
};

/// The probability that noise leaves `chi2` or more of so many degrees of freedom, at least one.
double chi_squared_tail(double chi2, double degrees);

/// `squares` in units of the noise's variance. `estimated`: the degrees of freedom from which the noise was estimated
/// where that was part of these same residuals, 0 where it was not; what they leave over is then compared with it
/// (Fisher's F), for chi2 and degrees are of the rest. Nothing where no degree of freedom is left.
std::optional<NoiseTest> noise_test(double squares, double degrees, double estimated);

}  // namespace handsight
