// SPDX-License-Identifier: Apache-2.0
// What few poses of real sessions say of causes, beside what all of their poses say.
// trial_few_poses POSES DRAWS SEED SESSION...
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <numeric>
#include <random>

#include "diagnosis/selection/improvement.h"
#include "estimation/report/fit_report.h"
#include "session/sample.h"
#include "session/session_xml.h"

namespace handsight::trials {
namespace {

constexpr int folds = 5;

/// Probabilities of the names of the catalogue in the model.
std::map<std::string, double> names_of(const Improvement& m) {
  std::map<std::string, double> names;
  for (const InclusionProbability& n : m.inclusion_probabilities.names)
    if (n.is_in_model && !n.id.starts_with("curve_")) names[n.id] = n.probability;
  return names;
}

Improvement quiet_improvement(const Session& session) {
  ImprovementOptions o;
  o.with_choosing = false;
  return improve(session, o);
}

/// Of so many used observations, drawn, in order of time.
std::vector<int> drawn_observations(const Session& session, int count, std::mt19937_64& random) {
  std::vector<int> all(session.observations.size());
  std::iota(all.begin(), all.end(), 0);
  std::erase_if(all, [&](int i) { return !is_used(session.observations[static_cast<std::size_t>(i)]); });
  std::shuffle(all.begin(), all.end(), random);
  all.resize(std::min(all.size(), static_cast<std::size_t>(count)));
  std::sort(all.begin(), all.end());
  return all;
}

/// How often each name is chosen where a fifth of the observations takes no part.
std::map<std::string, int> times_chosen(const Session& session, const std::vector<int>& drawn) {
  std::map<std::string, int> times;
  for (int fold = 0; fold < folds; ++fold) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      if (static_cast<int>(i) / 4 % folds != fold) kept.push_back(drawn[i]);
    for (const auto& [id, probability] : names_of(quiet_improvement(take_part(session, kept)))) ++times[id];
  }
  return times;
}

/// Names told of few poses: how many, and how many of them all poses have too.
struct Tally {
  int names = 0, held = 0;
};

int few_poses(int poses, int draws, std::uint64_t seed, const std::vector<std::string>& folders) {
  std::map<int, std::array<Tally, folds + 1>> by_probability;  // per cent, at least
  for (const std::string& folder : folders) {
    const Session session = read_session(folder);
    const std::map<std::string, double> whole = names_of(quiet_improvement(session));
    fmt::print("{}:", folder);
    for (const auto& [id, probability] : whole) fmt::print(" {} {:.3f}", id, probability);
    fmt::print("\n");
    std::mt19937_64 random(seed);
    for (int draw = 0; draw < draws; ++draw) {
      const std::vector<int> drawn = drawn_observations(session, poses, random);
      const std::map<std::string, double> names = names_of(quiet_improvement(take_part(session, drawn)));
      const std::map<std::string, int> times = times_chosen(session, drawn);
      fmt::print("  draw {}:", draw);
      for (const auto& [id, probability] : names) {
        const int chosen = times.contains(id) ? times.at(id) : 0;
        const bool is_held = whole.contains(id);
        fmt::print(" {} {:.3f} {}/{}{}", id, probability, chosen, folds, is_held ? "" : " (not of all)");
        for (const int least : {50, 80, 95, 99})
          if (100 * probability >= least) {
            Tally& tally = by_probability[least][static_cast<std::size_t>(chosen)];
            ++tally.names;
            tally.held += is_held;
          }
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
  }
  for (const auto& [least, by_times] : by_probability)
    for (int chosen = 0; chosen <= folds; ++chosen) {
      const Tally& t = by_times[static_cast<std::size_t>(chosen)];
      if (t.names > 0)
        fmt::print("told as {} % and more, chosen in {} of {} folds: all poses have it too {} of {}\n", least, chosen,
                   folds, t.held, t.names);
    }
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "trial_few_poses POSES DRAWS SEED SESSION...\n");
    return 2;
  }
  return handsight::trials::few_poses(std::atoi(argv[1]), std::atoi(argv[2]), std::strtoull(argv[3], nullptr, 10),
                                      {argv + 4, argv + argc});
}
