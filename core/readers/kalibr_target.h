// SPDX-License-Identifier: Apache-2.0
// Kalibr's description of a target (april_6x6.yaml and the like).
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "print/target.h"

namespace handsight {

bool is_kalibr_target(const YAML::Node& yaml);

/// aprilgrid (tags of two modules' border, as kalibr_create_target_pdf draws them) and checkerboard. InputError where a
/// number is missing, and for a circlegrid, which cannot be found in images.
Target read_kalibr_target(const YAML::Node& yaml, const std::string& file);

}  // namespace handsight
