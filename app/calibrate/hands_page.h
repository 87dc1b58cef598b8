// SPDX-License-Identifier: GPL-3.0-or-later
// TCP->Body of each hand of a collection, with its error: what a play shows of one session.
#pragma once

#include <QWidget>

#include "workbench/workbench.h"

class QLabel;
class QTableWidget;

namespace handsight::app {

class HandsPage : public QWidget {
  Q_OBJECT

 public:
  explicit HandsPage(Workbench& workbench, QWidget* parent = nullptr);
  void refresh();
  /// Looked at now: what takes longer is worked out.
  void look();

 private:
  void show_held_out();
  Workbench& workbench_;
  QLabel* sentence_;
  QTableWidget* table_;
  ModelVersionPointer held_out_of_;
  std::vector<ErrorSummary> held_out_;  // by session, with the robot from the others alone; empty: not yet
};

}  // namespace handsight::app
