// SPDX-License-Identifier: GPL-3.0-or-later
// Touches against the model: what was touched in words, its fixtures and residuals as a 3D scene.
#pragma once

#include "widgets/scene/scene_marks.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// What an observation touches; null where it is watched.
const Fixture* touched_fixture(const Session& session, const Observation& observation);

/// Fixture, kind and reading, a sentence each, and with a row how far off; for the panel that else shows an image.
QString touched_text(const Session& session, const Observation& observation, const InspectionRow* row,
                     const DisplayUnits& units);

/// A predicted error (size_of_error) is reported in mm as of points, of three coordinates each; of touches a reading is
/// one.
ResidualSize as_read(ResidualSize predicted, const ModelVersion& model);

/// The tip (m, root frame) as it is predicted, and what takes it to where it was read: along the reading alone.
struct TouchResidual {
  Vector3 tip{0, 0, 0}, off{0, 0, 0};
};
TouchResidual touch_residual(const InspectionRow& row);

widgets::SceneArrow touch_arrow(const InspectionRow& row);

/// The fixtures at their places as the model has them, else as the session says (those of which it says nothing are
/// left out), as large as they were touched. `root_from_link` in the posture of the observation that is shown.
std::vector<widgets::SceneFixture> scene_fixtures(const Document& document, const Observation& shown,
                                                  const std::vector<Rigid>& root_from_link);

}  // namespace handsight::app
