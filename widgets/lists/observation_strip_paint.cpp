// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPaintEvent>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"
#include "widgets/lists/observation_strip.h"

namespace handsight::widgets {
namespace {

/// Height of a cell as a share, on a logarithmic scale from a third of sigma to twenty.
double height_share(double rms_over_sigma) {
  constexpr double low = 1.0 / 3, high = 20;
  const double share = std::log(std::max(rms_over_sigma, low) / low) / std::log(high / low);
  return 0.12 + 0.88 * std::clamp(share, 0.0, 1.0);
}

/// Where the noise is not known: on a logarithmic scale from a twentieth of the largest to the largest.
double height_share_of_largest(double size, double largest) {
  constexpr double low = 1.0 / 20;
  const double share = std::log(std::max(size / largest, low) / low) / std::log(1 / low);
  return 0.12 + 0.88 * std::clamp(share, 0.0, 1.0);
}

/// Which of two cells a column shows: the worse used one.
bool is_worse(const ObservationCell& a, const ObservationCell& b) {
  const bool a_counts = a.state == CellState::used, b_counts = b.state == CellState::used;
  if (a_counts != b_counts) return a_counts;
  if (!a.rms_over_sigma && !b.rms_over_sigma)
    return reported_size(a).value.value_or(-1) > reported_size(b).value.value_or(-1);
  return a.rms_over_sigma.value_or(-1) > b.rms_over_sigma.value_or(-1);
}

}  // namespace

ShownSize ObservationStrip::largest_without_noise() const {
  ShownSize largest;
  for (const ObservationCell& cell : cells_) {
    if (cell.rms_over_sigma) return {};
    if (cell.state != CellState::used || !cell.size) continue;
    if (cell.size->value.value_or(0) > largest.value.value_or(0)) largest = *cell.size;
  }
  return largest;
}

void ObservationStrip::paint_cell(QPainter& painter, const ObservationCell& cell, const QRectF& slot) const {
  const Colors& c = colors();
  const double gap = slot.width() >= 5 ? 1 : 0;
  const QRectF room = slot.adjusted(gap / 2, 0, -gap / 2, 0);
  const bool has_preview = cell.predicted.has_value();
  const auto draw = [&](std::optional<double> share, const QColor& color, double bottom, double height) {
    const double tall = share ? std::max(4.0, height * *share) : 4.0;
    const QRectF bar(room.left(), bottom - tall, room.width(), tall);
    painter.fillRect(share ? bar : bar.adjusted(0, 2, 0, 0), share ? color : c.hairline);
    return bar;
  };
  const double bottom = has_preview ? room.top() + room.height() / 2 - 1 : room.bottom();
  const std::optional<double> size = cell.size ? cell.size->value : std::nullopt;
  if (cell.rms_over_sigma)
    draw(height_share(*cell.rms_over_sigma), residual_color(cell.rms_over_sigma, cell.coordinates), bottom,
         bottom - room.top());
  else  // a middling grey: neither good nor bad
    draw(size && largest_.value ? std::optional(height_share_of_largest(*size, *largest_.value)) : std::nullopt,
         c.residual[1], bottom, bottom - room.top());
  if (has_preview) {
    const QRectF bar = draw(height_share(*cell.predicted), residual_color(cell.predicted, cell.coordinates),
                            room.bottom(), room.height() / 2 - 1);
    painter.fillRect(QRectF(bar.left(), bar.top(), bar.width(), 1.5), c.candidate);
  }
  if (cell.state == CellState::rejected || cell.state == CellState::excluded) {
    if (room.width() >= 4) {
      // On a rim: the bar below it has any colour from nearly the ground's to nearly the ink's.
      const double thick = cell.state == CellState::excluded ? 2 : 1;
      for (const QPen& pen : {QPen(c.panel, thick + 2), QPen(c.ink1, thick)}) {
        painter.setPen(pen);
        painter.drawLine(room.bottomLeft() - QPointF(0, 1), room.topRight() + QPointF(0, room.height() * 0.3));
      }
    } else
      painter.fillRect(QRectF(room.left(), room.top() + room.height() / 2, room.width(), 2), c.ink2);
  }
}

void ObservationStrip::paint_cells() {
  largest_ = largest_without_noise();
  const double ratio = devicePixelRatioF();
  picture_ = QPixmap(size() * ratio);
  picture_.setDevicePixelRatio(ratio);
  picture_.fill(colors().window);
  QPainter painter(&picture_);
  const QRectF area = cells_area();
  painter.fillRect(area, colors().sunken);
  painter.setClipRect(area);
  const double width = cell_width();
  const int count = static_cast<int>(cells_.size());
  if (width * ratio >= 1) {
    painter.setRenderHint(QPainter::Antialiasing, width >= 5);
    const int last = std::min(count - 1, static_cast<int>(std::ceil(first_ + area.width() / width)));
    for (int i = std::max(0, static_cast<int>(first_)); i <= last; ++i)
      paint_cell(painter, cells_[static_cast<std::size_t>(i)], QRectF(find_left(i), area.top(), width, area.height()));
  } else {
    const double column = 1 / ratio;
    for (int k = 0; k < std::ceil(area.width() * ratio); ++k) {
      const double x = area.left() + k * column;
      const int from = static_cast<int>(first_ + (x - area.left()) / width);
      const int to = std::min(count, static_cast<int>(first_ + (x + column - area.left()) / width));
      if (from >= to) continue;
      const auto begin = cells_.begin() + from;
      const auto worst =
          std::max_element(begin, cells_.begin() + to, [](const auto& a, const auto& b) { return is_worse(b, a); });
      paint_cell(painter, *worst, QRectF(x, area.top(), column, area.height()));
    }
  }
  paint_sessions(painter);
  is_stale_ = false;
}

std::vector<int> ObservationStrip::session_starts() const {
  std::vector<int> starts;
  for (int i = 0; i < static_cast<int>(cells_.size()); ++i) {
    const int session = cells_[static_cast<std::size_t>(i)].session;
    if (session >= 0 && (i == 0 || cells_[static_cast<std::size_t>(i - 1)].session != session)) starts.push_back(i);
  }
  return starts;
}

/// Between two sessions a gap, under each a line of its colour.
void ObservationStrip::paint_sessions(QPainter& painter) const {
  const std::vector<int> starts = session_starts();
  const QRectF area = cells_area();
  painter.setClipping(false);
  for (std::size_t s = 0; s < starts.size(); ++s) {
    const int end = s + 1 < starts.size() ? starts[s + 1] : static_cast<int>(cells_.size());
    const double from = std::max(find_left(starts[s]), area.left()), to = std::min(find_left(end), area.right());
    if (from >= to) continue;
    painter.fillRect(QRectF(from, area.bottom() + 1, to - from - 1, 3),
                     session_mark_color(cells_[static_cast<std::size_t>(starts[s])].session));
    if (s > 0 && from > area.left()) painter.fillRect(QRectF(from - 1, area.top(), 2, area.height()), colors().ink1);
  }
}

void ObservationStrip::paint_marks(QPainter& painter) const {
  const Colors& c = colors();
  const QRectF area = cells_area();
  painter.setBrush(Qt::NoBrush);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto ring = [&](ObservationId id, const QColor& color, double pen) {
    QRectF cell = cell_rect(id);
    if (cell.isEmpty()) return;
    if (cell.width() < 6) cell = QRectF(cell.center().x() - 3, cell.top(), 6, cell.height());
    painter.setPen(QPen(color, pen));
    painter.drawRoundedRect(cell.adjusted(-pen / 2, -pen / 2, pen / 2, pen / 2), 2, 2);
  };
  if (!highlighted_.empty()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.ink1);
    for (const ObservationId id : highlighted_) {
      const QRectF cell = cell_rect(id);
      if (!cell.isEmpty()) painter.drawEllipse(QPointF(cell.center().x(), area.top() + 3), 2.5, 2.5);
    }
    painter.setBrush(Qt::NoBrush);
  }
  if (hovered_ != no_observation && hovered_ != selected_) ring(hovered_, c.ink2, 1.5);
  ring(selected_, c.accent, 2);
  if (is_brushing_ && brush_from_ >= 0 && brush_to_ >= 0) {
    QColor fill = c.accent;
    fill.setAlpha(60);
    const double from = find_left(std::min(brush_from_, brush_to_));
    const double to = find_left(std::max(brush_from_, brush_to_) + 1);
    painter.fillRect(QRectF(from, area.top(), to - from, area.height()).intersected(area), fill);
  }
}

/// Under the cells, as far as there is room.
void ObservationStrip::paint_ids(QPainter& painter) const {
  const QRectF row(layout_gap, 42, width() - 2 * layout_gap, 15);
  painter.setFont(text_font(TextRole::small));
  painter.setPen(colors().ink2);
  const QFontMetricsF metrics(painter.font());
  const double width_of_cell = cell_width();
  int step = 1;
  for (const int s : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 100000}) {
    step = s;
    if (s * width_of_cell > 44) break;
  }
  // Where a session begins stand its mark and its name, as far as it goes.
  std::vector<QRectF> taken;
  const std::vector<int> starts = session_starts();
  for (std::size_t s = 0; s < starts.size(); ++s) {
    const int session = cells_[static_cast<std::size_t>(starts[s])].session;
    const double from = std::max(find_left(starts[s]), row.left());
    const double to = s + 1 < starts.size() ? std::min(find_left(starts[s + 1]), row.right()) : row.right();
    if (to - from < 14) continue;
    draw_session_mark(painter, QPointF(from + 6, row.center().y()), 9, session);
    const QString name = metrics.elidedText(session_names_.value(session), Qt::ElideRight, to - from - 18);
    painter.setPen(colors().ink1);
    painter.drawText(QRectF(from + 14, row.top(), to - from - 14, row.height()), Qt::AlignVCenter | Qt::AlignLeft,
                     name);
    taken.emplace_back(from, row.top(), 14 + metrics.horizontalAdvance(name) + 8, row.height());
  }
  painter.setPen(colors().ink2);
  const auto is_taken = [&](double from, double to) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const QRectF& t) { return from < t.right() && to + 6 > t.left(); });
  };
  const int count = static_cast<int>(cells_.size());
  for (int i = static_cast<int>(std::ceil(first_ / step)) * step; i < count; i += step) {
    const QString text = QString::number(cells_[static_cast<std::size_t>(i)].id);
    const double wide = metrics.horizontalAdvance(text);
    const double left = std::max(find_left(i) + width_of_cell / 2 - wide / 2, row.left());
    if (left + wide > row.right()) break;
    if (is_taken(left, left + wide)) continue;
    painter.drawText(QRectF(left, row.top(), wide + 1, row.height()), Qt::AlignVCenter | Qt::AlignLeft, text);
  }
}

/// A line of its own, from the left: how many times the noise each colour is.
void ObservationStrip::paint_legend(QPainter& painter) const {
  const Colors& c = colors();
  const QRectF row(layout_gap, 57, width() - 2 * layout_gap, 15);
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  const QFontMetricsF metrics(painter.font());
  double x = row.left();
  const auto write = [&](const QString& text) {
    const double wide = metrics.horizontalAdvance(text);
    painter.drawText(QRectF(x, row.top(), wide + 1, row.height()), Qt::AlignVCenter | Qt::AlignLeft, text);
    x += wide;
  };
  const auto swatch = [&](int step) {
    painter.fillRect(QRectF(x, row.top() + 3, 12, 10), c.residual[static_cast<std::size_t>(step)]);
    x += 12;
  };
  const auto is_fitted = [](const ObservationCell& cell) { return cell.size.has_value(); };
  const auto has_ratio = [](const ObservationCell& cell) { return cell.rms_over_sigma.has_value(); };
  if (std::any_of(cells_.begin(), cells_.end(), is_fitted) && std::none_of(cells_.begin(), cells_.end(), has_ratio))
    return write(largest_.value ? QObject::tr("The noise is not known: a cell's height is its error, the highest %1.")
                                      .arg(size_text(largest_))
                                : QObject::tr("The noise is not known: nothing to colour by."));
  write(QString::fromUtf8("× ") + QObject::tr("noise:"));
  const QStringList names = {QStringLiteral("< 1.5"), QStringLiteral("< 3"), QStringLiteral("< 5"),
                             QStringLiteral("< 10"), QString::fromUtf8("≥ 10")};
  for (int i = 0; i < names.size(); ++i) {
    x += 12;
    if (i == 0) swatch(0);
    swatch(i + 1);
    x += 4;
    write(i == 0 ? QString(names[0]).replace('.', decimal_mark()) : names[i]);
  }
}

void ObservationStrip::paint_lens(QPainter& painter) const {
  const int index = find_index(hovered_);
  if (cell_width() >= 4 || index < 0 || !underMouse()) return;
  constexpr int around = 6;
  constexpr double wide = 11;
  const QRectF area = cells_area();
  const double full = (2 * around + 1) * wide + 4;
  const double middle = std::clamp(find_left(index), area.left() + full / 2, area.right() - full / 2);
  const QRectF lens(middle - full / 2, area.top(), full, area.height());
  painter.setPen(QPen(colors().control_edge, 1));
  painter.setBrush(colors().panel);
  painter.drawRoundedRect(lens, 3, 3);
  for (int i = -around; i <= around; ++i) {
    const int at = index + i;
    if (at < 0 || at >= static_cast<int>(cells_.size())) continue;
    const QRectF slot(middle + (i - 0.5) * wide, lens.top() + 2, wide, lens.height() - 4);
    paint_cell(painter, cells_[static_cast<std::size_t>(at)], slot);
    if (i == 0) {
      painter.setPen(QPen(colors().ink1, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(slot);
    }
  }
}

void ObservationStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (cells_.empty()) {
    painter.fillRect(rect(), colors().window);
    painter.fillRect(cells_area(), colors().sunken);
    draw_sentence(painter, cells_area(), empty_text_);
  } else {
    if (is_stale_ || picture_.devicePixelRatio() != devicePixelRatioF()) paint_cells();
    painter.drawPixmap(0, 0, picture_);
    paint_marks(painter);
    paint_lens(painter);
  }
  paint_ids(painter);
  paint_legend(painter);
  if (hasFocus()) draw_focus(painter, rect());
}

}  // namespace handsight::widgets
