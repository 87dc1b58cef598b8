// SPDX-License-Identifier: GPL-3.0-or-later
// Which cameras' images stand beside each other: of a pair both, of one camera its own alone, of more the two that were
// chosen last in this strip. Of a collection those of the selected observation's session.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "workbench/observation_views.h"

class QHBoxLayout;
class QToolButton;

namespace handsight::app {

class CameraStrip : public QWidget {
  Q_OBJECT

 public:
  /// Hides itself where there is nothing to choose, and the second view where there is but one camera.
  CameraStrip(Workbench& workbench, widgets::ImageView* first, widgets::ImageView* second, QWidget* parent = nullptr);

  /// The views that are in use, each with its camera.
  std::vector<ShownCamera> shown();
  int look_up_camera(const widgets::ImageView* view) const;
  /// In place of the one that was chosen longest ago, where it is not shown already.
  void show_camera(int camera);

 signals:
  /// Other cameras are shown than before.
  void changed();

 private:
  void rebuild();
  void follow();
  void refresh();

  Workbench& workbench_;
  std::array<widgets::ImageView*, 2> views_;
  std::array<int, 2> cameras_ = {0, 1};
  int next_ = 1;               // the view that the next choice goes to
  int first_ = 0, count_ = 0;  // cameras of the selected observation's session
  std::vector<QToolButton*> buttons_;
  QHBoxLayout* row_;
};

}  // namespace handsight::app
