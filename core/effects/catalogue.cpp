// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <unordered_map>

#include "effects/list.h"

namespace handsight {

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> effects = {joint_offset(),
                                              joint_scale(),
                                              joint_elasticity(),
                                              link_elasticity(),
                                              link_geometry(),
                                              encoder_eccentricity(),
                                              transmission_ripple(),
                                              backlash(),
                                              friction_hysteresis(),
                                              payload(),
                                              base_tilt(),
                                              mimic_linkage(),
                                              base_elasticity(),
                                              mimic_error(),
                                              camera_mount(),
                                              stereo_rig(),
                                              camera_intrinsics(),
                                              lens_distortion(),
                                              time_lag(),
                                              mount_drift(),
                                              body_slip(),
                                              marker_slip()};
  return effects;
}

const Effect* find_effect(const std::string& id) {
  static const auto by_id = [] {
    std::unordered_map<std::string, const Effect*> map;
    for (const Effect& e : catalogue()) map.emplace(e.id, &e);
    return map;
  }();
  const auto found = by_id.find(id);
  return found == by_id.end() ? nullptr : found->second;
}

std::vector<int> effect_places(const Effect& effect, const Chain& chain) {
  std::vector<int> places;
  if (effect.scope == EffectScope::session) return {-1};
  if (effect.scope == EffectScope::marker)
    for (int m = 0; m < chain.marker_count; ++m) places.push_back(m);
  if (effect.scope == EffectScope::joint || effect.scope == EffectScope::mimic_joint)
    for (std::size_t j = 0; j < chain.robot.joints.size(); ++j) {
      const Joint& joint = chain.robot.joints[j];
      if (joint.moves() && (effect.scope == EffectScope::joint || joint.is_mimic()))
        places.push_back(static_cast<int>(j));
    }
  return places;
}

std::string place_name(const Effect& effect, int place, const Robot& robot) {
  if (place < 0) return "";
  if (effect.scope == EffectScope::marker) return fmt::format("marker {}", place);
  return robot.joints[static_cast<std::size_t>(place)].name;
}

int markers_of(const std::vector<EffectTerm>& terms) {
  int count = 0;
  for (const EffectTerm& term : terms)
    if (find_effect(term.id)->scope == EffectScope::marker) count = std::max(count, term.joint + 1);
  return count;
}

Sites moved_sites(const Circumstances& c, const std::vector<EffectTerm>& terms) {
  Sites sites;
  sites.markers.assign(static_cast<std::size_t>(std::max(c.chain->marker_count, markers_of(terms))), Vector3::Zero());
  if (terms.empty()) return sites;
  sites.robot.joints.resize(c.chain->robot.joints.size());
  for (const EffectTerm& term : terms) find_effect(term.id)->move(c, term.joint, term.values, sites);
  return sites;
}

}  // namespace handsight
