// SPDX-License-Identifier: Apache-2.0
#include "estimation/online/online_step.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

bool moved_enough(const Joint& joint, double change, const OnlineOptions& options) {
  return std::abs(change) >= (joint.kind == JointKind::prismatic ? options.new_pose_m : options.new_pose_rad);
}

}  // namespace

Message excluded_text(const Observation& observation) {
  if (observation.reason.empty()) return "excluded by the user";
  return message("excluded by the user: {}", observation.reason);
}

Message motion_refusal(const Chain& chain, const OnlineOptions& options, const Eigen::VectorXd& last,
                       const Eigen::VectorXd& position, std::int64_t last_id) {
  double largest = 0;
  for (Eigen::Index j = 0; j < position.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    const double change = position[j] - last[j];
    if (moved_enough(joint, change, options)) return {};
    if (joint.kind != JointKind::prismatic) largest = std::max(largest, std::abs(change));
  }
  return message("joints moved {:.1f} deg since observation {}; {:.0f} deg count as new", 57.29578 * largest, last_id,
                 57.29578 * options.new_pose_rad);
}

void keep_step(const OnlineStep& step, Observation& observation) {
  observation.decision = step.accepted ? Decision::accepted : Decision::rejected;
  observation.reason = step.reason;
  if (step.from_images && !step.sightings.empty()) observation.sightings = step.sightings;
}

}  // namespace handsight
