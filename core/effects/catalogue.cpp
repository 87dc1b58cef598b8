// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "effects/effect.h"
#include "effects/target_effects.h"

namespace handsight {

const Effect* find_effect(const std::string& id) {
  static const auto by_id = [] {
    std::unordered_map<std::string, const Effect*> map;
    for (const Effect& e : catalogue()) map.emplace(e.id, &e);
    return map;
  }();
  const auto found = by_id.find(id);
  return found == by_id.end() ? nullptr : found->second;
}

std::vector<const Effect*> catalogue_beside(const OwnEffects& own) {
  std::vector<const Effect*> all;
  for (const Effect& effect : catalogue())
    if (std::none_of(own.begin(), own.end(), [&](const auto& o) { return o->id == effect.id; })) all.push_back(&effect);
  return all;
}

const Effect* find_effect(const std::string& id, const OwnEffects& own) {
  for (const std::shared_ptr<const Effect>& effect : own)
    if (effect->id == id) return effect.get();
  return find_effect(id);
}

const Effect& term_effect(const EffectTerm& term) {
  if (term.own) return *term.own;
  const Effect* effect = find_effect(term.id);
  check(effect != nullptr, "\"{}\" is no effect of the catalogue", term.id);
  return *effect;
}

EffectTerm term_of(const Effect& effect, int place, std::shared_ptr<const Effect> own) {
  EffectTerm term{effect.id, place, std::vector<double>(effect.parameters.size(), 0.0), {}, std::move(own)};
  // A choice that cannot be 0 is the first of its alternatives.
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (const std::vector<double>& choices = effect.parameters[p].choices;
        !choices.empty() && std::find(choices.begin(), choices.end(), 0.0) == choices.end())
      term.values[p] = choices.front();
  return term;
}

namespace {

/// Marks the joints from a link up to the root.
void mark_up_to_root(const Robot& robot, int link, std::vector<char>& marked) {
  for (int j = robot.links[static_cast<std::size_t>(link)].parent_joint; j >= 0;
       j = robot.links[static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(j)].parent_link)].parent_joint)
    marked[static_cast<std::size_t>(j)] = 1;
}

/// Marks joints that carry mass above a marked spring: their posture is its load. Parents come before children.
void mark_loads(const Robot& robot, std::vector<char>& marked) {
  const std::size_t count = robot.joints.size();
  std::vector<char> carries_mass(count, 0), hangs_on_spring(count, 0);
  for (std::size_t j = count; j-- > 0;) {
    const auto child = static_cast<std::size_t>(robot.joints[j].child_link);
    if (robot.links[child].mass > 0) carries_mass[j] = 1;
    const int above = robot.links[static_cast<std::size_t>(robot.joints[j].parent_link)].parent_joint;
    if (above >= 0 && carries_mass[j]) carries_mass[static_cast<std::size_t>(above)] = 1;
  }
  for (std::size_t j = 0; j < count; ++j) {
    const int above = robot.links[static_cast<std::size_t>(robot.joints[j].parent_link)].parent_joint;
    if (above < 0) continue;
    const auto a = static_cast<std::size_t>(above);
    hangs_on_spring[j] = hangs_on_spring[a] || (marked[a] && robot.joints[a].stiffness > 0);
  }
  for (std::size_t j = 0; j < count; ++j)
    if (hangs_on_spring[j] && carries_mass[j]) marked[j] = 1;
}

/// The joints that the measurement can depend on: between the root and the chain's two ends, what loads springs there,
/// and what such joints follow. Wheels, grippers and the other arm are none of them.
std::vector<char> joints_that_matter(const Chain& chain) {
  const Robot& robot = chain.robot;
  std::vector<char> marked(robot.joints.size(), 0);
  mark_up_to_root(robot, chain.tcp_link, marked);
  mark_up_to_root(robot, chain.mount_link, marked);
  for (const Chain& part : chain.parts) {
    mark_up_to_root(robot, part.tcp_link, marked);
    mark_up_to_root(robot, part.mount_link, marked);
  }
  mark_loads(robot, marked);
  for (bool has_new = true; has_new;) {
    has_new = false;
    for (std::size_t j = 0; j < marked.size(); ++j)
      for (const Mimic& mimic : robot.joints[j].mimics) {
        char& followed = marked[static_cast<std::size_t>(mimic.joint)];
        has_new = has_new || (marked[j] && !followed);
        followed = followed || marked[j];
      }
  }
  return marked;
}

}  // namespace

std::vector<int> effect_places(const Effect& effect, const Chain& chain) {
  std::vector<int> places;
  if (effect.scope == EffectScope::session && !has_no_target(effect)) return {-1};
  if (effect.scope == EffectScope::tag) return effect.tags;
  if (effect.scope == EffectScope::part)
    for (std::size_t p = 0; p < effect.parts.size(); ++p)
      if (!effect.parts[p].empty()) places.push_back(static_cast<int>(p));
  if (effect.scope == EffectScope::camera)
    for (std::size_t c = 0; c < effect.cameras.size(); ++c)
      if (!effect.cameras[c].empty()) places.push_back(static_cast<int>(c));
  if (effect.scope == EffectScope::marker && !chain.is_one_target)
    for (int m = 0; m < chain.marker_count; ++m) places.push_back(m);
  if (!moves_one_joint(effect) || chain.robot.is_of_poses) return places;
  const std::vector<char> matters = joints_that_matter(chain);
  for (std::size_t j = 0; j < chain.robot.joints.size(); ++j) {
    const Joint& joint = chain.robot.joints[j];
    if (matters[j] && joint.moves() && (effect.scope == EffectScope::joint || joint.is_mimic()))
      places.push_back(static_cast<int>(j));
  }
  return places;
}

std::string place_name(const Effect& effect, int place, const Robot& robot) {
  if (place < 0) return "";
  if (effect.scope == EffectScope::marker) return fmt::format("marker {}", place);
  if (effect.scope == EffectScope::tag) return fmt::format("tag {}", place);
  if (effect.scope == EffectScope::part) return effect.parts[static_cast<std::size_t>(place)];
  if (effect.scope == EffectScope::camera) return effect.cameras[static_cast<std::size_t>(place)];
  return robot.joints[static_cast<std::size_t>(place)].name;
}

double prior_sigma(const EffectParameter& parameter, const Chain& chain) {
  if (!(parameter.share_of_focal > 0) || !chain.rig) return parameter.sigma;
  double sum = 0;
  for (const RigCamera& c : chain.rig->cameras) sum += c.camera.fx;
  return parameter.share_of_focal * (sum / chain.rig->count());
}

Sites unmoved_sites(const Chain& chain) {
  Sites sites;
  sites.robot.joints.resize(chain.robot.joints.size());
  sites.markers.assign(static_cast<std::size_t>(chain.marker_count), Vector3::Zero());
  return sites;
}

bool is_finite(const Sites& s) {
  const auto joint = [](const JointChange& j) {
    return std::isfinite(j.angle) && j.frame.allFinite() && j.after.allFinite() && std::isfinite(j.compliance) &&
           std::isfinite(j.lateral_compliance) && std::isfinite(j.gap);
  };
  return std::all_of(s.robot.joints.begin(), s.robot.joints.end(), joint) && std::isfinite(s.robot.tilt_x) &&
         std::isfinite(s.robot.tilt_y) && s.mount.allFinite() && s.drift.allFinite() && s.body.allFinite() &&
         s.hand.allFinite() &&
         std::all_of(s.cameras.begin(), s.cameras.end(),
                     [](const CameraChange& c) { return c.motion.allFinite() && c.numbers.allFinite(); }) &&
         std::all_of(s.markers.begin(), s.markers.end(), [](const Vector3& m) { return m.allFinite(); });
}

int count_markers(const std::vector<EffectTerm>& terms) {
  int count = 0;
  for (const EffectTerm& term : terms)
    if (term_effect(term).scope == EffectScope::marker) count = std::max(count, term.place + 1);
  return count;
}

Sites moved_sites(const ObservationState& c, const std::vector<EffectTerm>& terms) {
  Sites sites;
  sites.markers.assign(static_cast<std::size_t>(std::max(c.chain->marker_count, count_markers(terms))),
                       Vector3::Zero());
  if (terms.empty()) return sites;
  sites.robot.joints.resize(c.chain->robot.joints.size());
  for (const EffectTerm& term : terms) term_effect(term).move(c, term.place, term.values, sites);
  return sites;
}

}  // namespace handsight
