// SPDX-License-Identifier: Apache-2.0
// One hidden curve and nothing else: is it found, of the right variable at the right site, and as good as told?
// trial_discovery COUNT [FIRST_SEED] [ROBOT]
#include <fmt/format.h>

#include <cstdio>

#include "diagnosis/ranking/curves.h"
#include "effects/own_effect.h"
#include "fixtures/trial_sessions.h"

namespace handsight::trials {
namespace {

struct Hidden {
  std::string form, site;
  std::vector<std::string> variables;  // as a user reads them: any of them is right
  EffectTerm term;
};

/// `form` of the joints a and b, at the site.
Hidden hidden_curve(const Session& like, std::uint64_t seed) {
  std::mt19937_64 random(seed * 7331 + 5);
  std::normal_distribution<double> normal;
  const Chain chain = make_chain(like);
  const std::size_t inner = like.joints.size() - 1;  // the last joint may only turn the hand
  const std::size_t first = like.joints.size() > 8 ? 3 : 0;
  const std::size_t a = first + random() % (inner - first);
  std::size_t b = first + random() % (inner - first);
  if (b == a) b = a > first ? a - 1 : a + 1;
  const std::string qa = "q_" + formula_name(like.joints[a]), qb = "q_" + formula_name(like.joints[b]);
  struct Form {
    std::string name, formula;
    std::vector<std::string> variables;
  };
  const std::vector<Form> forms{{"sin 2.7 q + 0.4", "sin(2.7*" + qa + "+0.4)", {"angle of " + like.joints[a]}},
                                {"sin 3.6 q", "sin(3.6*" + qa + ")", {"angle of " + like.joints[a]}},
                                {"q|q|", qa + "*abs(" + qa + ")", {"angle of " + like.joints[a]}},
                                {"step at 0.6", "(" + qa + " > 0.6 ? 1 : 0)", {"angle of " + like.joints[a]}},
                                {"exp(-t/T)", "exp(-time/0.2)", {"time"}},
                                {"q q", qa + "*" + qb, {"angle of " + like.joints[a], "angle of " + like.joints[b]}}};
  const Form& form = forms[seed % forms.size()];
  const bool at_joint = random() % 2 == 0;
  const std::size_t where = form.name == "exp(-t/T)" ? b : a;
  EffectDefinition d;
  d.id = "hidden_curve";
  d.scope = at_joint ? "joint" : "session";
  if (at_joint) {
    d.parameters = {{"size", "rad", 1e-3}};
    d.moves = {{"angle", "size*" + form.formula, 0}};
  } else {
    for (const char* axis : {"x", "y", "z"}) {
      d.parameters.push_back({axis, "m", 1e-3});
      d.moves.push_back({std::string("hand_") + axis, std::string(axis) + "*" + form.formula, 0});
    }
  }
  const auto effect = own_effect(d, like.robot);
  Hidden h{form.name, at_joint ? "the angle of " + like.joints[where] : "the hand", form.variables,
           term_of(*effect, at_joint ? chain.joints[where] : -1, effect)};
  for (double& v : h.term.values) v = at_joint ? 1e-3 * (1 + std::abs(normal(random))) : 1e-3 * normal(random);
  return h;
}

double held_out_px(const Session& session, const FitOptions& o) {
  const Fit f = fit(session, o);
  return report(session, f, o).held_out.rms_pixel.value_or(0);
}

int discovery_trials(const Arguments& a) {
  int trials = 0, small = 0, good = 0, right_variable = 0, right_site = 0, named = 0;
  for (int i = 0; i < a.count; ++i) {
    const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
    const int robot = a.robot >= 0 ? a.robot : std::array{3, 1, 3, 2}[static_cast<std::size_t>(i / 6) % 4];
    const Session like = robot_session(robot, seed);
    const Hidden h = hidden_curve(like, seed);
    SimulationOptions o = simulation(seed + 300000, robot);
    o.effects = {h.term};
    if (noncentrality_of(like, o) < 50) {
      ++small;
      continue;
    }
    const Session session = simulate_session(like, o).session;
    FitOptions reported;
    reported.estimated = {h.term};
    const double best = held_out_px(session, reported);
    const Improvement m = improve(session);
    const double reached = m.steps.back().held_out.rms_pixel.value_or(9);
    std::string found, names;
    bool variable = false, site = false;
    for (const EffectTerm& t : list_terms(m.last.model.fit)) {
      if (!is_curve(t)) {
        names += " " + t.id;
        continue;
      }
      const std::string& cause = t.own->definition->cause;
      found += " [" + formula_text(*t.own->definition) + "]";
      for (const std::string& v : h.variables)
        variable = variable || cause.find("moves with the " + v) != std::string::npos;
      std::string at = cause;
      at.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(at.front())));
      site = site || at.starts_with(h.site);
    }
    ++trials;
    good += reached < 1.3 * best;
    right_variable += variable;
    right_site += site;
    named += !names.empty();
    if (!variable || !site || reached >= 1.3 * best || !names.empty())
      fmt::print("  robot {} seed {}: {} at {} ({}); found{}{}; held out {:.4f}, told {:.4f} px\n", robot, seed, h.form,
                 h.site, h.variables.front(), found, names, reached, best);
    std::fflush(stdout);
  }
  fmt::print(
      "hidden curves: {} seen ({} too small): held out within 1.3 of told {} ({:.1f} %), right variable {} ({:.1f} %), "
      "right "
      "site {} ({:.1f} %), a name beside it {}\n",
      trials, small, good, 100.0 * good / std::max(1, trials), right_variable,
      100.0 * right_variable / std::max(1, trials), right_site, 100.0 * right_site / std::max(1, trials), named);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  return discovery_trials(arguments(argc, argv, "all"));
}
