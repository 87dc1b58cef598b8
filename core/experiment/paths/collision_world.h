// SPDX-License-Identifier: Apache-2.0
// Does the robot touch itself or what stands about, and is a line of sight free? By FCL (Debian: libfcl-dev).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "chain/chain.h"
#include "experiment/paths/cell.h"
#include "experiment/paths/robot_solids.h"

namespace handsight {

inline constexpr double usual_clearance = 0.02;  // m

/// Was the program built with FCL and OMPL? Where not, a sentence that says what is needed.
std::optional<Message> what_paths_need();

/// Links that are fixed to each other are one body; neighbours by a joint are not watched against each other, nor are
/// pairs of an SRDF file, nor those that touch in nearly all postures (95 of 100 drawn ones; 10 where they are always
/// nearer than the clearance). A pair that comes nearer than the clearance in nearly all postures, or in one of those
/// that the robot has been in, is watched without clearance; one whose shapes touch where the robot has been is not
/// watched (its shapes are thicker than the robot). Without a plane in the cell the floor is one through the root's
/// origin, gravity being its normal, unless the robot has been below it.
class CollisionWorld {
 public:
  /// `taken`: postures in which the robot has been, in the order of Chain::joints. InputError where what_paths_need.
  CollisionWorld(const Chain& chain, const RobotSolids& solids, const Cell& cell,
                 const std::vector<Eigen::VectorXd>& taken, double clearance = usual_clearance);
  ~CollisionWorld();
  CollisionWorld(CollisionWorld&&) noexcept;
  CollisionWorld& operator=(CollisionWorld&&) noexcept;

  /// What stands in the way of this posture, "l3 and hand": nothing where it is free. Springs are left out.
  /// `with_clearance` false: only what really touches.
  std::optional<Message> touching(const Eigen::VectorXd& position, bool with_clearance = true) const;

  /// Does a link other than those that carry the ends, or something of the cell, stand between two points of them? The
  /// points in the frames of their links, m.
  bool is_hidden(const Eigen::VectorXd& position, const Vector3& in_mount, const Vector3& in_tcp) const;

  /// How far any point of the robot moves at most, m, by such a step of the joints.
  double farthest_way(const Eigen::VectorXd& step) const;

  /// A thing that the TCP's link carries beside its shapes: the target. It joins the link's body.
  void carry(const RobotSolid& solid);

  const std::vector<Message>& notes() const;
  std::size_t watched_pairs() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace handsight
