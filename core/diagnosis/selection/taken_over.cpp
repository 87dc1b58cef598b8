// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/taken_over.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/verdict/stand_in.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// Is a number larger than usual that was not before?
bool has_grown(const Fit& before, const Fit& after, const Chain& chain) {
  const std::vector<EffectTerm> was = list_terms(before), is = list_terms(after);
  return std::any_of(is.begin(), is.end(), [&](const EffectTerm& t) {
    const auto same = std::find_if(was.begin(), was.end(), [&](const EffectTerm& b) { return is_same_place(b, t); });
    return same != was.end() && !is_curve(t) && is_plausible({*same}, chain) && !is_plausible({t}, chain);
  });
}

bool describes_as_well(const Fit& with, const Fit& without, double noise) {
  constexpr double as_well = 20;  // chi-squared
  return without.solution.normal.data_cost() - with.solution.normal.data_cost() <= as_well * noise * noise;
}

}  // namespace

bool is_same_place(const EffectTerm& a, const EffectTerm& b) { return a.id == b.id && a.place == b.place; }

bool is_taken_over(const std::vector<EffectTerm>& gone, const Session& session, const FitOptions& options,
                   const Fit& with, const Fit& without) {
  const Chain& chain = with.problem.source->chain;
  const auto is_large = [&](const EffectTerm& t) { return !is_plausible({t}, chain); };
  const auto large = static_cast<std::size_t>(std::count_if(gone.begin(), gone.end(), is_large));
  if (large == 0 || !has_grown(with, without, chain)) return false;
  const NoiseModel by = noise_model(with);
  if (describes_as_well(with, without, by.noise)) return true;
  if (large == gone.size()) return false;
  FitOptions without_large = options;
  std::erase_if(without_large.estimated, [&](const EffectTerm& t) {
    return std::any_of(gone.begin(), gone.end(),
                       [&](const EffectTerm& g) { return is_large(g) && is_same_place(g, t); });
  });
  without_large.start = estimate(without);
  without_large.start->effects.resize(0);
  set_quick(by, without_large);
  const Fit rest = fit(session, without_large);
  return rest.converged() && has_grown(with, rest, chain) && describes_as_well(with, rest, by.noise);
}

}  // namespace handsight
