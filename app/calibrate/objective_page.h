// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's three objectives side by side, and the choice of the one that the model is fitted with.
#pragma once

#include <QWidget>
#include <array>

#include "workbench/workbench.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QTableWidget;

namespace handsight::app {

class ObjectivePage : public QWidget {
  Q_OBJECT

 public:
  ObjectivePage(Workbench& workbench, QWidget* parent);
  /// Fits only while it is looked at.
  void set_active(bool active);

 private:
  void compare();
  void show_results(const std::array<ModelVersionPointer, 3>& results);
  void choose(const ModelSettings& settings);

  Workbench& workbench_;
  QButtonGroup* choices_;
  QCheckBox* fix_;
  QTableWidget* table_;
  QLabel* sentence_;
  bool is_active_ = false;
  std::int64_t compared_ = -1;  // revision
};

}  // namespace handsight::app
