// SPDX-License-Identifier: Apache-2.0
// What an experiment does with the robot: which moves, where they lead, what is measured there.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "estimation/solvers/normal_equations.h"
#include "experiment/loop/experiment_run.h"
#include "experiment/loop/touch_choice.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

constexpr double slow_share = 0.1;  // of the speed, for the first move
constexpr int least_shown = 3;      // poses, before anything moves
constexpr int most_in_vain = 10;    // moves in a row that brought nothing

}  // namespace

std::vector<PlannedMove> Experiment::next_moves() {
  const auto began = Clock::now();
  ChoiceOptions choice;
  choice.count = options_.batch;
  if (options_.until.count) choice.count = std::min(choice.count, *options_.until.count - result_.observations);
  // While little is measured each pose may settle what is missing. Who is asked whether to begin sees some.
  choice.for_cause = options_.until.odds && !result_.settled && !options_.between && !session_.is_touch();
  if (const std::size_t used = result_.known.used; choice.for_cause && used < least_for_none) {
    const int most = used < least_to_diagnose ? static_cast<int>(least_to_diagnose - used) : 1;
    choice.count = std::min(choice.count, batches_ == 0 ? std::max(least_shown, most) : most);
  }
  choice.in_vain = std::max(in_vain_, poses_without_ - 1);
  if (in_vain_ > 0) choice.count = 1;  // what it brings is wanted before the next
  asked_for_ = std::max(choice.count, 1);
  choice.with_repeat = batches_ % 2 == 1;
  choice.seed = options_.seed + 1000 * static_cast<std::uint64_t>(batches_ + session_.observations.size());
  ++batches_;
  std::vector<PlannedMove> moves;
  if (session_.is_touch()) {
    add_moves(choose_touches(session_, model_, result_.known, *reach_, choice), moves);
  } else if (options_.given.empty()) {
    add_moves(choose_poses(session_, model_, result_.known, *reach_, at_, choice), moves);
  } else {
    std::vector<ChosenPose> given;
    for (const Eigen::VectorXd& position : options_.given) given.push_back({position, PoseReason::repeat});
    add_moves(std::move(given), moves);
  }
  const double a_pose = seconds_since(began) / std::max<double>(1, static_cast<double>(moves.size()));
  if (!moves.empty()) result_.longest_choice = std::max(result_.longest_choice, a_pose);
  return moves;
}

/// The nearest first; what no way leads to is remembered.
void Experiment::add_moves(std::vector<ChosenPose> chosen, std::vector<PlannedMove>& moves) {
  Eigen::VectorXd from = at_;
  while (!chosen.empty()) {
    const auto nearest = std::min_element(chosen.begin(), chosen.end(), [&](const ChosenPose& a, const ChosenPose& b) {
      return (a.position - from).cwiseAbs().maxCoeff() < (b.position - from).cwiseAbs().maxCoeff();
    });
    const ChosenPose pose = *nearest;
    chosen.erase(nearest);
    auto way = way_between(reach_->world, reach_->chain, reach_->ranges, from, pose.position);
    if (!way && moves.empty())
      way = way_by_going_back(reach_->world, reach_->chain, reach_->ranges, at_, way_back_, pose.position);
    if (!way) {
      reach_->refused.push_back(pose.position);
      continue;
    }
    moves.push_back({pose, *way, measure_length(from, *way)});
    from = pose.position;
  }
}

void Experiment::confirm(const std::vector<PlannedMove>& moves) {
  if (was_confirmed_) return;
  if (options_.confirm && !options_.confirm(moves))
    throw Ended{ExperimentEnd::not_confirmed, "Nothing was confirmed, so that nothing has moved."};
  was_confirmed_ = true;
  start_ = Clock::now();  // who was asked may have thought about it
}

MoveAnswer Experiment::moved(const PlannedMove& move) {
  std::vector<Eigen::VectorXd> path;
  for (const Eigen::VectorXd& point : move.way) path.push_back(order_.to_driver(point));
  MoveAnswer answer = robot_.move(path, options_.speed * (has_moved_ ? 1 : slow_share));
  ++result_.moves;
  if (!answer.ok) return answer;
  answer.position = order_.to_session(answer.position);
  if (answer.torque.size() > 0) answer.torque = order_.to_session(answer.torque);
  require_arrival(reach_->chain, session_.joints, move.pose.position, answer.position);
  has_moved_ = true;
  way_back_.assign(move.way.rbegin() + 1, move.way.rend());
  way_back_.push_back(at_);
  at_ = answer.position;
  return answer;
}

void Experiment::drive(const PlannedMove& move) {
  ExperimentStep step;
  step.move = move;
  // A move that was refused before leaves the robot elsewhere: the way begins there anew.
  if (!is_free(reach_->world, reach_->chain, at_, move.way.front())) {
    const auto way = way_between(reach_->world, reach_->chain, reach_->ranges, at_, move.pose.position);
    if (!way) {
      step.reason = "no way leads there from where the robot stands now";
      reach_->refused.push_back(move.pose.position);
      return reported(step);
    }
    step.move.way = *way;
  }
  const MoveAnswer stood = moved(step.move);
  if (!stood.ok) {
    step.reason = message("refused: {}", stood.why);
    reach_->refused.push_back(move.pose.position);
    if (++in_vain_ >= most_in_vain)
      throw DriverFault(
          message("The driver has refused or shown nothing in {} moves in a row, the last time because: {}.",
                  most_in_vain, stood.why));
    return reported(step);
  }
  step.reached = true;
  if (is_interrupted()) throw Ended{ExperimentEnd::interrupted, "The experiment was interrupted after a move."};
  look(step, stood);
  if (step.accepted && options_.fit_each_look && options_.given.empty()) learn_from_look();
  reported(step);
}

double Experiment::next_time(const std::optional<double>& of_driver) {
  if (!has_offset_ && of_driver) {
    time_offset_ = last_time_ + 1 - *of_driver;
    has_offset_ = true;
  }
  const double time = of_driver && has_offset_ ? time_offset_ + *of_driver : last_time_ + 1;
  last_time_ = std::max(last_time_, time);
  return last_time_;
}

std::int64_t Experiment::next_id() const {
  std::int64_t id = 0;
  for (const Observation& o : session_.observations) id = std::max(id, o.id + 1);
  return id;
}

std::optional<Observation> Experiment::seen(ExperimentStep& step, const MoveAnswer& stood) {
  const LookAnswer seen = robot_.look();
  if (seen.ok) return make_observation(session_, next_id(), next_time(stood.time), stood, seen);
  step.reason = message("nothing was seen: {}", seen.why);
  return std::nullopt;
}

std::optional<Observation> Experiment::touched(ExperimentStep& step, const MoveAnswer& stood) {
  const ChosenPose& pose = step.move.pose;
  TouchAnswer read =
      robot_.touch({session_.fixtures[static_cast<std::size_t>(pose.fixture)].id, order_.to_driver(pose.touching)});
  if (!read.ok) {
    step.reason = message("nothing was touched: {}", read.why);
    return std::nullopt;
  }
  if (read.torque.size() > 0) read.torque = order_.to_session(read.torque);
  Observation o = observation_of_touch(session_, pose.fixture, read,
                                       read.position.size() > 0 ? order_.to_session(read.position) : stood.position);
  o.id = next_id();
  o.time = next_time(read.time ? read.time : stood.time);
  return o;
}

/// Decided, and kept before anything moves on.
void Experiment::take(ExperimentStep& step, Observation observation) {
  step.id = observation.id;
  session_.observations.push_back(std::move(observation));
  Observation& o = session_.observations.back();
  OnlineStep decided;
  if (deciding_) {
    decided = deciding_->decide(session_, session_.observations.size() - 1);
  } else {
    decided = decided_touch(*result_.known.fit, session_, o);
    keep_step(decided, o);
  }
  step.accepted = decided.accepted;
  step.reason = decided.reason;
  ++result_.observations;
  result_.accepted += decided.accepted ? 1 : 0;
  keep();
  if (options_.on_observation) options_.on_observation(session_, session_.observations.back());
}

void Experiment::look(ExperimentStep& step, const MoveAnswer& stood) {
  std::optional<Observation> observation = session_.is_touch() ? touched(step, stood) : seen(step, stood);
  const bool is_seen = observation.has_value();
  if (observation) take(step, std::move(*observation));
  if (step.accepted) {
    in_vain_ = 0;
    return;
  }
  if (!is_seen || session_.observations.back().sightings.empty()) reach_->refused.push_back(step.move.pose.position);
  if (++in_vain_ >= most_in_vain)
    throw DriverFault(
        message("Of {} moves in a row none brought an observation that could be used, the last time "
                "because: {}.",
                most_in_vain, at_most(step.reason, 200)));
}

/// Whole on disk before anything moves on.
void Experiment::keep() {
  if (!options_.save) return;
  replace_session(session_);
  session_.source = std::make_shared<const std::string>(session_text(session_));
}

void Experiment::reported(const ExperimentStep& step) {
  result_.steps.push_back(step);
  result_.steps.back().hand_limit = result_.known.hand_limit;
  if (options_.on_step) options_.on_step(result_.steps.back());
}

}  // namespace handsight
