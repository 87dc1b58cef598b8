// SPDX-License-Identifier: GPL-3.0-or-later
// How the nine small plots are painted.
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/explain/pattern_page.h"

namespace handsight::widgets {
namespace {

bool contains(const std::vector<ObservationId>& sorted, ObservationId id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

struct RoundMarks {
  std::vector<double> values;
  int decimals = 0;  // that tell them apart
};

/// Multiples of 1, 2 or 5 times a power of ten within a range: at most `most`, and two where any power has two.
RoundMarks round_marks(double low, double high, int most) {
  RoundMarks finer;
  const double power = std::pow(10, std::floor(std::log10((high - low) / most)));
  for (const double times : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    const double step = times * power, first = std::ceil(low / step), last = std::floor(high / step);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    const int between = static_cast<int>(last - first);
    if (between >= most) {
      finer = {{first * step, last * step}, decimals};
      continue;
    }
    if (between <= 0) break;
    RoundMarks marks{{}, decimals};
    for (int i = 0; i <= between; ++i) marks.values.push_back((first + i) * step);
    return marks;
  }
  return finer;
}

/// As many names of a list as there is room for, none of them cut; the first alone is cut at worst.
QString whole_names(const QString& list, const QFontMetricsF& metrics, double room) {
  const QString between = QStringLiteral(", ");
  const QStringList names = list.split(between, Qt::SkipEmptyParts);
  QString fitting = names.value(0);
  for (int i = 1; i < names.size(); ++i) {
    const QString longer = fitting + between + names[i];
    if (metrics.horizontalAdvance(longer) > room) break;
    fitting = longer;
  }
  return fitting;
}

}  // namespace

void PatternPage::paint_head(QPainter& painter, int place) const {
  const Colors& c = colors();
  const PatternPlot& plot = plots_[static_cast<std::size_t>(place)];
  const QRectF cell = plot_rect(place).adjusted(6, 1, -6, -1);
  painter.setFont(text_font(TextRole::small));
  const QFontMetricsF metrics(painter.font());
  /// With the word before it where there is room for both.
  const auto worded = [&](const QString& sentence, const QString& alone, const QRectF& room, Qt::TextElideMode mode) {
    draw_text(
        painter, room, Qt::AlignLeft | Qt::AlignVCenter,
        metrics.horizontalAdvance(sentence) <= room.width() ? sentence : metrics.elidedText(alone, mode, room.width()));
  };
  const QRectF head(cell.left(), cell.top(), cell.width(), 16), last(cell.left(), cell.bottom() - 15, cell.width(), 15);
  const QRectF foot(cell.left(), last.top() - 14, cell.width(), 15);
  // The strength: a bar that is filled as far as the residual follows; beside the variable where that leaves it whole,
  // so that the names of effects have their line.
  constexpr double of_mark = 34;
  const QString what = has_numbers_ ? with_unit(plot.what, plot.y_unit) : plot.what,
                variable = has_numbers_ ? with_unit(plot.against, plot.x_unit) : plot.against,
                against = tr("against %1").arg(variable);
  const bool is_at_foot = metrics.horizontalAdvance(against) <= foot.width() - of_mark;
  const QRectF mark(last.right() - 30, (is_at_foot ? foot : last).top() + 4, 30, 7);
  painter.setPen(c.ink1);
  worded(what, plot.what, head, Qt::ElideMiddle);
  painter.setPen(QPen(plot.is_chance ? c.hairline : c.control_edge, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(mark.adjusted(0.5, 0.5, -0.5, -0.5));
  if (!plot.is_chance)
    painter.fillRect(QRectF(mark.left(), mark.top(), mark.width() * std::clamp(plot.strength, 0.0, 1.0), mark.height()),
                     c.ink2);
  painter.setPen(c.ink2);
  const QRectF names = last.adjusted(0, 0, is_at_foot ? 0 : -of_mark, 0);
  const QString shown = whole_names(plot.shows, metrics, names.width());
  const qsizetype two_words = plot.against.lastIndexOf(' ', plot.against.lastIndexOf(' ') - 1);
  // What it stands against is whole before effects are named: the tool tip names them, too.
  if (metrics.horizontalAdvance(plot.against) > foot.width() && two_words > 0) {
    worded(plot.against.left(two_words), plot.against.left(two_words), foot, Qt::ElideMiddle);
    return worded(plot.against.mid(two_words + 1), plot.against.mid(two_words + 1), names, Qt::ElideMiddle);
  }
  worded(metrics.horizontalAdvance(against) <= foot.width() ? against : tr("against %1").arg(plot.against),
         plot.against, foot, Qt::ElideMiddle);  // joints differ at their ends
  painter.setPen(c.ink3);
  if (!shown.isEmpty()) worded(tr("shows %1").arg(shown), shown, names, Qt::ElideRight);
}

/// Two or three numbers along each axis; the units stand beside the quantities.
void PatternPage::paint_numbers(QPainter& painter, int place) const {
  const Colors& c = colors();
  const Range& r = ranges_[static_cast<std::size_t>(place)];
  const QRectF area = canvas(place), cell = plot_rect(place);
  painter.setFont(text_font(TextRole::small));
  const QFontMetricsF metrics(painter.font());
  const double high = metrics.height();
  const auto most = [](double room, double each) { return std::clamp(static_cast<int>(room / each), 2, 5); };
  painter.setPen(QPen(c.ink2, 1));
  const RoundMarks ys = round_marks(r.low, r.high, most(area.height(), 1.3 * high)),
                   xs = round_marks(r.left, r.right, most(area.width(), 45));
  for (const double y : ys.values) {
    const double at = std::round(on_screen(place, r.left, y).y()) + 0.5;
    painter.drawLine(QPointF(area.left() - 3, at), QPointF(area.left(), at));
    draw_text(painter, {cell.left() + 2, at - high / 2, area.left() - cell.left() - 7, high},
              Qt::AlignRight | Qt::AlignVCenter, fixed_text(y, ys.decimals));
  }
  for (const double x : xs.values) {
    const QString text = fixed_text(x, xs.decimals);
    const double at = std::round(on_screen(place, x, r.low).x()) + 0.5, wide = metrics.horizontalAdvance(text) + 4;
    painter.drawLine(QPointF(at, area.bottom()), QPointF(at, area.bottom() + 3));
    const double left = std::clamp(at - wide / 2, cell.left() + 2, cell.right() - wide - 2);
    draw_text(painter, {left, area.bottom() + 3, wide, high}, Qt::AlignHCenter | Qt::AlignTop, text);
  }
}

void PatternPage::paint_curves(QPainter& painter, int place) const {
  const Colors& c = colors();
  const PatternPlot& plot = plots_[static_cast<std::size_t>(place)];
  const auto curve = [&](const std::vector<TrendPoint>& points, auto&& y_of) {
    QPolygonF line;
    for (const TrendPoint& point : points) line += on_screen(place, point.x, y_of(point));
    return line;
  };
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPolygonF trend = curve(plot.trend, [](const TrendPoint& p) { return p.y; });
  painter.setPen(QPen(c.panel, 4));  // a rim: the strongest residuals are as dark as the line
  painter.drawPolyline(trend);
  painter.setPen(QPen(c.ink1, 1.6));
  painter.drawPolyline(trend);
  QPen dashed(c.candidate, 1.8, Qt::DashLine);
  dashed.setDashPattern({4, 2.5});
  painter.setPen(dashed);
  painter.drawPolyline(curve(plot.candidate, [](const TrendPoint& p) { return p.y; }));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PatternPage::paint_points(QImage& image, int place, const std::vector<DotStamp>& stamps,
                               const DotStamp& plain) const {
  const double ratio = image.devicePixelRatio();
  const QRectF area = canvas(place);
  for (const ScatterPoint& point : plots_[static_cast<std::size_t>(place)].points) {
    const QPointF there = on_screen(place, point.x, point.y), at = there * ratio;
    if (there.y() < area.top() || there.y() > area.bottom()) continue;  // a triangle says so (paint_beyond)
    const DotStamp& stamp =
        point.rms_over_sigma ? stamps[static_cast<std::size_t>(residual_step(*point.rms_over_sigma, point.coordinates))]
                             : plain;
    stamp.put(image, at.x(), at.y());
  }
}

/// Points beyond the axis: a red triangle at its end.
void PatternPage::paint_beyond(QPainter& painter, int place) const {
  const QRectF area = canvas(place);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors().bad);
  for (const ScatterPoint& point : plots_[static_cast<std::size_t>(place)].points) {
    const QPointF at = on_screen(place, point.x, point.y);
    const bool is_above = at.y() < area.top();
    if (!is_above && at.y() <= area.bottom()) continue;
    const double tip = is_above ? area.top() + 1 : area.bottom() - 1, base = is_above ? tip + 5 : tip - 5;
    painter.drawPolygon(QPolygonF({{at.x(), tip}, {at.x() - 3.5, base}, {at.x() + 3.5, base}}));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PatternPage::paint_rings(QPainter& painter, int place) const {
  if (highlighted_.empty() && selected_ < 0 && hovered_ < 0) return;
  const Colors& c = colors();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const ScatterPoint& point : plots_[static_cast<std::size_t>(place)].points) {
    const bool is_selected = point.observation == selected_, is_hovered = point.observation == hovered_;
    if (!is_selected && !is_hovered && !contains(highlighted_, point.observation)) continue;
    painter.setPen(is_selected ? QPen(c.accent, 2) : QPen(is_hovered ? c.ink2 : c.ink1, is_hovered ? 1.5 : 1));
    const double radius = is_selected || is_hovered ? 5 : 3;
    painter.drawEllipse(on_screen(place, point.x, point.y), radius, radius);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PatternPage::paint_ground(QPainter& painter, int place) const {
  const Colors& c = colors();
  const PatternPlot& plot = plots_[static_cast<std::size_t>(place)];
  const QRectF cell = plot_rect(place), area = canvas(place);
  painter.fillRect(cell, place == selected_plot_ ? c.selected_row : c.panel);
  painter.fillRect(area, c.panel);
  painter.setClipRect(area);
  if (plot.noise) {
    const double top = on_screen(place, 0, *plot.noise).y(), bottom = on_screen(place, 0, -*plot.noise).y();
    painter.fillRect(QRectF(area.left(), top, area.width(), bottom - top), noise_hatching(c.hairline));
  }
  if (!plot.trend.empty()) {
    QPolygonF band;
    for (const TrendPoint& p : plot.trend) band += on_screen(place, p.x, p.high);
    for (auto p = plot.trend.rbegin(); p != plot.trend.rend(); ++p) band += on_screen(place, p->x, p->low);
    QColor veil = c.ink2;
    veil.setAlpha(38);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    painter.drawPolygon(band);
  }
  if (!plot.candidate.empty() && plot.candidate.front().low < plot.candidate.front().high) {
    QPolygonF band;
    for (const TrendPoint& p : plot.candidate) band += on_screen(place, p.x, p.high);
    for (auto p = plot.candidate.rbegin(); p != plot.candidate.rend(); ++p) band += on_screen(place, p->x, p->low);
    painter.setPen(Qt::NoPen);
    painter.setBrush(noise_hatching(c.hairline));
    painter.drawPolygon(band);
  }
  painter.setPen(QPen(c.hairline, 1));
  const double zero = std::round(on_screen(place, 0, 0).y()) + 0.5;
  painter.drawLine(QPointF(area.left(), zero), QPointF(area.right(), zero));
  painter.setClipping(false);
}

void PatternPage::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.fillRect(rect(), c.window);
  if (plots_.empty()) {
    draw_sentence(painter, rect(), empty_text_);
    if (hasFocus()) draw_focus(painter, rect());
    return;
  }
  for (int i = 0; i < count(); ++i) paint_ground(painter, i);
  const double ratio = devicePixelRatioF();
  QImage dots = dot_canvas(size(), ratio);
  const std::vector<DotStamp> stamps = residual_stamps(3 * ratio, 255);
  const DotStamp plain(c.ink3, 3 * ratio);
  for (int i = 0; i < count(); ++i) paint_points(dots, i, stamps, plain);
  painter.drawImage(0, 0, dots);
  for (int i = 0; i < count(); ++i) {
    painter.setClipRect(canvas(i));
    paint_curves(painter, i);
    paint_beyond(painter, i);
    paint_rings(painter, i);
    painter.setClipping(false);
    paint_head(painter, i);
    if (has_numbers_) paint_numbers(painter, i);
    const QRectF cell = plot_rect(i);
    if (i == selected_plot_)
      draw_focus(painter, cell);
    else if (i == hovered_plot_) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(c.control_edge, 1));
      painter.drawRect(cell.adjusted(0.5, 0.5, -0.5, -0.5));
    }
  }
  if (brushing_ >= 0) {
    QColor veil = c.accent;
    veil.setAlpha(40);
    painter.setPen(QPen(c.accent, 1));
    painter.setBrush(veil);
    painter.drawRect(QRectF(brush_from_, brush_to_).normalized());
  }
  if (!progress_.isEmpty()) {
    painter.setFont(text_font(TextRole::small));
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(progress_) + 10;
    draw_plate(painter, {width() - wide, height() - 28.0}, progress_, c.ink2, c.sunken);
  }
}

}  // namespace handsight::widgets
