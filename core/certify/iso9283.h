// SPDX-License-Identifier: Apache-2.0
// Figures of ISO 9283:1998, "Manipulating industrial robots: performance criteria and related test methods". Poses are
// base_from_hand; positions in m, orientations as rotation vectors of attained * commanded^-1 about the base's axes
// (for the small angles at hand they are the differences of the standard's a, b, c).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

/// What the standard asks for: cycles of each pose, poses, and directions of approach.
inline constexpr int iso_cycles = 30, iso_poses = 5, iso_directions = 3;

/// 7.2.1 and 7.2.2, of one pose.
struct PoseFigures {
  int cycles = 0;
  double ap = 0;                         // AP_P, m: from the commanded position to the barycentre of the attained
  Vector3 ap_xyz = Vector3::Zero();      // AP_x, AP_y, AP_z, m: mean attained minus commanded
  Vector3 ap_abc = Vector3::Zero();      // AP_a, AP_b, AP_c, rad
  std::optional<double> rp;              // RP_l, m: mean distance from the barycentre and three deviations of it
  std::optional<Vector3> rp_abc;         // RP_a, RP_b, RP_c, rad: three standard deviations
  Vector3 barycentre = Vector3::Zero();  // m
};

/// `attained` holds at least one; RP needs two.
PoseFigures pose_figures(const Rigid& commanded, const std::vector<Rigid>& attained);

/// 7.2.3, of one pose: the greatest distance between the barycentres of attained positions (m), and the greatest
/// difference of the mean orientations (rad, about each axis), over the directions of approach. Needs two directions.
struct DirectionFigures {
  double vap = 0;
  Vector3 vap_abc = Vector3::Zero();
};
DirectionFigures direction_figures(const Rigid& commanded, const std::vector<std::vector<Rigid>>& by_direction);

/// 7.3.2 and 7.3.3: the mean attained distance of two poses minus the commanded one (m), and three standard deviations
/// of it (needs two cycles). Cycle j of one stands with cycle j of the other; what one has more of is left out.
struct DistanceFigures {
  int cycles = 0;
  double commanded = 0, ad = 0;
  std::optional<double> rd;
};
DistanceFigures distance_figures(const Rigid& commanded_1, const std::vector<Rigid>& attained_1,
                                 const Rigid& commanded_2, const std::vector<Rigid>& attained_2);

}  // namespace handsight
