// SPDX-License-Identifier: Apache-2.0
// Proof plots: component plus residual of each number of an effect, against what it follows. A number acts at a scalar
// site of the chain; with s_i the coordinates of observation i by that site, r_i what the model with the effect leaves
// and c_i what the effect moves there, e_i = c_i + s_i.r_i / s_i.s_i, known to noise / |s_i|: what this observation
// alone says of the site, the share of everything else taken out. The points lie along c, and the slope of e by c's
// share of each number is that number as it was estimated.
#pragma once

#include "base/message.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "effects/effect.h"
#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

struct ProofPoint {
  int index = 0;          // into Session::observations
  std::int64_t id = 0;    // of the observation
  double x = 0;           // of ProofPlot::against
  double y = 0;           // component plus residual; y - curve is what is left after the addition
  double sigma = 0;       // of y, of the noise alone
  double curve = 0;       // the component: sum of numbers times shares
  Eigen::VectorXd share;  // of the component by each number: per unit of it
};

/// One number of the effect.
struct ProofNumber {
  std::size_t term = 0, parameter = 0;  // into the terms given
  std::string name, unit;
  double value = 0, sigma = 0;  // as estimated
  double slope = 0;             // of the points: of y by the share, weighed by sigma; differs by the prior's pull alone
};

/// One scalar site: what the numbers of one term do there.
struct ProofPlot {
  std::string of;            // the joint, the marker, "" for the session
  Message quantity;          // of y: "error of arm_2"; a number of its own where no site is scalar
  std::string unit;          // of y: rad
  Message against;           // of x: "gravity torque at arm_2"
  std::string against_unit;  // of x: N m
  std::vector<ProofNumber> numbers;
  std::vector<ProofPoint> points;  // in order of time
  int left_out = 0;                // observations that say nothing of it
  double noise = 0;                // the median of the points' sigmas
  double largest_x = 0;            // the largest |x|
  double largest = 0;              // the largest |curve|
  double hand_m = 0;               // how far that moves the markers' middle, at most
  double strength = 0;             // the component's squares over the noise
};

/// Of effects that this fit estimates, by what it leaves: the strongest plot first. `terms` must be terms of the fit.
std::vector<ProofPlot> make_proof(const Session& session, const Fit& fit, const std::vector<EffectTerm>& terms);

/// Of a candidate: by its full fit where there was one, else linear. Empty where the candidate has no terms.
std::vector<ProofPlot> make_proof(const Diagnosis& diagnosis, const DiagnosisCandidate& candidate);

/// How well the points follow the curve: the share of their squares (in units of their sigmas) that it takes away, 0 to
/// 1. Noise alone takes none; a cause that is wrong leaves most of them where they are.
double followed(const ProofPlot& plot);
inline constexpr double least_followed = 0.5;  // from here on one sees it

/// "arm_2 gives way by 150 +- 0.6 urad for each N m: 12 N m at most here, so 1.8 mrad, 1.4 mm at the hand."
std::string proof_text(const ProofPlot& plot);

/// Lines of a CSV with a head: candidate, of, quantity, unit, against, unit, observation, x, y, sigma, curve, left.
std::string proof_csv_head();
std::string proof_csv_lines(const std::string& candidate, const ProofPlot& plot);

}  // namespace handsight
