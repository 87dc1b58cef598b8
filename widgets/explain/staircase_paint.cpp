// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/staircase_paint.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

/// One level of a line: y over a slot.
struct Level {
  QRectF slot;
  double y = 0;
};

const VersionStep& step(const StaircaseScene& scene, int i) {
  return scene.state->versions[static_cast<std::size_t>(i)];
}

int count(const StaircaseScene& scene) { return static_cast<int>(scene.state->versions.size()); }

/// The levels of a line. Refused steps are passed over; a step that falls is between the one before and its own.
std::vector<Level> levels(const StaircaseScene& scene, std::optional<double> VersionStep::*value) {
  std::vector<Level> all;
  for (int i = 0; i < count(scene); ++i) {
    const std::optional<double>& error = step(scene, i).*value;
    if (step(scene, i).is_refused || !error) continue;
    double y = scene.axis.at(*error);
    if (i == scene.falling && !all.empty()) y = all.back().y + scene.fallen * (y - all.back().y);
    all.push_back({scene.slots_[static_cast<std::size_t>(i)], y});
  }
  return all;
}

QPainterPath find_line(const std::vector<Level>& levels) {
  QPainterPath path;
  for (const Level& level : levels) {
    if (path.isEmpty())
      path.moveTo(level.slot.left(), level.y);
    else
      path.lineTo(level.slot.left(), path.currentPosition().y());  // level past refused steps
    path.lineTo(level.slot.left(), level.y);
    path.lineTo(level.slot.right(), level.y);
  }
  return path;
}

void paint_floor(QPainter& painter, const StaircaseScene& scene) {
  const Colors& c = colors();
  const std::optional<double>& noise = scene.state->noise;
  if (!noise || !(*noise > 0)) return;
  const double y = scene.axis.at(*noise);
  painter.fillRect(QRectF(scene.area.left(), y, scene.area.width(), scene.area.bottom() - y),
                   noise_hatching(c.control_edge));
  painter.setFont(number_font(TextRole::small));
  const QString text = QCoreApplication::translate("handsight::widgets::Staircase", "noise %1")
                           .arg(with_unit_text(noise, scene.state->unit));
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 8;
  draw_plate(painter, {scene.area.right() - wide, (y + scene.area.bottom()) / 2}, text, c.ink2, c.panel);
}

void paint_slots(QPainter& painter, const StaircaseScene& scene) {
  const Colors& c = colors();
  painter.setFont(number_font(TextRole::small));
  for (int i = 0; i < count(scene); ++i) {
    const QRectF slot = scene.slots_[static_cast<std::size_t>(i)];
    const QRectF foot(slot.left(), scene.area.bottom() + 2, slot.width(), 16);
    if (i == scene.current) {
      painter.fillRect(slot, c.selected_row);
      painter.fillRect(QRectF(slot.left() + 2, foot.bottom(), slot.width() - 4, 2), c.accent);
    }
    if (i == scene.hovered) {
      painter.setPen(QPen(c.control_edge, 1));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(slot.adjusted(0.5, 0.5, -0.5, -0.5));
    }
    const bool is_a = i == scene.state->compared_a, is_b = i == scene.state->compared_b;
    painter.setPen(is_a || is_b ? c.ink1 : c.ink3);
    const QString name = is_a ? QStringLiteral("A") : is_b ? QStringLiteral("B") : QString::number(i);
    if (is_a || is_b)
      draw_plate(painter, {foot.center().x() - 7, foot.center().y()}, name, c.panel, c.ink2);
    else
      painter.drawText(foot, Qt::AlignCenter, name);
  }
}

void paint_refused(QPainter& painter, const StaircaseScene& scene) {
  const Colors& c = colors();
  for (int i = 0; i < count(scene); ++i) {
    const VersionStep& s = step(scene, i);
    const std::optional<double> error = s.held_out ? s.held_out : s.fitted;
    if (!s.is_refused) continue;
    const QRectF slot = scene.slots_[static_cast<std::size_t>(i)];
    const double y = error ? scene.axis.at(*error) : slot.center().y();
    painter.setPen(QPen(c.control_edge, 2));
    painter.drawLine(QPointF(slot.left() + 3, y), QPointF(slot.right() - 3, y));
    const QPointF middle(slot.center().x(), y - 9);
    painter.setPen(QPen(c.ink3, 1.5));
    painter.drawLine(middle - QPointF(3, 3), middle + QPointF(3, 3));
    painter.drawLine(middle - QPointF(3, -3), middle + QPointF(3, -3));
  }
}

void paint_preview(QPainter& painter, const StaircaseScene& scene, const std::vector<Level>& held_out) {
  if (!scene.state->preview || !scene.state->preview->held_out) return;
  const QRectF slot = scene.slots_.back();
  const double y = scene.axis.at(*scene.state->preview->held_out);
  double from = y;
  for (int i = 0, level = 0; i < count(scene); ++i) {
    if (step(scene, i).is_refused || !step(scene, i).held_out) continue;
    if (i <= scene.current) from = held_out[static_cast<std::size_t>(level)].y;
    ++level;
  }
  QPainterPath path;
  path.moveTo(slot.left(), from);
  path.lineTo(slot.left(), y);
  path.lineTo(slot.right(), y);
  QPen pen(colors().candidate, 2);
  pen.setDashPattern({3, 2});
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
  painter.setFont(number_font(TextRole::small));
  painter.drawText(QRectF(slot.left() - 20, y - 18, slot.width() + 40, 16), Qt::AlignCenter,
                   short_text(scene.state->preview->held_out));
}

void paint_legend(QPainter& painter, const StaircaseScene& scene, int width) {
  const Colors& c = colors();
  const auto tr = [](const char* text) { return QCoreApplication::translate("handsight::widgets::Staircase", text); };
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  painter.drawText(QRectF(layout_gap, 2, 60, 18), Qt::AlignLeft | Qt::AlignVCenter, scene.state->unit);
  const QFontMetricsF metrics(painter.font());
  double right = width - layout_gap;
  const auto entry = [&](const QString& name, const QPen& pen) {
    const double wide = metrics.horizontalAdvance(name) + 2;
    painter.setPen(c.ink2);
    painter.drawText(QRectF(right - wide, 2, wide, 18), Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setPen(pen);
    painter.drawLine(QPointF(right - wide - 22, 11.5), QPointF(right - wide - 5, 11.5));
    right -= wide + 36;
  };
  entry(tr("fitted"), QPen(c.ink3, 1.2));
  entry(tr("held out"), QPen(c.ink1, 2));
}

}  // namespace

void paint_staircase(QPainter& painter, const StaircaseScene& scene, int width) {
  const Colors& c = colors();
  paint_legend(painter, scene, width);
  painter.setRenderHint(QPainter::Antialiasing, false);
  paint_slots(painter, scene);
  draw_log_axis(painter, scene.axis, scene.area);
  paint_floor(painter, scene);
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<Level> held_out = levels(scene, &VersionStep::held_out),
                           fitted = levels(scene, &VersionStep::fitted);
  QColor gap = c.care;
  gap.setAlpha(70);
  for (const Level& h : held_out)  // between the lines: over-fitting
    for (const Level& f : fitted)
      if (f.slot == h.slot && f.y > h.y) painter.fillRect(QRectF(h.slot.left(), h.y, h.slot.width(), f.y - h.y), gap);
  paint_refused(painter, scene);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(c.ink3, 1.2));
  painter.drawPath(find_line(fitted));
  painter.setPen(QPen(c.ink1, 2));
  painter.drawPath(find_line(held_out));
  paint_preview(painter, scene, held_out);
}

}  // namespace handsight::widgets
