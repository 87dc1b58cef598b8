// SPDX-License-Identifier: Apache-2.0
// Mouse and keyboard for the widgets' tests.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>

namespace handsight::test {

/// Shown, exposed and drawn.
inline void show(QWidget& widget, const QSize& size) {
  widget.resize(size);
  widget.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
  QTest::qWait(50);
}

inline void click(QWidget* widget, const QPointF& at, Qt::KeyboardModifiers keys = {}) {
  QTest::mouseMove(widget, at.toPoint());
  QTest::mouseClick(widget, Qt::LeftButton, keys, at.toPoint());
}

inline void drag(QWidget* widget, const QPointF& from, const QPointF& to, Qt::KeyboardModifiers keys = {},
                 Qt::MouseButton button = Qt::LeftButton) {
  QTest::mousePress(widget, button, keys, from.toPoint());
  for (int i = 1; i <= 4; ++i) {
    const QPointF at = from + (to - from) * i / 4;
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, keys);
    QApplication::sendEvent(widget, &move);
  }
  QTest::mouseRelease(widget, button, keys, to.toPoint());
}

inline void hover(QWidget* widget, const QPointF& at) {
  QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &move);
}

inline void wheel(QWidget* widget, const QPointF& at, int steps) {
  QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(widget, &event);
}

}  // namespace handsight::test
