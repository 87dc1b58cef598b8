// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "command.h"
#include "effects/effect.h"

namespace handsight::cli {
namespace {

const char* at(EffectScope scope) {
  switch (scope) {
    case EffectScope::joint:
      return ", at each joint";
    case EffectScope::mimic_joint:
      return ", at each joint that follows others";
    case EffectScope::marker:
      return ", at each marker";
    case EffectScope::session:
      return "";
  }
  return "";
}

int run(const Output& output) {
  output.require_places();
  Json list = Json::array();
  for (const Effect& effect : catalogue()) {
    output.line(fmt::format("{}  ({})", effect.id, effect.title));
    output.line("  " + effect.cause);
    Json parameters = Json::array();
    for (const EffectParameter& p : effect.parameters) {
      output.line(fmt::format("  {} [{}], plausible size {:g}{}", p.name, p.unit, p.sigma, at(effect.scope)));
      parameters.push_back({{"name", p.name}, {"unit", p.unit}, {"sigma", p.sigma}});
    }
    output.line("  Seen: " + effect.visibility);
    output.line("  Check: " + effect.check);
    output.line("  Source: " + effect.source);
    list.push_back({{"id", effect.id},
                    {"title", effect.title},
                    {"cause", effect.cause},
                    {"parameters", parameters},
                    {"visibility", effect.visibility},
                    {"check", effect.check},
                    {"source", effect.source}});
  }
  output.json(list);
  return done;
}

}  // namespace

Command add_effects(CLI::App& app) {
  auto output = std::make_shared<Output>();
  CLI::App* command = app.add_subcommand("effects", "The catalogue of physical effects");
  add_json_option(*command, *output);
  return {command, [output] { return run(*output); }};
}

}  // namespace handsight::cli
