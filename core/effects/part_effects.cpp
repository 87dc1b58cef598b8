// SPDX-License-Identifier: Apache-2.0
#include "effects/part_effects.h"

#include <algorithm>

#include "base/error.h"
#include "effects/list.h"
#include "effects/rig_effects.h"

namespace handsight {
namespace {

/// By what parts an effect is distinguished: each by itself, or one for all with the same mount or body.
using Owner = int Chain::*;

/// The effect at every part that is the first with its owner's number; it moves all parts with that number.
Effect at_parts(Effect effect, const Chain& chain, Owner owner, bool is_of_hand) {
  const auto of_session = effect.move;
  std::vector<int> numbers;  // by part
  for (const Chain& part : chain.parts) {
    // Which fixture the hand touches changes nothing about it.
    const bool is_own = !(part.is_fixture && is_of_hand);
    const bool is_new = is_own && std::find(numbers.begin(), numbers.end(), part.*owner) == numbers.end();
    effect.parts.push_back(is_new ? chain.part_names[numbers.size()] : "");
    numbers.push_back(part.*owner);
  }
  effect.scope = EffectScope::part;
  effect.move = [=](const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
    // A pose outside any part asks what the effect does where it acts.
    const bool is_of_part = c.chain->parts.empty() && !numbers.empty();
    if (is_of_part && c.chain->*owner != numbers[static_cast<std::size_t>(place)]) return;
    of_session(c, -1, values, sites);
  };
  return effect;
}

/// The session that a part is of: fixtures of one are named after it, "SESSION FIXTURE"; of a session by itself, "".
std::string find_session(const Chain& chain, const Chain& part) {
  const std::string& name = chain.part_names[static_cast<std::size_t>(part.part)];
  if (!part.is_fixture) return name;
  const std::size_t blank = name.rfind(' ');
  return blank == std::string::npos ? "" : name.substr(0, blank);
}

bool is_one_session(const Chain& chain) {
  return std::all_of(chain.parts.begin(), chain.parts.end(), [&](const Chain& part) {
    return find_session(chain, part) == find_session(chain, chain.parts.front());
  });
}

/// A joint's effect that is another in one session than in the others: what has changed between them.
Effect changed_between(const Effect& of_robot, const Chain& chain) {
  Effect effect = of_robot;
  effect.id = of_robot.id + "_changed";
  effect.title = of_robot.title + " changed between sessions";
  effect.cause = "In one session this is another than in the others. " + of_robot.cause;
  effect.visibility = "Needs a session before and one after the change. " + of_robot.visibility;
  effect.scope = EffectScope::part;
  struct Place {
    int session, joint;
  };
  std::vector<Place> places;
  std::vector<std::string> sessions;
  std::vector<int> session_of_part;
  for (const Chain& part : chain.parts) {
    const std::string name = find_session(chain, part);
    const auto known = std::find(sessions.begin(), sessions.end(), name);
    const auto session = static_cast<int>(known - sessions.begin());
    session_of_part.push_back(session);
    if (known != sessions.end()) continue;  // another fixture of it
    sessions.push_back(name);
    for (const int joint : effect_places(of_robot, chain)) {
      const std::string& joint_name = chain.robot.joints[static_cast<std::size_t>(joint)].name;
      const auto& own = part.own;
      const bool is_asked = std::find(own.begin(), own.end(), of_robot.id + ":" + joint_name) != own.end() ||
                            std::find(own.begin(), own.end(), of_robot.id) != own.end();
      if (session == 0 && !is_asked) continue;  // against the first session, unless that is the one
      places.push_back({session, joint});
      effect.parts.push_back(name.empty() ? joint_name : fmt::format("{} {}", name, joint_name));
    }
  }
  effect.formulas = nullptr;  // its places are not the robot's joints
  effect.move = [=, of_robot_move = of_robot.move](const ObservationState& c, int place, std::span<const double> values,
                                                   Sites& sites) {
    const Place& at = places[static_cast<std::size_t>(place)];
    if (c.chain->parts.empty() && session_of_part[static_cast<std::size_t>(c.chain->part)] != at.session) return;
    of_robot_move(c, at.joint, values, sites);
  };
  return effect;
}

/// The effects of joints that a part has for itself by its description, and the one that changes most often.
std::vector<std::string> may_change(const Chain& chain) {
  std::vector<std::string> ids{"joint_offset"};
  for (const Chain& part : chain.parts)
    for (const std::string& own : part.own) {
      const std::string id = own.substr(0, own.find(':'));
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    }
  return ids;
}

}  // namespace

OwnEffects part_effects(const Chain& chain) {
  OwnEffects all;
  if (chain.parts.empty()) return all;
  const auto add = [&](Effect effect, Owner owner, bool is_of_hand = false) {
    all.push_back(std::make_shared<const Effect>(at_parts(std::move(effect), chain, owner, is_of_hand)));
  };
  add(camera_mount(), &Chain::mount);
  add(mount_drift(), &Chain::part);
  add(mount_slip(), &Chain::part);
  if (chain.is_touch && is_one_session(chain)) return all;
  add(payload(), &Chain::body);
  add(time_lag(), &Chain::part, true);
  add(body_slip(), &Chain::part, true);
  for (const std::string& id : may_change(chain)) {
    const Effect* const effect = find_effect(id);
    if (!effect || !moves_one_joint(*effect))
      throw InputError(
          message("own=\"{}\": only effects that sit at joints can be one session's own; slips, drifts, "
                  "cameras and bodies are so without being named.",
                  id));
    all.push_back(std::make_shared<const Effect>(changed_between(*effect, chain)));
  }
  return all;
}

std::vector<EffectTerm> own_terms(const Chain& chain, const OwnEffects& effects) {
  std::vector<EffectTerm> terms;
  std::vector<std::string> asked;  // sessions, of which each fixture has the same
  for (const Chain& part : chain.parts) {
    if (std::find(asked.begin(), asked.end(), find_session(chain, part)) != asked.end()) continue;
    asked.push_back(find_session(chain, part));
    for (const std::string& said : part.own) {
      const std::string id = said.substr(0, said.find(':')) + "_changed";
      const std::string joint = said.find(':') == std::string::npos ? "" : said.substr(said.find(':') + 1);
      const std::string session = find_session(chain, part);
      const std::string before_joint = session.empty() ? "" : session + " ";
      const std::size_t before = terms.size();
      for (const std::shared_ptr<const Effect>& effect : effects)
        for (std::size_t p = 0; effect->id == id && p < effect->parts.size(); ++p)
          if (effect->parts[p] == before_joint + joint || (joint.empty() && effect->parts[p].starts_with(before_joint)))
            terms.push_back(term_of(*effect, static_cast<int>(p), effect));
      if (terms.size() == before)
        throw InputError(
            message("session \"{}\": own=\"{}\" names no joint between its sensor and its TCP.", session, said));
    }
  }
  return terms;
}

Effect at_bodies(const std::vector<std::pair<int, Effect>>& of_parts, const Chain& chain) {
  Effect all = of_parts.front().second;
  all.scope = EffectScope::part;
  all.parts.assign(chain.parts.size(), "");
  struct Body {
    int number = -1;
    std::ptrdiff_t first_marker = 0;
    decltype(Effect::move) move = {};
  };
  std::vector<Body> bodies(chain.parts.size());
  for (const auto& [part, effect] : of_parts) {
    const auto p = static_cast<std::size_t>(part);
    all.parts[p] = chain.part_names[p];
    bodies[p] = {chain.parts[p].body, chain.parts[p].first_marker, effect.move};
  }
  all.move = [=](const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
    const Body& body = bodies[static_cast<std::size_t>(place)];
    const bool is_of_part = c.chain->parts.empty();
    const bool has_markers = static_cast<std::ptrdiff_t>(sites.markers.size()) > body.first_marker;
    if ((is_of_part && c.chain->body != body.number) || !has_markers) return;
    std::vector<Vector3> markers = std::move(sites.markers);
    sites.markers.assign(markers.begin() + body.first_marker, markers.end());  // each body counts its own from 0
    body.move(c, -1, values, sites);
    std::copy(sites.markers.begin(), sites.markers.end(), markers.begin() + body.first_marker);
    sites.markers = std::move(markers);
  };
  return all;
}

OwnEffects rig_effects_of_parts(const Rig& cameras, const std::vector<int>& firsts) {
  if (firsts.size() <= 1) return rig_effects(cameras);
  const Rig one{{cameras.at(0)}};  // of a single camera each number is its own
  OwnEffects all = rig_effects(one);
  OwnEffects named;
  for (const std::shared_ptr<const Effect>& effect : all) {
    Effect own = *effect;
    if (!own.cameras.empty()) own.cameras = camera_names(cameras);
    named.push_back(std::make_shared<const Effect>(std::move(own)));
  }
  Effect moved = rig_motions(cameras);
  for (const int first : firsts) moved.cameras[static_cast<std::size_t>(first)].clear();
  const bool any =
      std::any_of(moved.cameras.begin(), moved.cameras.end(), [](const std::string& name) { return !name.empty(); });
  if (any) named.push_back(std::make_shared<const Effect>(std::move(moved)));
  return named;
}

}  // namespace handsight
