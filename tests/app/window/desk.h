// SPDX-License-Identifier: Apache-2.0
// A user at the window: mouse, keyboard, eyes. What tests do goes through the window system's events.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QElapsedTimer>
#include <QMenu>
#include <QScrollArea>
#include <QTest>
#include <filesystem>
#include <functional>

#include "window/main_window.h"

namespace handsight::test {

/// How many times longer a test waits for what it waits for: instrumented programs are up to twenty times slower.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int patience = 20;
#else
inline constexpr int patience = 1;
#endif

/// A sample session that a test may change.
inline std::filesystem::path copy_of_sample(const std::filesystem::path& folder, const std::string& name) {
  const auto copy = folder / name;
  std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name, copy,
                        std::filesystem::copy_options::recursive);
  return copy;
}

class Desk {
 public:
  Desk() {
    window.show();
    (void)QTest::qWaitForWindowExposed(&window);
    window.activateWindow();  // no window manager does it on a bare X server
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }

  template <class Widget>
  Widget* find(const char* name) const {
    auto* found = window.findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << "no widget is called " << name;
    return found;
  }

  /// Presses and releases a mouse button at a place of a widget.
  void click(QWidget* widget, const QPoint& at, Qt::KeyboardModifiers keys = {},
             Qt::MouseButton button = Qt::LeftButton) {
    scroll_to(widget, at);
    QWidget* top = widget->window();
    const QPoint there = widget->mapTo(top, at);
    QTest::mouseMove(top->windowHandle(), there);
    QTest::mouseClick(top->windowHandle(), button, keys, there);
    QTest::qWait(5);
  }
  /// What is out of sight is scrolled to first, as a user does.
  void scroll_to(QWidget* widget, const QPoint& at) {
    if (widget->visibleRegion().contains(at)) return;
    for (QWidget* p = widget->parentWidget(); p; p = p->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(p); area && area->widget()) {
        const QPoint there = widget->mapTo(area->widget(), at);
        area->ensureVisible(there.x(), there.y(), 20, 20);
        QTest::qWait(10);
      }
  }
  void click(QWidget* widget) { click(widget, widget->rect().center()); }
  void press_button(const char* name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_TRUE(button->isVisible()) << name << " cannot be seen";
    ASSERT_TRUE(button->isEnabled()) << name << " cannot be pressed";
    click(button);
  }
  /// Chooses an entry of the session's menu by its name.
  void choose(const char* name) {
    emit find<QMenu>("menu")->aboutToShow();
    auto* entry = find<QAction>(name);
    ASSERT_TRUE(entry && entry->isVisible() && entry->isEnabled()) << name << " is not offered";
    entry->trigger();
    QTest::qWait(5);
  }
  void drag(QWidget* widget, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    QWindow* top = widget->window()->windowHandle();
    const QPoint a = widget->mapTo(widget->window(), from), b = widget->mapTo(widget->window(), to);
    QTest::mousePress(top, Qt::LeftButton, keys, a);
    for (int i = 1; i <= 8; ++i) {
      QTest::mouseMove(top, a + (b - a) * i / 8);
      QTest::qWait(2);
    }
    QTest::mouseRelease(top, Qt::LeftButton, keys, b);
    QTest::qWait(5);
  }
  void key(int key, Qt::KeyboardModifiers keys = {}) {
    QTest::keyClick(window.windowHandle(), static_cast<Qt::Key>(key), keys);
    QTest::qWait(5);
  }
  void type_into(QWidget* field, const QString& text) {
    click(field);
    QWindow* top = field->window()->windowHandle();
    QTest::keyClick(top, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(top, Qt::Key_Delete);
    for (const QChar c : text) QTest::keyClick(top, c.toLatin1());
    QTest::qWait(5);
  }
  bool wait(const std::function<bool()>& until, int milliseconds = 30000) {
    return QTest::qWaitFor(until, patience * milliseconds);
  }
  /// Until nothing runs in the background and the fit belongs to what is shown.
  bool settle() {
    return wait([this] {
      auto& workbench = window.workbench();
      return !workbench.jobs.is_busy() && !workbench.background.is_busy() && !workbench.refit.is_pending() &&
             !workbench.images.is_busy();
    });
  }

  app::Document& document() { return window.workbench().document; }
  app::MainWindow window;
};

}  // namespace handsight::test
