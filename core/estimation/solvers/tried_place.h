// SPDX-License-Identifier: Apache-2.0
// The problem at the unknowns that Ceres tries.
#pragma once

#include <ceres/ceres.h>

#include <vector>

#include "estimation/problem/problem.h"
#include "estimation/solvers/least_squares.h"
#include "estimation/solvers/motion_manifold.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {

/// All sightings and priors read their places from here.
class TriedPlace : public ceres::EvaluationCallback {
 public:
  TriedPlace(const Problem& original, const Unknowns& start, const SolveOptions& options)
      : problem(original),
        unknowns(start),
        is_fixed_body(options.fixed_body),
        body(list_numbers(Rigid{})),
        effects(start.effects.size()),
        start_(start) {
    for (Eigen::Index i = 0; i < effects.size(); ++i) effects[i] = start.effects[i] / sigma(i);
    for (int i = 0; i < problem.mount_count(); ++i) mounts.push_back(list_numbers(start.mount(i)));
    mount_steps_by_numbers.resize(mounts.size());
    motions.resize(problem.observations.size());
    sensor_from_tcp.resize(problem.observations.size());
  }

  double sigma(Eigen::Index effect) const {
    return problem.columns_of_effects[static_cast<std::size_t>(effect)].prior_sigma();
  }

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_point) override {
    read();
    const bool lacks = evaluate_jacobians && !derives_;
    if (!new_point && !lacks) return;
    if (problem.effect_count() > 0) place_effects(evaluate_jacobians);
    derives_ = evaluate_jacobians;
    for (std::size_t k = 0; k < problem.observations.size(); ++k) {
      const ProblemObservation& o = problem.observations[k];
      sensor_from_tcp[k] = sensor_from_tcp_at(o, unknowns);
      if (evaluate_jacobians) motions[k] = motion_by_columns(problem, o, unknowns);
    }
    if (!evaluate_jacobians) return;
    for (std::size_t i = 0; i < mounts.size(); ++i)
      if (is_free(i)) mount_steps_by_numbers[i] = mount_manifold.step_by_numbers(mounts[i].data());
    if (is_fixed_body) body_step_by_numbers = body_manifold.step_by_numbers(body.data());
  }

  /// The unknowns of Ceres' numbers.
  void read() {
    for (Eigen::Index i = 0; i < effects.size(); ++i) unknowns.effects[i] = effects[i] * sigma(i);
    for (std::size_t i = 0; i < mounts.size(); ++i)
      if (is_free(i)) unknowns.mount(static_cast<int>(i)) = make_motion(mounts[i].data());
    if (!is_fixed_body) return;
    for (std::size_t m = 0; m < unknowns.markers_in_tcp.size(); ++m)
      unknowns.markers_in_tcp[m] = make_motion(body.data()) * start_.markers_in_tcp[m];
  }

  bool is_free(std::size_t mount) const { return problem.column_of_mount(static_cast<int>(mount)) >= 0; }
  std::size_t mount_at(std::size_t observation) const {
    return static_cast<std::size_t>(problem.observations[observation].mount);
  }

  Problem problem;
  Unknowns unknowns;  // its markers are Ceres' own where the body is not held
  bool is_fixed_body;
  MotionNumbers body;
  std::vector<MotionNumbers> mounts;
  Eigen::VectorXd effects;  // in prior sigmas
  MotionManifold mount_manifold{false}, body_manifold{true};
  Eigen::Matrix<double, 6, 12> body_step_by_numbers;
  std::vector<Eigen::Matrix<double, 6, 12>> mount_steps_by_numbers;
  std::vector<Rigid> sensor_from_tcp;
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> motions;  // motion_by_columns

 private:
  void place_effects(bool derives) {
    if (derives)
      set_effects(problem, unknowns.effects);
    else
      follow_effects(problem, unknowns.effects);
  }
  Unknowns start_;
  bool derives_ = false;
};

}  // namespace handsight
