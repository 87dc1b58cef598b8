// SPDX-License-Identifier: Apache-2.0
#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

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
  moves_every_angle(effect, [](const auto& joint, const auto& number) { return -number[0] * joint.velocity; });
  return effect;
}

}  // namespace handsight
