// SPDX-License-Identifier: Apache-2.0
// trial_experiment robots COUNT SEED [FROM [SIZE]]: simulated robots from a rough start, one hidden cause of SIZE (1)
//   prior sigmas or none; how many poses the loop needs for odds of 20, and how many random ones do that can be reached
//   and seen; how well the hand is known beside poses chosen with the truth known.
// trial_experiment wrist COUNT SEED [FROM [SIZE]]: the same of six axes with a camera on the hand, before a board.
//
// trial_experiment knowing COUNT SEED [FROM [SIZE [LEAST]]]: poses of the loop beside those of one who knows what is
//   hidden and random ones; causes of a chi-squared of LEAST and more.
//
// trial_experiment ways COUNT SEED: ways between random postures, checked at twice finer steps.
#include <fmt/core.h>
#include <sys/resource.h>

#include <chrono>
#include <map>

#include "chain/sighting.h"
#include "estimation/report/fit_report.h"
#include "experiment/loop/experiment.h"
#include "experiment/loop/settling.h"
#include "experiment/simulated/simulated_robot.h"
#include "fixtures/targets.h"
#include "fixtures/trial_sessions.h"
#include "knowing_poses.h"

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

constexpr int robots = 3;  // and one with a camera on its hand, by itself

Session like_of(int robot, std::uint64_t seed) {
  if (robot < robots) return trials::robot_session(robot, seed);
  Session s = fixture::eye_in_hand_session();
  s.mount.estimate = true;
  s.sigma_pixel.reset();
  return s;
}

Case drawn_case(int robot, int cause_number, std::uint64_t seed, double size) {
  std::mt19937_64 random(seed);
  Case c{like_of(robot, seed), {}, "none"};
  c.truth.seed = seed;
  c.truth.noise = trials::sigma;
  const char* causes[] = {"joint_offset", "joint_elasticity", "joint_scale", "encoder_eccentricity", "none", "curve"};
  const std::string cause = causes[cause_number % 6];
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

std::string cause_text(const std::optional<SettledCause>& found) {
  return !found ? "-" : found->follows ? "curve" : found->id.empty() ? "none" : found->id;
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
  return found && (c.hidden == "none"    ? found->id.empty() && !found->follows
                   : c.hidden == "curve" ? found->follows.has_value()
                                         : found->id == c.hidden);
}

/// The start's poses, then `count` drawn at random that are seen and touch nothing.
std::vector<Observation> random_poses(const Case& c, std::size_t count = most_poses) {
  const CollisionWorld world(make_chain(c.like), robot_solids(c.like), {}, {c.like.observations.back().position});
  std::vector<Observation> poses;
  for (const Observation& o : make_start(c).observations) poses.push_back(o);
  SimulationOptions options = c.truth;
  options.observations = 4 * most_poses;
  options.seed = c.truth.seed + 5000000;
  for (int draw = 0; draw < 20 && poses.size() < count + 2; ++draw, options.seed += 1000000) {
    const Session many = simulate_session(c.like, options).session;
    for (const Observation& o : many.observations)
      if (!world.touching(o.position)) poses.push_back(o);
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].id = static_cast<std::int64_t>(k);
    poses[k].time = 5.0 * static_cast<double>(k);
    poses[k].velocity.resize(0);
  }
  poses.resize(std::min<std::size_t>(poses.size(), count + 2));
  return poses;
}

/// The start's poses, then of many random ones those that he would take who knows what is hidden. Nothing where nothing
/// is, or no effect of the catalogue.
std::vector<Observation> knowing_poses(const Case& c) {
  constexpr std::size_t many = 300;
  if (c.truth.effects.empty()) return {};
  const std::vector<Observation> pool = random_poses(c, many);
  SimulationOptions clean = c.truth;
  clean.effects.clear();
  clean.noise = 1e-6;
  clean.declare_noise = false;
  trials::KnowingChoice choice(simulate_at(c.like, clean, pool).session, c.truth.effects[0], 2);
  if (!choice.knows()) return {};
  std::vector<Observation> poses{pool[0], pool[1]};
  while (poses.size() < most_poses + 2)
    if (const auto next = choice.take())
      poses.push_back(pool[*next]);
    else
      break;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].id = static_cast<std::int64_t>(k);
    poses[k].time = 5.0 * static_cast<double>(k);
  }
  return poses;
}

/// These poses one after another until the cause is settled, by the loop's own rules; how many.
int poses_needed(const Case& c, const std::vector<Observation>& poses, std::optional<SettledCause>& settled) {
  const Session all = simulate_at(c.like, c.truth, poses).session;
  Settling settling(odds);
  for (std::size_t count = least_to_diagnose; count <= all.observations.size();
       count += count < least_for_none ? 1 : batch) {
    Session some = all;
    some.observations.resize(count);
    const Knowledge known = assess_knowledge(some, {}, true, {});
    if (settling.is_settled_by(known)) {
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

/// The robots in turn, or with a camera on the hand alone.
void try_robots(int count, std::uint64_t first, int from, double size, bool on_hand) {
  std::vector<double> of_causes, where_poses_count, of_none, hands,
      choices;                                      // poses by the loop over random ones; the rest
  int names_told = 0, names_wrong = 0;              // by the loop
  std::map<std::string, std::array<int, 3>> named;  // all, right by the loop, right by random poses
  for (int i = from; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const int robot = on_hand ? robots : i % robots;
    const Case c = drawn_case(robot, on_hand ? i : i / robots, seed, size);
    const auto start = Clock::now();
    SimulatedRobot driven(c.like, {.truth = c.truth});
    const ExperimentResult loop =
        run_experiment(make_start(c), driven, quiet(fmt::format("odds={}|count={}", odds, most_poses)));
    const double seconds = seconds_since(start);
    std::optional<SettledCause> by_random;
    const int random_count = poses_needed(c, random_poses(c), by_random);
    auto& tally = named[c.hidden];
    ++tally[0];
    if (loop.settled && !loop.settled->id.empty()) {
      ++names_told;
      names_wrong += is_right(loop.settled, c) ? 0 : 1;
    }
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
        seed, robot, c.hidden, shown_by(c), end_name(loop.end), loop.observations, cause_text(loop.settled),
        random_count, cause_text(by_random), seconds, loop.longest_choice, hand);
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
  fmt::print("names told by the loop: {}, wrong {}\n", names_told, names_wrong);
  fmt::print(
      "poses of the loop by random ones: causes median {:.2f} of {} ({:.2f} of the {} that random ones did not show at "
      "the first diagnosis), no effect {:.2f} of {}; hand by poses of the "
      "known "
      "truth: median {:.3f}, at most {:.3f}; choice: median {:.2f} s, at most {:.2f} s a pose; {} MB\n",
      median(of_causes), of_causes.size(), median(where_poses_count), where_poses_count.size(), median(of_none),
      of_none.size(), median(hands), hands.empty() ? NAN : *std::max_element(hands.begin(), hands.end()),
      median(choices), *std::max_element(choices.begin(), choices.end()), usage.ru_maxrss / 1024);
}

/// How many poses of the loop, of one who knows what is hidden, and of random ones settle the cause.
void try_knowing(int count, std::uint64_t first, int from, double size, double least_shown) {
  std::vector<double> loop_by_random, knowing_by_random, loop_by_knowing;
  std::array<int, 3> right{};
  int all = 0;
  for (int i = from; i < count; ++i) {
    const Case c = drawn_case(i % robots, i / robots, first + static_cast<std::uint64_t>(i), size);
    const double shown = c.truth.effects.empty() ? 0 : shown_by(c);
    if (shown < least_shown) continue;
    const std::vector<Observation> knowing = knowing_poses(c);
    if (knowing.empty()) continue;
    std::optional<SettledCause> by_random, by_knowing;
    const int random_count = poses_needed(c, random_poses(c), by_random);
    const int knowing_count = poses_needed(c, knowing, by_knowing);
    SimulatedRobot robot(c.like, {.truth = c.truth});
    const ExperimentResult loop =
        run_experiment(make_start(c), robot, quiet(fmt::format("odds={}|count={}", odds, most_poses)));
    right[0] += is_right(loop.settled, c) ? 1 : 0;
    right[1] += is_right(by_knowing, c) ? 1 : 0;
    right[2] += is_right(by_random, c) ? 1 : 0;
    ++all;
    if (is_right(loop.settled, c) && is_right(by_knowing, c) && is_right(by_random, c)) {
      loop_by_random.push_back(static_cast<double>(loop.observations) / random_count);
      knowing_by_random.push_back(static_cast<double>(knowing_count) / random_count);
      loop_by_knowing.push_back(static_cast<double>(loop.observations) / knowing_count);
    }
    const auto name = [](const std::optional<SettledCause>& s) { return !s ? "-" : s->id.empty() ? "none" : s->id; };
    fmt::print("{} robot {} {:<22} chi2 {:<8.3g} loop {:>2} poses ({}), who knows {:>2} ({}), random {:>2} ({})\n",
               c.truth.seed, i % 3, c.hidden, shown, loop.observations, name(loop.settled), knowing_count,
               name(by_knowing), random_count, name(by_random));
    std::fflush(stdout);
  }
  fmt::print(
      "{} robots, named right by the loop {}, who knows {}, by random poses {}; of the {} that all name right: loop by "
      "random "
      "ones {:.2f} in the median, who knows by random ones {:.2f}, loop by who knows {:.2f}\n",
      all, right[0], right[1], right[2], loop_by_random.size(), median(loop_by_random), median(knowing_by_random),
      median(loop_by_knowing));
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

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "robots";
  const int count = argc > 2 ? std::atoi(argv[2]) : 6;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (what == "robots" || what == "wrist")
    try_robots(count, seed, argc > 4 ? std::atoi(argv[4]) : 0, argc > 5 ? std::atof(argv[5]) : 1, what == "wrist");
  else if (what == "knowing")
    try_knowing(count, seed, argc > 4 ? std::atoi(argv[4]) : 0, argc > 5 ? std::atof(argv[5]) : 1,
                argc > 6 ? std::atof(argv[6]) : 0);
  else if (what == "ways")
    try_ways(count, seed);
  else
    return 2;
  return 0;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) { return handsight::run(argc, argv); }
