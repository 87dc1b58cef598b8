// SPDX-License-Identifier: Apache-2.0
// Postures at static equilibrium one after another, as a fit asks for them by the hundred thousand: in memory that
// serves them all, and along secants.
#pragma once

#include <optional>

#include "robot/posture.h"

namespace handsight {

/// Takes the passes of an equilibrium on along the secant of the last two, as far as the two together say that it is,
/// where they close in on it: what does not close in fast may have no equilibrium to go to.
class EquilibriumSecant {
 public:
  void begin() { step_ = 0; }

  /// A pass has led from `now` to `next`, by `step` (rad, m) at most: leads `next` on.
  void lead_on(const Deflection& now, Deflection& next, double step);

 private:
  double step_ = 0;                              // of the pass before; 0: there was none
  Eigen::VectorXd to_, by_, last_to_, last_by_;  // where the passes led, and by how much
};

/// What serves posture after posture of a robot. The robot must not change meanwhile.
class PostureMemory {
 public:
  /// solve_posture(), to its tolerance; the answer is here until the next is asked for.
  const Posture& solve(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChange& change,
                       const Vector3& gravity, bool with_loads = true, const Deflection* start = nullptr);

 private:
  void place_joints(const Robot& robot, const RobotChange& change);
  void clear(const Robot& robot);

  const Robot* robot_ = nullptr;
  std::optional<posture_detail::Passes<double>> passes_;
  std::vector<Vector6> frame_, after_;  // the joints' changes that stand in passes_
  EquilibriumSecant secant_;
  Posture posture_;
};

}  // namespace handsight
