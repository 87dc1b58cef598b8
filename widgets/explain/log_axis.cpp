// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/log_axis.h"

#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {

LogAxis LogAxis::over(double low, double high, double bottom, double top) {
  if (!(low > 0) || !(high > 0) || low > high) low = 0.1, high = 1;
  const double room = std::max(std::pow(high / low, 0.12), std::sqrt(2.0));
  return {low / room, high * room, bottom, top};
}

double LogAxis::at(double value) const {
  const double share = std::log(std::max(value, low) / low) / std::log(high / low);
  return bottom + (top - bottom) * std::clamp(share, 0.0, 1.0);
}

namespace {

std::vector<double> list_marks(const LogAxis& axis, const std::vector<double>& steps, double least_px) {
  std::vector<double> all;
  for (int power = static_cast<int>(std::floor(std::log10(axis.low))); power <= std::log10(axis.high); ++power)
    for (const double step : steps) {
      const double value = step * std::pow(10.0, power);
      if (value < axis.low || value > axis.high) continue;
      if (all.empty() || std::abs(axis.at(value) - axis.at(all.back())) >= least_px) all.push_back(value);
    }
  return all;
}

}  // namespace

std::vector<double> LogAxis::marks() const {
  const double decade = std::abs(bottom - top) / std::log10(high / low);
  std::vector<double> steps = {1};
  if (decade * std::log10(2.0) > 18)
    steps = {1, 2, 5};
  else if (decade * std::log10(3.0) > 14)
    steps = {1, 3};
  std::vector<double> all = list_marks(*this, steps, 0);
  if (all.size() < 2) all = list_marks(*this, {1, 2, 3, 4, 5, 6, 7, 8, 9}, 18);  // less than a decade
  return all;
}

void draw_log_axis(QPainter& painter, const LogAxis& axis, const QRectF& area) {
  painter.setFont(number_font(TextRole::small));
  for (const double value : axis.marks()) {
    const double y = std::round(axis.at(value)) + 0.5;
    painter.setPen(QPen(colors().hairline, 1));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(colors().ink3);
    painter.drawText(QRectF(0, y - 9, area.left() - 5, 18), Qt::AlignRight | Qt::AlignVCenter, short_text(value, 1));
  }
}

}  // namespace handsight::widgets
