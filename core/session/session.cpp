// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

namespace handsight {

std::filesystem::path folder(const Session& session) {
  const std::filesystem::path parent = session.file.parent_path();
  return parent.empty() ? "." : parent;
}

bool is_used(const Observation& observation) {
  return !observation.sightings.empty() && observation.decision != Decision::rejected &&
         observation.decision != Decision::excluded;
}

}  // namespace handsight
