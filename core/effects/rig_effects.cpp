// SPDX-License-Identifier: Apache-2.0
#include "effects/rig_effects.h"

#include "effects/list.h"

namespace handsight {
namespace {

EffectParameter parameter_of(const CameraNumber& number, const std::string& prefix) {
  return {.name = prefix + number.name,
          .unit = number.unit,
          .sigma = number.sigma,
          .share_of_focal = number.share_of_focal};
}

/// An effect that this rig cannot have.
Effect nowhere(Effect effect) {
  effect.scope = EffectScope::camera;
  return effect;
}

}  // namespace

Effect with_camera_numbers(Effect effect, const Rig& rig, int first, int count) {
  const int cameras = is_pair(rig) ? 2 : 1;  // that one effect moves
  effect.scope = is_pair(rig) ? EffectScope::session : EffectScope::camera;
  if (!is_pair(rig)) effect.cameras = camera_names(rig);
  for (int c = 0; c < cameras; ++c)
    for (const CameraNumber& number : camera_numbers(rig.at(c).camera).subspan(first, count))
      effect.parameters.push_back(parameter_of(number, is_pair(rig) ? rig.at(c).name + "_" : ""));
  effect.move = [=](const ObservationState&, int place, std::span<const double> values, Sites& sites) {
    for (int c = 0; c < cameras; ++c) {
      CameraChange& change = sites.cameras[static_cast<std::size_t>(place >= 0 ? place : c)];
      for (int i = 0; i < count; ++i) change.numbers[first + i] += values[static_cast<std::size_t>(c * count + i)];
    }
  };
  return effect;
}

OwnEffects rig_effects(const Rig& rig) {
  if (is_left_and_right(rig)) return {};
  OwnEffects all;
  if (!is_pair(rig)) all.push_back(std::make_shared<const Effect>(nowhere(stereo_rig())));
  if (rig.count() > 2) all.push_back(std::make_shared<const Effect>(rig_motions(rig)));
  all.push_back(std::make_shared<const Effect>(camera_intrinsics(rig)));
  all.push_back(std::make_shared<const Effect>(lens_distortion(rig)));
  return all;
}

}  // namespace handsight
