// SPDX-License-Identifier: Apache-2.0
// A simulated session that arrives bit by bit, as from a robot that moves.
#pragma once

#include "simulation/simulated_files.h"

namespace handsight::cli {

/// Makes `folder` with the first observation, then adds the others at `rate` a second: lines of joints.csv, and images
/// or lines of points.csv, in the order in which a robot's program writes them. InputError where the folder is there.
void simulate_live(const SimulatedSession& simulated, const SimulationOptions& options,
                   const std::filesystem::path& robot_file, const ImageOptions& images,
                   const std::filesystem::path& folder, double rate, const std::function<void(int)>& arrived);

}  // namespace handsight::cli
