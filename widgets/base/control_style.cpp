// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/control_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionToolButton>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int button_margin = 9;  // px, left and right of what stands on it

void draw_indicator(QPainter& painter, const QStyleOption& option, bool is_round) {
  const Colors& c = colors();
  const bool is_enabled = option.state & QStyle::State_Enabled, is_on = option.state & QStyle::State_On;
  const bool is_partly_on = option.state & QStyle::State_NoChange;
  const double side = std::min({option.rect.width(), option.rect.height(), 14});
  QRectF area(0, 0, side, side);
  area.moveCenter(QRectF(option.rect).center());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor mark = is_enabled ? c.accent : c.ink3;
  painter.setPen(QPen(option.state & QStyle::State_MouseOver && is_enabled ? c.accent
                      : is_on                                              ? mark
                                                                           : c.control_edge,
                      1.2));
  painter.setBrush(is_on && !is_round ? mark : c.panel);
  const QRectF outline = area.adjusted(0.6, 0.6, -0.6, -0.6);
  if (is_round)
    painter.drawEllipse(outline);
  else
    painter.drawRoundedRect(outline, 2, 2);
  const auto at = [&](double x, double y) { return area.topLeft() + QPointF(x * side, y * side); };
  if (is_round && is_on) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark);
    painter.drawEllipse(area.center(), side * 0.26, side * 0.26);
  } else if (is_on) {
    painter.setPen(QPen(c.panel, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF{at(0.24, 0.52), at(0.43, 0.71), at(0.77, 0.30)});
  } else if (is_partly_on) {
    painter.setPen(QPen(mark, 2));
    painter.drawLine(at(0.28, 0.5), at(0.72, 0.5));
  }
  painter.restore();
}

/// Of fields to type in: Fusion's own is darker than a dark window.
void draw_field_outline(QPainter& painter, const QStyleOption& option) {
  const Colors& c = colors();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(option.state & QStyle::State_HasFocus ? c.accent : c.control_edge, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
  painter.restore();
}

}  // namespace

ControlStyle::ControlStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void ControlStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  switch (element) {
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      return draw_indicator(*painter, *option, false);
    case PE_IndicatorRadioButton:
      return draw_indicator(*painter, *option, true);
    case PE_FrameLineEdit:
      QProxyStyle::drawPrimitive(element, option, painter, widget);
      if (theme() == ThemeKind::dark) draw_field_outline(*painter, *option);
      return;
    default:
      QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

void ControlStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                      const QWidget* widget) const {
  if (control == CC_SpinBox && theme() == ThemeKind::dark) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    return draw_field_outline(*painter, *option);
  }
  const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
  if (control != CC_ToolButton || !button) return QProxyStyle::drawComplexControl(control, option, painter, widget);
  QStyleOptionToolButton plain = *button;
  plain.features &= ~QStyleOptionToolButton::HasMenu;
  QProxyStyle::drawComplexControl(control, &plain, painter, widget);
}

QSize ControlStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                     const QWidget* widget) const {
  QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (type != CT_PushButton || !button || button->text.isEmpty()) return size;
  return size.expandedTo({contents.width() + 2 * button_margin, 0});
}

}  // namespace handsight::widgets
