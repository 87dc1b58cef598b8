// SPDX-License-Identifier: GPL-3.0-or-later
// Effects in words and in units that people read.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "effects/effect.h"
#include "session/session.h"
#include "words/core_words.h"

namespace handsight::app {

/// 1.2e-4 rad is 0.12 mrad: value in the effect's unit * scale = value in `unit`. A number without a unit: in %.
struct ShownUnit {
  double scale = 1;
  QString unit;
};
ShownUnit shown_unit(const std::string& unit);

/// What a number is called: its name, abbreviations in words ("tu": "shift across, u").
QString number_title(const std::string& name);
inline QString number_title(const char* name) { return number_title(std::string(name)); }
inline QString number_title(const Message& quantity) {
  return quantity.arguments().empty() ? number_title(quantity.form()) : translated(quantity);
}

/// "Joint elasticity"; the id itself where the catalogue does not know it.
QString effect_title(const std::string& id);

/// "arm_2"; "marker 2" and "from observation 12 on" in the window's language.
QString place_text(const std::string& place);

/// "arm_2 and arm_4"; more than three: "arm_1, arm_2 and 4 more".
QString places_text(const std::vector<std::string>& where);

/// "joint elasticity of arm_2 and arm_4", within a sentence.
QString effect_text(const std::string& id, const std::vector<std::string>& where);
/// "mount drift and joint elasticity" of the ids of several, as `improve` joins them.
QString list_effects(const std::string& ids);

/// "joint elasticity of arm_2 and arm_4" from its title and places.
QString of_places(const QString& title, const std::vector<std::string>& where);

/// The ids of terms in their order, each once.
std::vector<std::string> list_ids(const std::vector<EffectTerm>& terms);

/// The terms of one effect.
std::vector<EffectTerm> terms_of_effect(const std::vector<EffectTerm>& terms, const std::string& id);

}  // namespace handsight::app
