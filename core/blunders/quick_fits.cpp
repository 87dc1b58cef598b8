// SPDX-License-Identifier: Apache-2.0
#include "blunders/quick_fits.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "effects/effect.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/start/multi_start.h"
#include "estimation/start/shape_start.h"
#include "estimation/start/start_markers.h"

namespace handsight {
namespace {

std::optional<Unknowns> start_at(const Session& session, const Chain& chain, const std::optional<Rigid>& mount) {
  if (!mount) return std::nullopt;
  const Problem problem = make_problem(session, chain);
  Unknowns start{start_markers(problem, *mount), *mount, {}};
  if (session.shape && session.shape->piece_count() == 1) start = laid_onto(*session.shape, start);
  return start;
}

/// Zeros that far off are a mistake of their own kind: half turns of the joints beside it make a joint count the other
/// way.
bool is_no_deviation(const FittedEffect& e) {
  constexpr double most = 0.5;  // rad or m
  return e.term.id == "joint_offset" && std::abs(e.term.values.front()) > most;
}

Left left_by(const Session& session, const std::optional<Rigid>& mount, const std::vector<std::string>& effects) {
  const Chain chain = make_chain(session);
  FitOptions options;
  options.start = start_at(session, chain, mount);
  options.most_iterations = 30;
  options.smallest_step = 1e-6;
  options.least_gain = session.is_tracker() ? 1e-12 : 1e-4;  // m^2, px^2: a quick answer
  try {
    for (const std::string& effect : effects)  // where no joint lies between hand and sensor they have no place
      for (const EffectTerm& term : effect_terms(effect, chain)) options.estimated.push_back(term);
    const Fit found = fit(session, options);
    if (std::ranges::any_of(found.effects, is_no_deviation)) return {};
    return {found.residual_rms,
            has_no_answer(found) || (found.converged() && looks_lost(found.problem, found.solution))};
  } catch (const InputError&) {  // nothing can be fitted
    return {};
  }
}

}  // namespace

Left left_by_plain(const Session& small, const std::optional<Rigid>& mount) { return left_by(small, mount, {}); }

Left left_by_offsets(const Session& small, const std::optional<Rigid>& mount) {
  if (small.robot.is_of_poses) return left_by_plain(small, mount);
  return left_by(small, mount, {"joint_offset"});
}

Left left_by_geometry(const Session& small, const std::optional<Rigid>& mount) {
  if (small.robot.is_of_poses) return left_by_plain(small, mount);
  return left_by(small, mount, {"joint_offset", "link_geometry"});
}

}  // namespace handsight
