// SPDX-License-Identifier: Apache-2.0
#include "session/edit.h"

#include <algorithm>

namespace handsight {
namespace {

bool same_cameras(const Sighting& x, const Sighting& y) {
  return std::equal(
      x.in_cameras.begin(), x.in_cameras.end(), y.in_cameras.begin(), y.in_cameras.end(),
      [](const CameraPoint& a, const CameraPoint& b) { return a.camera == b.camera && a.pixel == b.pixel; });
}

bool same_sighting(const Sighting& x, const Sighting& y) {
  return x.marker == y.marker && x.by == y.by && same_cameras(x, y) && x.point == y.point;
}

}  // namespace

EditableState read_state(const Observation& observation) {
  return {observation.sightings, observation.decision, observation.reason};
}

void set_state(Observation& observation, const EditableState& state) {
  observation.sightings = state.sightings;
  observation.decision = state.decision;
  observation.reason = state.reason;
}

bool same_state(const EditableState& a, const EditableState& b) {
  return a.decision == b.decision && a.reason == b.reason &&
         std::equal(a.sightings.begin(), a.sightings.end(), b.sightings.begin(), b.sightings.end(), same_sighting);
}

}  // namespace handsight
