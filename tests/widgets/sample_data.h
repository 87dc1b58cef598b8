// SPDX-License-Identifier: Apache-2.0
// What the widgets show in tests and in the gallery: a sample session, fitted.
#pragma once

#include <QImage>
#include <vector>

#include "estimation/report/fit_report.h"
#include "widgets/base/cells.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/observation_table.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {

struct SampleData {
  Session session;
  Fit fit;
  FitReport report;
  double noise = 0.2;  // px

  std::vector<widgets::ObservationCell> cells() const;
  std::vector<widgets::ObservationRow> rows() const;
  std::vector<widgets::MapPoint> map_points() const;
  std::vector<widgets::ConvergencePoint> convergence() const;
  std::vector<widgets::SceneArrow> arrows() const;
  std::vector<widgets::SceneCamera> cameras(int observation) const;
  std::vector<Rigid> posture(int observation) const;
  Rigid root_from_tcp(int observation) const;
  /// Measured and predicted marks, arrows and axes in the left image of an observation (index).
  void show_in(widgets::ImageView& view, int observation) const;
};

/// A folder of sample_sessions, every labelled observation used.
SampleData read_sample(const char* name);

/// Cells as a session of that many observations would have them; every 17th is rejected, every 101st excluded.
std::vector<widgets::ObservationCell> many_cells(int count);

}  // namespace handsight::test
