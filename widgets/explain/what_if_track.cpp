// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/what_if_track.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr double edge_margin = 12, middle_at = 22, handle_radius = 8, most_sizes = 3;

}  // namespace

WhatIfTrack::WhatIfTrack(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Size of the effect"));
}

void WhatIfTrack::set_parameter(const WhatIfParameter& parameter) {
  parameter_ = parameter;
  if (!(parameter_.plausible > 0)) parameter_.plausible = 1;
  parameter_.value = std::clamp(parameter_.value, -reach(), reach());
  update();
}

void WhatIfTrack::set_value(double value) {
  parameter_.value = std::clamp(value, -reach(), reach());
  setAccessibleDescription(with_unit_text(parameter_.value, parameter_.unit, 3));
  update();
}

double WhatIfTrack::reach() const {
  const double wide = most_sizes * parameter_.plausible;
  if (!parameter_.best) return wide;
  return std::max(wide, 1.15 * (std::abs(*parameter_.best) + parameter_.best_sigma.value_or(0)));
}

double WhatIfTrack::find_x(double value) const {
  return edge_margin + (width() - 2 * edge_margin) * (value + reach()) / (2 * reach());
}

double WhatIfTrack::value_at(double x) const {
  return std::clamp(((x - edge_margin) / std::max(width() - 2 * edge_margin, 1.0) * 2 - 1) * reach(), -reach(),
                    reach());
}

void WhatIfTrack::move_to(double value, bool is_final) {
  set_value(value);
  emit moved(parameter_.value);
  if (is_final) emit released(parameter_.value);
}

void WhatIfTrack::paint_best(QPainter& painter, double middle) const {
  if (!parameter_.best) return;
  const Colors& c = colors();
  const double best = find_x(*parameter_.best);
  const double sigma = std::abs(find_x(*parameter_.best + parameter_.best_sigma.value_or(0)) - best);
  QColor veil = c.candidate;
  veil.setAlpha(70);
  painter.fillRect(QRectF(best - sigma, middle - 9, 2 * sigma, 18), veil);
  QPen pen(c.candidate, 2);
  pen.setDashPattern({2, 1.2});
  painter.setPen(pen);
  painter.drawLine(QPointF(best, middle - 14), QPointF(best, middle + 9));
  painter.setFont(text_font(TextRole::small));
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(tr("best")) + 2;
  const double left = std::clamp(best + 4, 0.0, width() - wide);
  painter.drawText(QRectF(left, 0, wide, 14), Qt::AlignLeft | Qt::AlignVCenter, tr("best"));
}

void WhatIfTrack::paint_marks(QPainter& painter, double middle) const {
  const Colors& c = colors();
  painter.setFont(number_font(TextRole::small));
  const QRectF foot(0, middle + 13, width(), 16);
  const auto mark = [&](double value, Qt::Alignment alignment, const QString& text) {
    const double x = find_x(value);
    painter.setPen(QPen(c.control_edge, 1));
    painter.drawLine(QPointF(x, middle + 7), QPointF(x, middle + 12));
    painter.setPen(c.ink3);
    const double left = alignment & Qt::AlignLeft ? 2 : alignment & Qt::AlignRight ? width() - 122.0 : x - 60;
    painter.drawText(QRectF(left, foot.top(), 120, foot.height()), alignment | Qt::AlignVCenter, text);
  };
  mark(-reach(), Qt::AlignLeft, short_text(-reach()));
  mark(0, Qt::AlignHCenter, QStringLiteral("0"));
  mark(reach(), Qt::AlignRight, short_text(reach()));
}

void WhatIfTrack::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar(edge_margin, middle_at - 3, width() - 2 * edge_margin, 6);
  painter.fillRect(bar, c.sunken);
  const double from = find_x(-parameter_.plausible), to = find_x(parameter_.plausible);
  painter.fillRect(QRectF(from, bar.top() - 3, to - from, bar.height() + 6), c.hairline);  // what is plausible
  paint_marks(painter, middle_at);
  paint_best(painter, middle_at);
  const QPointF handle(find_x(parameter_.value), middle_at);
  painter.setPen(QPen(hasFocus() ? c.accent : c.ink1, 2));
  painter.setBrush(c.panel);
  painter.drawEllipse(handle, handle_radius, handle_radius);
  painter.setPen(Qt::NoPen);
  painter.setBrush(c.candidate);
  painter.drawEllipse(handle, 3, 3);
}

void WhatIfTrack::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  is_dragging_ = true;
  move_to(value_at(event->position().x()), false);
}

void WhatIfTrack::mouseMoveEvent(QMouseEvent* event) {
  if (is_dragging_) move_to(value_at(event->position().x()), false);
}

void WhatIfTrack::mouseReleaseEvent(QMouseEvent*) {
  if (!is_dragging_) return;
  is_dragging_ = false;
  emit released(parameter_.value);
}

void WhatIfTrack::mouseDoubleClickEvent(QMouseEvent*) {
  is_dragging_ = false;
  if (parameter_.best) move_to(*parameter_.best, true);
}

void WhatIfTrack::keyPressEvent(QKeyEvent* event) {
  const double fine = reach() / 50, coarse = reach() / 5;
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return move_to(parameter_.value - fine, true);
    case Qt::Key_Right:
    case Qt::Key_Up:
      return move_to(parameter_.value + fine, true);
    case Qt::Key_PageDown:
      return move_to(parameter_.value - coarse, true);
    case Qt::Key_PageUp:
      return move_to(parameter_.value + coarse, true);
    case Qt::Key_Home:
      return move_to(0, true);
    case Qt::Key_B:
      if (parameter_.best) move_to(*parameter_.best, true);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void WhatIfTrack::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();  // it must not change while the list is scrolled
  move_to(parameter_.value + (event->angleDelta().y() > 0 ? 1 : -1) * reach() / 50, true);
}

bool WhatIfTrack::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const QString best = parameter_.best
                           ? tr(" The size that fits best is %1 %2.")
                                 .arg(with_sigma_text(parameter_.best, parameter_.best_sigma), parameter_.unit)
                           : QString();
  show_tip(this, *static_cast<QHelpEvent*>(event), rect(),
           tr("Plausible within about ± %1.").arg(with_unit_text(parameter_.plausible, parameter_.unit)) + best);
  return true;
}

}  // namespace handsight::widgets
