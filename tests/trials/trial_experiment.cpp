// SPDX-License-Identifier: Apache-2.0
// trial_experiment robots COUNT SEED [FROM [SIZE]]: simulated robots from a rough start, one hidden cause of SIZE (1)
//   prior sigmas or none; how many poses the loop needs for odds of 20, and how many random ones do that can be reached
//   and seen; how well the hand is known beside poses chosen with the truth known.
// trial_experiment ways COUNT SEED: ways between random postures, checked at twice finer steps.
// trial_experiment months COUNT SEED: rechecks once an hour for a month without a change.
// trial_experiment changes COUNT SEED: changes after ten checks, seen within the five poses of the next.
#include <fmt/core.h>
#include <sys/resource.h>

#include <chrono>
#include <map>
#include <numeric>

#include "chain/sighting.h"
#include "compare/change_watch.h"
#include "estimation/report/fit_report.h"
#include "experiment/loop/experiment.h"
#include "experiment/simulated/simulated_robot.h"
#include "fixtures/targets.h"
#include "fixtures/trial_sessions.h"

namespace handsight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_poses = 60, batch = 5;
constexpr double odds = 20;
constexpr int fewest_new = static_cast<int>(least_to_diagnose) - 2;  // poses after the start, at the first diagnosis

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One robot with what is hidden in it.
struct Case {
  Session like;
  SimulationOptions truth;
  std::string hidden;
};

Case drawn_case(int number, std::uint64_t seed, double size) {
  const int robot = number % 3;
  std::mt19937_64 random(seed);
  Case c{trials::robot_session(robot, seed), {}, "none"};
  c.truth.seed = seed;
  c.truth.noise = trials::sigma;
  const char* causes[] = {"joint_offset", "joint_elasticity", "joint_scale", "encoder_eccentricity", "none", "curve"};
  const std::string cause = causes[number / 3 % 6];
  c.hidden = cause;
  const Chain chain = make_chain(c.like);
  if (cause == "curve") {
    const int joint = chain.joints[random() % chain.joints.size()];
    c.truth.curves.push_back({joint, 1.5e-3, false, 3.3});
  } else if (cause != "none") {
    const Effect& effect = *find_effect(cause);
    std::vector<int> places = effect_places(effect, chain);
    EffectTerm term = term_of(effect, places[random() % places.size()]);
    std::normal_distribution<double> normal;
    for (std::size_t p = 0; p < term.values.size(); ++p)
      term.values[p] = (normal(random) < 0 ? -size : size) * effect.parameters[p].sigma;
    if (cause == "joint_elasticity") term.values[0] = std::abs(term.values[0]);
    c.truth.effects = {term};
  }
  return c;
}

Session make_start(const Case& c) {
  SimulationOptions options = c.truth;
  options.observations = 2;
  return simulate_session(c.like, options).session;
}

ExperimentOptions quiet(const std::string& until) {
  ExperimentOptions options;
  options.save = false;
  options.batch = batch;
  add_goals(until, options.until);
  return options;
}

/// Is what was found what was hidden?
bool is_right(const std::optional<SettledCause>& found, const Case& c) {
  return found && (c.hidden == "none" ? found->id.empty() : found->id == c.hidden);
}

/// The start's poses, then those drawn at random that are seen and touch nothing.
std::vector<Observation> random_poses(const Case& c) {
  const CollisionWorld world(make_chain(c.like), robot_solids(c.like), {}, {c.like.observations.back().position});
  std::vector<Observation> poses;
  for (const Observation& o : make_start(c).observations) poses.push_back(o);
  SimulationOptions options = c.truth;
  options.observations = 4 * most_poses;
  options.seed = c.truth.seed + 5000000;
  for (int draw = 0; draw < 20 && poses.size() < most_poses + 2; ++draw, options.seed += 1000000) {
    const Session many = simulate_session(c.like, options).session;
    for (const Observation& o : many.observations)
      if (!world.touching(o.position)) poses.push_back(o);
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].id = static_cast<std::int64_t>(k);
    poses[k].time = 5.0 * static_cast<double>(k);
    poses[k].velocity.resize(0);
  }
  poses.resize(std::min<std::size_t>(poses.size(), most_poses + 2));
  return poses;
}

/// Random poses one after another until the cause is settled, by the loop's own rules; how many.
int random_poses_needed(const Case& c, std::optional<SettledCause>& settled) {
  const Session all = simulate_at(c.like, c.truth, random_poses(c)).session;
  int adequate_in_a_row = 0;
  for (std::size_t count = least_to_diagnose; count <= all.observations.size();
       count += count < least_for_none ? 1 : batch) {
    Session some = all;
    some.observations.resize(count);
    const Knowledge known = assess_knowledge(some, {}, true, {});
    if (!known.settled) continue;
    const bool is_none = known.settled->id.empty() && known.diagnosis->verdict == Verdict::adequate;
    if (is_none && known.used >= least_for_none && known.settled->odds >= 1) ++adequate_in_a_row;
    if (!is_none) adequate_in_a_row = 0;
    if (is_none ? adequate_in_a_row >= 2 : !known.settled->id.empty() && known.settled->odds >= odds) {
      settled = known.settled;
      return static_cast<int>(count) - 2;
    }
  }
  return most_poses;
}

/// How large the hidden cause is in as many random poses as are allowed, were nothing else wrong: chi-squared of what a
/// fit without it leaves.
double shown_by(const Case& c) {
  SimulationOptions options = c.truth;
  options.observations = most_poses;
  options.noise = 1e-6;
  options.declare_noise = false;
  const Session session = simulate_session(c.like, options).session;
  double rows = 0;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings) rows += row_count(s);
  return rows * std::pow(fit(session).residual_rms / trials::sigma, 2);
}

void try_robots(int count, std::uint64_t first, int from, double size) {
  std::vector<double> of_causes, where_poses_count, of_none, hands,
      choices;                                      // poses by the loop over random ones; the rest
  std::map<std::string, std::array<int, 3>> named;  // all, right by the loop, right by random poses
  for (int i = from; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const Case c = drawn_case(i, seed, size);
    const auto start = Clock::now();
    SimulatedRobot robot(c.like, {.truth = c.truth});
    const ExperimentResult loop =
        run_experiment(make_start(c), robot, quiet(fmt::format("odds={}|count={}", odds, most_poses)));
    const double seconds = seconds_since(start);
    std::optional<SettledCause> by_random;
    const int random_count = random_poses_needed(c, by_random);
    auto& tally = named[c.hidden];
    ++tally[0];
    tally[1] += is_right(loop.settled, c) ? 1 : 0;
    tally[2] += is_right(by_random, c) ? 1 : 0;
    const double ratio = static_cast<double>(loop.observations) / random_count;
    if (loop.settled || by_random) (c.truth.effects.empty() ? of_none : of_causes).push_back(ratio);
    if (by_random && !c.truth.effects.empty() && random_count > fewest_new) where_poses_count.push_back(ratio);
    choices.push_back(loop.longest_choice);
    double hand = NAN;
    // The hand beside as many poses that are chosen with the truth as the model.
    if (!c.truth.effects.empty()) {
      ExperimentOptions with_truth = quiet(fmt::format("count={}", loop.observations));
      with_truth.model.estimated = c.truth.effects;
      SimulatedRobot again(c.like, {.truth = c.truth});
      const ExperimentResult ideal = run_experiment(make_start(c), again, with_truth);
      const Fit by_loop = fit(loop.session, {.estimated = c.truth.effects});
      const Chain chain = make_chain(c.like);
      const Reach reach{chain,
                        {chain, robot_solids(c.like), {}, {c.like.observations.back().position}},
                        joint_ranges(chain, {}),
                        {},
                        {}};
      const auto poses = poses_to_judge_by(loop.session, by_loop, reach, 200, 99);
      const auto a = hand_limit(by_loop, poses);
      const auto b = ideal.known.fit ? hand_limit(*ideal.known.fit, poses) : std::nullopt;
      if (a && b) hands.push_back(hand = *a / *b);
    }
    fmt::print(
        "{} robot {} {:<22} chi2 {:<8.3g} {:<8} loop {:>2} poses ({}), random {:>2} ({}), {:.1f} s, choice {:.2f} s a "
        "pose, hand {:.3f}\n",
        seed, i % 3, c.hidden, shown_by(c), end_name(loop.end), loop.observations,
        loop.settled ? (loop.settled->id.empty() ? "none" : loop.settled->id) : "-", random_count,
        by_random ? (by_random->id.empty() ? "none" : by_random->id) : "-", seconds, loop.longest_choice, hand);
    if (!loop.settled && loop.known.diagnosis)
      fmt::print("     {}: {} by odds of {:.2g}, best {} {:.1f} of {:.1f}\n",
                 verdict_text(loop.known.diagnosis->verdict),
                 loop.known.settled->id.empty() ? "none" : loop.known.settled->id, loop.known.settled->odds,
                 loop.known.diagnosis->candidates.empty() ? "-" : loop.known.diagnosis->candidates[0].id,
                 loop.known.diagnosis->candidates.empty() ? 0 : loop.known.diagnosis->candidates[0].ln_bayes_factor,
                 loop.known.diagnosis->threshold);
    std::fflush(stdout);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  for (const auto& [cause, tally] : named)
    fmt::print("{:<22} {} robots, right by the loop {}, by random poses {}\n", cause, tally[0], tally[1], tally[2]);
  fmt::print(
      "poses of the loop by random ones: causes median {:.2f} of {} ({:.2f} of the {} that random ones did not show at "
      "the first diagnosis), no effect {:.2f} of {}; hand by poses of the "
      "known "
      "truth: median {:.3f}, at most {:.3f}; choice: median {:.2f} s, at most {:.2f} s a pose; {} MB\n",
      median(of_causes), of_causes.size(), median(where_poses_count), where_poses_count.size(), median(of_none),
      of_none.size(), median(hands), hands.empty() ? NAN : *std::max_element(hands.begin(), hands.end()),
      median(choices), *std::max_element(choices.begin(), choices.end()), usage.ru_maxrss / 1024);
}

void try_ways(int count, std::uint64_t seed) {
  int found = 0, round = 0, touched = 0, tried = 0;
  double longest = 0;
  const auto start = Clock::now();
  for (int robot = 0; robot < 3; ++robot) {
    const Session like = trials::robot_session(robot, seed);
    const Chain chain = make_chain(like);
    Cell cell;
    if (robot > 0) cell.boxes.push_back({{0.1, 0.1, 1.2}, {Matrix3::Identity(), {0.35, 0.25, 0.6}}});
    const Eigen::VectorXd home = like.observations.back().position;
    const CollisionWorld world(chain, robot_solids(like), cell, {home});
    const JointRanges ranges = joint_ranges(chain, {home});
    std::mt19937_64 random(seed + static_cast<std::uint64_t>(robot));
    std::uniform_real_distribution<double> uniform(0, 1);
    Eigen::VectorXd from = home;
    for (int i = 0; i < count / 3;) {
      Eigen::VectorXd to = ranges.lower;
      for (Eigen::Index j = 0; j < to.size(); ++j) to[j] += uniform(random) * (ranges.upper[j] - ranges.lower[j]);
      if (world.touching(to)) continue;
      ++i;
      ++tried;
      const auto began = Clock::now();
      const auto way = way_between(world, chain, ranges, from, to);
      longest = std::max(longest, seconds_since(began));
      if (!way) continue;
      ++found;
      round += way->size() > 1 ? 1 : 0;
      for (const Eigen::VectorXd& point : *way) {
        for (const Eigen::VectorXd& q : steps_between(world, chain, from, point, 2))
          touched += world.touching(q, false) ? 1 : 0;
        from = point;
      }
    }
  }
  fmt::print(
      "{} ways of {} asked for, {} round something; steps that touch at twice finer steps: {}; longest search {:.2f} "
      "s; "
      "{:.0f} s in all\n",
      found, tried, round, touched, longest, seconds_since(start));
}

struct Watched {
  Session session;
  CalibratedRobot robot;
  std::vector<Eigen::VectorXd> poses;
  SimulationOptions truth;
};

/// A six-axis arm with a board, calibrated by 60 poses; five poses to recheck in.
Watched watched(std::uint64_t seed) {
  Watched w;
  Session like = fixture::target_session(fixture::charuco(), 2);
  w.truth.observations = 60;
  w.truth.seed = seed;
  w.truth.noise = 0.1;
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

void try_months(int count, std::uint64_t first) {
  constexpr int hours = 720;
  int alarms = 0;
  double largest = -1e300;
  for (int i = 0; i < count; ++i) {
    const Watched w = watched(first + static_cast<std::uint64_t>(i));
    const Session month = visits(w, hours, {}, 100);
    Session watched_by = month;
    watched_by.observations.clear();  // a step copies the session
    ChangeWatch watch(w.robot, {.window = 5});
    bool alarm = false;
    for (const Observation& o : month.observations) {
      const auto step = watch.add(watched_by, o);
      largest = std::max(largest, step->ln_e_value);
      alarm = alarm || step->changed;
    }
    alarms += alarm ? 1 : 0;
  }
  fmt::print("{} months of {} checks of five poses without a change: {} false alarms, largest e-value {:.3g}\n", count,
             hours, alarms, std::exp(largest));
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
  const std::string what = argc > 1 ? argv[1] : "robots";
  const int count = argc > 2 ? std::atoi(argv[2]) : 6;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (what == "robots")
    try_robots(count, seed, argc > 4 ? std::atoi(argv[4]) : 0, argc > 5 ? std::atof(argv[5]) : 1);
  else if (what == "ways")
    try_ways(count, seed);
  else if (what == "months")
    try_months(count, seed);
  else if (what == "changes")
    try_changes(count, seed);
  else
    return 2;
  return 0;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) { return handsight::run(argc, argv); }
