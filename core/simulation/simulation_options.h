// SPDX-License-Identifier: Apache-2.0
// What a simulated session is to be: how large, how noisy, what is wrong with it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effects/effect.h"
#include "geometry/rigid.h"
#include "simulation/curve.h"

namespace handsight {

/// Something that goes wrong in one observation.
struct Disturbance {
  enum class Kind {
    joint,        // the joint's reading is off by `size` (rad, m)
    marker,       // marker `index` stands off by `size` (m) on the hand, a label that came loose
    right_image,  // the images of all cameras but the first were taken while joint `name` was `size` (rad, m) farther
                  // on
  };
  std::int64_t id = 0;
  Kind kind = Kind::joint;
  std::string name;
  int index = 0;
  double size = 0;
};

struct SimulationOptions {
  std::string title = "Simulated";
  int observations = 80;
  std::uint64_t seed = 1;
  std::optional<double> noise;  // px (m with a tracker) of one coordinate; absent: the session's, else 0.2 (2e-4)
  bool declare_noise = true;    // write sigma_pixel (sigma) into the session
  double joint_range = 0.8;     // share of every joint's limits that poses are drawn from
  double nearest = 0.30, farthest = 1.60;  // m from the camera, of the marker body
  double most_turned = 0.9;                // rad: between a marker's normal and the direction to the camera
  std::vector<EffectTerm> effects;         // the hidden truth
  std::vector<Curve> curves;               // and what no effect describes
  std::vector<Disturbance> disturbances;
  double wrong_corners = 0;  // share of the image points that are off by wrong_corner_size in u and in v, 0 to 1
  double unseen = 0;         // share of the markers that no camera saw, 0 to 1
  double body_size = 0.06;   // m: the longest side of the marker body, about
  std::vector<Vector3> markers_in_tcp;  // m: the body that is to be seen; empty: one is drawn
  bool follow = false;                  // neighbouring observations are neighbours in posture, as a guided arm's are
  Vector3 shift_in_sensor = Vector3::Zero();  // m: every marker is measured off by this (thesis 5.2)
};

constexpr double wrong_corner_size = 8;  // px, one standard deviation

}  // namespace handsight
