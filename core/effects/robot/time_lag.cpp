// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int, std::span<const double> values, Sites& sites) {
  const std::vector<Joint>& joints = c.chain->robot.joints;
  // A mimic joint follows the lagging joints by itself.
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].moves() && !joints[j].is_mimic())
      sites.robot.joints[j].angle -= values[0] * c.velocity[static_cast<Eigen::Index>(j)];
}

}  // namespace

Effect time_lag() {
  Effect effect;
  effect.id = "time_lag";
  effect.title = "Time lag";
  effect.cause =
      "The joint angles belong to another instant than the images: while the arm moves it is already "
      "elsewhere.";
  effect.visibility = "Needs joint velocities; poses at rest cannot show it.";
  effect.check = "Stop the arm before each image: the error must vanish.";
  effect.source = "Furgale, Rehder and Siegwart 2013";
  effect.scope = EffectScope::session;
  effect.parameters = {{"lag", "s", 0.02}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
