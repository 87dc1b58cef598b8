// SPDX-License-Identifier: Apache-2.0
// The marker body's shape, learned observation by observation from the sensor alone: what the robot does wrong cannot
// bend it.
#pragma once

#include <optional>
#include <vector>

#include "camera/rig.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

class RunningShape {
 public:
  explicit RunningShape(int marker_count);

  /// Lays the observation's points onto the shape by the markers that they share (three or more) and averages them in,
  /// each weighed by its covariance. `noise` is that of one coordinate (px, m). The first observation gives the frame;
  /// one that shares fewer than three markers with the shape adds nothing.
  void add(const Rig* rig, const std::vector<Sighting>& sightings, double noise);

  /// m, in the shape's own frame; empty for markers never seen as points.
  std::vector<std::optional<Vector3>> markers() const;
  /// m, root mean square over the axes, of the average; 0 for markers never seen.
  std::vector<double> sigmas() const;

 private:
  struct Sum {
    Matrix3 information = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
  };
  std::vector<Sum> sums_;
  bool started_ = false;
};

}  // namespace handsight
