// SPDX-License-Identifier: Apache-2.0
// Simulated sessions that tests of the diagnosis share.
#pragma once

#include "fixtures/arms.h"

namespace handsight {

/// A six-axis arm with springs at its second and third joint, watched from a stand.
inline Session like_stand() {
  Session s = fixture::stand_session();
  s.robot.joints[1].stiffness = s.robot.joints[2].stiffness = 12000;
  return s;
}

/// What it measures where these effects are hidden: noise 0.2 px (0.2 mm with a tracker), not declared.
inline Session simulated(const std::vector<EffectTerm>& effects, std::uint64_t seed, int observations = 60,
                         const Session& like = like_stand()) {
  SimulationOptions o;
  o.effects = effects;
  o.seed = seed;
  o.observations = observations;
  o.noise = like.is_tracker() ? 2e-4 : 0.2;
  o.declare_noise = false;
  return simulate_session(like, o).session;
}

/// Play at each joint of the seven-axis arm, and a base that is tilted: a first joint whose axis is upright has no
/// load, so that its play shows only with the tilt, and the tilt hardly without it.
inline std::vector<EffectTerm> play_beside_a_tilt() {
  std::vector<EffectTerm> hidden{{"base_tilt", -1, {-0.0336, -0.029}}};
  int joint = 0;
  for (const double gap : {-6.1e-4, -5.1e-4, -1.6e-5, 6.2e-4, 3.8e-4, 5.3e-4, 1.3e-4})
    hidden.push_back({"backlash", joint++, {gap}});
  return hidden;
}

}  // namespace handsight
