// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown beside the robot, as plain data: cameras, markers, arrows, ellipsoid.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "camera/camera.h"
#include "session/fixtures/fixture_kind.h"
#include "widgets/base/cells.h"

namespace handsight::widgets {

/// Everything in the root link's frame, m.
struct SceneCamera {
  QString name;
  Rigid root_from_camera;
  Camera camera;
};

/// A hand that the observation does not show, with its name.
struct SceneHand {
  QString name;
  Rigid root_from_tcp;
};

enum class SceneMarkerRole { measured, predicted };

struct SceneMarker {
  int marker = 0;
  Vector3 in_root{0, 0, 0};
  SceneMarkerRole role = SceneMarkerRole::measured;
  std::optional<double> rms_over_sigma;
};

/// The residual of a past observation at its TCP, magnified by the view.
struct SceneArrow {
  ObservationId observation = no_observation;
  Vector3 from{0, 0, 0};
  Vector3 residual{0, 0, 0};  // m, true size
  std::optional<double> rms_over_sigma;
  int coordinates = 12;
};

/// A way of the TCP.
struct ScenePath {
  std::vector<Vector3> points;
  bool is_now = false;  // the robot is on it; else it is to come
};

/// What a probe touches, in a frame of its own (m).
struct SceneFixture {
  QString name;
  FixtureShape shape = FixtureShape::patch;
  Rigid root_from_fixture;
  /// Of a patch (z = 0) two corners; the ends of a rod, an arrow and a bar. A ring is round the frame's origin.
  Vector3 from{0, 0, 0}, to{0, 0, 0};
  bool is_touched = false;  // in the observation that is shown
};

/// Where something is with this probability: the ellipsoid of a covariance.
struct SceneEllipsoid {
  Vector3 center{0, 0, 0};
  Matrix3 covariance = Matrix3::Zero();  // m^2
  double probability = 0.95;
};

}  // namespace handsight::widgets
