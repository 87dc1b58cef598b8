// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle as the left camera sees it. Internal to triangle_panel.cpp.
#pragma once

#include <QWidget>

#include "widgets/triangle_panel.h"

namespace handsight::widgets {

/// Markers and sides to scale, with numbers and lengths; click takes a marker.
class TriangleSketch : public QWidget {
  Q_OBJECT
 public:
  explicit TriangleSketch(QWidget* parent);
  void set_state(const TriangleState& state);

 signals:
  void marker_selected(int number);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  std::optional<QPointF> place(int number) const;
  TriangleState state_;
};

}  // namespace handsight::widgets
