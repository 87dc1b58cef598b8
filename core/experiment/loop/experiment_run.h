// SPDX-License-Identifier: Apache-2.0
// The loop of an experiment, step by step. Internal to its sources.
#pragma once

#include <chrono>

#include "experiment/loop/deciding.h"
#include "experiment/loop/driven_joints.h"
#include "experiment/loop/experiment_result.h"
#include "experiment/loop/settling.h"

namespace handsight {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The experiment is over; why, as the user reads it.
struct Ended {
  ExperimentEnd end;
  Message reason;
};

/// One experiment as it runs.
class Experiment {
 public:
  Experiment(Session session, DrivenRobot& robot, const ExperimentOptions& options)
      : session_(std::move(session)),
        robot_(robot),
        options_(options),
        model_(options.model),
        settling_(options.until.odds.value_or(1)) {}

  ExperimentResult run();

 private:
  void begin();
  void meet_driver();
  void make_reach();
  void round();
  void learn(bool with_diagnosis);
  void learn_from_look();
  void check_goals();
  void check_limits() const;
  std::vector<PlannedMove> next_moves();
  void add_moves(std::vector<ChosenPose> chosen, std::vector<PlannedMove>& moves);
  void confirm(const std::vector<PlannedMove>& moves);
  void drive(const PlannedMove& move);
  void look(ExperimentStep& step, const MoveAnswer& stood);
  std::optional<Observation> seen(ExperimentStep& step, const MoveAnswer& stood);
  std::optional<Observation> touched(ExperimentStep& step, const MoveAnswer& stood);
  void take(ExperimentStep& step, Observation observation);
  double next_time(const std::optional<double>& of_driver);
  std::int64_t next_id() const;
  MoveAnswer moved(const PlannedMove& move);
  void keep();
  void reported(const ExperimentStep& step);
  void finish();

  bool is_interrupted() const { return options_.is_interrupted && options_.is_interrupted(); }
  void note(const Message& text) const {
    if (options_.on_note) options_.on_note(text);
  }
  Session session_;
  DrivenRobot& robot_;
  const ExperimentOptions& options_;
  ExperimentModel model_;
  Settling settling_;
  ExperimentResult result_;
  JointOrder order_;
  std::optional<Reach> reach_;
  std::optional<Deciding> deciding_;
  Eigen::VectorXd at_;                     // where the robot stands, in the session's order
  std::vector<Eigen::VectorXd> way_back_;  // points after at_, to where it stood before
  bool was_confirmed_ = false, has_moved_ = false;
  int batches_ = 0, in_vain_ = 0, poses_without_ = 0, asked_for_ = 0;
  std::vector<Eigen::VectorXd> judged_by_;
  std::size_t judged_at_ = 0;
  double time_offset_ = 0, last_time_ = 0;  // s
  bool has_offset_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace handsight
