// SPDX-License-Identifier: Apache-2.0
// How well a robot's motions and what a sensor saw go together, in closed form and a few steps: hundreds of readings of
// a session are tried by it before any of them is fitted.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

struct SightedPoint {
  int number = 0;
  Vector3 in_sensor = Vector3::Zero();  // m
};

/// One observation: where the hand was, and what was seen of its points.
struct HandSight {
  Rigid mount_from_tcp;
  std::vector<SightedPoint> points;
};

struct HandEye {
  Rigid mount_from_sensor;
  std::vector<Vector3> points_in_tcp;  // m, by number; zero where never seen
  double mean_square = 0;  // m^2, of one point's distance; of the four fifths of the sights that go together best
};

/// Mean squared distance (m^2) of what a sight shows from where the points should be.
double left_in(const HandSight& sight, const HandEye& found);

/// The mount and the points at which the points, carried into the TCP frame, stand still best. `known`: the mount is
/// this one. Nothing with fewer than three sights.
std::optional<HandEye> hand_eye(const std::vector<HandSight>& sights, int point_count,
                                const std::optional<Rigid>& known);

}  // namespace handsight
