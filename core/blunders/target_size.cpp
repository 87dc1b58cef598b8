// SPDX-License-Identifier: Apache-2.0
#include "blunders/target_size.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "effects/own_effect.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

constexpr double many_times = 3;      // the noise: below that an effect may be missing, and diagnose finds it
constexpr double most_left = 0.6;     // of the error before
constexpr double least_scale = 0.01;  // less is a matter of diagnose, too
constexpr std::size_t fewest_views = 6;

bool has_effect(const std::vector<EffectTerm>& terms, const std::string& id) {
  return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& term) { return term.id == id; });
}

Message lengths(const Session& session, double scale) {
  const auto mm = [](double metres) { return message("{:.4g} mm", 1e3 * metres); };
  if (!session.target) return "";
  const Target& t = *session.target;
  const bool has_squares = t.kind == TargetKind::chessboard || t.kind == TargetKind::charuco;
  const double described = has_squares ? t.square : t.tag;
  return message(": its {} are about {}, not {}", has_squares ? "squares" : "tags", mm(described * (1 + scale)),
                 mm(described));
}

}  // namespace

std::optional<TargetSize> other_target_size(const Session& session, const Fit& fit_before, const FitOptions& options) {
  constexpr const char* id = "target_scale";
  const double before = fit_before.residual_rms;
  if (fit_before.solution.stopped || fit_before.problem.observations.size() < fewest_views) return std::nullopt;
  if (has_effect(options.estimated, id) || has_effect(options.effects, id)) return std::nullopt;
  if (fit_before.noise && !has_no_answer(fit_before) && before < many_times * *fit_before.noise) return std::nullopt;
  const bool is_known = session.shape && session.shape->sigma && session.shape->piece_count() == 1;
  if (!session.pose_sensor && !is_known) return std::nullopt;
  if (!session.parts.empty()) return std::nullopt;
  try {
    const Chain chain = chain_of(session);
    FitOptions with = options;
    for (EffectTerm& term : effect_terms(id, chain, own_effects_of(session, chain)))
      with.estimated.push_back(std::move(term));
    with.start.reset();
    // As a step of a diagnosis: what a wrong size leaves must not pass for the error of a robot that tells its poses.
    with.smallest_step = std::max(options.smallest_step, 1e-6);
    const Fit right = fit(session, with);
    if (!right.converged() || right.effects.empty() || !(right.residual_rms < most_left * before)) return std::nullopt;
    const FittedEffect& size = right.effects.back();
    TargetSize found{.scale = size.term.values.at(0),
                     .sigma = size.sigmas.at(0),
                     .in_pixels = !session.is_tracker(),
                     .rms_before = before,
                     .rms_after = right.residual_rms};
    if (std::abs(found.scale) < std::max(least_scale, 5 * found.sigma) || found.scale < -0.75 || found.scale > 3)
      return std::nullopt;
    found.text = message("The target is {:.1f} % {} than its description says{}.", 100 * std::abs(found.scale),
                         found.scale > 0 ? "larger" : "smaller", lengths(session, found.scale));
    found.fix =
        "Measure it over its whole length and put the right size into <target>; until then no place of the hand or of "
        "a camera is to be trusted (--effects target_scale estimates it with them).";
    return found;
  } catch (const InputError&) {  // it cannot be fitted: nothing is to be said
    return std::nullopt;
  }
}

}  // namespace handsight
