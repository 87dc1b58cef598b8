// SPDX-License-Identifier: Apache-2.0
// Postures at static equilibrium one after another, as a fit asks for them by the hundred thousand: in memory that
// serves them all, and with passes that learn from those before.
#pragma once

#include <optional>

#include "robot/posture.h"

namespace handsight {

/// Mixes the last passes of an equilibrium so that they close in on it (Anderson 1965; Walker and Ni 2011), also where
/// play throws the plain ones to and fro; but not where they lead away from where they are: what springs that are too
/// soft are in balance at they do not hold.
class EquilibriumMixing {
 public:
  void begin() { count_ = 0; }

  /// A pass has led from `now` to `next`: leads `next` on.
  void lead_on(const Deflection& now, Deflection& next);

 private:
  static constexpr int most = 4;  // passes that are mixed
  using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;

  Eigen::VectorXd to_, by_, new_to_, new_by_;  // where the last pass led, and by how much
  Eigen::MatrixXd by_to_, by_by_;              // what these differed by from one pass to the next, in columns
  int count_ = 0;                              // passes since it began, or they led away
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
  EquilibriumMixing mixing_;
  Posture posture_;
};

/// One posture by itself, as PostureMemory::solve() finds it: of some robots with play solve_posture() does not.
Posture solve_equilibrium(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChange& change,
                          const Vector3& gravity, bool with_loads = true);

}  // namespace handsight
