// SPDX-License-Identifier: Apache-2.0
// What laboratories bring: causes far larger than usual, mistakes, robots that scatter, poses that come region by
// region. trial_field [COUNT] [FIRST_SEED] [KIND] [judge]; kinds: zero, zeros, link, slip, scatter, regions, target,
// mount, sense. At the end: how often the names that were reported with some probability are there. With `judge`, for
// worlds with a background: the hand of one who is told the large cause and that each of four small effects is there at
// every joint in half of the worlds, and chooses among the sixteen by their evidence.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>

#include "blunders/find_blunders.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis.h"
#include "estimation/report/fit_report.h"
#include "fixtures/field_worlds.h"

namespace handsight::trials {
namespace {

/// The body's origin as the sensor sees it.
Vector3 seen_at(const Chain& chain, const Eigen::VectorXd& pose, const std::vector<EffectTerm>& terms,
                const Rigid& mount_from_sensor, const Vector3& body) {
  const Sites sites = moved_sites(states_at(chain, pose), terms);
  const auto ends = observed_ends(states_at(chain, pose), sites).ends;
  return inverse(ends.root_from_mount * mount_from_sensor * small_motion<double>(sites.mount)) * ends.root_from_tcp *
         body;
}

/// Mean distance (mm) of the body's true origin in fresh poses from where the fit puts it.
double error_on_fresh(const World& w, const Fit& f) {
  const Chain chain = make_chain(w.session);
  const Vector3 body = body_frame(f.sides, w.markers_in_tcp).tcp_from_body.translation;
  double sum = 0;
  for (const Eigen::VectorXd& pose : w.fresh_poses)
    sum += (seen_at(chain, pose, w.effects, w.mount_from_sensor, body) -
            seen_at(chain, pose, list_terms(f), estimate(f).mount_from_sensor, f.tcp_from_body.translation))
               .norm();
  return 1e3 * sum / static_cast<double>(w.fresh_poses.size());
}

/// The same at 0, and what is described wrongly beside them.
std::vector<EffectTerm> to_estimate(const World& w, const std::vector<EffectTerm>& effects) {
  std::vector<EffectTerm> terms;
  for (EffectTerm t : effects) {
    const Effect& e = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!e.parameters[p].is_choice) t.values[p] = 0;
    terms.push_back(t);
  }
  for (const char* id : {"target_scale", "camera_mount"})
    if (w.dominant.contains(id)) {
      const Chain chain = make_chain(w.session);
      for (EffectTerm& t : effect_terms(id, chain, list_own_effects(w.session, chain))) terms.push_back(t);
    }
  return terms;
}

Fit reported(const World& w) {
  FitOptions o;
  o.estimated = to_estimate(w, w.effects);
  return fit(w.session, o);
}

/// Of one who knows how worlds are made, but not what is in this one beside what is large.
Fit judged(const World& w) {
  const Chain chain = make_chain(w.session);
  FitOptions o;
  o.estimated = to_estimate(w, w.large);
  std::optional<Fit> likeliest = fit(w.session, o);
  const Eigen::Index large = likeliest->problem.effect_count();
  const NoiseModel by = noise_model(reported(w));
  double best = fit_evidence(*likeliest, large, by).ln_evidence;
  for (unsigned which = 1; which < 1U << small_effects.size(); ++which) {
    FitOptions with = o;
    for (std::size_t i = 0; i < small_effects.size(); ++i) {
      if (!(which >> i & 1U)) continue;
      const Effect& e = *find_effect(small_effects[i]);
      for (const int place : effect_places(e, chain))
        if (std::none_of(o.estimated.begin(), o.estimated.end(),
                         [&](const EffectTerm& t) { return t.id == e.id && t.place == place; }))
          with.estimated.push_back(term_of(e, place));
    }
    Fit f = fit(w.session, with);
    if (!f.converged()) continue;
    const double evidence = fit_evidence(f, large, by).ln_evidence;
    if (evidence <= best) continue;
    best = evidence;
    likeliest = std::move(f);
  }
  return std::move(*likeliest);
}

/// Reported against true, of names of the catalogue, by probability.
struct Claims {
  static constexpr std::array<double, 14> bounds{0.05, 0.1, 0.2, 0.3,  0.4,  0.5,   0.6,
                                                 0.7,  0.8, 0.9, 0.95, 0.99, 0.999, 1.0000001};
  struct Bin {
    int count = 0, right = 0;
    double sum = 0;
  };
  std::array<Bin, bounds.size() - 1> bins;

  void add(double probability, bool is_right) {
    const auto above = std::upper_bound(bounds.begin(), bounds.end(), probability);
    if (above == bounds.begin() || above == bounds.end()) return;
    Bin& bin = bins[static_cast<std::size_t>(above - bounds.begin() - 1)];
    ++bin.count;
    bin.right += is_right;
    bin.sum += probability;
  }

  void print() const {
    for (std::size_t b = 0; b < bins.size(); ++b)
      if (bins[b].count > 0)
        fmt::print("reported {:5.1f} to {:5.1f} %, on average {:5.2f} %: there {:5.1f} % ({} of {})\n", 1e2 * bounds[b],
                   std::min(1e2, 1e2 * bounds[b + 1]), 1e2 * bins[b].sum / bins[b].count,
                   1e2 * bins[b].right / bins[b].count, bins[b].right, bins[b].count);
  }
};

struct Score {
  int worlds = 0, first = 0, kept = 0, disowned = 0, wrongly_adequate = 0, wrong_names = 0, names = 0,
      worse_than_plain = 0;
  std::vector<double> to_reported;  // error on fresh poses by that of the fit told everything
  std::vector<double> of_judge;     // the same of the judge, where that is asked for
  double seconds = 0;
};

/// A mistake is found before any effect.
void judge_blunder(const World& w, Score& score) {
  const std::vector<Blunder> found = find_blunders(w.session, fit(w.session, {}));
  const bool is_right =
      !found.empty() && display_name(found.front()) == w.blunder && found.front().together_with.empty();
  score.first += is_right;
  if (!is_right)
    fmt::print("  {}: {}\n", w.blunder, found.empty() ? "nothing found" : "found " + display_name(found.front()));
}

/// "joint_offset (disowned)", "-backlash +joint_scale", "a little joint_offset"
std::string step_text(const ImprovementStep& s) {
  std::string text = s.added + (s.stands.empty() ? "" : " (disowned)");
  if (!s.removed.empty()) text += fmt::format(" -{}", s.removed);
  for (const std::string& id : s.exchanged) text += " +" + id;
  if (!s.background.empty()) text += fmt::format(" a little {}", fmt::join(s.background, ", "));
  return text;
}

void judge_effects(std::uint64_t seed, const World& w, bool with_judge, Score& score, Claims& claims) {
  const Improvement m = improve(w.session, {});
  const std::string named = m.steps.size() > 1 ? m.steps[1].added : "";
  const bool is_first = w.dominant.empty() ? named.empty() || named.starts_with("curve_") : w.dominant.contains(named);
  score.first += is_first;
  const std::vector<EffectTerm>& last = m.last.model_options.estimated;
  const bool is_kept = w.dominant.empty() || std::any_of(last.begin(), last.end(), [&](const EffectTerm& t) {
                         return !is_small(t) && w.dominant.contains(t.id);
                       });
  score.kept += is_kept;
  int disowned = 0, wrong = 0;
  std::string wrong_names;
  for (const ImprovementStep& s : m.steps) disowned += w.dominant.contains(s.added) && !s.stands.empty();
  for (const InclusionProbability& n : m.inclusion_probabilities.names) {
    if (n.id.starts_with("curve_")) continue;
    if (!w.unasked.contains(n.id)) claims.add(n.probability, w.right.contains(n.id));
    if (n.probability < 0.95) continue;
    ++score.names;
    if (w.right.contains(n.id)) continue;
    ++wrong;
    wrong_names += fmt::format(" {} {:.4f}{}", n.id, n.probability, n.is_in_model ? "" : " (not in the model)");
  }
  score.disowned += disowned;
  score.wrong_names += wrong;
  const bool is_adequate = w.has_remainder && m.last.verdict == Verdict::adequate;
  score.wrongly_adequate += is_adequate;
  const double found = error_on_fresh(w, m.last.model.fit), best = error_on_fresh(w, reported(w)),
               plain = error_on_fresh(w, fit(w.session, {}));
  score.to_reported.push_back(found / std::max(best, 1e-3));
  if (with_judge) score.of_judge.push_back(error_on_fresh(w, judged(w)) / std::max(best, 1e-3));
  const bool is_worse = found > 1.5 * plain;
  score.worse_than_plain += is_worse;
  if (is_first && is_kept && disowned + wrong == 0 && !is_adequate && !is_worse && found < 1.3 * best) return;
  fmt::print("  seed {}, scatter {:.2g} mrad, target {:.1f} %:", seed, 1e3 * w.repeatability, 1e2 * w.target_scale);
  for (const ImprovementStep& s : m.steps) fmt::print(" {}", step_text(s));
  for (const RefusedStep& r : m.refused) fmt::print(" [{}: {}]", r.id, r.reason);
  fmt::print("; {} disowned, {} wrong names{}, hand {:.2f} mm, told {:.2f}, plain {:.2f}, {}\n", disowned, wrong,
             wrong_names, found, best, plain, verdict_text(m.last.verdict));
}

void judge(std::uint64_t seed, const World& w, bool with_judge, Score& score, Claims& claims) {
  const auto began = std::chrono::steady_clock::now();
  ++score.worlds;
  if (w.blunder.empty())
    judge_effects(seed, w, with_judge, score, claims);
  else
    judge_blunder(w, score);
  score.seconds =
      std::max(score.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
}

/// "1.04 median 1.97 worst"
std::string ratios_text(std::vector<double> ratios) {
  if (ratios.empty()) return "of none";
  std::sort(ratios.begin(), ratios.end());
  return fmt::format("{:.2f} median {:.2f} worst", ratios[ratios.size() / 2], ratios.back());
}

void run(const std::string& kind, int count, std::uint64_t first_seed, bool asks_judge, Claims& claims) {
  const bool with_judge = asks_judge && kind != "scatter" && kind != "regions";  // these have no background
  for (const int observations : {8, 15, 25, 40, 80}) {                           // effects are reported from ten on
    Score s;
    for (int i = 0; i < count; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      judge(seed, world(kind, observations, seed), with_judge, s, claims);
    }
    fmt::print(
        "{:8} {:2} poses: first right {} of {}, in the model {}, disowned {}, wrong names above 95 % {} of {}, "
        "adequate wrongly {}, "
        "worse than 1.5 plain {}, hand to told {}{}, {:.1f} s at most\n",
        kind, observations, s.first, s.worlds, s.kept, s.disowned, s.wrong_names, s.names, s.wrongly_adequate,
        s.worse_than_plain, ratios_text(s.to_reported), with_judge ? ", a judge's " + ratios_text(s.of_judge) : "",
        s.seconds);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  handsight::trials::Claims claims;
  for (const char* kind : {"zero", "zeros", "link", "slip", "scatter", "regions", "target", "mount", "sense"})
    if (argc <= 3 || std::string(argv[3]) == kind)
      handsight::trials::run(kind, count, first, argc > 4 && std::string(argv[4]) == "judge", claims);
  claims.print();
}
