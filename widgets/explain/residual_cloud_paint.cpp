// SPDX-License-Identifier: GPL-3.0-or-later
// How the two clouds are painted.
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/explain/residual_cloud.h"

namespace handsight::widgets {
namespace {

/// Powers of ten within two decades below the reach.
std::vector<double> round_sizes(double reach) {
  std::vector<double> sizes;
  const int first = static_cast<int>(std::ceil(std::log10(std::max(reach / 100, 1e-9))));
  for (int power = first; std::pow(10.0, power) < reach; ++power) sizes.push_back(std::pow(10.0, power));
  return sizes;
}

}  // namespace

void ResidualCloud::paint_ground(QPainter& painter, int index) const {
  const Colors& c = colors();
  const QRectF area = pane(index);
  const QPointF middle = area.center();
  const double half = area.width() / 2;
  painter.setBrush(c.sunken);
  painter.setPen(QPen(c.hairline, 1));
  painter.drawEllipse(middle, half - 0.5, half - 0.5);
  painter.setBrush(Qt::NoBrush);
  if (shown(index).empty()) return;
  painter.drawLine(QPointF(area.left(), middle.y()), QPointF(area.right(), middle.y()));
  painter.drawLine(QPointF(middle.x(), area.top()), QPointF(middle.x(), area.bottom()));
  for (const double size : round_sizes(reach_)) painter.drawEllipse(middle, half * radius(size), half * radius(size));
}

void ResidualCloud::paint_ring_names(QPainter& painter, const QRectF& area) const {
  const Colors& c = colors();
  const double half = area.width() / 2;
  QColor plate = c.sunken;
  plate.setAlpha(200);
  painter.setFont(number_font(TextRole::small));
  painter.setBrush(Qt::NoBrush);
  for (const double sigmas : {1.0, 3.0}) {
    if (!noise_) break;
    const double r = half * radius(sigmas * *noise_);
    painter.setPen(QPen(c.ink2, 1, Qt::DashLine));
    painter.drawEllipse(area.center(), r, r);
    if (r < 16) continue;  // no room for its name
    const QString name = QStringLiteral("%1 σ").arg(sigmas);
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(name) + 6;
    draw_plate(painter, {area.center().x() - wide / 2, area.center().y() - r - 8}, name, c.ink2, plate);
    painter.setBrush(Qt::NoBrush);
  }
  painter.setPen(c.ink3);
  for (const double size : round_sizes(reach_)) {
    const double r = half * radius(size);
    if (size > 0.7 * reach_ || (noise_ && size < 4 * *noise_) || r < 16) continue;
    draw_plate(painter, {area.center().x() + r * 0.7071 - 2, area.center().y() + r * 0.7071 + 4},
               size_text({size, unit_}, 1), c.ink3, plate);
  }
}

void ResidualCloud::paint_points(QImage& image, int index) const {
  const double ratio = image.devicePixelRatio();
  const std::vector<CloudPoint>& points = shown(index);
  const std::vector<DotStamp> stamps = residual_stamps((points.size() > 3000 ? 2.2 : 3) * ratio, 200);
  const DotStamp plain(colors().ink3, 3 * ratio);
  const QRectF area = pane(index);
  for (const CloudPoint& point : points) {
    const double length = std::hypot(point.du, point.dv);
    const double scale = length > 0 ? radius(length) * area.width() / 2 / length : 0;
    const QPointF at = (area.center() + QPointF(point.du, point.dv) * scale) * ratio;
    if (!noise_) {
      plain.put(image, at.x(), at.y());
      continue;
    }
    const int step = residual_step(length / std::sqrt(2.0) / *noise_, 2);
    stamps[static_cast<std::size_t>(step)].put(image, at.x(), at.y());
  }
}

const QImage& ResidualCloud::still_dots() const {
  const Still wanted{
      {}, QSizeF(size()) * devicePixelRatioF(), reach_, noise_.value_or(0), is_linear_, colors().panel.rgba()};
  const bool holds = !still_.dots.isNull() && still_.size == wanted.size && still_.reach == wanted.reach &&
                     still_.noise == wanted.noise && still_.is_linear == wanted.is_linear &&
                     still_.ground == wanted.ground;
  if (holds) return still_.dots;
  still_ = wanted;
  still_.dots = dot_canvas(size(), devicePixelRatioF());
  paint_points(still_.dots, 0);
  return still_.dots;
}

void ResidualCloud::paint_marked(QPainter& painter, int index) const {
  if (selected_ < 0 && hovered_ < 0 && highlighted_.empty()) return;
  const Colors& c = colors();
  painter.setBrush(Qt::NoBrush);
  const bool hovers_here = !is_apart_ || index == hovered_pane_;
  for (const CloudPoint& point : shown(index)) {
    const bool is_selected = point.observation == selected_;
    const bool is_hovered = hovers_here && point.observation == hovered_;
    const bool is_high = std::binary_search(highlighted_.begin(), highlighted_.end(), point.observation);
    if (!is_selected && !is_hovered && !is_high) continue;
    painter.setPen(is_selected ? QPen(c.accent, 1.5) : QPen(is_hovered ? c.ink2 : c.ink1, is_hovered ? 1.5 : 1));
    const double r = is_selected || is_hovered ? 4.5 : 3;
    painter.drawEllipse(on_screen(index, point.du, point.dv), r, r);
  }
}

void ResidualCloud::paint_pane(QPainter& painter, int index) const {
  const Colors& c = colors();
  const QRectF area = pane(index);
  const bool is_after = (index == 1) != is_swapped_;
  const bool is_tried = is_after && is_predicted_;
  painter.setFont(text_font(TextRole::small));
  QString title = is_after ? after_.title : before_.title;
  if (title.isEmpty() || QFontMetricsF(painter.font()).horizontalAdvance(title) > area.width())
    title = is_after ? tr("after") : tr("before");
  painter.setPen(is_tried ? c.candidate : c.ink2);
  draw_text(painter, QRectF(area.left(), area.top() - 20, area.width(), 18), Qt::AlignCenter, title);
  if (shown(index).empty()) {
    painter.setPen(c.ink2);
    const QRectF room = area.adjusted(wide_gap, 0, -wide_gap, 0);
    constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;
    const QString& text = is_after ? after_empty_text_ : empty_text_;
    // In a small disc a sentence would go over its rim.
    if (painter.boundingRect(room, flags, text).height() < 0.75 * area.height()) painter.drawText(room, flags, text);
    return;
  }
  paint_ring_names(painter, area);
  paint_marked(painter, index);
  if (!is_tried) return;
  QPen pen(c.candidate, 2);
  pen.setDashPattern({4, 3});
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawEllipse(area.adjusted(1, 1, -1, -1));
}

void ResidualCloud::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  if (before_.points.empty() && after_.points.empty() && moving_.empty()) {
    draw_sentence(painter, rect(), empty_text_);
    return;
  }
  for (int i = 0; i < 2; ++i) paint_ground(painter, i);
  QImage dots = is_swapped_ ? dot_canvas(size(), devicePixelRatioF()) : still_dots().copy();
  if (is_swapped_) paint_points(dots, 0);
  paint_points(dots, 1);
  painter.drawImage(0, 0, dots);
  for (int i = 0; i < 2; ++i) paint_pane(painter, i);
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink3);
  const bool is_bent = noise_ && !is_linear_ && 15 * *noise_ <= reach_;
  const QString rim = tr("rim %1").arg(size_text({reach_, unit_}));
  draw_text(painter, QRectF(layout_gap, pane(0).bottom() + 2, width() - 2.0 * layout_gap, 16), Qt::AlignCenter,
            is_bent ? rim + tr(", compressed beyond 3 σ") : rim);
  if (hasFocus()) draw_focus(painter, rect());
}

}  // namespace handsight::widgets
