// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/three_numbers.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr double stairs_width = 120;
constexpr double number_line = 22, caption_line = 6;  // baselines above the lower edge

QString ratio_text(const ErrorNumbers& numbers) {
  std::optional<double> ratio = numbers.ratio;
  if (!ratio && numbers.now && numbers.noise && *numbers.noise > 0) ratio = *numbers.now / *numbers.noise;
  if (!ratio) return QStringLiteral("-");
  QString text = short_text(ratio) + QStringLiteral(" ×");
  if (numbers.predicted_ratio)
    text += QStringLiteral(" → ") + short_text(numbers.predicted_ratio) + QStringLiteral(" ×");
  return text;
}

/// What stands below the first number.
QString caption_of(const ErrorNumbers& n) {
  if (!n.excluded_note.isEmpty()) return QObject::tr("error now (%1)").arg(n.excluded_note);
  if (n.elsewhere) return QObject::tr("held out; elsewhere %1").arg(with_unit_text(n.elsewhere, n.unit));
  return QObject::tr("error now, held out");
}

QString now_text(const ErrorNumbers& n) {
  QString text = with_unit_text(n.now, n.unit);
  if (n.predicted) text += QStringLiteral(" → ") + with_unit_text(n.predicted, n.unit);
  return text;
}

QString about_numbers(const QString& unit) {
  if (unit == unit_name(SizeUnit::millimetre))
    return QObject::tr(
        "How far the hand is from where it is predicted, all markers of an observation together (with a tracker: each "
        "marker), on observations that the fit has not seen; what noise alone would make of it; and how many times "
        "larger than that it is. U changes the unit.");
  return QObject::tr(
      "The error of one coordinate (root mean square) on observations that the fit has not seen, the noise of the "
      "measurement, and how many times larger the error is. Elsewhere: where whole regions of poses are held out. U "
      "changes the unit.");
}

QString noise_caption(const ErrorNumbers& n) {
  return n.noise_note.isEmpty() ? QObject::tr("noise floor") : QObject::tr("noise, %1").arg(n.noise_note);
}

std::optional<double> height_of(const VersionStep& step) { return step.held_out ? step.held_out : step.fitted; }

}  // namespace

ThreeNumbers::ThreeNumbers(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAccessibleName(QObject::tr("Error now, noise floor, ratio"));
}

void ThreeNumbers::set_numbers(ErrorNumbers numbers) {
  numbers_ = std::move(numbers);
  hovered_ = -1;
  setAccessibleDescription(
      QObject::tr("Error now %1, noise %2, ratio %3")
          .arg(now_text(numbers_), with_unit_text(numbers_.noise, numbers_.unit), ratio_text(numbers_)));
  updateGeometry();
  update();
}

QSize ThreeNumbers::sizeHint() const {
  const QFontMetricsF numbers(number_font(TextRole::number)), small(text_font(TextRole::small));
  const auto wide = [&](const QString& text, const QString& caption) {
    return std::max(numbers.horizontalAdvance(text), small.horizontalAdvance(caption)) + wide_gap;
  };
  const QString caption = caption_of(numbers_);
  const double width = wide(now_text(numbers_), caption) +
                       wide(with_unit_text(numbers_.noise, numbers_.unit), noise_caption(numbers_)) +
                       wide(ratio_text(numbers_), QObject::tr("ratio")) + stairs_width;
  return {static_cast<int>(std::ceil(width)) + layout_gap, 44};
}

/// The numbers first: where there is no room for the line as well, it is left away.
QSize ThreeNumbers::minimumSizeHint() const { return sizeHint() - QSize(stairs_width, 0); }

QRectF ThreeNumbers::stairs_area() const {
  if (width() < sizeHint().width()) return {};
  return {width() - stairs_width, 4.0, stairs_width - layout_gap, height() - 8.0};
}

QRectF ThreeNumbers::step_rect(int version) const {
  const int count = static_cast<int>(numbers_.versions.size());
  if (version < 0 || version >= count) return {};
  const QRectF area = stairs_area();
  const double width = std::min(area.width() / count, 28.0);
  return {area.left() + version * width, area.top(), width, area.height()};
}

int ThreeNumbers::step_at(const QPointF& position) const {
  for (int i = 0; i < static_cast<int>(numbers_.versions.size()); ++i)
    if (step_rect(i).contains(position)) return i;
  return -1;
}

QString ThreeNumbers::step_text(int version) const {
  const VersionStep& step = numbers_.versions[static_cast<std::size_t>(version)];
  QString text =
      QObject::tr("%1: held out %2, fitted %3")
          .arg(step.name, with_unit_text(step.held_out, numbers_.unit), with_unit_text(step.fitted, numbers_.unit));
  if (step.is_refused) text += QObject::tr(", not added");
  if (!step.reason.isEmpty()) text += QStringLiteral(": ") + step.reason;
  return text;
}

void ThreeNumbers::paint_stairs(QPainter& painter) const {
  const Colors& c = colors();
  const QRectF area = stairs_area();
  if (area.isEmpty()) return;
  painter.fillRect(area, c.sunken);
  double low = numbers_.noise.value_or(1e300), high = numbers_.noise.value_or(0);
  for (const VersionStep& step : numbers_.versions) {
    for (const std::optional<double>& value : {step.fitted, step.held_out}) {
      if (!value || *value <= 0) continue;
      low = std::min(low, *value);
      high = std::max(high, *value);
    }
  }
  if (!(high > 0)) return;
  low = std::min(low, high / 2) / 1.3;
  const QRectF room = area.adjusted(0, 3, 0, 0);
  const auto y_of = [&](double value) {
    return room.bottom() - room.height() * std::log(std::max(value, low) / low) / std::log(high / low);
  };
  if (numbers_.noise && *numbers_.noise > 0) {
    const double y = y_of(*numbers_.noise);
    painter.fillRect(QRectF(area.left(), y, area.width(), area.bottom() - y), noise_hatching(c.control_edge));
  }
  const int current = numbers_.current < 0 ? static_cast<int>(numbers_.versions.size()) - 1 : numbers_.current;
  QPainterPath held_out, fitted;
  const auto extend = [&](QPainterPath& path, std::optional<double> value, const QRectF& slot) {
    if (!value) return;
    const double y = y_of(*value);
    if (path.isEmpty()) path.moveTo(slot.left(), y);
    path.lineTo(slot.left(), path.currentPosition().y());  // level past refused steps
    path.lineTo(slot.left(), y);
    path.lineTo(slot.right(), y);
  };
  for (int i = 0; i < static_cast<int>(numbers_.versions.size()); ++i) {
    const VersionStep& step = numbers_.versions[static_cast<std::size_t>(i)];
    const QRectF slot = step_rect(i);
    if (i == current) painter.fillRect(slot, c.selected_row);
    if (i == hovered_) {
      painter.setPen(QPen(c.ink2, 1));
      painter.drawRect(slot.adjusted(0.5, 0.5, -0.5, -0.5));
    }
    if (step.is_refused) {
      const double y = y_of(height_of(step).value_or(high));
      painter.setPen(QPen(c.ink3, 2));
      painter.drawLine(QPointF(slot.left() + 2, y), QPointF(slot.right() - 2, y));
      continue;
    }
    extend(held_out, step.held_out, slot);
    extend(fitted, step.fitted, slot);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(c.ink3, 1));
  painter.drawPath(fitted);
  painter.setPen(QPen(c.ink1, 2));
  painter.drawPath(held_out);
}

void ThreeNumbers::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  const QFontMetricsF numbers(number_font(TextRole::number)), small(text_font(TextRole::small));
  double x = layout_gap;
  const auto column = [&](const QString& text, const QString& caption, const QColor& ink) {
    const double wide = std::max(numbers.horizontalAdvance(text), small.horizontalAdvance(caption));
    painter.setFont(number_font(TextRole::number));
    painter.setPen(numbers_.is_stale ? c.ink3 : ink);
    painter.drawText(QPointF(x, height() - number_line), text);
    painter.setFont(text_font(TextRole::small));
    painter.setPen(c.ink2);
    painter.drawText(QPointF(x, height() - caption_line), caption);
    x += wide + wide_gap;
  };
  const QString caption = caption_of(numbers_);
  column(now_text(numbers_), caption, numbers_.predicted ? c.candidate : c.ink1);
  column(with_unit_text(numbers_.noise, numbers_.unit), noise_caption(numbers_), c.ink1);
  column(ratio_text(numbers_), QObject::tr("ratio"), numbers_.predicted_ratio ? c.candidate : c.ink1);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (!numbers_.versions.empty()) paint_stairs(painter);
  if (hasFocus()) draw_focus(painter, rect());
}

void ThreeNumbers::mousePressEvent(QMouseEvent* event) {
  const int step = step_at(event->position());
  if (event->button() == Qt::LeftButton && step >= 0) emit version_selected(step);
}

void ThreeNumbers::mouseMoveEvent(QMouseEvent* event) {
  const int step = step_at(event->position());
  if (step == hovered_) return;
  hovered_ = step;
  emit read_out(step < 0 ? QString() : step_text(step));
  update();
}

void ThreeNumbers::leaveEvent(QEvent*) {
  if (hovered_ < 0) return;
  hovered_ = -1;
  emit read_out({});
  update();
}

void ThreeNumbers::keyPressEvent(QKeyEvent* event) {
  const int count = static_cast<int>(numbers_.versions.size());
  const int current = numbers_.current < 0 ? count - 1 : numbers_.current;
  const int next = event->key() == Qt::Key_Left ? current - 1 : event->key() == Qt::Key_Right ? current + 1 : -1;
  if (next >= 0 && next < count)
    emit version_selected(next);
  else
    QWidget::keyPressEvent(event);
}

bool ThreeNumbers::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int step = step_at(help->pos());
  show_tip(this, *help, rect(), step >= 0 ? step_text(step) : about_numbers(numbers_.unit));
  return true;
}

}  // namespace handsight::widgets
