// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/experiment_run.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "diagnosis/verdict/explanation.h"
#include "experiment/loop/forecast.h"

namespace handsight {
namespace {

constexpr int most_poses_without = 15;  // asked for in a row, of which none was found
constexpr int poses_for_limit = 150;

/// Two digits, as the window says them: nobody knows odds better.
double rounded_odds(double odds) {
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(odds, 1.0))) - 1));
  return std::round(odds / step) * step;
}

Message named_cause(const SettledCause& settled) {
  const Effect* const effect = find_effect(settled.id);
  Message cause = effect ? looked_up(effect->title) : verbatim(settled.id);
  if (settled.where.empty()) return cause;
  return settled.where.front().starts_with("from observation")
             ? message("{} {}", cause, listed_places(settled.where))
             : message("{} of {}", cause, listed_places(settled.where));
}

Message cause_sentence(const SettledCause& settled) {
  const Message odds = settled.odds > 1e6 ? Message("more than a million to one")
                                          : message("about {:.0f} to one", rounded_odds(settled.odds));
  if (settled.follows)
    return message("What is missing follows the {} in a form that is not in the catalogue, by odds of {}.",
                   *settled.follows, odds);
  if (settled.id.empty()) return "Nothing is missing that these poses could show.";
  return message("What is missing: {}, by odds of {}.", named_cause(settled), odds);
}

/// Why everything that was asked for is reached.
Message reached_text(const Goals& until, const ExperimentResult& result) {
  Message text = "What was asked for is reached.";
  if (until.odds) text += message(" {}", cause_sentence(*result.settled));
  if (until.hand) text += message(" The hand is known to {:.3g} mm (95 %).", 1e3 * *result.known.hand_limit);
  return text;
}

}  // namespace

ExperimentResult Experiment::run() {
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
  if (session_.is_touch() && !options_.given.empty())
    throw InputError("A recheck drives to poses and looks; a session of touches is rechecked by its own touches.");
  meet_driver();
  make_reach();
  if (!session_.is_touch()) deciding_.emplace(session_);
  last_time_ = session_.observations.back().time;
  if (!options_.given.empty()) return;
  learn(true);
  if (session_.is_touch() && !result_.known.fit)
    throw InputError(
        "An experiment of touches begins where they can be fitted, and these cannot yet: touch each fixture by hand "
        "first, a plane at three places at least (fit says what is lacking).");
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
    poses_without_ += asked_for_;
    if (poses_without_ >= most_poses_without)
      throw Ended{
          ExperimentEnd::no_more_poses,
          "No further pose was found that the robot can reach without a collision and where the target is seen."};
    return;
  }
  poses_without_ = 0;
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

void Experiment::check_goals() {
  const Goals& until = options_.until;
  const Knowledge& known = result_.known;
  if (until.odds && !result_.settled && settling_.is_settled_by(known)) {
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

}  // namespace handsight
