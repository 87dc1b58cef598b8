// SPDX-License-Identifier: Apache-2.0
// Poses as options give them: --position, --positions FILE.csv.
#pragma once

#include "predict_source.h"

namespace handsight::cli {

struct PoseOptions {
  std::vector<std::string> positions;
  std::string file;
};
void add_pose_options(const CommandLine& command, PoseOptions& options);

/// What the options name, those of --position first, each at rest and from nowhere. InputError where there is none or
/// one is wrong. Prints what of the table was used.
std::vector<ObservationState> driven_poses(const PoseOptions& options, const CalibratedRobot& source);

}  // namespace handsight::cli
