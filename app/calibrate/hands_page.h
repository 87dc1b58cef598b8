// SPDX-License-Identifier: GPL-3.0-or-later
// TCP->Body of each hand of a collection, with its error: what a play shows of one session.
#pragma once

#include <QWidget>

#include "bench/workbench.h"

class QLabel;
class QTableWidget;

namespace handsight::app {

class HandsPage : public QWidget {
  Q_OBJECT

 public:
  explicit HandsPage(Workbench& bench, QWidget* parent = nullptr);
  void refresh();

 private:
  Workbench& bench_;
  QLabel* sentence_;
  QTableWidget* table_;
};

}  // namespace handsight::app
