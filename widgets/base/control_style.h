// SPDX-License-Identifier: GPL-3.0-or-later
// Fusion, with boxes and circles that can be seen on dark ground too.
#pragma once

#include <QProxyStyle>

namespace handsight::widgets {

/// Fusion draws the outlines of check boxes and radio buttons darker than the window: on a dark one nobody sees them.
/// Its arrow of a button's menu stands below the text's line; here the text has one of its own. Its longer buttons end
/// where their text does; here there is room on both sides.
class ControlStyle : public QProxyStyle {
 public:
  ControlStyle();
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override;
};

}  // namespace handsight::widgets
