// SPDX-License-Identifier: Apache-2.0
// Sample sessions with another number of cameras.
#pragma once

#include "app/window/desk.h"
#include "session/session_xml.h"

namespace handsight::test {

/// A copy of a sample in which only this many cameras are there; those beyond two have seen nothing.
inline std::filesystem::path sample_with_cameras(const std::filesystem::path& folder, const std::string& name,
                                                 int cameras) {
  const auto session = copy_of_sample(folder, name);
  Session s = read_session(session / "session.xml");
  if (cameras == 1) s.rig->cameras.resize(1);
  for (int i = 2; i < cameras; ++i) {
    s.rig->cameras.push_back(s.rig->cameras[1]);
    s.rig->cameras.back().name = fmt::format("side_{}", i);
    s.rig->cameras.back().camera_from_first.translation.y() += 0.1 * i;
  }
  for (Observation& o : s.observations) {
    if (cameras > 1) continue;
    o.images[1].clear();
    for (Sighting& sighting : o.sightings) forget(sighting, 1);
  }
  s.source.reset();
  save_session(s);
  return session;
}

}  // namespace handsight::test
