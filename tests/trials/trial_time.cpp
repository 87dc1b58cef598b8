// SPDX-License-Identifier: Apache-2.0
// How long `improve` takes on sessions like an industrial arm's before a laser tracker: 250 poses, three points,
// effects small and large, and a shift of the hand that only a curve can follow. In units of a `fit` of 1000
// observations, which is measured beside every session. trial_time COUNT [FIRST_SEED] [--markdown]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <set>

#include "estimation/fit/fit.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

constexpr int measured = 250, of_fit = 1000;
constexpr double tracker_sigma = 2e-5, repeatability = 2e-5;  // m; rad
constexpr double shift_mm = 0.03, mass_error = 0.1;

struct Time {
  double processor = 0, clock = 0;  // s
};

template <class Act>
Time time_of(const Act& act) {
  const std::clock_t processor = std::clock();
  const auto clock = std::chrono::steady_clock::now();
  act();
  return {static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count()};
}

/// Five to nine effects of the robot, 0.1 to 3 of the usual size.
std::vector<EffectTerm> hidden_effects(const Session& like, std::mt19937_64& random) {
  const Chain chain = make_chain(like);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::size_t count = 5 + random() % 5;
  std::set<std::string> ids;
  std::vector<EffectTerm> all;
  while (ids.size() < count) {
    const Effect& e = catalogue()[random() % catalogue().size()];
    const bool has_moment = std::any_of(e.parameters.begin(), e.parameters.end(),
                                        [](const EffectParameter& p) { return p.is_choice && p.choices.empty(); });
    if (has_moment || ids.contains(e.id)) continue;
    std::vector<EffectTerm> terms = random_terms(e, chain, random);
    if (terms.empty()) continue;
    const double size = 0.33 * std::pow(3.0, uniform(random));
    for (EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!e.parameters[p].is_choice) t.values[p] *= size;
    ids.insert(e.id);
    all.insert(all.end(), terms.begin(), terms.end());
  }
  return all;
}

Session arm_before_a_tracker(std::uint64_t seed) {
  std::mt19937_64 random(seed * 6364136223846793005u + 41);
  std::normal_distribution<double> normal;
  Session like = fixture::tracker_session();
  like.mount.estimate = true;
  Session real = like;
  for (Link& link : real.robot.links) link.mass *= 1 + mass_error * normal(random);
  SimulationOptions o;
  o.observations = measured;
  o.seed = seed + 90000;
  o.noise = tracker_sigma;
  o.farthest = 4;
  o.effects = hidden_effects(like, random);
  o.effects.push_back(*hidden_shift(like, shift_mm, random));
  Session session = simulate_session(real, o).session;
  session.robot = like.robot;
  for (Observation& observation : session.observations)
    for (Eigen::Index j = 0; j < observation.position.size(); ++j)
      observation.position[j] += repeatability * normal(random);
  return session;
}

/// The fastest of some: the others were disturbed.
Time time_of_fit(const Session& session) {
  constexpr int times = 15;
  Time best{1e300, 1e300};
  for (int i = 0; i < times; ++i) {
    const Time t = time_of([&] { fit(session); });
    best = {std::min(best.processor, t.processor), std::min(best.clock, t.clock)};
  }
  return best;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.size() % 2 ? v[v.size() / 2] : 0.5 * (v[v.size() / 2 - 1] + v[v.size() / 2]);
}

void run(int count, std::uint64_t first, const TableOutput& output) {
  SimulationOptions thousand;
  thousand.observations = of_fit;
  const Session session_of_fit = simulate_session(fixture::stand_session(), thousand).session;
  std::vector<double> processor, clock;
  for (int i = 0; i < count; ++i) {
    const Session session = arm_before_a_tracker(first + static_cast<std::uint64_t>(i));
    const Time unit = time_of_fit(session_of_fit);
    Improvement m;
    const Time t = time_of([&] { m = improve(session); });
    processor.push_back(t.processor / unit.processor);
    clock.push_back(t.clock / unit.clock);
    fmt::print(
        "  seed {}: {:.1f} s of processor time, {:.1f} s by the clock; fit {:.2f} ms; {:.0f} and {:.0f} fits; "
        "{} steps, {} models, {}\n",
        first + static_cast<std::uint64_t>(i), t.processor, t.clock, 1e3 * unit.processor, processor.back(),
        clock.back(), m.steps.size() - 1, m.models, verdict_text(m.last.verdict));
    std::fflush(stdout);
  }
  Table table({{"`improve`, 250 poses, three points, in fits of 1000 observations"}, {"median"}, {"worst"}}, output);
  const auto worst = [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); };
  table.print({fmt::format("processor time, {} sessions", count), median(processor), worst(processor)});
  table.print({"by the clock", median(clock), worst(clock)});
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  const auto output = handsight::trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
  handsight::trials::run(count, argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1, output);
}
