// SPDX-License-Identifier: Apache-2.0
/// @file
/// A model: the effects that are taken to be there beside the robot's description, where they sit, with which values,
/// and which of them a fit may move. `handsight-cli effects` lists the catalogue with parameters, units and sources.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace handsight {

/// A model from effects as they are written on the command line: "joint_offset" (everywhere it may sit) and
/// "joint_offset:arm_2+arm_3" are estimated, "joint_offset:arm_2.offset=0.01" is held at that value. Where an effect
/// has a choice (the observation from which on a slip is there), the one that suits the session best.
/// Throws InputError where a name is not known; the sentence lists what is.
Model named_model(const Session& session, const std::vector<std::string>& effects);

}  // namespace handsight
