// SPDX-License-Identifier: Apache-2.0
#include "blunders/target_size.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "blunders/reported_error.h"
#include "effects/own_effect.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

constexpr double clear_times = 3;  // the noise: below that an effect may be missing, and diagnose finds it
constexpr const char* scale_effect = "target_scale";
constexpr double most_left = 0.6;     // of the error before
constexpr double least_scale = 0.01;  // less is a matter of diagnose, too
constexpr std::size_t fewest_views = 6;

bool has_effect(const std::vector<EffectTerm>& terms, const std::string& id) {
  return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& term) { return term.id == id; });
}

Message lengths(const Session& session, double scale) {
  const auto mm = [](double metres) { return message("{:.4g} mm", 1e3 * metres); };
  if (!session.target) return "";
  const double described = described_length(*session.target);
  return message(": its {} are about {}, not {}", has_squares(*session.target) ? "squares" : "tags",
                 mm(described * (1 + scale)), mm(described));
}

struct SizeFound {
  double scale = 0, sigma = 0, rms = 0, error = 0;
};

/// By the effect that says so.
std::optional<SizeFound> by_effect(const Session& session, const FitOptions& options) {
  const Chain chain = make_chain(session);
  FitOptions with = options;
  for (EffectTerm& term : effect_terms(scale_effect, chain, list_own_effects(session, chain)))
    with.estimated.push_back(std::move(term));
  with.start.reset();
  // As a step of a diagnosis: what a wrong size leaves must not pass for the error of a robot that tells its poses.
  with.smallest_step = std::max(options.smallest_step, 1e-6);
  const Fit right = fit(session, with);
  if (!right.converged() || right.effects.empty()) return std::nullopt;
  const FittedEffect& size = right.effects.back();
  return SizeFound{size.term.values.at(0), size.sigmas.at(0), right.residual_rms, reported_error(session, right)};
}

/// By fits with other sizes: of single tags, each of which may lie anywhere.
class SizesOfTags {
 public:
  SizesOfTags(const Session& session, FitOptions options) : session_(session), options_(std::move(options)) {
    options_.start.reset();
    options_.smallest_step = std::max(options_.smallest_step, 1e-6);
  }

  /// The square of the rms is nearly a parabola of the size.
  std::optional<SizeFound> best(double square_as_it_is) const {
    double at = 0, here = square_as_it_is, curvature = 0;
    for (const double step : {0.05, 0.02, 0.005}) {
      const double more = square_at(at + step), less = square_at(at - step);
      curvature = 0.5 * (more + less - 2 * here) / (step * step);
      if (!(curvature > 0)) return std::nullopt;
      at = std::clamp(at + 0.25 * (less - more) / (step * curvature), least, most);
      here = square_at(at);
    }
    const double numbers = 6.0 * static_cast<double>(session_.observations.size());
    return SizeFound{at, std::sqrt(here / (curvature * numbers)), std::sqrt(here), std::sqrt(here)};
  }

 private:
  static constexpr double least = -0.6, most = 1.5;
  double square_at(double scale) const {
    Session other = session_;
    set_target(other, scaled(*session_.target, 1 + scale));
    const double rms = fit(other, options_).residual_rms;
    return rms * rms;
  }

  const Session& session_;
  FitOptions options_;
};

}  // namespace

bool has_squares(const Target& target) {
  return target.kind == TargetKind::chessboard || target.kind == TargetKind::charuco;
}

double described_length(const Target& target) { return has_squares(target) ? target.square : target.tag; }

std::optional<TargetSize> other_target_size(const Session& session, const Fit& fit_before, const FitOptions& options) {
  const double before = fit_before.residual_rms;
  if (fit_before.solution.stopped || fit_before.problem.observations.size() < fewest_views) return std::nullopt;
  if (has_effect(options.estimated, scale_effect) || has_effect(options.effects, scale_effect)) return std::nullopt;
  if (fit_before.noise && !has_no_answer(fit_before) && before < clear_times * *fit_before.noise) return std::nullopt;
  const bool is_known = session.shape && session.shape->sigma && session.shape->piece_count() == 1;
  const bool are_tags = session.target && session.target->kind == TargetKind::tags && session.shape &&
                        session.shape->sigma && session.shape->piece_count() > 1;
  if (!session.pose_sensor && !is_known && !are_tags) return std::nullopt;
  if (!session.parts.empty()) return std::nullopt;
  try {
    const auto size = are_tags ? SizesOfTags(session, options).best(before * before) : by_effect(session, options);
    if (!size || !(size->rms < most_left * before)) return std::nullopt;
    TargetSize found{.scale = size->scale,
                     .sigma = size->sigma,
                     .in_pixels = !session.is_tracker(),
                     .rms_before = before,
                     .rms_after = size->rms,
                     .error_before = reported_error(session, fit_before),
                     .error_after = size->error};
    if (std::abs(found.scale) < std::max(least_scale, 5 * found.sigma) || found.scale < -0.75 || found.scale > 3)
      return std::nullopt;
    found.text = message("The target is {:.1f} % {} than its description says{}.", 100 * std::abs(found.scale),
                         found.scale > 0 ? "larger" : "smaller", lengths(session, found.scale));
    found.fix =
        session.pose_sensor
            ? "Measure it over its whole length and give the right size to the program that found its poses; until "
              "then "
              "no "
              "place of the hand or of a camera is to be trusted (--effects target_scale estimates it with them)."
        : are_tags
            ? "Measure its black square and put the right size into <target>; until then no place of the hand or of a "
              "camera is to be trusted."
            : "Measure it over its whole length and put the right size into <target>; until then no place of the hand "
              "or of "
              "a camera is to be trusted (--effects target_scale estimates it with them).";
    return found;
  } catch (const InputError&) {  // it cannot be fitted: nothing is to be said
    return std::nullopt;
  }
}

}  // namespace handsight
