// SPDX-License-Identifier: Apache-2.0
// Who cannot see the window hears what everything is called: each control that takes the focus has a name, and what is
// painted says what is selected in it.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>

#include "app/window/pages.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

std::string where(const QWidget* widget) {
  std::string path;
  for (const QWidget* w = widget; w; w = w->parentWidget())
    path += std::string(w->metaObject()->className()) + "(" + w->objectName().toStdString() + ") ";
  return path;
}

void expect_names(QWidget& window, const char* state) {
  for (QWidget* w : window.findChildren<QWidget*>()) {
    if (!w->isVisible() || !w->isEnabled() || w->focusPolicy() == Qt::NoFocus) continue;
    if (qobject_cast<QScrollBar*>(w) || qobject_cast<QSplitter*>(w) || qobject_cast<QScrollArea*>(w)) continue;
    if (w->focusProxy()) continue;
    QAccessibleInterface* voice = QAccessible::queryAccessibleInterface(w);
    ASSERT_NE(voice, nullptr);
    EXPECT_FALSE(voice->text(QAccessible::Name).isEmpty()) << state << ": " << where(w);
  }
}

TEST(Accessible, EveryControlHasAName) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(1440, 900);
  expect_names(desk.window, "start");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
  ASSERT_TRUE(desk.settle());
  for (int n = 1; n <= 5; ++n) {
    desk.key(Qt::Key_0 + n, Qt::ControlModifier);
    desk.settle();
    expect_names(desk.window, std::to_string(n).c_str());
  }
}

TEST(Accessible, TheStripSaysWhatIsSelected) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
  ASSERT_TRUE(desk.settle());
  desk.window.workbench().selection.select_observation(17);
  EXPECT_TRUE(desk.find<widgets::ObservationStrip>("strip")->accessibleDescription().startsWith("obs 17"))
      << desk.find<widgets::ObservationStrip>("strip")->accessibleDescription().toStdString();
}

}  // namespace
}  // namespace handsight::test
