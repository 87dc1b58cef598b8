// SPDX-License-Identifier: GPL-3.0-or-later
// The keys, laid over the window; any key or click takes it away.
#pragma once

#include <QWidget>
#include <vector>

namespace handsight::app {

class KeyList : public QWidget {
  Q_OBJECT

 public:
  static void show_over(QWidget* window);
  /// Every key with what it does, headings left out.
  static std::vector<std::pair<QString, QString>> keys();

 protected:
  explicit KeyList(QWidget* window);
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace handsight::app
