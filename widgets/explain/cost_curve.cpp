// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/cost_curve.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/explain/log_axis.h"

namespace handsight::widgets {

struct CostCurve::Scale {
  QRectF area;
  LogAxis y;
  int last = 1;
  double find_x(int iteration) const { return area.left() + area.width() * iteration / std::max(last, 1); }
};

CostCurve::CostCurve(QWidget* parent) : QWidget(parent), empty_text_(tr("The cost of a fit is drawn here.")) {
  setMouseTracking(true);
  setAccessibleName(tr("Cost of the running fit"));
}

void CostCurve::start(const QString& quantity, const QString& unit) {
  points_.clear();
  quantity_ = quantity;
  unit_ = unit;
  outcome_.clear();
  is_running_ = true;
  hovered_ = -1;
  update();
}

void CostCurve::clear() {
  start({}, {});
  is_running_ = false;
}

void CostCurve::append(int iteration, double cost) {
  if (!std::isfinite(cost) || cost <= 0) return;
  points_.push_back({iteration, cost});
  update();
}

void CostCurve::finish(const QString& outcome) {
  outcome_ = outcome;
  is_running_ = false;
  update();
}

void CostCurve::set_floor(std::optional<double> cost) {
  floor_ = cost;
  update();
}

void CostCurve::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

QRectF CostCurve::area() const { return {44, 22, width() - 44.0 - layout_gap, height() - 22.0 - 20}; }

CostCurve::Scale CostCurve::scale() const {
  double low = 1e300, high = 0;
  int last = 5;  // room for a usual fit, so that the curve does not jump at every point
  for (const Point& point : points_) {
    low = std::min(low, point.cost);
    high = std::max(high, point.cost);
    last = std::max(last, (point.iteration + 4) / 5 * 5);
  }
  if (floor_ && *floor_ > 0) low = std::min(low, *floor_);
  return {area(), LogAxis::over(low, high, area().bottom(), area().top()), last};
}

void CostCurve::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  if (points_.empty()) {
    draw_sentence(painter, rect(), is_running_ ? tr("The fit starts …") : empty_text_);
    return;
  }
  const Scale s = scale();
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  const QString title = unit_.isEmpty() ? quantity_ : QStringLiteral("%1 (%2)").arg(quantity_, unit_);
  const Point& latest = points_.back();
  const QString state = is_running_ ? tr("iteration %1").arg(latest.iteration) : outcome_;
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(state) + 2;
  draw_text(painter, QRectF(layout_gap, 2, width() - wide - 3 * layout_gap, 18), Qt::AlignLeft | Qt::AlignVCenter,
            title);
  draw_text(painter, QRectF(layout_gap, 2, width() - 2.0 * layout_gap, 18), Qt::AlignRight | Qt::AlignVCenter, state);
  draw_log_axis(painter, s.y, s.area);
  if (floor_ && *floor_ > 0)
    painter.fillRect(QRectF(s.area.left(), s.y.at(*floor_), s.area.width(), s.area.bottom() - s.y.at(*floor_)),
                     noise_hatching(c.control_edge));
  painter.setPen(c.ink3);
  for (int i = 0; i <= s.last; i += std::max(s.last / 5, 1))
    painter.drawText(QRectF(s.find_x(i) - 20, s.area.bottom() + 2, 40, 16), Qt::AlignCenter, QString::number(i));
  QPolygonF line;
  for (const Point& point : points_) line += QPointF(s.find_x(point.iteration), s.y.at(point.cost));
  painter.setPen(QPen(c.ink1, 2));
  painter.drawPolyline(line);
  painter.setPen(Qt::NoPen);
  painter.setBrush(c.ink1);
  for (const QPointF& at : line) painter.drawEllipse(at, 2.5, 2.5);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(c.ink2, 1.5));
  if (hovered_ >= 0 && hovered_ < line.size()) painter.drawEllipse(line[hovered_], 5, 5);
}

void CostCurve::mouseMoveEvent(QMouseEvent* event) {
  const Scale s = scale();
  int nearest = -1;
  double best = 12;
  for (int i = 0; i < count(); ++i) {
    const double away = std::abs(s.find_x(points_[static_cast<std::size_t>(i)].iteration) - event->position().x());
    if (away < best) best = away, nearest = i;
  }
  if (nearest == hovered_) return;
  hovered_ = nearest;
  const Point* point = nearest < 0 ? nullptr : &points_[static_cast<std::size_t>(nearest)];
  emit read_out(point ? tr("iteration %1: %2").arg(point->iteration).arg(with_unit_text(point->cost, unit_, 3))
                      : QString());
  update();
}

void CostCurve::leaveEvent(QEvent*) {
  if (hovered_ >= 0) emit read_out({});
  hovered_ = -1;
  update();
}

}  // namespace handsight::widgets
