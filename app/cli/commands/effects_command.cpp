// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command.h"
#include "effects/own_effect.h"

namespace handsight::cli {
namespace {

/// Where an effect sits: by its name in effects.xml, or in the catalogue, and in words.
struct ScopeWords {
  const char *name, *at;
};

ScopeWords list_words(EffectScope scope) {
  switch (scope) {
    case EffectScope::joint:
      return {"joint", ", at each joint"};
    case EffectScope::mimic_joint:
      return {"mimic_joint", ", at each joint that follows others"};
    case EffectScope::marker:
      return {"marker", ", at each marker"};
    case EffectScope::camera:
      return {"camera", ", of each camera"};
    case EffectScope::tag:
      return {"tag", ", of each tag of a body of tags"};
    case EffectScope::part:
      return {"part", ", of each session of a collection"};
    case EffectScope::session:
      return {"session", ""};
  }
  return {"", ""};
}

struct EffectsArguments {
  std::string session;
  Output output;
};

Json effect_json(const Effect& effect) {
  Json parameters = Json::array();
  for (const EffectParameter& p : effect.parameters)
    parameters.push_back({{"name", p.name}, {"unit", p.unit}, {"sigma", p.sigma}});
  Json j{{"id", effect.id},
         {"title", effect.title},
         {"cause", effect.cause},
         {"scope", list_words(effect.scope).name},
         {"parameters", parameters},
         {"visibility", effect.visibility},
         {"check", effect.check},
         {"source", effect.source},
         {"from", effect.definition ? effect.definition->file : "catalogue"}};
  if (effect.definition) j["definition"] = effect_definition_text(*effect.definition);
  return j;
}

void print_effect(const Output& output, const Effect& effect) {
  output.line(fmt::format("{}  ({})", effect.id, effect.title));
  const auto reported = [&](const char* what, const std::string& text) {
    if (!text.empty()) output.line(std::string("  ") + what + text);
  };
  reported("", effect.cause);
  for (const EffectParameter& p : effect.parameters)
    output.line(fmt::format("  {} [{}], prior sigma {:g}{}", p.name, p.unit, p.sigma, list_words(effect.scope).at));
  reported("Seen: ", effect.visibility);
  reported("Check: ", effect.check);
  reported("Source: ", effect.source);
  if (!effect.definition) return;
  for (const DefinedMove& m : effect.definition->moves) output.line(fmt::format("  Moves {} by {}", m.site, m.formula));
  output.line(fmt::format("  From {}, line {}", effect.definition->file, effect.definition->line));
}

int run(const EffectsArguments& o) {
  o.output.require_places();
  Json list = Json::array();
  OwnEffects own;
  if (!o.session.empty()) {
    const Session session = open_session(o.session);
    own = list_own_effects(session, make_chain(session));
  }
  const auto tell = [&](const Effect& effect) {
    print_effect(o.output, effect);
    list.push_back(effect_json(effect));
  };
  for (const Effect* effect : catalogue_beside(own)) tell(*effect);
  for (const std::shared_ptr<const Effect>& effect : own) tell(*effect);
  o.output.json(list);
  return done;
}

}  // namespace

Command add_effects(const CommandLine& program) {
  auto options = std::make_shared<EffectsArguments>();
  const CommandLine command = program.command("effects", "The catalogue of physical effects, and a session's own");
  command.option("--session", options->session, "A session folder: its own effects are told too");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
