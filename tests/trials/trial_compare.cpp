// SPDX-License-Identifier: Apache-2.0
// Pairs of sessions of one robot with one change between them, or none: is it named, and is nothing named where nothing
// is? A third of the robots have effects of the catalogue that the model does not know, the same in both sessions; a
// third besides have masses that are wrong by 12 % and a shift of the hand by 0.3 mm an axis that no catalogue has.
// trial_compare COUNT [FIRST_SEED] [ROBOT] [KIND: all, or a change's id]; "five" compares a calibration with five
// poses. ROBOT 3, the usual: another robot and other cameras in every pair. [--markdown]
#include <fmt/format.h>

#include <cstdio>
#include <map>

#include "compare/comparison.h"
#include "estimation/report/export.h"
#include "estimation/report/fit_report.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

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

enum class Model { right, lacking, outside };
constexpr const char* model_names[] = {"right", "lacking", "outside"};

struct Pair {
  Session before, after;
  std::vector<EffectTerm> change;
  std::vector<EffectTerm> unknown;  // in both, not in the model
};

std::vector<EffectTerm> drawn_change(const Effect& e, const Chain& chain, std::mt19937_64& random) {
  std::vector<EffectTerm> terms = random_terms(e, chain, random);
  if (terms.size() > 1) terms.erase(terms.begin() + 1, terms.end());
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      if (e.parameters[p].is_choice)
        t.values[p] = 0;
      else
        t.values[p] *= 0.3;  // 0.1 to 1 of the prior sigma: what weeks do
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

Pair drawn_pair(int robot, std::uint64_t seed, const Hidden& what, Model model) {
  std::mt19937_64 random(seed * 7919 + 13);
  const Session like = robot_session(robot, seed);
  const Chain chain = make_chain(like);
  Pair pair;
  if (model != Model::right)
    for (const char* id : {"joint_elasticity", "encoder_eccentricity"})
      for (const EffectTerm& t : random_terms(*find_effect(id), chain, random)) pair.unknown.push_back(t);
  Session real = like;
  if (model == Model::outside) {
    std::normal_distribution<double> normal;
    for (Link& link : real.robot.links) link.mass *= std::max(0.3, 1 + 0.12 * normal(random));
    pair.unknown.push_back(*hidden_shift(like, 0.3, random));
  }
  SimulationOptions o = simulation(seed + 300000, robot);
  o.effects = pair.unknown;
  if (what.effect[0]) pair.change = drawn_change(*find_effect(what.effect), chain, random);
  // The same hand, other poses, other noise: simulated with the same seed for markers is not at hand, so that the
  // second session is cut from one simulation of twice as many observations, in which the change comes after the first
  // half.
  SimulationOptions both = o;
  both.observations = 2 * observations;
  const SimulatedSession without = simulate_session(real, both);
  both.effects.insert(both.effects.end(), pair.change.begin(), pair.change.end());
  const SimulatedSession with = simulate_session(real, both);
  pair.before = without.session;
  pair.after = with.session;
  for (Session* session : {&pair.before, &pair.after}) session->robot = like.robot;
  pair.before.observations.resize(observations);
  pair.after.observations.erase(pair.after.observations.begin(), pair.after.observations.begin() + observations);
  return pair;
}

/// The chi-squared that the true change takes away where everything else is given.
double shown_if_told(const Pair& pair, const std::string& truth) {
  if (truth.empty()) return 0;
  std::vector<EffectTerm> reported = pair.unknown;
  for (EffectTerm& t : reported) std::fill(t.values.begin(), t.values.end(), 0.0);
  try {
    return shown(compare(pair.before, pair.after, reported), truth);
  } catch (const InputError&) {  // with all of it told the fit finds no answer
    return 0;
  }
}

struct Row {
  int pairs = 0, named = 0, ambiguous = 0, wrong = 0, missed = 0, weak = 0;
  int strong_if_told = 0, named_if_told = 0;
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

void count(Row& row, const Comparison& c, const std::string& truth, bool strong) {
  const std::string found = found_in(c);
  ++row.pairs;
  if (!strong)
    ++row.weak;
  else if (found == truth)
    ++row.named;
  else if (std::count(c.indistinguishable_from.begin(), c.indistinguishable_from.end(), truth) > 0)
    ++row.ambiguous;
  else if (found.empty())
    ++row.missed;
  else
    ++row.wrong;
}

void print(const char* model, const std::string& name, const Row& r) {
  fmt::print(
      "{:<8} {:<14} {:>4} pairs, {:>4} named, {:>3} tied with another, {:>3} missed, {:>3} wrong, {:>3} weaker than 50",
      model, name, r.pairs, r.named, r.ambiguous, r.missed, r.wrong, r.weak);
  if (r.strong_if_told > 0) fmt::print("; of {} of 50 with all else told {} named", r.strong_if_told, r.named_if_told);
  fmt::print("\n");
}

/// Of changes, and of pairs in which nothing has changed.
void print(Table& table, const std::string& model, const Row& change, const Row& nothing) {
  table.print({model, share_text(change.named, change.pairs - change.weak),
               share_text(change.named_if_told, change.strong_if_told), share_text(nothing.named, nothing.pairs)});
}

void add(const Row& one, Row& all) {
  all.pairs += one.pairs, all.named += one.named, all.ambiguous += one.ambiguous, all.wrong += one.wrong;
  all.missed += one.missed, all.weak += one.weak;
  all.strong_if_told += one.strong_if_told, all.named_if_told += one.named_if_told;
}

int compare_trials(const Arguments& a, const TableOutput& output) {
  const bool five = a.kind == "five";
  std::map<std::string, Row> rows[std::size(model_names)];
  for (int i = 0; i < a.count; ++i) {
    const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
    const int robot = a.robot >= 0 ? a.robot : 3;
    const Hidden& what = hidden[static_cast<std::size_t>(i) % std::size(hidden)];
    if (a.kind != "all" && !five && a.kind != (what.group[0] ? what.group : "nothing")) continue;
    const auto model = static_cast<Model>(i / static_cast<int>(std::size(hidden)) % 3);
    std::optional<Pair> drawn;
    std::optional<Comparison> comparison;
    try {
      drawn = drawn_pair(robot, seed, what, model);
      comparison = five ? with_five_poses(*drawn) : compare(drawn->before, drawn->after);
    } catch (const InputError& error) {  // these cameras see hardly any pose, or a fit finds no answer and it says so
      fmt::print("  robot {} seed {} is left out: {}\n", robot, seed, error.what());
      continue;
    }
    const Pair& pair = *drawn;
    const Comparison& c = *comparison;
    const std::string found = found_in(c), truth = what.group;
    const double noncentrality = shown(c, truth);
    const bool strong = truth.empty() || noncentrality >= 50;
    const double if_told = five || model == Model::right ? noncentrality : shown_if_told(pair, truth);
    Row& row = rows[static_cast<int>(model)][truth.empty() ? "nothing" : truth];
    count(row, c, truth, strong);
    if (!truth.empty() && if_told >= 50) ++row.strong_if_told, row.named_if_told += found == truth;
    if (found != truth && (strong || if_told >= 50))
      fmt::print(
          "  robot {} seed {}, {} model: {} (noncentrality {:.0f}, told {:.0f}), found {} ({:.1f}; threshold "
          "{:.1f}): {}\n",
          robot, seed, model_names[static_cast<int>(model)], truth.empty() ? "nothing" : truth, noncentrality, if_told,
          found.empty() ? "nothing" : found, c.changes.empty() ? 0.0 : c.changes.front().ln_bayes_factor, c.threshold,
          c.sentence);
    std::fflush(stdout);
  }
  Table table({{"model of both sessions"},
               {"strong changes named"},
               {"strong if all else were known, named"},
               {"unchanged pairs unchanged"}},
              output);
  Row together, nothing;
  for (std::size_t model = 0; model < std::size(model_names); ++model) {
    Row all;
    for (const auto& [name, r] : rows[model]) {
      print(model_names[model], name, r);
      if (name == "nothing") continue;
      add(r, all);
    }
    if (all.pairs > 0) print(model_names[model], "any change", all);
    if (all.pairs > 0) print(table, model_names[model], all, rows[model]["nothing"]);
    add(all, together), add(rows[model]["nothing"], nothing);
  }
  print(table, "together", together, nothing);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return compare_trials(arguments(argc, argv, "all"), output);
}
