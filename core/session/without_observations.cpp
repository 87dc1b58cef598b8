// SPDX-License-Identifier: Apache-2.0
#include "session/without_observations.h"

namespace handsight {

Session without_observations(const Session& session) {
  // All members by name, so that one that is added later cannot be forgotten here.
  const auto& [file, title, robot_file, robot, tcp, repeatability, gravity, mount, rig, sigma_pixel, sigma_point,
               pose_sensor, target, shape, marker_count, joints, parts, other_mounts, fixtures, distances, observations,
               effect_definitions, notes, source] = session;
  return {file,         title,
          robot_file,   robot,
          tcp,          repeatability,
          gravity,      mount,
          rig,          sigma_pixel,
          sigma_point,  pose_sensor,
          target,       shape,
          marker_count, joints,
          parts,        other_mounts,
          fixtures,     distances,
          {},           effect_definitions,
          notes,        source};
}

}  // namespace handsight
