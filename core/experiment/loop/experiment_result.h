// SPDX-License-Identifier: Apache-2.0
// What is asked of an experiment, and what became of it.
#pragma once

#include "base/message.h"
#include "experiment/loop/choice.h"
#include "experiment/loop/goals.h"

namespace handsight {

/// A pose with the way to it.
struct PlannedMove {
  ChosenPose pose;
  std::vector<Eigen::VectorXd> way;  // the points after where the robot stands before it; the last is the pose
  double length = 0;                 // rad (m), of the fastest joint
};

/// What became of one pose.
struct ExperimentStep {
  std::int64_t id = -1;  // of the observation; -1: none was made
  PlannedMove move;
  bool reached = false, accepted = false;
  Message reason;                         // why it was not reached or not accepted
  std::optional<double> hand_limit, rms;  // m; px or m: after it
};

enum class ExperimentEnd { reached, count, time, no_more_poses, interrupted, not_confirmed, fault, dry_run };
const char* end_name(ExperimentEnd end);

struct ExperimentOptions {
  Goals until;
  ExperimentModel model;
  std::optional<CompetingEffects> between;  // asked for by the user, in place of what the diagnosis finds
  Cell cell;
  std::optional<WorkBox> box;
  double speed = 0.2;  // rad/s (m/s) of the fastest joint; the first move takes a tenth of it
  std::uint64_t seed = 1;
  std::vector<Eigen::VectorXd> given;  // these poses and no others; nothing is chosen, fitted or diagnosed then
  int batch = 5;                       // poses that are chosen at once; then it is diagnosed
  bool dry_run = false;                // nothing moves
  bool save = true;                    // the session is written after each look
  bool fit_each_look = false;          // on_knowledge after each accepted observation, what was diagnosed last with it
  /// Asked once, before anything moves, with what is to come. Empty: yes.
  std::function<bool(const std::vector<PlannedMove>&)> confirm;
  std::function<void(const std::vector<PlannedMove>&)> on_plan;
  std::function<void(const ExperimentStep&)> on_step;
  std::function<void(const Session&, const Observation&)> on_observation;  // once it is decided and kept
  std::function<void(const Knowledge&)> on_knowledge;
  std::function<void(const Message&)> on_note;
  std::function<bool()> is_interrupted;
};

struct ExperimentResult {
  Session session;  // with what was measured
  ExperimentEnd end = ExperimentEnd::reached;
  Message reason;  // a sentence: why it ended
  Message more;    // a sentence: what more poses would bring; empty where that is not known
  int moves = 0, observations = 0, accepted = 0;
  std::vector<ExperimentStep> steps;
  std::vector<PlannedMove> planned;  // of a dry run
  Knowledge known;
  std::optional<SettledCause> settled;  // the cause that the odds asked for are for
  double seconds_a_pose = 0;
  double longest_choice = 0;  // s, of the choices of poses, a pose
};

}  // namespace handsight
