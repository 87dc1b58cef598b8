// SPDX-License-Identifier: Apache-2.0
// Pairs of sessions of one robot with one change between them, or none: is it named, and is nothing named where nothing
// is? Half of the robots have effects that the model does not know, the same in both sessions.
// trial_compare COUNT [FIRST_SEED] [ROBOT] [KIND: all, or a change's id]; "five" compares a calibration with five poses
#include <fmt/format.h>

#include <cstdio>
#include <map>

#include "estimation/export.h"
#include "estimation/fit_report.h"
#include "fixtures/trial_sessions.h"
#include "ways/comparison.h"

namespace handsight::trials {
namespace {

struct Hidden {
  const char *group, *effect;
};
constexpr Hidden hidden[] = {{"", ""},
                             {"camera_mount", "camera_mount"},
                             {"stereo_rig", "stereo_rig"},
                             {"body_slip", "body_slip"},
                             {"marker_slip", "marker_slip"},
                             {"joint_offset", "joint_offset"},
                             {"payload", "payload"},
                             {"lens", "lens_distortion"},
                             {"lens", "camera_intrinsics"}};

struct Pair {
  Session before, after;
  std::vector<EffectTerm> change;
};

std::vector<EffectTerm> drawn_change(const Effect& e, const Chain& chain, std::mt19937_64& random) {
  std::vector<EffectTerm> terms = random_terms(e, chain, random);
  if (terms.size() > 1) terms.erase(terms.begin() + 1, terms.end());
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      if (e.parameters[p].is_choice)
        t.values[p] = 0;
      else
        t.values[p] *= 0.3;  // 0.1 to 1 of the plausible size: what weeks do
    }
  return terms;
}

/// How strongly the pair shows its change: the chi-squared that the true change takes away, against the scatter that
/// the comparison counts with. 0 where it was not among those that were fitted in full.
double shown(const Comparison& c, const std::string& truth) {
  for (const Change& change : c.changes)
    if (change.id == truth) return change.explained;
  return 0;
}

Pair drawn_pair(int robot, std::uint64_t seed, const Hidden& what, bool imperfect) {
  std::mt19937_64 random(seed * 7919 + 13);
  const Session like = robot_session(robot, seed);
  const Chain chain = chain_of(like);
  std::vector<EffectTerm> unknown;
  if (imperfect)
    for (const char* id : {"joint_elasticity", "encoder_eccentricity"})
      for (const EffectTerm& t : random_terms(*find_effect(id), chain, random)) unknown.push_back(t);
  Pair pair;
  SimulationOptions o = simulation(seed + 300000, robot);
  o.effects = unknown;
  if (what.effect[0]) pair.change = drawn_change(*find_effect(what.effect), chain, random);
  // The same hand, other poses, other noise: simulated with the same seed for markers is not at hand, so that the
  // second session is cut from one simulation of twice as many observations, in which the change comes after the first
  // half.
  SimulationOptions both = o;
  both.observations = 2 * observations;
  const SimulatedSession without = simulate_session(like, both);
  both.effects.insert(both.effects.end(), pair.change.begin(), pair.change.end());
  const SimulatedSession with = simulate_session(like, both);
  pair.before = without.session;
  pair.after = with.session;
  pair.before.observations.resize(observations);
  pair.after.observations.erase(pair.after.observations.begin(), pair.after.observations.begin() + observations);
  return pair;
}

struct Row {
  int pairs = 0, named = 0, ambiguous = 0, wrong = 0, missed = 0, weak = 0;
};

std::string found_in(const Comparison& c) {
  return c.verdict == ComparisonVerdict::unchanged ? "" : c.changes.front().id;
}

/// The last five observations against the calibration of the first session.
Comparison with_five_poses(const Pair& pair) {
  const Fit f = fit(pair.before);
  const FitOptions options;
  const CalibratedRobot robot = calibrated_robot(pair.before, f, report(pair.before, f, options), options, "trial");
  Session five = pair.after;
  five.observations.erase(five.observations.begin() + 5, five.observations.end());
  return compare(robot, five);
}

int compare_trials(const Arguments& a) {
  const bool five = a.kind == "five";
  std::map<std::string, Row> rows[2];
  for (int i = 0; i < a.count; ++i) {
    const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
    const int robot = a.robot >= 0 ? a.robot : i % 3;
    const Hidden& what = hidden[static_cast<std::size_t>(i / 3) % std::size(hidden)];
    if (a.kind != "all" && !five && a.kind != what.group) continue;
    const bool imperfect = (i / 27) % 2 == 1;
    const Pair pair = drawn_pair(robot, seed, what, imperfect);
    const Comparison c = five ? with_five_poses(pair) : compare(pair.before, pair.after);
    const std::string found = found_in(c), truth = what.group;
    Row& row = rows[imperfect][truth.empty() ? "nothing" : truth];
    ++row.pairs;
    const double noncentrality = shown(c, truth);
    const bool strong = truth.empty() || noncentrality >= 50;
    const bool tied = std::count(c.cannot_be_told_from.begin(), c.cannot_be_told_from.end(), truth) > 0;
    if (!strong)
      ++row.weak;
    else if (found == truth)
      ++row.named;
    else if (tied)
      ++row.ambiguous;
    else if (found.empty())
      ++row.missed;
    else
      ++row.wrong;
    if (strong && found != truth)
      fmt::print("  robot {} seed {}{}: {} (noncentrality {:.0f}), found {} ({:.1f}; threshold {:.1f}): {}\n", robot,
                 seed, imperfect ? ", imperfect model" : "", truth.empty() ? "nothing" : truth, noncentrality,
                 found.empty() ? "nothing" : found, c.changes.empty() ? 0.0 : c.changes.front().ln_bayes_factor,
                 c.threshold, c.sentence);
    std::fflush(stdout);
  }
  for (const int imperfect : {0, 1})
    for (const auto& [name, r] : rows[imperfect])
      fmt::print("{} model, {}: {} pairs, {} named, {} tied with another, {} missed, {} wrong, {} weaker than 50\n",
                 imperfect ? "imperfect" : "right", name, r.pairs, r.named, r.ambiguous, r.missed, r.wrong, r.weak);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  return compare_trials(arguments(argc, argv, "all"));
}
