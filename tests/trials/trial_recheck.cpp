// SPDX-License-Identifier: Apache-2.0
// trial_recheck months COUNT SEED: rechecks once an hour for a month without a change, each of a robot of its own.
// trial_recheck scores COUNT SEED: checks of five poses without a change: the mean e-value, and how large the scores
//   are that e-values are made of.
// trial_recheck changes COUNT SEED: changes after ten checks, seen within the five poses of the next.
#include <fmt/core.h>

#include <ctime>
#include <map>
#include <numeric>

#include "compare/change_watch.h"
#include "compare/watch_parts.h"
#include "estimation/report/fit_report.h"
#include "fixtures/targets.h"
#include "fixtures/trial_sessions.h"

namespace handsight {
namespace {

double noise_of(const Session& s) { return s.is_tracker() ? 1e-4 : 0.1; }  // m, px

struct Watched {
  Session session;
  CalibratedRobot robot;
  std::vector<Eigen::VectorXd> poses;
  SimulationOptions truth;
};

/// A six-axis arm with a board before two cameras.
Session with_board() { return fixture::target_session(fixture::charuco(), 2); }

/// Calibrated by 60 poses; five poses to recheck in.
Watched watched(std::uint64_t seed, const Session& like = with_board()) {
  Watched w;
  w.truth.observations = 60;
  w.truth.seed = seed;
  w.truth.noise = noise_of(like);
  w.session = simulate_session(like, w.truth).session;
  const Fit f = fit(w.session);
  w.robot = calibrated_robot(w.session, f, report(w.session, f), {}, "trial");
  std::vector<Eigen::VectorXd> positions;
  for (const Observation& o : w.session.observations) positions.push_back(o.position);
  for (const std::size_t p : telling_poses(w.robot, w.session, positions, 5)) w.poses.push_back(positions[p]);
  return w;
}

Session visits(const Watched& w, int count, const std::vector<EffectTerm>& effects, int skipped) {
  std::vector<Observation> given;
  for (int v = 0; v < count; ++v)
    for (const Eigen::VectorXd& q : w.poses) {
      Observation o;
      o.time = static_cast<double>(given.size());
      o.position = q;
      given.push_back(o);
    }
  // The noise follows from an observation's place.
  std::vector<Observation> all(static_cast<std::size_t>(skipped), given.front());
  all.insert(all.end(), given.begin(), given.end());
  for (std::size_t k = 0; k < all.size(); ++k) all[k].id = static_cast<std::int64_t>(k);
  SimulationOptions truth = w.truth;
  truth.effects = effects;
  Session s = simulate_at(w.session, truth, all).session;
  s.observations.erase(s.observations.begin(), s.observations.begin() + skipped);
  return s;
}

/// Checks without a change: what is seen from the poses is simulated once, and each visit has noise of its own.
class QuietChecks {
 public:
  QuietChecks(const Watched& w, std::uint64_t seed) : noise_(noise_of(w.session)), random_(seed) {
    Watched exact = w;
    exact.truth.noise = 1e-9;
    session_ = visits(exact, 1, {}, 0);
    session_.sigma_pixel = w.session.sigma_pixel;
    session_.sigma_point = w.session.sigma_point;
    poses_ = std::move(session_.observations);
    session_.observations.clear();  // a step copies the session
  }

  /// Without noise.
  const std::vector<Observation>& poses() const { return poses_; }

  /// The session without observations, to whose poses they belong.
  const Session& session() const { return session_; }

  std::vector<Observation> next() {
    std::vector<Observation> check = poses_;
    for (Observation& o : check)
      for (Sighting& s : o.sightings) {
        for (CameraPoint& p : s.in_cameras) p.pixel += noise_ * Vector2(draw(), draw());
        if (s.point) *s.point += noise_ * Vector3(draw(), draw(), draw());
      }
    return check;
  }

 private:
  double draw() { return normal_(random_); }

  double noise_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Session session_;
  std::vector<Observation> poses_;
};

/// Of every twelve robots six are seen by a tracker, five by cameras that see three markers, one has a board.
Session drawn_robot(int number) {
  if (number % 12 == 0) return with_board();
  if (number % 2 == 0) return number % 4 == 0 ? fixture::stand_session(3) : fixture::seven_axis_session(4);
  return fixture::tracker_session(4);
}

/// A month's checks as a ChangeWatch makes them, but for two things: it is linearised in each pose once, as each
/// visit's noise only adds to the errors there, and what would have changed is not put into words.
struct Month {
  bool alarm = false;
  double largest = -1e300;  // ln of the e-value
};

Month make_month(const Watched& w, std::uint64_t seed, int hours) {
  WatchParts parts;
  parts.before = w.robot;
  parts.options.window = 5;
  QuietChecks exact(w, seed);
  std::vector<Recent> visits;
  for (const Observation& o : exact.poses()) {
    Matrix6 repeatability;
    Recent& visit = visits.emplace_back();
    visit.sums = parts.sums_of(exact.session(), o, repeatability);
    visit.pose = parts.locate(o.position, repeatability);
  }
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Month month;
  for (int hour = 0; hour < hours && !month.alarm; ++hour)
    for (Recent visit : visits) {
      PoseSums& sums = visit.sums;
      for (Eigen::Index row = 0; row < sums.error.size(); ++row) sums.error[row] += sums.count[row] * normal(random);
      sums.gradient = sums.rows.transpose() * sums.error;
      visit.number = parts.count++;
      visit.ln_weight = parts.rounds.next_ln_weight(visit.pose);
      if (visit.number == 0) parts.ln_first_weight = visit.ln_weight;
      parts.keep(std::move(visit));
      month.largest = std::max(month.largest, WatchParts::ln_e_value(parts.starts()));
      month.alarm = month.alarm || month.largest >= -std::log(parts.options.chance);
    }
  return month;
}

void try_months(int count, std::uint64_t first) {
  constexpr int hours = 720;
  int alarms = 0;
  double largest = -1e300;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const Month month = make_month(watched(seed, drawn_robot(i)), seed, hours);
    largest = std::max(largest, month.largest);
    alarms += month.alarm ? 1 : 0;
    const int done = i + 1;
    if (done % 100 == 0 || done == count)
      fmt::print(
          "{} months of {} checks of five poses without a change: {} false alarms, largest e-value {:.3g}; {:.2f} s of "
          "a processor each\n",
          done, hours, alarms, std::exp(largest),
          static_cast<double>(std::clock()) / CLOCKS_PER_SEC / static_cast<double>(done));
    std::fflush(stdout);
  }
}

/// A mean over robots and its standard error.
struct Mean {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double x) { sum += x, squares += x * x, ++count; }
  double mean() const { return sum / count; }
  double sigma() const { return std::sqrt((squares / count - mean() * mean()) / std::max(count - 1, 1)); }
};

/// Were a watch's unknowns drawn as it supposes, the square of each change's score would be 1 in the mean, and each
/// e-value as well. An e-value is a mean of exponentials of squared scores: where these are 1 at most in the mean (of
/// normal ones), its expectation is 1 at most too.
void try_scores(int count, std::uint64_t first) {
  constexpr int checks_each = 10;
  constexpr double loosely = 3;  // prior sigmas in which a watch holds a size that it reports
  std::map<std::string, Mean> scores;
  Mean e_values;
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const Watched w = watched(seed, drawn_robot(i));
    QuietChecks checks(w, seed);
    std::map<std::string, Mean> of_robot;
    Mean e_of_robot;
    for (int c = 0; c < checks_each; ++c) {
      ChangeWatch watch(w.robot, {.window = 5});
      std::optional<WatchStep> last;
      for (const Observation& o : checks.next()) last = watch.add(checks.session(), o);
      e_of_robot.add(std::exp(last->ln_e_value));
      largest = std::max(largest, std::exp(last->ln_e_value));
      for (const WatchedChange& change : last->each) {
        if (change.sigma.size() != 1) continue;
        const double size = loosely * term_effect(change.terms[0]).parameters[0].sigma;
        const double precision = 1 / (change.sigma[0] * change.sigma[0]), own = precision - 1 / (size * size);
        const double score = change.terms[0].values[0] * precision;
        if (own > 1e-3 * precision) of_robot[change.what + " " + change.where].add(score * score / own);
      }
    }
    e_values.add(e_of_robot.mean());
    for (const auto& [what, mean] : of_robot) scores[what].add(mean.mean());
  }
  fmt::print("{} robots, {} checks each without a change: mean e-value {:.4f} +- {:.4f}, largest {:.3g}\n", count,
             checks_each, e_values.mean(), e_values.sigma(), largest);
  for (const auto& [what, mean] : scores)
    fmt::print("  {:<24} squared score {:.3f} +- {:.3f} in the mean (1: as supposed, less: cautious), of {} robots\n",
               what, mean.mean(), mean.sigma(), mean.count);
}

/// In how many sigmas of the best estimate a change of one number shows, were it known what has changed and when.
double known_sigmas(const WatchStep& step, const EffectTerm& truth, const std::string& where) {
  for (const WatchedChange& c : step.each)
    if (c.what == truth.id && c.where == where) return std::abs(truth.values[0]) / c.sigma[0];
  return NAN;
}

/// The chance that a test of that one change, at a false alarm in 1000, sees it: no test sees more.
double power_of_best_test(double sigmas) {
  constexpr double at_one_in_1000 = 3.0902;
  return 0.5 * std::erfc((at_one_in_1000 - sigmas) / std::sqrt(2.0));
}

void try_changes(int count, std::uint64_t first) {
  std::map<std::string, std::vector<double>> best_power;
  std::map<std::string, std::array<int, 4>> tallies;  // all, seen, named, or said not to be distinguished
  for (int i = 0; i < count; ++i) {
    const Watched w = watched(first + 500 + static_cast<std::uint64_t>(i));
    std::mt19937_64 random(first + static_cast<std::uint64_t>(i));
    std::normal_distribution<double> normal;
    const auto direction = [&] {
      Vector3 v(normal(random), normal(random), normal(random));
      return Vector3(v.normalized());
    };
    const Chain chain = make_chain(w.session);
    std::vector<std::pair<std::string, EffectTerm>> changes;
    const auto add = [&](const std::string& kind, const std::string& id, int place, const std::vector<double>& values) {
      EffectTerm term = term_of(*find_effect(id), place);
      for (std::size_t p = 0; p < values.size(); ++p) term.values[p] = values[p];
      changes.emplace_back(kind, term);
    };
    Vector3 d = 5e-4 * direction();
    add("mount 0.5 mm", "camera_mount", -1, {d.x(), d.y(), d.z()});
    d = 0.1 * M_PI / 180 * direction();
    add("mount 0.1 degrees", "camera_mount", -1, {0, 0, 0, d.x(), d.y(), d.z()});
    const int joint = i % 3;
    add(fmt::format("zero of joint {} 0.2 mrad", joint + 1), "joint_offset",
        chain.joints[static_cast<std::size_t>(joint)], {normal(random) < 0 ? -2e-4 : 2e-4});
    d = 3e-4 * direction();
    add("hand 0.3 mm", "body_slip", -1, {d.x(), d.y(), d.z()});
    for (const auto& [kind, term] : changes) {
      ChangeWatch watch(w.robot);
      const Session before = visits(w, 10, {}, 100), after = visits(w, 1, {term}, 200);
      for (const Observation& o : before.observations) watch.add(before, o);
      std::optional<WatchStep> last;
      for (const Observation& o : after.observations) last = watch.add(after, o);
      fmt::print("{} {}: ln e-value {:.1f}, {}", first + static_cast<std::uint64_t>(i), kind, last->ln_e_value,
                 last->text);
      if (term.values.size() == 1) {
        const double sigmas = known_sigmas(*last, term, place_name(term_effect(term), term.place, chain.robot));
        best_power[kind].push_back(power_of_best_test(sigmas));
        fmt::print(" [{:.1f} sigmas; the best test sees {:.3f}]", sigmas, best_power[kind].back());
      }
      fmt::print("\n");
      std::fflush(stdout);
      auto& tally = tallies[kind];
      ++tally[0];
      tally[1] += last->changed ? 1 : 0;
      const auto& others = last->indistinguishable_from;
      const bool is_tied = std::find(others.begin(), others.end(), term.id) != others.end();
      const bool is_named = last->what == term.id &&
                            (term.place < 0 || last->where == place_name(term_effect(term), term.place, chain.robot));
      tally[2] += last->changed && is_named ? 1 : 0;
      tally[3] += last->changed && (is_named || is_tied) ? 1 : 0;
    }
  }
  for (const auto& [kind, tally] : tallies)
    fmt::print(
        "{:<28} {} changes after ten checks: seen within five poses {}, named right {}, or as not told apart {}\n",
        kind, tally[0], tally[1], tally[2], tally[3]);
  for (const auto& [kind, powers] : best_power)
    fmt::print("{:<28} a test that knows the joint and the moment sees {:.1f} of {}\n", kind,
               std::accumulate(powers.begin(), powers.end(), 0.0), powers.size());
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "changes";
  const int count = argc > 2 ? std::atoi(argv[2]) : 6;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (what == "months")
    try_months(count, seed);
  else if (what == "scores")
    try_scores(count, seed);
  else if (what == "changes")
    try_changes(count, seed);
  else
    return 2;
  return 0;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) { return handsight::run(argc, argv); }
