// SPDX-License-Identifier: Apache-2.0
// One, two and three effects at once: what improve adds, what it leaves on observations that it has not seen, and
// whether its numbers' sigmas are right. trial_several COUNT [FIRST_SEED] [ROBOT] [EFFECTS, 0 for all]
#include <fmt/format.h>

#include <cstdio>

#include "diagnosis/ranking/refitting.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

struct Expected {
  double rms = 0;            // px
  double low = 0, high = 0;  // 99 of 100 are between
};

/// What a right model of this size leaves on held-out observations: noise, and what its parameters, estimated from the
/// other folds, add to it.
Expected expected_held_out(const Fit& f) {
  double mean = 0, variance = 0, rows = 0;
  for (int fold = 0; fold < 5; ++fold) {
    std::vector<int> train;
    NormalEquations held(f.problem.columns());
    double held_rows = 0;
    for (std::size_t i = 0; i < f.problem.observations.size(); ++i) {
      const ProblemObservation& o = f.problem.observations[i];
      if (fold_of(static_cast<int>(i)) != fold) {
        train.push_back(static_cast<int>(i));
        continue;
      }
      add_observation(f.problem, o, estimate(f), held);
      for (const Sighting& s : o.sightings) held_rows += row_count(s);
    }
    complete(held);
    const Eigen::MatrixXd spread =
        pseudo_inverse(normal_equations(f.problem, estimate(f), train).information) * held.information;
    mean += held_rows + spread.trace();
    variance += 2 * (held_rows + 2 * spread.trace() + (spread * spread).trace());
    rows += held_rows;
  }
  const auto rms = [&](double squares) { return sigma * std::sqrt(squares / rows); };
  return {rms(mean), rms(mean - 2.576 * std::sqrt(variance)), rms(mean + 2.576 * std::sqrt(variance))};
}

struct Tally {
  int trials = 0, exact = 0, beaten = 0, in_band = 0, numbers = 0, covered = 0;
  double ratio = 0;  // sum of held out over expected
};

std::vector<std::string> list_ids(const std::vector<EffectTerm>& terms) {
  std::vector<std::string> ids;
  for (const EffectTerm& t : terms) ids.push_back(t.id);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

const EffectTerm* same_place(const EffectTerm& term, const std::vector<EffectTerm>& list) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const EffectTerm& t) {
    if (t.id != term.id || t.place != term.place) return false;
    const Effect& effect = term_effect(t);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].is_choice && t.values[p] != term.values[p]) return false;
    return true;
  });
  return found == list.end() ? nullptr : &*found;
}

/// Numbers of an exactly right model that the measurements settle (sigma below a third of the prior's): how many of
/// their 95 % intervals hold the truth?
void count_covered(const Fit& f, const std::vector<EffectTerm>& truth, Tally& tally) {
  if (f.effects.size() != truth.size()) return;
  for (const FittedEffect& e : f.effects)
    if (!same_place(e.term, truth)) return;
  for (const FittedEffect& e : f.effects) {
    const EffectTerm& t = *same_place(e.term, truth);
    const Effect& effect = term_effect(t);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      if (effect.parameters[p].is_choice || !(e.sigmas[p] < effect.parameters[p].sigma / 3)) continue;
      ++tally.numbers;
      tally.covered += std::abs(e.term.values[p] - t.values[p]) < 1.96 * e.sigmas[p];
    }
  }
}

/// Effects drawn from the catalogue, each with a noncentrality of 60 or more by itself.
std::vector<EffectTerm> hidden_effects(const Session& like, std::size_t count, const SimulationOptions& o,
                                       std::mt19937_64& random) {
  const Chain chain = make_chain(like);
  std::vector<EffectTerm> terms;
  while (list_ids(terms).size() < count) {
    const Effect& e = catalogue()[random() % catalogue().size()];
    const std::vector<std::string> taken = list_ids(terms);
    if (std::count(taken.begin(), taken.end(), e.id)) continue;
    SimulationOptions alone = o;
    alone.effects = random_terms(e, chain, random);
    if (alone.effects.empty() || noncentrality_of(like, alone) < 60) continue;
    terms.insert(terms.end(), alone.effects.begin(), alone.effects.end());
  }
  return terms;
}

/// ln of the evidence of a model with these effects, choices of joints included: what decides between two of them.
double ln_evidence(const Diagnosis& d, const std::vector<EffectTerm>& terms, const Chain& chain) {
  FitOptions o;
  o.estimated = terms;
  o.start = d.model_options.start;
  double value = fit_evidence(fit(d.model.session, o), 0, noise_model(d.model.fit)).ln_evidence;
  for (const std::string& id : list_ids(terms)) {
    const auto of_it = [&](const EffectTerm& t) { return t.id == id; };
    const EffectTerm& one = *std::find_if(terms.begin(), terms.end(), of_it);
    const auto places = static_cast<double>(effect_places(term_effect(one), chain).size());
    const auto taken = static_cast<double>(std::count_if(terms.begin(), terms.end(), of_it));
    value -= std::lgamma(places + 1) - std::lgamma(taken + 1) - std::lgamma(places - taken + 1);
  }
  return value;
}

std::string listed_ids(const std::vector<EffectTerm>& terms) {
  std::string text;
  for (const std::string& id : list_ids(terms)) text += " " + id;
  return text;
}

void run_trial(const Session& like, int robot, std::uint64_t seed, std::size_t effects, Tally& tally) {
  std::mt19937_64 random(seed * 7001 + 13 * effects + static_cast<unsigned>(robot));
  SimulationOptions o = simulation(seed + 90000, robot);
  o.effects = hidden_effects(like, effects, o, random);
  const Improvement m = improve(simulate_session(like, o).session);
  const Fit& f = m.last.model.fit;
  const std::vector<EffectTerm> found = list_terms(f);
  const double held_out = m.steps.back().held_out.rms_pixel.value_or(9);
  const Expected expected = expected_held_out(f);
  const bool is_exact = list_ids(found) == list_ids(o.effects);
  const bool is_in_band = held_out > expected.low && held_out < expected.high;
  ++tally.trials;
  tally.exact += is_exact;
  tally.in_band += is_in_band;
  tally.ratio += held_out / expected.rms;
  if (is_exact) count_covered(f, o.effects, tally);
  if (is_exact && is_in_band) return;
  const Chain chain = make_chain(like);
  const double ahead = ln_evidence(m.last, found, chain) - ln_evidence(m.last, o.effects, chain);
  tally.beaten += !is_exact && ahead > 0;
  fmt::print(
      "  robot {} seed {}: truth{}; found{}, ahead of the truth by ln BF {:.1f}; held out {:.3f} px, expected {:.3f} "
      "to "
      "{:.3f}; {}\n",
      robot, seed, listed_ids(o.effects), listed_ids(found), ahead, held_out, expected.low, expected.high,
      verdict_text(m.last.verdict));
  std::fflush(stdout);
}

void add(const Tally& one, Tally& all) {
  all.trials += one.trials, all.exact += one.exact, all.in_band += one.in_band, all.beaten += one.beaten;
  all.covered += one.covered, all.numbers += one.numbers, all.ratio += one.ratio;
}

void print(Table& table, const TableCell& effects, const Tally& t) {
  table.print({effects, share_text(t.exact, t.trials, 1), share_text(t.in_band, t.trials, 1),
               t.ratio / std::max(1, t.trials), share_text(t.covered, t.numbers, 1)});
}

int several_trials(const Arguments& a, const TableOutput& output) {
  Table table({{"effects"},
               {"exact set (aim: 90 %)"},
               {"held out in the 99 % band of a right model of that size (aim: 97 %)"},
               {"held out over what is expected (aim: 1 %)", 3},
               {"95 % intervals that hold the truth (aim: 93 to 97 %)"}},
              output);
  Tally all;
  for (std::size_t effects = 1; effects <= 3; ++effects) {
    if (std::atoi(a.kind.c_str()) > 0 && std::atoi(a.kind.c_str()) != static_cast<int>(effects)) continue;
    Tally tally;
    for (int robot = 0; robot < 4; ++robot) {
      if (a.skips(robot)) continue;
      for (int i = 0; i < a.count; ++i) {
        const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
        run_trial(robot_session(robot, seed), robot, seed, effects, tally);
      }
    }
    print(table, effects, tally);
    fmt::print("  of the sets that are not the truth {} are likelier than it\n", tally.beaten);
    add(tally, all);
  }
  print(table, "all", all);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return several_trials(arguments(argc, argv, "0"), output);
}
