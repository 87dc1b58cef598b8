// SPDX-License-Identifier: Apache-2.0
// The hand that carries the markers, and where on it they are.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/scene_parts.h"

namespace handsight {

/// Places for 1 to 64 markers on the back of a hand: about 40 to 90 mm apart and not on a line for up to six, as near
/// as the labels allow for more; normals within some 15 degrees of `back`, all at most 0.4 m from the TCP.
std::vector<MarkerPlate> lay_out_markers(int count, double cell, std::uint64_t seed,
                                         const Vector3& back = Vector3::UnitX(),
                                         const Vector3& fingers = Vector3::UnitZ());

/// Labels at given places (TCP frame, m) with a common normal, turned at random in their planes. Cells are smaller than
/// `cell` where the labels would cover each other.
std::vector<MarkerPlate> marker_plates(const std::vector<Vector3>& centers, const Vector3& normal, double cell,
                                       std::uint64_t seed);

/// The frame of a label: z along its normal, x and y along the edges of its cells.
Rigid tcp_from_plate(const MarkerPlate& marker);

/// Axes whose z is along `normal` and whose x is as near to `along` as that allows.
Matrix3 axes_from(const Vector3& normal, const Vector3& along);

struct Hand {
  std::vector<Solid> solids;  // in the TCP frame
  std::vector<Plate> plates;
  std::vector<double> pedestals;  // m, per marker: deep enough to reach the palm
};

/// Palm, fingers and forearm for one marker or more; 8 mm are left for labels that slip inward.
Hand build_hand(const std::vector<MarkerPlate>& markers, const Vector3& fingers);

}  // namespace handsight
