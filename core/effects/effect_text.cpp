// SPDX-License-Identifier: Apache-2.0
// Effects with values as users write them.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "effects/effect.h"
#include "effects/target_effects.h"
#include "robot/joint_names.h"

namespace handsight {
namespace {

std::string known_effects(const OwnEffects& own) {
  std::string list;
  for (const Effect* effect : catalogue_beside(own)) list += (list.empty() ? "" : ", ") + effect->id;
  for (const std::shared_ptr<const Effect>& effect : own) list += ", " + effect->id;
  return list;
}

template <class Number>
bool read_number(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

int joint_for(const Effect& effect, const std::string& name, const Robot& robot, const std::string& text) {
  const int joint = find_joint(robot, name);
  if (joint < 0 || !robot.joints[static_cast<std::size_t>(joint)].moves())
    throw InputError(message("Effect \"{}\": the robot has no moving joint \"{}\"; it has: {}.", text, name,
                             list_moving_joints(robot)));
  if (effect.scope == EffectScope::mimic_joint && !robot.joints[static_cast<std::size_t>(joint)].is_mimic())
    throw InputError(
        message("Effect \"{}\": the joint \"{}\" follows no other; {} sits at joints that do.", text, name, effect.id));
  return joint;
}

int camera_for(const Effect& effect, const std::string& name, const std::string& text) {
  std::string known;
  for (std::size_t c = 0; c < effect.cameras.size(); ++c) {
    if (effect.cameras[c].empty()) continue;
    if (effect.cameras[c] == name) return static_cast<int>(c);
    known += (known.empty() ? "" : ", ") + effect.cameras[c];
  }
  throw InputError(message("Effect \"{}\": {} sits at no camera \"{}\"; it may sit at: {}.", text, effect.id, name,
                           known.empty() ? Message("none of this session") : verbatim(known)));
}

/// The numbers of the tags, as sentences list them.
std::string tags_of(const Effect& effect) {
  constexpr std::size_t most = 20;
  const std::size_t count = std::min(effect.tags.size(), most);
  return fmt::format("{}{}",
                     fmt::join(effect.tags.begin(), effect.tags.begin() + static_cast<std::ptrdiff_t>(count), ", "),
                     count < effect.tags.size() ? " ..." : "");
}

/// `effect.tags` may be empty: a calibration is read without the session that it is of.
int tag_for(const Effect& effect, const std::string& name, const std::string& text) {
  constexpr std::string_view prefix = "tag ";  // as place_name writes it
  int tag = -1;
  if (!read_number(name.starts_with(prefix) ? name.substr(prefix.size()) : name, tag) || tag < 0)
    throw InputError(message("Effect \"{}\": \"{}\" is no tag; write its number.", text, name));
  if (!effect.tags.empty() && std::find(effect.tags.begin(), effect.tags.end(), tag) == effect.tags.end())
    throw InputError(message("Effect \"{}\": the target has no tag {}; it has: {}.", text, tag, tags_of(effect)));
  return tag;
}

int part_for(const Effect& effect, const std::string& name, const std::string& text) {
  for (std::size_t p = 0; p < effect.parts.size(); ++p)
    if (!name.empty() && effect.parts[p] == name) return static_cast<int>(p);
  throw InputError(message("Effect \"{}\": {} sits at no session \"{}\"; it may sit at: {}.", text, effect.id, name,
                           fmt::join(effect.parts, ", ")));
}

int place_for(const Effect& effect, const std::string& name, const Robot& robot, const std::string& text) {
  if (effect.scope == EffectScope::camera) return camera_for(effect, name, text);
  if (effect.scope == EffectScope::tag) return tag_for(effect, name, text);
  if (effect.scope == EffectScope::part) return part_for(effect, name, text);
  if (effect.scope != EffectScope::marker) return joint_for(effect, name, robot, text);
  constexpr std::string_view prefix = "marker ";  // as place_name writes it
  int marker = -1;
  if (!read_number(name.starts_with(prefix) ? name.substr(prefix.size()) : name, marker) || marker < 0 || marker > 63)
    throw InputError(message("Effect \"{}\": \"{}\" is no marker; write its number, 0 to 63.", text, name));
  return marker;
}

/// An effect and, where it is one by formula, its owner.
struct Found {
  const Effect* effect;
  std::shared_ptr<const Effect> own;
};

Found effect_for(const std::string& id, const OwnEffects& own) {
  for (const std::shared_ptr<const Effect>& effect : own)
    if (effect->id == id) return {effect.get(), effect};
  if (const Effect* effect = find_effect(id)) return {effect, nullptr};
  throw InputError(message("Effect \"{}\" is not in the catalogue, which has: {}.", id, known_effects(own)));
}

std::size_t term_for(const Found& found, int place, std::vector<EffectTerm>& terms) {
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (terms[t].id == found.effect->id && terms[t].place == place) return t;
  terms.push_back(term_of(*found.effect, place, found.own));
  return terms.size() - 1;
}

const char* kind_of_place(EffectScope scope) {
  return scope == EffectScope::marker   ? "marker"
         : scope == EffectScope::camera ? "camera"
         : scope == EffectScope::tag    ? "tag"
         : scope == EffectScope::part   ? "session"
                                        : "joint";
}

/// `text` is what sentences call it.
NumberPlace add_number(const Found& found, int place, const std::string& name, double value, const std::string& text,
                       std::vector<EffectTerm>& terms) {
  const Effect& effect = *found.effect;
  const auto parameter = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                      [&](const EffectParameter& p) { return p.name == name; });
  if (parameter == effect.parameters.end())
    throw InputError(message("Effect \"{}\": {} has no parameter \"{}\".", text, effect.id, name));
  const NumberPlace number{term_for(found, place, terms),
                           static_cast<std::size_t>(parameter - effect.parameters.begin())};
  double& there = terms[number.term].values[number.parameter];
  there = parameter->is_choice ? value : there + value;
  return number;
}

}  // namespace

NumberPlace add_effect_number(const std::string& id, const std::string& of, const std::string& name, double value,
                              const Robot& robot, std::vector<EffectTerm>& terms, const OwnEffects& own) {
  const Found found = effect_for(id, own);
  const Effect& effect = *found.effect;
  const std::string text = fmt::format("{}:{}{}{}", id, of, of.empty() ? "" : ".", name);
  const int place = effect.scope == EffectScope::session ? -1 : place_for(effect, of, robot, text);
  return add_number(found, place, name, value, text, terms);
}

void add_effect_value(const std::string& text, const Robot& robot, std::vector<EffectTerm>& terms,
                      const OwnEffects& own) {
  const auto colon = text.find(':');
  const auto equals = text.find('=');
  if (colon == std::string::npos || equals == std::string::npos || equals < colon)
    throw InputError(
        message("Effect \"{}\" has no value; write it as id:joint.parameter=value, for example "
                "joint_elasticity:arm_2.compliance=1e-4.",
                text));
  const std::string id = text.substr(0, colon);
  const Found found = effect_for(id, own);
  const Effect* const effect = found.effect;
  if (has_no_target(*effect))
    throw InputError(message("Effect \"{}\": this session has no {}, which {} is of.", text,
                             effect->scope == EffectScope::tag ? "body of tags whose places are known"
                                                               : "target of one piece whose shape is known",
                             id));
  std::string name = text.substr(colon + 1, equals - colon - 1);
  int place = -1;
  if (effect->scope != EffectScope::session) {
    const auto dot = name.rfind('.');
    const char* const kind = kind_of_place(effect->scope);
    if (dot == std::string::npos)
      throw InputError(message("Effect \"{}\" sits at a {}; write {}:{}.parameter=value.", text, kind, id,
                               effect->scope == EffectScope::marker || effect->scope == EffectScope::tag ? "0" : kind));
    place = place_for(*effect, name.substr(0, dot), robot, text);
    name = name.substr(dot + 1);
  }
  double value = 0;
  if (!read_number(text.substr(equals + 1), value) || !std::isfinite(value))
    throw InputError(message("Effect \"{}\": \"{}\" is not a finite number.", text, text.substr(equals + 1)));
  add_number(found, place, name, value, text, terms);
}

std::vector<EffectTerm> effect_terms(const std::string& text, const Chain& chain, const OwnEffects& own) {
  const auto colon = text.find(':');
  const std::string id = text.substr(0, colon);
  const Found found = effect_for(id, own);
  const Effect* const effect = found.effect;
  std::vector<int> places;
  if (colon == std::string::npos) {
    places = effect_places(*effect, chain);
    if (places.empty())
      throw InputError(message("Effect \"{}\" has no place in this session: it sits at {}.", id,
                               effect->scope == EffectScope::mimic_joint ? "joints that follow others"
                               : effect->scope == EffectScope::camera ? "cameras, which this session has not got for it"
                               : effect->scope == EffectScope::tag    ? "the tags of a body whose places are known"
                               : effect->scope == EffectScope::session ? "a target of one piece whose shape is known"
                               : effect->scope == EffectScope::joint   ? "joints between the sensor and the TCP"
                                                                       : "markers"));
  } else if (effect->scope == EffectScope::session) {
    throw InputError(message("Effect \"{}\" sits at no joint; write {} alone.", text, id));
  } else {
    std::string rest = text.substr(colon + 1);
    while (true) {
      const auto plus = rest.find('+');
      places.push_back(place_for(*effect, rest.substr(0, plus), chain.robot, text));
      if (plus == std::string::npos) break;
      rest = rest.substr(plus + 1);
    }
  }
  std::vector<EffectTerm> terms;
  for (const int place : places) term_for(found, place, terms);
  return terms;
}

}  // namespace handsight
