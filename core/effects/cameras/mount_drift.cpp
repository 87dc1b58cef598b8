// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/list.h"

namespace handsight {
namespace {

/// How much of the drift has come: linear in time, or where `settling` is set 1 - exp(-t / (settling T)).
double arrived(const ObservationState& c, double settling) {
  if (!(c.duration > 0)) return 0;
  const double share = c.elapsed / c.duration;
  return settling > 0 ? 1 - std::exp(-share / settling) : share;
}

void move(const ObservationState& c, int, std::span<const double> values, Sites& sites) {
  sites.drift += arrived(c, values[6]) * Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect mount_drift() {
  Effect effect;
  effect.id = "mount_drift";
  effect.title = "Mount drift";
  effect.cause =
      "The cameras move slowly against their link while the session lasts: warming up, or a screw that "
      "gives way.";
  effect.visibility = "The order of the poses must not follow their posture.";
  effect.check = "Come back to the first pose at the end.";
  effect.check_reads = CheckReads::start_to_end;
  effect.source = "Common in photogrammetry";
  effect.scope = EffectScope::session;
  effect.parameters = {{"x", "m", 1e-3},
                       {"y", "m", 1e-3},
                       {"z", "m", 1e-3},
                       {"rx", "rad", 2e-3},
                       {"ry", "rad", 2e-3},
                       {"rz", "rad", 2e-3},
                       {"settling", "share of the session", 1, true, {0, 0.1, 0.3}}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
