// SPDX-License-Identifier: GPL-3.0-or-later
// The track of the what-if slider. Internal to what_if_*.cpp and its tests.
#pragma once

#include <QWidget>

#include "widgets/explain/what_if_state.h"

namespace handsight::widgets {

class WhatIfTrack : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfTrack(QWidget* parent = nullptr);
  void set_parameter(const WhatIfParameter& parameter);
  void set_value(double value);
  double reach() const;  // the largest size that it can show
  double find_x(double value) const;
  const WhatIfParameter& parameter() const { return parameter_; }
  QSize sizeHint() const override { return {320, 52}; }
  QSize minimumSizeHint() const override { return {180, 52}; }

 signals:
  void moved(double value);
  void released(double value);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;

 private:
  double value_at(double x) const;
  void move_to(double value, bool is_final);
  void paint_best(QPainter& painter, double middle) const;
  void paint_marks(QPainter& painter, double middle) const;

  WhatIfParameter parameter_;
  bool is_dragging_ = false;
};

}  // namespace handsight::widgets
