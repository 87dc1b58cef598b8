// SPDX-License-Identifier: Apache-2.0
// Which poses are measured next, and how the robot comes there.
#pragma once

#include <functional>

#include "experiment/loop/knowledge.h"
#include "experiment/paths/joint_paths.h"

namespace handsight {

enum class PoseReason { spread, near_seen, precision, cause, between, region, repeat };
/// "to settle the estimate", for people.
const char* reason_text(PoseReason reason);
/// "precision", for programs.
const char* reason_name(PoseReason reason);

struct ChosenPose {
  Eigen::VectorXd position;  // rad (m), in the order of the session's joints
  PoseReason reason = PoseReason::spread;
  int fixture = -1;          // that is touched from there, into Session::fixtures; -1: the pose is looked from
  Eigen::VectorXd touching;  // rad (m): where the tip is expected to touch it
};

/// Where an experiment may go: the robot, what stands about it, what was tried in vain.
struct Reach {
  Chain chain;
  CollisionWorld world;
  JointRanges ranges;
  std::vector<Eigen::VectorXd> refused;  // could not be reached, or showed nothing
  std::optional<WorkBox> box;            // where the hand is wanted to be known
};

/// Free of collisions, within the ranges, and not near what was tried in vain.
bool can_be_taken(const Reach& reach, const Eigen::VectorXd& position);

/// Does the sensor see the target there: turned away by less than 60 degrees, in one image at least with a margin, and
/// nothing between? Of a tracker or a sensor of poses only what stands between counts.
bool is_well_seen(const Reach& reach, const Fit& fit, const Eigen::VectorXd& position);

struct ChoiceOptions {
  int count = 5;
  bool with_repeat = false;
  bool for_cause = false;  // what is missing is asked for, and not known yet
  int in_vain = 0;         // in a row: moves that brought nothing, or one less than poses that no way leads to
  std::uint64_t seed = 1;
};

/// Up to `count` poses. From two in vain on: small steps from where the target was seen, the smaller the more were in
/// vain, for where it sits is not known as well as it seems, or no way leads farther. Without a fit poses are spread
/// about where the target was seen, or where the robot stands (`from`). With one, for_cause: those that say most about
/// what is missing (plan_for_causes). Otherwise, with fewer than six observations spread over what can be seen, later
/// for the two causes that cannot be distinguished, the rest for the precision of the model with what is likely. Of
/// four and more one is in a region not yet seen, of three and more one is repeated for the scatter where that is asked
/// for. Fewer, or none, where there are no more.
std::vector<ChosenPose> choose_poses(const Session& session, const ExperimentModel& model, const Knowledge& known,
                                     const Reach& reach, const Eigen::VectorXd& from, const ChoiceOptions& options);

/// Poses over what can be reached and seen, to ask the hand's limit at: within the box where there is one.
std::vector<Eigen::VectorXd> poses_to_judge_by(const Session& session, const Fit& fit, const Reach& reach, int count,
                                               std::uint64_t seed);

}  // namespace handsight
