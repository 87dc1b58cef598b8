// SPDX-License-Identifier: Apache-2.0
// Curves: what an empirical error term found, settled in form, setting and directions, as a term that a model may take
// in like an effect (effects/own_effect.h).
#pragma once

#include "diagnosis/ranking/ranking.h"

namespace handsight {

struct FoundCurve {
  EffectTerm term;       // with the linear estimate
  double ln_factor = 0;  // linear, of this form against nothing, no odds
  double ln_ways = 0;    // of the choices in which it could have been another
  std::string variable;  // as a user reads it
  std::string where;     // the joint that it moves, "hand" or "mount"
};

/// The best curve of these empirical error terms (those near the first in evidence are looked at); none where no
/// formula can say what they follow. `w` is whitened for the first one's scatter, `id` is what the curve is to be
/// called.
std::optional<FoundCurve> find_curve(const WhitenedModel& w, const NoiseKnowledge& noise, const Problem& problem,
                                     const std::vector<Variable>& variables,
                                     const std::vector<RankedEmpiricalError>& empirical_errors, const std::string& id);

/// "curve_1" or the first number that none of the terms has.
std::string next_curve_id(const std::vector<EffectTerm>& terms);

/// Is the term a curve without a name?
inline bool is_curve(const EffectTerm& term) { return term.own && term.own->is_unnamed(); }

/// What a curve follows, as a user reads it: "angle of arm_3", "distance from the sensor".
std::string followed_variable(const EffectDefinition& curve);

/// Does a curve without a name follow the time: a drift of a form that is not in the catalogue?
bool is_curve_of_time(const EffectTerm& term);

/// Of the forms, sites and directions in which a curve could have been another.
inline constexpr double ln_ways_of_curves = 5;

/// ln of the odds against a curve without a name, these ways included.
double ln_odds_against_curve(const EffectTerm& term);

/// "angle", or "hand_x, hand_z": the sites that it moves.
std::string sites_text(const EffectDefinition& definition);

/// "sine*sin(3.3*q)" and the like, one formula a site: "hand_x: x_sine*sin(3.3*q_arm_4) + ...". A place is reported
/// once, as u: "hand_z: z_slope*u + z_bow*u^2; u = (... - 1.31)/0.42".
std::string formula_text(const EffectDefinition& definition);

}  // namespace handsight
