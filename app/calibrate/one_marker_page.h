// SPDX-License-Identifier: GPL-3.0-or-later
// One marker (thesis 4.2): the mass that pulls the TCP toward where the marker was measured, per observation.
#pragma once

#include <QWidget>

#include "estimation/report/one_marker.h"
#include "workbench/workbench.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace handsight::app {

class OneMarkerPage : public QWidget {
  Q_OBJECT

 public:
  OneMarkerPage(Workbench& workbench, QWidget* parent);
  void set_active(bool active);

 private:
  void compute();
  void show_result(const OneMarkerResult& result);

  Workbench& workbench_;
  QComboBox* marker_;
  QTableWidget* table_;
  QLabel* sentence_;
  bool is_active_ = false, is_filling_ = false;
};

}  // namespace handsight::app
