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

}  // namespace handsight
