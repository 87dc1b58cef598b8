// SPDX-License-Identifier: Apache-2.0
// What a ChangeWatch has gathered. Internal to change_watch.
#pragma once

#include <Eigen/Cholesky>
#include <deque>
#include <optional>

#include "compare/change_candidates.h"
#include "compare/pose_sums.h"
#include "compare/watch_rounds.h"
#include "compare/watch_step.h"
#include "correct/calibrated_robot.h"

namespace handsight {

struct WatchedPose {
  Eigen::VectorXd position;
  Matrix6 repeatability = Matrix6::Zero();
  PoseSums unchanged;                  // all its observations as if nothing had changed
  PoseSums changed;                    // ... as if all were made after the change
  Normal without_change, with_change;  // what is left of both without the pose
};

struct Recent {
  std::size_t pose = 0, number = 0;
  double ln_weight = 0;  // of a change that comes just before it
  PoseSums sums;
  Normal of_pose;  // what its pose says of such a change
};

struct WatchParts {
  CalibratedRobot before;
  WatchOptions options;
  std::vector<WatchedPose> poses;
  std::deque<Recent> recent;
  Normal without_change, from_first;  // of all poses: no change, one before the very first observation
  std::size_t count = 0;
  Rounds rounds;
  double ln_first_weight = 0;  // of a change before the very first observation
  bool has_changed = false;
  // Of the problem, the same for all observations.
  Eigen::Index base = 0;
  Eigen::MatrixXd known;
  std::vector<ChangeUnit> units;
  std::vector<Eigen::Index> first_of_unit;
  std::vector<std::string> groups;         // of units, in their order by name
  std::vector<std::size_t> group_of_unit;  // into them
  Eigen::VectorXd sizes;                   // plausible, of the changes' columns
  std::optional<Chain> chain;
  double coordinate = 0;  // variance of what a coordinate is off by at every visit of a pose, in units of the noise

  /// What is said of the unknowns that changes share with all before them; the same wherever a change begins.
  struct Shared {
    Eigen::LLT<Eigen::MatrixXd> information;
    Eigen::VectorXd gradient;  // L^-1 of it
  };

  /// One start of the change: what each unit's evidence is from there on.
  struct Start {
    double ln_weight = 0;
    std::vector<Eigen::MatrixXd> information;  // by unit, of its own numbers, the shared unknowns taken out
    Eigen::VectorXd gradient;                  // of all changes, likewise
    std::vector<double> evidence;              // by unit
    double ln_e_value = 0;
  };

  PoseSums sums_of(const Session& session, const Observation& observation, Matrix6& repeatability);
  std::size_t locate(const Eigen::VectorXd& position, const Matrix6& repeatability);
  void keep(Recent observation);
  Start start_at(double ln_weight, const Normal& normal, const Shared& shared) const;
  std::vector<Start> starts() const;
  static double ln_e_value(const std::vector<Start>& starts);
  std::vector<double> by_group(const std::vector<double>& evidence) const;
  double mixture(const std::vector<double>& evidence) const;
  WatchedChange measure_size(std::size_t unit, const Start& start) const;
  WatchStep reported(const std::vector<Start>& starts) const;
};

}  // namespace handsight
