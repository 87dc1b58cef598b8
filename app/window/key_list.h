// SPDX-License-Identifier: GPL-3.0-or-later
// The keys, laid over the window; any key or click takes it away.
#pragma once

#include <QWidget>
#include <vector>

#include "workbench/actions.h"

namespace handsight::app {

class KeyList : public QWidget {
  Q_OBJECT

 public:
  static void show_over(QWidget* window, std::vector<Actions::Row> rows);

 protected:
  explicit KeyList(QWidget* window);
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::size_t second_column() const;

  std::vector<Actions::Row> rows_;
};

}  // namespace handsight::app
