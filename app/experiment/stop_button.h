// SPDX-License-Identifier: GPL-3.0-or-later
// The large red button that stops the robot.
#pragma once

#include <QPushButton>

namespace handsight::app {

class StopButton : public QPushButton {
  Q_OBJECT

 public:
  explicit StopButton(QWidget* parent = nullptr);
  QSize sizeHint() const override { return {132, 52}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace handsight::app
