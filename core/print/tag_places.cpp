// SPDX-License-Identifier: Apache-2.0
// Tags at known places: bodies of several, and ArUco grid boards.
#include <algorithm>

#include "print/target.h"

namespace handsight {

Rigid target_from_tag(const TagPlace& place) { return {rotation_from_rpy(place.rpy), place.xyz}; }

bool are_places_exact(const Target& target) {
  return std::all_of(target.places.begin(), target.places.end(),
                     [](const TagPlace& p) { return p.sigma == 0 && p.sigma_angle == 0; });
}

Target without_places(Target target) {
  if (!target.places.empty()) target.sigma.reset();
  return target;
}

Target scaled(Target target, double factor) {
  for (double* length : {&target.square, &target.tag, &target.separation}) *length *= factor;
  if (target.sigma) *target.sigma *= factor;
  for (TagPlace& place : target.places) {
    place.xyz *= factor;
    place.size *= factor;
    place.sigma *= factor;
  }
  return target;
}

void lay_out_grid(Target& target) {
  target.ids.clear();
  target.places.clear();
  const double step = target.tag + target.separation;
  for (int row = 0; row < target.rows; ++row)
    for (int column = 0; column < target.columns; ++column) {
      const double middle = 0.5 * target.tag;
      target.ids.push_back(target.first_id + static_cast<int>(target.ids.size()));
      target.places.push_back(
          {.xyz = Vector3(column * step + middle, row * step + middle, 0), .size = target.tag, .sigma = 0});
    }
}

}  // namespace handsight
