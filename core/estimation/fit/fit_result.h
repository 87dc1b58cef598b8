// SPDX-License-Identifier: Apache-2.0
// What a fit finds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "chain/body_frame.h"
#include "estimation/fit/fit_options.h"
#include "estimation/fit/noise.h"
#include "estimation/solvers/least_squares.h"

namespace handsight {

/// How the covariances were made.
enum class CovarianceKind {
  noise,          // from the noise of one coordinate: right where the model agrees with the measurements
  repeatability,  // from how the observations differ (clustered by observation): the model does not fit, p < 1e-3
};

/// An effect of the model after a fit.
struct FittedEffect {
  EffectTerm term;
  std::vector<double> sigmas;  // per parameter; 0 where it was held
};

struct Fit {
  Problem problem;  // at the solution
  Solution solution;
  Objective objective = Objective::image;
  bool fixed_markers = false;
  BodySides sides;
  Rigid tcp_from_body;
  Matrix6 covariance = Matrix6::Zero();  // of xi in exp(xi) tcp_from_body
  bool rotation_is_observed = true;      // false with one or two markers: the rest is left at its start
  std::vector<FittedEffect> effects;     // held ones first
  std::vector<Vector3> markers_in_body;  // m; not meaningful for markers never seen (Problem::marker_is_seen)
  Eigen::MatrixXd parameter_covariance;  // problem columns
  Eigen::MatrixXd model_covariance =
      Matrix6::Zero();               // 6 + n: xi, then every number of `effects` in their order; held ones are 0
  Eigen::MatrixXd shape_covariance;  // of the held markers' shape, problem columns; empty where markers are free
  CovarianceKind covariance_kind = CovarianceKind::noise;
  double residual_rms = 0;      // px or m, of one coordinate
  int rows = 0;                 // coordinates
  int unknowns = 0;             // that the measurements determine: what a prior holds does not count (tr H_data H^-1)
  double loss_noise = 1;        // px or m: what the bend of a robust loss was measured in
  std::optional<double> noise;  // of one coordinate: declared, else estimated
  std::optional<NoiseEstimate> noise_estimate;
  std::optional<double> chi2_per_dof;
  double angle_axis_sigma_m = 0, angle_axis_sigma_rad = 0;  // the weights of the angle-axis objective
  int sightings_left_out = 0;                               // seen by one camera only, where the objective needs points
  std::vector<Message> notes;                               // a sentence each

  bool converged() const { return solution.converged; }
};

/// The effects of a fit with their values.
std::vector<EffectTerm> list_terms(const Fit& fit);

/// The markers in the TCP frame and the mount that this fit found.
inline const Unknowns& estimate(const Fit& f) { return f.solution.unknowns; }

}  // namespace handsight
