// SPDX-License-Identifier: GPL-3.0-or-later
// The Inspect workspace: which observations are off, whose fault it is, and what becomes of the fit without them.
#pragma once

#include "workbench/workspace.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace handsight::widgets {
class AttributionBar;
class HistogramPlot;
class ImageView;
class ObservationTable;
class ResidualMap;
class RobotView;
}  // namespace handsight::widgets

namespace handsight::app {

class CameraStrip;

class InspectWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit InspectWorkspace(Workbench& workbench, QWidget* parent = nullptr);

  std::vector<Action> own_actions() const override;
  WorkStatus status() const override;
  void activate() override;

 private:
  void make_layout();
  QWidget* make_actions();
  QWidget* make_map();
  QWidget* make_threshold();
  void connect_table();
  void connect_images();
  void connect_plots();
  void connect_workbench();
  void refresh_all();
  void refresh_rows();
  void refresh_units();
  void refresh_observation();
  void refresh_plots();
  void refresh_cameras();
  void relabel_in_place(int camera, int marker, const Vector2& px, bool finished, bool free);
  void relabel(const QString& sentence, std::int64_t id, const EditableState& after);
  void remove_marker(int marker);
  void renumber(int marker, int to);
  void try_threshold(double threshold, const std::vector<std::int64_t>& beyond);
  std::vector<std::int64_t> chosen() const;

  widgets::ObservationTable* table_;
  widgets::ImageView *left_, *right_;
  CameraStrip* cameras_;
  QWidget* images_;  // hidden where there are none
  widgets::AttributionBar* attribution_;
  widgets::RobotView* scene_;
  widgets::HistogramPlot* histogram_;
  widgets::ResidualMap* map_;
  QTabWidget* tabs_;
  QComboBox* map_camera_;  // whose residuals are shown over the image
  QPushButton *exclude_, *include_, *look_, *relabel_, *exclude_beyond_;
  QLabel* beyond_text_;
  std::vector<std::int64_t> beyond_;
  bool is_stale_ = true, robot_is_set_ = false;
};

}  // namespace handsight::app
