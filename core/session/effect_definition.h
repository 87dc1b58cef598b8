// SPDX-License-Identifier: Apache-2.0
// Effects that a file defines by formulas: effects.xml in a session's folder, files of the user's own folder, and those
// that an exported calibration carries along. Plain data as written; effects/own_effect.h makes effects of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/xml.h"

namespace handsight {

struct DefinedParameter {
  std::string name;
  std::string unit;
  double sigma = 0;  // the prior sigma
};

/// One site that the effect moves, and by how much: a formula, linear in the parameters.
struct DefinedMove {
  std::string site;
  std::string formula;
  int line = 0;  // in EffectDefinition::file; 0: not known
};

struct EffectDefinition {
  std::string id;
  std::string title;
  std::string scope = "joint";  // joint, marker or session
  std::string cause, visibility, check, source;
  std::vector<DefinedParameter> parameters;
  std::vector<DefinedMove> moves;
  bool unnamed = false;  // a curve that the program has found
  std::string file;      // as sentences call it
  int line = 0;
};

/// One <effect> element. Refuses what is not complete: id, scope, parameters, moves.
EffectDefinition read_effect_definition(const XmlNode& node, Ignored& ignored);

/// A text <handsight_effects version="1">; `file` is what sentences call it. `notes`: what was ignored.
std::vector<EffectDefinition> parse_effect_definitions(const std::string& text, const std::string& file,
                                                       std::vector<Message>* notes = nullptr);

/// effects.xml in `session_folder`, then every *.xml of `user_folder` in the order of names, where they exist; of one
/// id the session's counts, then the first; the others are named in `notes`.
std::vector<EffectDefinition> find_effect_definitions(const std::filesystem::path& session_folder,
                                                      const std::filesystem::path& user_folder,
                                                      std::vector<Message>& notes);

/// $XDG_DATA_HOME/handsight/effects, else ~/.local/share/handsight/effects; empty where neither is set.
std::filesystem::path user_effects_folder();

/// Adds the definition as an <effect> element.
void write_effect_definition(tinyxml2::XMLElement& parent, const EffectDefinition& definition);

/// The same as a text of its own.
std::string effect_definition_text(const EffectDefinition& definition);

}  // namespace handsight
