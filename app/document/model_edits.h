// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the model's effects as actions, with their sentences.
#pragma once

#include "document/document.h"

namespace handsight::app {

/// Estimates these terms too, ticked by hand.
Edit with_effect(const Document& document, const std::vector<EffectTerm>& terms);

/// Settings with the estimated terms that Explain arrived at, fitted as it fits.
ModelSettings with_estimated(ModelSettings settings, const std::vector<EffectTerm>& estimated);

/// Takes an effect out at all its places. Empty where it is not in the model.
Edit without_effect(const Document& document, const std::string& id);

/// Holds an effect at its present numbers, or estimates it again from there.
Edit with_effect_held(const Document& document, const std::string& id, bool held);

/// Holds one number of an effect where it is, or estimates it again: the `number`-th of all its numbers, term by term.
/// Its effect counts as ticked by hand then.
Edit with_number_held(const Document& document, const std::string& id, std::size_t number, bool held);

/// What a number of an effect is multiplied by to be shown: 1000 of what is in mm.
double shown_scale(const Document& document, const std::string& id, std::size_t number);

/// A held number set to another: the `number`-th of all its numbers, term by term, in the effect's own unit.
Edit with_value(const Document& document, const std::string& id, std::size_t number, double value);

/// Where the effect explains most in the session as the model of these settings leaves it; its choices set. Slow: for
/// the background. Empty where it has no place in this session.
std::vector<EffectTerm> best_places(const Session& session, const ModelSettings& settings, const std::string& id);

}  // namespace handsight::app
