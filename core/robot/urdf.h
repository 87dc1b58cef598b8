// SPDX-License-Identifier: Apache-2.0
// Robots from URDF files, with three extensions in a <joint> that other URDF readers ignore:
//   <stiffness value="9000"/>               the joint's spring, N m/rad (N/m); absent: rigid
//   several <mimic>                          their contributions add
//   <dh a="" alpha="" d="" theta=""/>        in place of <origin> and <axis>: Craig's modified
//   Denavit-Hartenberg,
//                                            parent_from_child = Rx(alpha) Tx(a) Rz(theta + q) Tz(d)
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "robot/robot.h"

namespace handsight {

/// Reads a URDF file. InputError where it is wrong. `notes` takes, a sentence each, what was left out or
/// looks wrong.
Robot read_urdf(const std::filesystem::path& path, std::vector<Message>* notes = nullptr);

/// The same from a text; `file_name` is what sentences call it. Links and joints are ordered so that parents
/// come before children, depth first, siblings as in the file. A mimic of a mimic is kept as it is written;
/// loops are refused. Bytes that are not UTF-8 are read as Latin-1.
Robot parse_urdf(const std::string& text, const std::string& file_name, std::vector<Message>* notes);

}  // namespace handsight
