// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle as the left camera sees it. Internal to triangle_panel.cpp.
#pragma once

#include <QWidget>

#include "widgets/images/triangle_state.h"

namespace handsight::widgets {

/// Markers and sides to scale, with numbers and lengths; click takes a marker. Until they are placed, how they are
/// numbered elsewhere.
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
  bool shows_known() const;
  const std::vector<TriangleMarker>& drawn() const;
  std::optional<QPointF> place(int number) const;
  void paint_known(QPainter& painter) const;
  TriangleState state_;
};

}  // namespace handsight::widgets
