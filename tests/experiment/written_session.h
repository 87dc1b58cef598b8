// SPDX-License-Identifier: Apache-2.0
// Sessions in folders, with which an experiment may begin.
#pragma once

#include "base/files.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"

namespace handsight::fixture {

/// A session of so many observations, with its robot, in a new folder inside `parent`.
inline std::filesystem::path written_session(const Session& like, const std::filesystem::path& parent,
                                             int observations = 3, std::uint64_t seed = 5,
                                             const std::string& name = "session") {
  const std::filesystem::path urdf = parent / (name + ".urdf");
  replace_file(urdf, urdf_text(like.robot));
  SimulationOptions options;
  options.observations = observations;
  options.seed = seed;
  write_simulated(simulate_session(like, options), options, urdf, {}, parent / name);
  return parent / name;
}

}  // namespace handsight::fixture
