// SPDX-License-Identifier: Apache-2.0
// Is what was hidden named, and where it sits? trial_effects COUNT [FIRST_SEED] [ROBOT] [EFFECT] [--markdown]
#include <fmt/format.h>

#include <cstdio>
#include <map>

#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

struct Tally {
  int trials = 0, first = 0, named = 0, joint_trials = 0, joint = 0, detected = 0;
};

/// Nothing where there is nothing to count.
TableCell percent(int count, int all, int digits) {
  return all > 0 ? fmt::format("{:.{}f}", 100.0 * count / all, digits) : "";
}

void print(Table& table, const std::string& name, const Tally& t, int digits) {
  table.print({name, t.trials, percent(t.first, t.trials, digits), percent(t.named, t.trials, digits),
               percent(t.joint, t.joint_trials, digits)});
}

Table table_of(const std::string& rows, const TableOutput& output) {
  return {{{.heading = rows, .width = 28}, {"trials"}, {"first %"}, {"first or tied %"}, {"joint right %"}}, output};
}

int effect_trials(const Arguments& a, const TableOutput& output) {
  std::map<std::string, Tally> by_effect;
  std::map<std::size_t, Tally> by_noncentrality;
  const double edges[] = {0, 10, 30, 50, 100, 1000, 1e300};
  const char* names[] = {"0-10", "10-30", "30-50", "50-100", "100-1000", "over 1000"};
  for (int robot = 0; robot < 4; ++robot) {
    if (a.skips(robot)) continue;
    for (const Effect& e : catalogue()) {
      if (a.kind != "all" && e.id != a.kind) continue;
      for (int i = 0; i < a.count; ++i) {
        const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
        std::mt19937_64 random(seed * 104729 + std::hash<std::string>{}(e.id) % 100000 + static_cast<unsigned>(robot));
        const Session like = robot_session(robot, random());
        const Chain chain = make_chain(like);
        SimulationOptions o = simulation(seed + 5000 * static_cast<std::uint64_t>(robot), robot);
        o.effects = random_terms(e, chain, random);
        if (o.effects.empty()) continue;
        SimulatedSession s;
        double lambda = 0;
        try {
          lambda = noncentrality_of(like, o);
          s = simulate_session(like, o);
        } catch (const InputError&) {
          continue;
        }
        const Diagnosis d = diagnose(s.session, quick());
        if (d.candidates.empty()) continue;
        const DiagnosisCandidate& best = d.candidates.front();
        const bool is_first = best.id == e.id;
        const bool is_named =
            is_first || std::count(best.indistinguishable_from.begin(), best.indistinguishable_from.end(), e.id) > 0;
        const bool detected = d.verdict != Verdict::adequate;
        const bool at_joint = e.scope == EffectScope::joint && o.effects.size() == 1;
        const bool joint =
            is_first && std::count(best.where.begin(), best.where.end(),
                                   at_joint ? like.robot.joints[static_cast<std::size_t>(o.effects[0].place)].name
                                            : std::string()) > 0;
        std::size_t bin = 0;
        while (lambda >= edges[bin + 1]) ++bin;
        for (Tally* t : {lambda >= 50 ? &by_effect[e.id] : nullptr, &by_noncentrality[bin]}) {
          if (!t) continue;
          ++t->trials;
          t->first += is_first;
          t->named += is_named;
          t->detected += detected;
          t->joint_trials += at_joint && is_first;
          t->joint += joint;
        }
        if (lambda >= 50 && !is_first) {
          const auto truth =
              std::find_if(d.candidates.begin(), d.candidates.end(), [&](const auto& c) { return c.id == e.id; });
          fmt::print("  robot {} seed {} {} x{} lambda {:.0f}: {} ({}) {:.1f}, truth {:.1f}{}\n", robot, seed, e.id,
                     o.effects.size(), lambda, top(d), verdict_text(d.verdict), best.ln_bayes_factor,
                     truth == d.candidates.end() ? 0.0 : truth->ln_bayes_factor, is_named ? " (named)" : "");
          std::fflush(stdout);
        }
      }
    }
  }
  Table effects = table_of("effect, noncentrality 50 and more", output);
  Tally all;
  for (const auto& [name, t] : by_effect) {
    print(effects, name, t, 0);
    all.trials += t.trials, all.first += t.first, all.named += t.named, all.joint += t.joint;
    all.joint_trials += t.joint_trials, all.detected += t.detected;
  }
  Table table = table_of("noncentrality", output);
  for (const auto& [bin, t] : by_noncentrality) print(table, names[bin], t, 0);
  print(table, "50 and more (aims: 97, 99.5, 97)", all, 1);
  fmt::print("not called adequate: {} of {} of 50 and more\n", all.detected, all.trials);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return effect_trials(arguments(argc, argv, "all"), output);
}
