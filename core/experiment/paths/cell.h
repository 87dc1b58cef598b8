// SPDX-License-Identifier: Apache-2.0
// What stands about the robot: cell.xml.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

struct CellBox {
  Vector3 size = Vector3::Ones();  // m
  Rigid root_from_box;             // its middle
};

/// Solid is where normal . x < offset.
struct CellPlane {
  Vector3 normal = Vector3::UnitZ();  // unit, root frame
  double offset = 0;                  // m
};

struct Cell {
  std::vector<CellBox> boxes;
  std::vector<CellPlane> planes;
};

/// `<handsight_cell version="1"><box size="" xyz="" rpy=""/><plane normal="" offset=""/></handsight_cell>`, lengths in
/// m, in the root link's frame. InputError names file and line.
Cell parse_cell(const std::string& text, const std::string& file);
Cell read_cell(const std::filesystem::path& file);

}  // namespace handsight
