// SPDX-License-Identifier: Apache-2.0
// A link's surface as triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace handsight {

/// Triangles of points in the file's own unit. Every index is below the number of points, every number finite.
struct Mesh {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace handsight
