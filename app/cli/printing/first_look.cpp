// SPDX-License-Identifier: Apache-2.0
#include "first_look.h"

#include "base/error.h"
#include "blunders/reported_error.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/start/multi_start.h"
#include "reported_json.h"
#include "session/sample.h"

namespace handsight::cli {
namespace {

/// Where a first fit leaves more than noise and a robot's deviations explain.
std::optional<Message> unexplained_error(const Session& session, const Fit& fit) {
  if (!has_no_answer(fit) && !looks_lost(fit.problem, fit.solution)) return std::nullopt;
  return message(
      "A first fit leaves {}: more than noise and a robot's deviations explain, and no kind of mistake that is "
      "looked for explains it. Make sure that poses and measurements are of the same instants and that units, angles, "
      "target and mount are what the session says; fit and diagnose tell which observations stand out.",
      verbatim(error_text(!session.is_tracker(), reported_error(session, fit))));
}

/// `first`: first_fit().
std::optional<TargetSize> find_target_size(const Session& session, const Fit& first) {
  if (!session.target && !session.pose_sensor) return std::nullopt;
  try {
    const auto sample = take_sample(session, most_in_first_fit, most_in_first_fit);
    return other_target_size(sample ? sample->session : session, first, {.smallest_step = 1e-6});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<DistanceDoubt> find_doubtful_distance(const Session& session) {
  try {
    return session.is_touch() ? doubtful_distance(session, fit(session, {}), {}) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

FirstLook first_look(const Session& session, SessionCheck& check) {
  FirstLook look;
  if (!check.problems.empty()) return look;
  const std::optional<Fit> fit = first_fit(session);
  if (fit) look.size = find_target_size(session, *fit);
  look.distance = find_doubtful_distance(session);
  if (look.size) check.warnings.push_back(look.size->text + " " + look.size->fix);
  if (look.distance) check.warnings.push_back(look.distance->text);
  if (settles_it(look.size) || look.distance) return look;
  look.blunders = fit ? list_blunders(session, *fit) : blunders_in_files(session);
  if (!fit || !look.blunders.empty()) return look;
  if (const Message turns = turn_misfit_text(fit->problem, estimate(*fit)); !turns.empty())
    check.warnings.push_back(turns);
  else if (!look.size)
    if (const auto text = unexplained_error(session, *fit)) check.warnings.push_back(*text);
  return look;
}

Json first_look_json(const Session& session, const SessionCheck& check, const FirstLook& look) {
  Json json = check_json(session, check);
  json["target_size"] = target_size_json(look.size);
  json["doubtful_distance"] = doubtful_distance_json(look.distance, session);
  json["blunders"] = blunders_json(look.blunders);
  return json;
}

}  // namespace handsight::cli
