// SPDX-License-Identifier: GPL-3.0-or-later
// The Label workspace: the first observation, by hand.
#pragma once

#include "frame/workspace.h"
#include "label/labeller.h"

class QCheckBox;
class QLabel;

namespace handsight::widgets {
class ImageView;
class Loupe;
class TrianglePanel;
}  // namespace handsight::widgets

namespace handsight::app {

class LabelWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit LabelWorkspace(Workbench& bench, QWidget* parent = nullptr);

  QString name() const override { return tr("Label"); }
  WorkStatus status() const override;
  Panel panel() const override { return Panel::absent; }
  void activate() override;
  bool key(QKeyEvent* event) override;

 private:
  void make_layout();
  void connect_left();
  void connect_right();
  void connect_panel();
  void show_observation();
  void find_corners(std::int64_t id);
  void corners_found(std::int64_t id, CornersOfPair corners);
  /// Everything that is shown, from the labeller.
  void refresh();
  void refresh_panel();
  void say(const QString& sentence);
  void select_marker(int marker);
  void use();
  void next_observation();

  Labeller labeller_;
  std::int64_t observation_ = -1;
  std::int64_t corners_of_ = -1;
  int marker_ = -1;   // selected
  QString sentence_;  // the last refusal of a click
  widgets::ImageView *left_, *right_;
  widgets::Loupe *left_loupe_, *right_loupe_;
  widgets::TrianglePanel* triangle_;
  QCheckBox* together_;
  QLabel* hint_;
};

}  // namespace handsight::app
