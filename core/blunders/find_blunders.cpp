#include <cstdio>
#include <cstdlib>
// SPDX-License-Identifier: Apache-2.0
#include "blunders/find_blunders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/text.h"
#include "blunders/judging.h"
#include "blunders/places.h"
#include "blunders/seen_points.h"
#include "blunders/trials.h"
#include "estimation/start/competition.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

constexpr double many_times = 10;     // the noise
constexpr double several_pixels = 3;  // where the noise is not known
constexpr double several_m = 3e-3;
constexpr double few_pixels = 1, few_m = 1e-3;                // less than that no blunder leaves, whatever the noise
constexpr double half = 0.5;                                  // of the rms, at most, once it is right
constexpr double well_above = 10;                             // ln Bayes factor
constexpr double smallest_zero = 2 * std::numbers::pi / 180;  // rad: less is a deviation as robots have them
constexpr double smallest_shift = 0.01;                       // m
constexpr double large_zero = 10 * std::numbers::pi / 180;    // rad: more is no deviation
constexpr std::size_t judged = 6;                             // of the best

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
double unit_of(const std::vector<Mend>& mends) {
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
    for (const EffectTerm& term : terms_of(fit))
      if (!term.id.empty()) as_it_is_.plain.rms = std::min(as_it_is_.plain.rms, fit.residual_rms);
  }

  /// ln Bayes factor of the trial over the session as it is; nothing where it is not to be claimed.
  std::optional<double> verdict(const Trial& trial) const {
    for (const Mend& mend : trial.mends)
      if (is_small_zero(mend, thin_, smallest_zero, smallest_shift)) return std::nullopt;
    const Session small = with_few_markers(put_right(thin_, trial.mends));
    const std::optional<Rigid> mount = trial.found->mount_from_sensor;
    const double unit = unit_of(trial.mends);
    Left plain = left_by_plain(small, mount);
    plain.rms *= unit;
    if (std::getenv("HSDEBUG")) std::fprintf(stderr, "judge plain %g -> %g lost %d; off %g geo %g\n", as_it_is_.plain.rms, plain.rms, plain.is_lost, as_it_is_.offsets.rms, as_it_is_.geometry.rms);
    const double ln = likelier(as_it_is_.plain.rms, plain.rms, numbers_of(trial)) - price_of_trials(trial);
    if (!(plain.rms < as_it_is_.plain.rms) || ln < well_above) return std::nullopt;
    if (is_right_alone(trial, plain)) return ln;
    return is_right_with_geometry(small, mount, unit) ? std::optional(ln) : std::nullopt;
  }

 private:
  static Left better(const Left& a, const Left& b) { return b.rms < a.rms ? b : a; }
  static int numbers_of(const Trial& trial) {
    int numbers = 0;
    for (const Mend& mend : trial.mends) numbers += mend.kind->numbers;
    return numbers;
  }
  double likelier(double before, double after, int numbers) const {
    return ln_likelier(before * before, after * after, trials_.sights(), trials_.rows(), numbers);
  }
  /// What the quick trials were charged for having been so many.
  double price_of_trials(const Trial& trial) const {
    return ln_likelier(trials_.as_it_is().left(), trial.left(), trials_.sights(), trials_.rows(), numbers_of(trial)) -
           trial.ln_bayes_factor;
  }

  /// It leaves a plain answer, and more numbers of the robot do not explain as much.
  bool is_right_alone(const Trial& trial, const Left& plain) const {
    if (plain.is_lost || !(plain.rms < half * as_it_is_.plain.rms)) return false;
    const bool is_large_zero = trial.mends[0].kind->id == "joint_zero" &&
                               !is_small_zero(trial.mends[0], thin_, large_zero, 10 * smallest_shift);
    if (thin_.robot.is_of_poses || (trial.mends.size() == 1 && is_large_zero)) return true;
    const int joints = static_cast<int>(thin_.joints.size());
    const int own = numbers_of(trial);
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

std::vector<std::string> names_of(const std::vector<Mend>& mends) {
  std::vector<std::string> names;
  for (const Mend& mend : mends) names.push_back(name_of(mend.kind->id, mend.where));
  return names;
}

/// One entry a mend, of a pair both.
std::vector<Blunder> told(const Session& session, const Trial& trial, double ln, double before, double after) {
  std::vector<Blunder> blunders;
  const std::vector<std::string> names = names_of(trial.mends);
  for (std::size_t i = 0; i < trial.mends.size(); ++i) {
    const Mend& mend = trial.mends[i];
    Blunder b{.id = mend.kind->id,
              .where = mend.where,
              .text = mend.kind->text(mend.where, session),
              .fix = mend.kind->fix(mend.where, session),
              .in_pixels = !session.is_tracker(),
              .rms_before = before,
              .rms_after = after,
              .ln_bayes_factor = ln};
    for (std::size_t k = 0; k < names.size(); ++k)
      if (k != i) b.together_with.push_back(names[k]);
    blunders.push_back(std::move(b));
  }
  return blunders;
}

/// The whole fit of the whole session once it is right; nothing where that is not clearly better.
std::optional<double> confirmed(const Session& session, const Trial& trial, double before) {
  try {
    const Fit right = fit(put_right(session, trial.mends));
    if (std::getenv("HSDEBUG")) std::fprintf(stderr, "confirm %g before %g answer %d\n", right.residual_rms, before, !is_no_answer(right.problem, right.solution));
    const bool is_answer = !is_no_answer(right.problem, right.solution);
    return is_answer && unit_of(trial.mends) * right.residual_rms < 0.8 * before ? std::optional(right.residual_rms)
                                                                                 : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// A sensor of poses without sigmas weighs places and turns by what is left, which differs between readings.
Session with_one_lever(Session session) {
  if (!session.pose_sensor) return session;
  if (!session.pose_sensor->sigma || !session.pose_sensor->sigma_angle)
    session.pose_sensor = PoseSensor{1e-3, 1e-3 / usual_lever};
  for (Observation& o : session.observations)
    if (o.target_pose && is_used(o)) show_pose(o, pose_lever(*session.pose_sensor));
  session.sigma_point = session.pose_sensor->sigma;
  session.shape = KnownShape{pose_shape(pose_lever(*session.pose_sensor)), 1e-3 * *session.sigma_point};
  return session;
}

}  // namespace

bool may_be_a_blunder(const Session& session, const Fit& fit) {
  if (fit.solution.stopped || fit.problem.observations.size() < 6) return false;
  if (is_no_answer(fit.problem, fit.solution) || looks_lost(fit.problem, fit.solution)) return true;
  const bool tracker = session.is_tracker();
  if (!(fit.residual_rms > (tracker ? few_m : few_pixels))) return false;
  return fit.residual_rms > (fit.noise ? many_times * *fit.noise : tracker ? several_m : several_pixels);
}

std::vector<Blunder> find_blunders(const Session& session, const Fit& fit,
                                   const std::function<bool(double)>& on_progress) {
  const auto goes_on = [&](double share) { return !on_progress || on_progress(share); };
  const Session thin = with_one_lever(thinned_session(session));
  Trials trials(thin);
  const std::vector<Trial> tried = trials.run(goes_on);
  if (tried.empty()) return {};
  if (std::getenv("HSDEBUG")) {
    std::fprintf(stderr, "sights %zu rows %d base %g\n", trials.sights(), trials.rows(), std::sqrt(trials.as_it_is().left()));
    for (std::size_t i = 0; i < std::min<std::size_t>(12, tried.size()); ++i) {
      for (const Mend& m : tried[i].mends) std::fprintf(stderr, " %s:%s", m.kind->id.c_str(), m.where.c_str());
      std::fprintf(stderr, "  ln %g left %g of %zu\n", tried[i].ln_bayes_factor, std::sqrt(tried[i].left()), tried.size());
    }
  }
  std::optional<Judge> judge;
  std::vector<std::pair<double, const Trial*>> claims;
  for (std::size_t i = 0; i < std::min(judged, tried.size()); ++i) {
    const Trial& trial = tried[i];
    if (!trial.found || trial.ln_bayes_factor < well_above) break;
    if (!judge) judge.emplace(thin, trials, fit);
    if (const auto ln = judge->verdict(trial)) claims.emplace_back(*ln, &trial);
    if (!goes_on(0.8 + 0.03 * static_cast<double>(i))) return {};
  }
  std::stable_sort(claims.begin(), claims.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [ln, trial] : claims)
    if (const auto after = confirmed(session, *trial, fit.residual_rms))
      return told(session, *trial, ln, fit.residual_rms, *after);
  return {};
}

}  // namespace handsight
