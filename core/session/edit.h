// SPDX-License-Identifier: Apache-2.0
// What can be changed of a session's observations once they are measured, and a change of them as data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// Reasons of those that a user leaves out.
inline constexpr const char* by_the_user = "by the user";
inline constexpr const char* beyond_the_threshold = "beyond the threshold";

/// What a user can change of one observation.
struct EditableState {
  std::vector<Sighting> sightings;
  Decision decision = Decision::none;
  Message reason;
};

EditableState read_state(const Observation& observation);
void set_state(Observation& observation, const EditableState& state);
bool same_state(const EditableState& a, const EditableState& b);

struct ObservationEdit {
  std::int64_t id = 0;
  EditableState before, after;
};

/// Of the observations of one session: those that were changed, and those that came.
struct SessionEdit {
  std::vector<ObservationEdit> observations;
  std::vector<Observation> added;

  bool is_empty() const { return observations.empty() && added.empty(); }
};

}  // namespace handsight
