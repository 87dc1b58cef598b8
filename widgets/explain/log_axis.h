// SPDX-License-Identifier: GPL-3.0-or-later
// A vertical log axis with 1-2-5 marks. Internal to widgets/explain.
#pragma once

#include <QPainter>
#include <vector>

namespace handsight::widgets {

struct LogAxis {
  double low = 0.1, high = 1;  // values at the ends
  double bottom = 0, top = 0;  // screen
  /// With some room round the values; at least a factor of two.
  static LogAxis over(double low, double high, double bottom, double top);
  double at(double value) const;      // screen, kept within the ends
  std::vector<double> marks() const;  // at least 16 px apart
};

/// Hairlines over the area and the numbers left of it.
void draw_log_axis(QPainter& painter, const LogAxis& axis, const QRectF& area);

}  // namespace handsight::widgets
