// SPDX-License-Identifier: GPL-3.0-or-later
// What a user calls a candidate or terms of the model: an effect by its title, a curve without a name by what it does.
#pragma once

#include <QString>

#include "diagnosis/verdict/finding.h"

namespace handsight::app {

/// The curves without a name among a fit's terms.
std::vector<EffectTerm> list_curves(const Fit& fit);

/// "The hand shifts along y with sin(3.3 q) of arm_4"; `place` is the joint at which it acts, empty for the session.
QString curve_title(const EffectDefinition& definition, const std::string& place, const Robot& robot);

/// A curve as a sentence: "arm_3 has an error that repeats three times a turn (± 1.5 mrad)", else its title.
QString curve_sentence(const EffectTerm& term, const Robot& robot);

/// "Joint elasticity", or of an effect by formula its title, of a curve what it does.
QString make_title(const EffectTerm& term, const Robot& robot);

/// "joint elasticity of arm_2 and arm_4" or "the hand shifts along y with sin(3.3 q) of arm_4": within a sentence, of
/// terms of one effect.
QString display_name(const std::vector<EffectTerm>& terms, const Session& session);
QString display_name(const DiagnosisCandidate& candidate, const Session& session);

/// "added joint elasticity of arm_2", "took out: the hand shifts along y with ...": what is told as a sentence stays
/// one.
QString addition_text(const std::vector<EffectTerm>& terms, const Session& session);
QString removal_text(const std::vector<EffectTerm>& terms, const Session& session);

}  // namespace handsight::app
