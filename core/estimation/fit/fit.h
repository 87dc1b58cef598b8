// SPDX-License-Identifier: Apache-2.0
// The fit: TCP->Body, markers and mount from the labelled observations, by one of the thesis's three objectives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chain/body_frame.h"
#include "estimation/fit/noise.h"
#include "estimation/solvers/least_squares.h"
#include "session/session.h"

namespace handsight {

enum class Objective {
  image,       // thesis (4.42): px in the images (m in a tracker session)
  camera,      // thesis (4.41): m in the first camera's frame, triangulated markers
  angle_axis,  // thesis (4.39-4.40): body pose of each observation; m and rad weighed by their sigmas
};

struct FitOptions {
  Objective objective = Objective::image;
  bool fix_markers = false;  // hold the body's shape at the average of the observations (thesis 4.19-4.23)
  Loss loss = Loss::none;
  std::vector<EffectTerm> effects;    // in the model, held at these values
  std::vector<EffectTerm> estimated;  // in the model, estimated with their plausible sizes as priors; from here
  std::shared_ptr<const CameraKnowledge> camera_images;  // of the session's rig; counts with the cameras' effects
  std::optional<BodySides> sides;                        // decided earlier; absent: decided by this fit's estimate
  std::optional<Rigid> start_tcp_from_body;  // what the session cannot observe of the rotation is taken from here
  std::optional<Unknowns> start;  // markers and mount of a fit before, near the answer; absent: in closed form
  int most_iterations = 100;
  double smallest_step = 1e-12;  // SolveOptions::smallest_step
  double least_gain = 0;         // SolveOptions::least_gain
  double reuse_below = 0;        // SolveOptions::reuse_below
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

/// How the covariances were made.
enum class CovarianceKind {
  noise,    // from the noise of one coordinate: right where the model agrees with the measurements
  scatter,  // from how the observations differ (clustered by observation): the model does not fit, p < 1e-3
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
  std::vector<std::string> notes;                           // a sentence each

  bool converged() const { return solution.converged; }
};

/// Throws InputError where nothing can be fitted: no used observation, or an unknown mount that nothing determines.
Fit fit(const Session& session, const FitOptions& options = {});

/// The effects of a fit with their values.
std::vector<EffectTerm> terms_of(const Fit& fit);

/// The markers in the TCP frame and the mount that this fit found.
inline const Unknowns& estimate(const Fit& f) { return f.solution.unknowns; }

}  // namespace handsight
