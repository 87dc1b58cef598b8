// SPDX-License-Identifier: Apache-2.0
// Poses that a robot could take next: within all joint limits, the markers in front of the cameras.
#pragma once

#include <random>

#include "estimation/fit/fit.h"

namespace handsight {

/// Uniform in [0, 1), the same on every platform.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// Says of a pose whether it can be taken and measured. What shows the markers well (how far away, how far turned) is
/// learned from the observations that were taken. Obstacles, collisions and hidden lines of sight are not known.
class PoseJudge {
 public:
  /// `fit` is of that session and lives as long.
  PoseJudge(const Session& session, const Fit& fit);

  /// 0 where the pose is within the limits (those of joints that follow others too) and the cameras (of more than two
  /// any two) see every marker; else how far from that it is, in rough units of a radian. Springs are left out.
  double violation(const Eigen::VectorXd& position) const;

  /// Do the cameras see a body that sits there, does a sensor of poses by what it has seen? Always true before a
  /// tracker.
  bool is_shown(const Rigid& sensor_from_tcp) const { return unseen(sensor_from_tcp) == 0; }

  /// What every joint may take (rad, m), in the order of the session: limits less a margin; of a joint without limits
  /// a turn about what was taken (a sliding one: what was taken).
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  bool has_range(Eigen::Index joint) const { return upper_[joint] > lower_[joint]; }

 private:
  void set_limits(const Session& session);
  void learn_what_shows();
  /// Of a sensor of poses, whose image is not known: where it looks, by what it has seen.
  void learn_sight();
  double unseen_by_poses(const Rigid& sensor_from_tcp) const;
  double unseen(const Rigid& sensor_from_tcp) const;
  double unseen_by(const Camera& camera, const Vector3& x, const Vector3& normal, const Vector3& middle) const;

  const Fit& fit_;
  Chain rigid_;  // the chain without springs: millimetres do not decide what is seen
  std::vector<Vector3> markers_;
  Vector3 middle_ = Vector3::Zero();       // of the markers, TCP frame
  std::optional<Vector3> facing_;          // TCP frame: where the markers look; absent: all around
  double most_turned_ = 0.9;               // rad, between `facing_` and the way to a camera
  double nearest_ = 0.3, farthest_ = 1.6;  // m from the camera
  std::optional<Vector3> sight_;           // sensor frame: where a sensor of poses looks; absent: all around
  double widest_ = 0.5;                    // rad, between `sight_` and what it sees
  Eigen::VectorXd lower_, upper_;
};

/// Up to `count` poses spread over what the robot can reach and the cameras can see, by random walks from the poses
/// that were taken and from anywhere; the same for the same seed. InputError where none is found.
std::vector<Eigen::VectorXd> pose_pool(const Session& session, const PoseJudge& judge, int count, std::uint64_t seed);

}  // namespace handsight
