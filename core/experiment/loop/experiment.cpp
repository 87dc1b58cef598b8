// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/experiment.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/text.h"
#include "diagnosis/verdict/explanation.h"
#include "experiment/loop/deciding.h"
#include "experiment/loop/driven_joints.h"
#include "experiment/loop/forecast.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double slow_share = 0.1;       // of the speed, for the first move
constexpr int most_in_vain = 10;         // moves in a row that brought nothing
constexpr int most_batches_without = 3;  // choices in a row that found no pose
constexpr int poses_for_limit = 150;
constexpr std::size_t least_for_none = 20;  // observations before it is said that nothing is missing

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The experiment is over; why, as the user reads it.
struct Ended {
  ExperimentEnd end;
  Message reason;
};

/// Why everything that was asked for is reached.
Message reached_text(const Goals& until, const ExperimentResult& result) {
  const Message hand = until.hand ? message("{:.3g}", 1e3 * *result.known.hand_limit) : Message();
  if (!until.odds) return message("What was asked for is reached: the hand is known to {} mm (95 %).", hand);
  if (result.settled->id.empty())
    return until.hand ? message(
                            "What was asked for is reached: nothing is missing that these poses could show, and "
                            "the hand is known to {} mm (95 %).",
                            hand)
                      : Message("What was asked for is reached: nothing is missing that these poses could show.");
  const Message odds = result.settled->odds > 1e6 ? Message("more than a million to one")
                                                  : message("about {:.0f} to 1", result.settled->odds);
  const Effect* const effect = find_effect(result.settled->id);
  Message cause = effect ? looked_up(effect->title) : verbatim(result.settled->id);
  if (!result.settled->where.empty()) cause = message("{} ({})", cause, listed_places(result.settled->where));
  return until.hand ? message(
                          "What was asked for is reached. What is missing: {}, by odds of {}; the hand is known to "
                          "{} mm (95 %).",
                          cause, odds, hand)
                    : message("What was asked for is reached. What is missing: {}, by odds of {}.", cause, odds);
}

class Experiment {
 public:
  Experiment(Session session, DrivenRobot& robot, const ExperimentOptions& options)
      : session_(std::move(session)), robot_(robot), options_(options), model_(options.model) {}

  ExperimentResult run() {
    try {
      begin();
      while (true) round();
    } catch (const Ended& ended) {
      result_.end = ended.end;
      result_.reason = ended.reason;
    } catch (const DriverFault& fault) {
      robot_.stop();
      result_.end = is_interrupted() ? ExperimentEnd::interrupted : ExperimentEnd::fault;
      result_.reason = fault.sentence();
    } catch (...) {
      robot_.stop();
      throw;
    }
    finish();
    return std::move(result_);
  }

 private:
  void begin();
  void meet_driver();
  void make_reach();
  void round();
  void learn(bool with_diagnosis);
  void learn_from_look();
  void check_goals();
  bool is_settled(const Knowledge& known);
  void check_limits() const;
  std::vector<PlannedMove> next_moves();
  void add_moves(std::vector<ChosenPose> chosen, std::vector<PlannedMove>& moves);
  void confirm(const std::vector<PlannedMove>& moves);
  void drive(const PlannedMove& move);
  void look(ExperimentStep& step, const MoveAnswer& stood);
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
  ExperimentResult result_;
  JointOrder order_;
  std::optional<Reach> reach_;
  std::optional<Deciding> deciding_;
  Eigen::VectorXd at_;  // where the robot stands, in the session's order
  bool was_confirmed_ = false, has_moved_ = false;
  int batches_ = 0, in_vain_ = 0, batches_without_ = 0, adequate_in_a_row_ = 0;
  std::vector<Eigen::VectorXd> judged_by_;
  std::size_t judged_at_ = 0;
  double time_offset_ = 0, last_time_ = 0;  // s
  bool has_offset_ = false;
  Clock::time_point start_ = Clock::now();
};

void Experiment::meet_driver() {
  const DriverHello hello = robot_.hello();
  for (const char* what : {"move", "look"})
    if (std::find(hello.can.begin(), hello.can.end(), what) == hello.can.end())
      throw DriverFault(message("The driver {} does not say that it can \"{}\", which an experiment needs.",
                                in_quotes(hello.name), what));
  order_ = joint_order(session_, hello);
  at_ = session_.observations.back().position;
  if (hello.position)
    at_ = order_.to_session(*hello.position);
  else
    note(
        "The driver does not say where the robot stands: it is taken to stand where the session's last observation "
        "was.");
}

void Experiment::make_reach() {
  std::vector<Eigen::VectorXd> taken;
  for (const Observation& o : session_.observations) taken.push_back(o.position);
  taken.push_back(at_);
  const Chain chain = make_chain(session_);
  CollisionWorld world(chain, robot_solids(session_), options_.cell, taken);
  for (const Message& text : world.notes()) note(text);
  JointRanges ranges = joint_ranges(chain, taken);
  reach_.emplace(Reach{chain, std::move(world), std::move(ranges), {}, options_.box});
}

void Experiment::begin() {
  if (const auto need = what_paths_need()) throw InputError(*need);
  if (session_.robot.is_of_poses)
    throw InputError("An experiment moves joints, and of this session's robot only the flange's poses are known.");
  if (session_.is_touch())
    throw InputError(
        "An experiment looks from where nothing is touched, and a touch is made by hand or by a program that feels it; "
        "plan tells which posture on which fixture comes next.");
  meet_driver();
  make_reach();
  deciding_.emplace(session_);
  last_time_ = session_.observations.back().time;
  if (!options_.given.empty()) return;
  learn(true);
  check_goals();
}

/// The choice, the moves, and then what they have taught.
void Experiment::round() {
  const std::vector<PlannedMove> moves = next_moves();
  if (options_.on_plan) options_.on_plan(moves);
  if (options_.dry_run) {
    result_.planned = moves;
    throw Ended{ExperimentEnd::dry_run, "A dry run: these are the poses that would be taken first; nothing has moved."};
  }
  if (moves.empty()) {
    if (++batches_without_ >= most_batches_without)
      throw Ended{
          ExperimentEnd::no_more_poses,
          "No further pose was found that the robot can reach without a collision and where the target is seen."};
    return;
  }
  batches_without_ = 0;
  confirm(moves);
  for (const PlannedMove& move : moves) {
    check_limits();
    drive(move);
  }
  if (!options_.given.empty())
    throw Ended{ExperimentEnd::reached, message("The {} poses that were given have been taken.", moves.size())};
  learn(true);
  check_goals();
}

void Experiment::learn(bool with_diagnosis) {
  if (result_.known.fit && (judged_by_.empty() || session_.observations.size() > judged_at_ + 10)) {
    judged_by_ = poses_to_judge_by(session_, *result_.known.fit, *reach_, poses_for_limit, options_.seed + 5);
    judged_at_ = session_.observations.size();
  }
  Knowledge known = assess_knowledge(session_, model_, with_diagnosis, judged_by_);
  if (known.fit && judged_by_.empty()) {
    judged_by_ = poses_to_judge_by(session_, *known.fit, *reach_, poses_for_limit, options_.seed + 5);
    known.hand_limit = hand_limit(*known.fit, judged_by_);
  }
  if (options_.between) known.competing = options_.between;
  result_.known = std::move(known);
  if (options_.on_knowledge) options_.on_knowledge(result_.known);
}

/// Between two diagnoses: a fit, beside what the last one found.
void Experiment::learn_from_look() {
  Knowledge before = std::move(result_.known);
  Knowledge known = assess_knowledge(session_, model_, false, judged_by_);
  known.diagnosis = std::move(before.diagnosis);
  known.settled = std::move(before.settled);
  known.competing = std::move(before.competing);
  known.likely = std::move(before.likely);
  result_.known = std::move(known);
  if (options_.on_knowledge) options_.on_knowledge(result_.known);
}

void Experiment::check_limits() const {
  if (is_interrupted()) throw Ended{ExperimentEnd::interrupted, "The experiment was interrupted between two moves."};
  if (options_.until.count && result_.observations >= *options_.until.count)
    throw Ended{ExperimentEnd::count,
                message("The {} observations that were asked for are made.", result_.observations)};
  if (options_.until.seconds && seconds_since(start_) >= *options_.until.seconds)
    throw Ended{ExperimentEnd::time,
                message("The time that was asked for is over ({:.0f} s).", *options_.until.seconds)};
}

/// By odds; that nothing is missing is said of what two diagnoses in a row find so, from twenty observations on.
bool Experiment::is_settled(const Knowledge& known) {
  if (!known.settled) return false;
  if (!known.settled->id.empty() || known.diagnosis->verdict != Verdict::adequate) {
    adequate_in_a_row_ = 0;
    return !known.settled->id.empty() && known.settled->odds >= *options_.until.odds;
  }
  if (known.used < least_for_none || known.settled->odds < 1) return false;
  return ++adequate_in_a_row_ >= 2;
}

void Experiment::check_goals() {
  const Goals& until = options_.until;
  const Knowledge& known = result_.known;
  if (until.odds && !result_.settled && is_settled(known)) {
    result_.settled = known.settled;
    // What has a name belongs to the model from now on: the hand is to be known with it.
    for (const EffectTerm& term : known.settled->terms) model_.estimated.push_back(term);
    if (until.hand && !known.settled->terms.empty()) learn(true);
  }
  const bool has_odds = !until.odds || result_.settled;
  const bool has_hand = !until.hand || (result_.known.hand_limit && *result_.known.hand_limit <= *until.hand);
  if (until.wants_something() && has_odds && has_hand) {
    throw Ended{ExperimentEnd::reached, reached_text(until, result_)};
  }
  check_limits();
}

std::vector<PlannedMove> Experiment::next_moves() {
  const auto began = Clock::now();
  ChoiceOptions choice;
  choice.count = options_.batch;
  if (options_.until.count) choice.count = std::min(choice.count, *options_.until.count - result_.observations);
  choice.with_repeat = batches_ % 2 == 1;
  choice.seed = options_.seed + 1000 * static_cast<std::uint64_t>(batches_ + session_.observations.size());
  ++batches_;
  std::vector<PlannedMove> moves;
  if (options_.given.empty()) {
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
    const auto way = way_between(reach_->world, reach_->chain, reach_->ranges, from, pose.position);
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

void Experiment::look(ExperimentStep& step, const MoveAnswer& stood) {
  const LookAnswer seen = robot_.look();
  if (!has_offset_ && stood.time) {
    time_offset_ = last_time_ + 1 - *stood.time;
    has_offset_ = true;
  }
  const double time = stood.time && has_offset_ ? time_offset_ + *stood.time : last_time_ + 1;
  if (!seen.ok) {
    step.reason = message("nothing was seen: {}", seen.why);
  } else {
    std::int64_t id = 0;
    for (const Observation& o : session_.observations) id = std::max(id, o.id + 1);
    last_time_ = std::max(last_time_, time);
    session_.observations.push_back(make_observation(session_, id, last_time_, stood, seen));
    const OnlineStep decided = deciding_->decide(session_, session_.observations.size() - 1);
    step.id = id;
    step.accepted = decided.accepted;
    step.reason = decided.reason;
    ++result_.observations;
    result_.accepted += decided.accepted ? 1 : 0;
    keep();
    if (options_.on_observation) options_.on_observation(session_, session_.observations.back());
  }
  if (step.accepted) {
    in_vain_ = 0;
    return;
  }
  if (session_.observations.back().sightings.empty() || !seen.ok) reach_->refused.push_back(step.move.pose.position);
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

void Experiment::finish() {
  if (result_.end != ExperimentEnd::dry_run && result_.end != ExperimentEnd::not_confirmed && options_.given.empty()) {
    if (has_offset_ && result_.observations > 1)
      result_.seconds_a_pose = (last_time_ - time_offset_) / result_.observations;
    else if (result_.observations > 0)
      result_.seconds_a_pose = seconds_since(start_) / result_.observations;
    if (result_.end == ExperimentEnd::fault || result_.end == ExperimentEnd::interrupted) try {
        result_.known = assess_knowledge(session_, model_, false, judged_by_);
      } catch (const InputError&) {  // of what there is nothing follows
      }
    if (reach_) result_.more = forecast(session_, model_, result_.known, *reach_, result_.seconds_a_pose);
  }
  result_.session = std::move(session_);
}

}  // namespace

const char* end_name(ExperimentEnd end) {
  switch (end) {
    case ExperimentEnd::reached:
      return "reached";
    case ExperimentEnd::count:
      return "count";
    case ExperimentEnd::time:
      return "time";
    case ExperimentEnd::no_more_poses:
      return "no_more_poses";
    case ExperimentEnd::interrupted:
      return "interrupted";
    case ExperimentEnd::not_confirmed:
      return "not_confirmed";
    case ExperimentEnd::fault:
      return "driver";
    default:
      return "dry_run";
  }
}

ExperimentResult run_experiment(Session session, DrivenRobot& robot, const ExperimentOptions& options) {
  return Experiment(std::move(session), robot, options).run();
}

}  // namespace handsight
