// SPDX-License-Identifier: GPL-3.0-or-later
// What was touched, fixture by fixture: how often, how far off, and where it stands.
#pragma once

#include <QWidget>

#include "workbench/workbench.h"

class QLabel;
class QTableWidget;

namespace handsight::app {

class FixturesPage : public QWidget {
  Q_OBJECT

 public:
  explicit FixturesPage(Workbench& workbench, QWidget* parent = nullptr);
  void refresh();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_rows();

  Workbench& workbench_;
  QLabel* sentence_;
  QTableWidget* table_;
};

}  // namespace handsight::app
