// SPDX-License-Identifier: Apache-2.0
#include "blunders/find_blunders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/text.h"
#include "blunders/pairing_order.h"
#include "blunders/places.h"
#include "blunders/quick_fits.h"
#include "blunders/reported_error.h"
#include "blunders/seen_points.h"
#include "blunders/stray_poses.h"
#include "blunders/trials.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/start/multi_start.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

constexpr double many_times = 10;     // the noise
constexpr double several_pixels = 3;  // where the noise is not known
constexpr double several_m = 3e-3;
constexpr double few_pixels = 1, few_m = 1e-3;                // less than that no blunder leaves, whatever the noise
constexpr double half = 0.5;                                  // of the rms, at most, once it is right
constexpr double tenth = 0.1;                                 // ... where it is right and the robot is not
constexpr double well_above = 10;                             // ln Bayes factor
constexpr double smallest_zero = 2 * std::numbers::pi / 180;  // rad: less is a deviation as robots have them
constexpr double smallest_shift = 0.01;                       // m
constexpr double large_zero = 10 * std::numbers::pi / 180;    // rad: more is no deviation
constexpr double several_turns = 0.02;                        // rad: of poses whose sigmas are not known
constexpr double as_likely = 5;                               // ln Bayes factor: nobody could say which of two it is
constexpr std::size_t judged = 8;                             // of the best

bool is_small_zero(const Mend& mend, const Session& session, double turn, double shift) {
  if (mend.kind->id != "joint_zero") return false;
  const auto [joint, value] = name_and_value(mend.where);
  const bool slides = joint_named(session, joint).kind == JointKind::prismatic;
  return std::abs(number_in(value, "joint_zero")) < (slides ? shift : turn);
}

Session put_right(const Session& session, const std::vector<Mend>& mends) {
  Session right = session;
  for (const Mend& mend : mends) mend.kind->mend(mend.where, right);
  return right;
}

/// One new unit of what is left in old ones: a session in millimetres leaves a thousand times as much.
double find_unit(const std::vector<Mend>& mends) {
  double unit = 1;
  for (const Mend& mend : mends) unit *= mend.kind->measured_unit;
  return unit;
}

/// What the small session leaves in three ways.
struct Judgement {
  Left plain, offsets, geometry;
};

class Judge {
 public:
  Judge(const Session& thin, const Trials& trials, const Fit& fit) : thin_(thin), trials_(trials) {
    const Session small = with_few_markers(thin);
    const auto& found = trials.as_it_is().found;
    const Rigid by_fit = estimate(fit).mount_from_sensor;
    const std::optional<Rigid> mount = found ? std::optional(found->mount_from_sensor) : std::nullopt;
    as_it_is_ = {better(left_by_plain(small, by_fit), left_by_plain(small, mount)),
                 better(left_by_offsets(small, by_fit), left_by_offsets(small, mount)),
                 better(left_by_geometry(small, by_fit), left_by_geometry(small, mount))};
    for (const EffectTerm& term : list_terms(fit))
      if (!term.id.empty()) as_it_is_.plain.rms = std::min(as_it_is_.plain.rms, fit.residual_rms);
  }

  /// ln Bayes factor of the trial over the session as it is; nothing where it is not to be claimed.
  std::optional<double> verdict(const Trial& trial) const {
    for (const Mend& mend : trial.mends)
      if (is_small_zero(mend, thin_, smallest_zero, smallest_shift)) return std::nullopt;
    const Session small = with_few_markers(put_right(thin_, trial.mends));
    const std::optional<Rigid> mount = trial.found->mount_from_sensor;
    const double unit = find_unit(trial.mends);
    Left plain = left_by_plain(small, mount);
    plain.rms *= unit;
    const double ln = likelier(as_it_is_.plain.rms, plain.rms, list_numbers(trial)) - price_of_trials(trial);
    if (!(plain.rms < as_it_is_.plain.rms) || ln < well_above) return std::nullopt;
    if (is_right_alone(trial, plain)) return ln;
    return is_right_with_geometry(small, mount, unit) ? std::optional(ln) : std::nullopt;
  }

 private:
  static Left better(const Left& a, const Left& b) { return b.rms < a.rms ? b : a; }
  static int list_numbers(const Trial& trial) {
    int numbers = 0;
    for (const Mend& mend : trial.mends) numbers += mend.kind->numbers;
    return numbers;
  }
  double likelier(double before, double after, int numbers) const {
    return ln_likelier(before * before, after * after, trials_.sights(), trials_.rows(), numbers);
  }
  /// What the quick trials were charged for having been so many.
  double price_of_trials(const Trial& trial) const {
    return ln_likelier(trials_.as_it_is().left(), trial.left(), trials_.sights(), trials_.rows(), list_numbers(trial)) -
           trial.ln_bayes_factor;
  }

  /// It leaves a plain answer, and more numbers of the robot do not explain as much.
  bool is_right_alone(const Trial& trial, const Left& plain) const {
    if (!(plain.rms < (plain.is_lost ? tenth : half) * as_it_is_.plain.rms)) return false;
    const bool is_large_zero = trial.mends[0].kind->id == "joint_zero" &&
                               !is_small_zero(trial.mends[0], thin_, large_zero, 10 * smallest_shift);
    if (thin_.robot.is_of_poses || (trial.mends.size() == 1 && is_large_zero)) return true;
    const int joints = static_cast<int>(thin_.joints.size());
    const int own = list_numbers(trial);
    return likelier(as_it_is_.offsets.rms, plain.rms, own - joints) > 3 &&
           likelier(as_it_is_.geometry.rms, plain.rms, own - 7 * joints) > 3;
  }

  /// With the robot's deviations taken out of both readings it leaves less than half.
  bool is_right_with_geometry(const Session& small, const std::optional<Rigid>& mount, double unit) const {
    if (thin_.robot.is_of_poses) return false;
    const Left offsets = left_by_offsets(small, mount), geometry = left_by_geometry(small, mount);
    return !offsets.is_lost && unit * offsets.rms < half * as_it_is_.offsets.rms &&
           unit * geometry.rms < half * as_it_is_.geometry.rms;
  }

  const Session& thin_;
  const Trials& trials_;
  Judgement as_it_is_;
};

std::vector<std::string> list_names(const std::vector<Mend>& mends) {
  std::vector<std::string> names;
  for (const Mend& mend : mends) names.push_back(display_name(mend.kind->id, mend.where));
  return names;
}

/// What a fit leaves of one coordinate (px, m), and as its report says it.
struct FitError {
  double rms = 0, reported = 0;
};

/// One entry a mend, of a pair both.
std::vector<Blunder> reported(const Session& session, const Trial& trial, double ln, const FitError& before,
                              const FitError& after) {
  std::vector<Blunder> blunders;
  const std::vector<std::string> names = list_names(trial.mends);
  for (std::size_t i = 0; i < trial.mends.size(); ++i) {
    const Mend& mend = trial.mends[i];
    Blunder b{.id = mend.kind->id,
              .where = mend.where,
              .text = mend.kind->text(mend.where, session),
              .fix = mend.kind->fix(mend.where, session),
              .in_pixels = !session.is_tracker(),
              .rms_before = before.rms,
              .rms_after = after.rms,
              .error_before = before.reported,
              .error_after = after.reported,
              .ln_bayes_factor = ln};
    for (std::size_t k = 0; k < names.size(); ++k)
      if (k != i) b.together_with.push_back(names[k]);
    blunders.push_back(std::move(b));
  }
  return blunders;
}

/// Found in the whole session, not by trial.
std::vector<Blunder> reported(const Session& session, std::optional<Blunder> found, const FitError& before) {
  if (!found) return {};
  found->error_before = before.reported;
  Session right = session;
  find_blunder_kind(found->id)->mend(found->where, right);
  found->error_after = reported_error(right, fit(right, {.smallest_step = 1e-9}));
  return {*found};
}

/// As who has put it right will read it: with the sensor's own lever, which `with_one_lever` does without.
double reported_once_right(const Session& given, const Trial& trial) {
  const Session right = put_right(given, trial.mends);
  return reported_error(right, fit(right, {.smallest_step = 1e-9}));
}

/// The whole fit of the whole session (`given`, with one lever) once it is right; nothing where that is not clearly
/// better.
std::optional<FitError> confirmed(const Session& given, const Session& session, const Trial& trial, double before) {
  try {
    const Fit right = fit(put_right(session, trial.mends), {.smallest_step = 1e-9});
    const bool is_answer = !is_no_answer(right.problem, right.solution);
    if (!is_answer || !(find_unit(trial.mends) * right.residual_rms < 0.8 * before)) return std::nullopt;
    return FitError{right.residual_rms, reported_once_right(given, trial)};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// A sensor of poses without sigmas weighs places and turns by what is left, which differs between readings.
Session with_one_lever(Session session) {
  if (!has_unknown_lever(session)) return session;
  session.pose_sensor = PoseSensor{1e-3, 1e-3 / usual_lever};
  for (Observation& o : session.observations)
    if (o.target_pose && is_used(o)) show_pose(o, pose_lever(*session.pose_sensor));
  session.sigma_point = session.pose_sensor->sigma;
  session.shape = KnownShape{pose_shape(pose_lever(*session.pose_sensor)), 1e-3 * *session.sigma_point};
  return session;
}

/// The best, without pairs of which one alone is as good.
std::vector<const Trial*> most_promising(const std::vector<Trial>& tried) {
  std::vector<const Trial*> best;
  std::vector<std::string> alone;
  for (const Trial& trial : tried) {
    if (best.size() == judged || !trial.found || trial.ln_bayes_factor < well_above) break;
    const std::vector<std::string> names = list_names(trial.mends);
    if (names.size() == 1) alone.push_back(names[0]);
    const bool has_one = names.size() > 1 && std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                           return std::find(alone.begin(), alone.end(), name) != alone.end();
                         });
    if (!has_one) best.push_back(&trial);
  }
  return best;
}

struct Claim {
  double ln = 0;
  const Trial* trial = nullptr;
};

/// How far from the flange what it carries would be: the sensor, or the target.
double distance_on_flange(const Session& thin, const Trial& trial) {
  if (thin.tcp == "base") return trial.found->mount_from_sensor.translation.norm();
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : trial.found->points_in_tcp)
    middle += x / static_cast<double>(trial.found->points_in_tcp.size());
  return middle.norm();
}

/// Poses of the flange inverted and poses of the target inverted explain the same, with the two unknown places
/// exchanged.
bool are_twins(const Claim& a, const Claim& b) {
  const auto inverts_one = [](const Claim& c) {
    return c.trial->mends.size() == 1 && c.trial->mends[0].kind->id == "pose_inverted";
  };
  return inverts_one(a) && inverts_one(b);
}

/// Best first; of twins the one in which the flange carries the nearer of the two.
void bring_likeliest_first(const Session& thin, std::vector<Claim>& claims) {
  std::stable_sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) { return a.ln > b.ln; });
  for (std::size_t i = 1; i < claims.size(); ++i)
    if (are_twins(claims[0], claims[i]) &&
        distance_on_flange(thin, *claims[i].trial) < distance_on_flange(thin, *claims[0].trial))
      std::swap(claims[0], claims[i]);
}

void say_what_else(const std::vector<Claim>& claims, const Claim& reported_one, std::vector<Blunder>& blunders) {
  std::vector<Message> others;
  for (const Claim& other : claims)
    if (other.trial != reported_one.trial &&
        (other.ln > reported_one.ln - as_likely || are_twins(other, reported_one)) &&
        other.trial->mends.size() == reported_one.trial->mends.size())
      others.push_back(joined(verbatim(list_names(other.trial->mends)), " with "));
  if (!others.empty())
    blunders.front().text += message(" (These measurements are explained as well by {}.)", joined(others));
}

}  // namespace

bool may_be_a_blunder(const Session& session, const Fit& fit) {
  if (fit.solution.stopped || fit.problem.observations.size() < 6) return false;
  if (is_no_answer(fit.problem, fit.solution) || looks_lost(fit.problem, fit.solution)) return true;
  // Where the sigmas are not given, turns that fit badly count little, and what is left of the places looks well.
  if (has_unknown_lever(session) && fit.residual_rms > several_turns * fit.problem.shape->markers.front().norm())
    return true;
  const bool tracker = session.is_tracker();
  if (!(fit.residual_rms > (tracker ? few_m : few_pixels))) return false;
  return fit.residual_rms > (fit.noise ? many_times * *fit.noise : tracker ? several_m : several_pixels);
}

std::vector<Blunder> find_wrong_order(const Session& session, const Fit& given) {
  return reported(session, find_pairing_order(with_one_lever(session), given.residual_rms),
                  {given.residual_rms, reported_error(session, given)});
}

std::vector<Blunder> find_blunders(const Session& session, const Fit& given,
                                   const std::function<bool(double)>& on_progress) {
  if (!session.parts.empty()) return {};  // each session of a collection is asked by itself
  const auto goes_on = [&](double share) { return !on_progress || on_progress(share); };
  const Session whole = with_one_lever(session);
  const Session thin = thinned_session(whole);
  Trials trials(thin);
  const std::vector<Trial> tried = trials.run(goes_on);
  const std::vector<const Trial*> promising = most_promising(tried);
  const bool may_stray = session.pose_sensor.has_value();
  const FitError before{
      has_unknown_lever(session) ? fit(whole, {.smallest_step = 1e-9}).residual_rms : given.residual_rms,
      reported_error(session, given)};
  const Judge judge(thin, trials, given);
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < promising.size(); ++i) {
    if (const auto ln = judge.verdict(*promising[i])) claims.push_back({*ln, promising[i]});
    if (!goes_on(0.8 + 0.02 * static_cast<double>(i))) return {};
  }
  bring_likeliest_first(thin, claims);
  for (const Claim& claim : claims)
    if (const auto after = confirmed(session, whole, *claim.trial, before.rms)) {
      std::vector<Blunder> blunders = reported(session, *claim.trial, claim.ln, before, *after);
      say_what_else(claims, claim, blunders);
      return blunders;
    }
  auto found = find_pairing_order(whole, before.rms);
  if (!found && may_stray) found = find_stray_poses(whole, before.rms);
  return reported(session, found, before);
}

}  // namespace handsight
