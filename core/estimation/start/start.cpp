// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/start.h"

#include "estimation/start/shape_start.h"
#include "estimation/start/start_by_points.h"

namespace handsight {

std::optional<Unknowns> start_values(const Problem& problem, const Mount& mount) {
  std::optional<Unknowns> start = start_by_shape(problem, mount);
  if (!start) start = start_by_points(problem, mount);
  if (start) start->effects = effect_values(problem);
  return start;
}

}  // namespace handsight
