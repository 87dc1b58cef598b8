// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/problem_part.h"

#include <algorithm>
#include <iterator>

namespace handsight {

Problem without_observations(const Problem& problem) {
  // Every field by its name: one that a problem gets some day is missing here until it is named too.
  const auto& [observations, rig, marker_count, mount_is_estimated, other_mounts_estimated, mount_distances,
               mount_places, marker_is_seen, source, terms, columns_of_effects, tcp_from_slip, other_slip_frames,
               with_motions, noise, noise_is_guessed, flange_error, cameras_by_effect, robot_scale, camera_images,
               shape] = problem;
  return Problem{{},
                 rig,
                 marker_count,
                 mount_is_estimated,
                 other_mounts_estimated,
                 mount_distances,
                 mount_places,
                 marker_is_seen,
                 source,
                 terms,
                 columns_of_effects,
                 tcp_from_slip,
                 other_slip_frames,
                 with_motions,
                 noise,
                 noise_is_guessed,
                 flange_error,
                 cameras_by_effect,
                 robot_scale,
                 camera_images,
                 shape};
}

Problem take_part(const Problem& problem, const std::function<bool(const ProblemObservation&)>& is_taken) {
  Problem part = without_observations(problem);
  std::copy_if(problem.observations.begin(), problem.observations.end(), std::back_inserter(part.observations),
               is_taken);
  return part;
}

Problem take_stretch(const Problem& problem, std::size_t first, std::size_t last) {
  Problem part = without_observations(problem);
  const auto at = [&](std::size_t place) {
    return problem.observations.begin() + static_cast<std::ptrdiff_t>(std::min(place, problem.observations.size()));
  };
  part.observations.assign(at(first), at(last));
  return part;
}

}  // namespace handsight
