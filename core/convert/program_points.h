// SPDX-License-Identifier: Apache-2.0
// Points of robot programs as tables of the flange: KRL (.dat of KUKA), RAPID (.mod of ABB), TP (.ls of Fanuc).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "readers/table.h"

namespace handsight {

/// Every cartesian point that the program declares, in its order: x y z in mm and a quaternion. Nothing where the text
/// is no such program, or declares none. A sentence in the table's notes.
std::optional<Table> program_points(std::string_view text, const std::string& file);

}  // namespace handsight
