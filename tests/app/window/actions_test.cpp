// SPDX-License-Identifier: Apache-2.0
// One registry: what the menu, the keys, Ctrl+K and the tool tips offer is the same.
#include "workbench/actions.h"

#include <gtest/gtest.h>

#include <QMenu>
#include <set>

#include "app/window/desk.h"

namespace handsight::test {
namespace {

TEST(Actions, AKeyDoesWhatItsActionDoesAndNothingWhereItIsNotPossible) {
  QWidget window;
  app::Actions actions(&window);
  int done = 0;
  bool possible = true;
  actions.add({.id = "a",
               .group = "Everywhere",
               .text = "&Do it",
               .keys = {QKeySequence(Qt::CTRL | Qt::Key_J)},
               .run = [&] { ++done; },
               .is_possible = [&] { return possible; },
               .section = 1});
  actions.add({.id = "b", .group = "Plots", .text = "choose", .gesture = "Shift+drag"});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QTest::keyClick(&window, Qt::Key_J, Qt::ControlModifier);
  EXPECT_EQ(done, 1);
  possible = false;
  QTest::keyClick(&window, Qt::Key_J, Qt::ControlModifier);
  EXPECT_EQ(done, 1);
  EXPECT_EQ(actions.of("a").tool_tip(), "Do it (Ctrl+J)");
  const auto sheet = actions.sheet();
  ASSERT_EQ(sheet.size(), 4U);
  EXPECT_TRUE(sheet[0].is_heading() && sheet[2].is_heading());
  EXPECT_EQ(sheet[1].keys, "Ctrl+J");
  EXPECT_EQ(sheet[3].keys, "Shift+drag");
  QMenu menu;
  actions.fill(menu);
  ASSERT_EQ(menu.actions().size(), 1);
  possible = true;
  menu.actions().front()->trigger();
  EXPECT_EQ(done, 2);
}

/// Everything in the menu is an action of the registry, its key is listened to once, and it stands in the sheet.
TEST(Actions, OfTheWindowAreInMenuAndSheetAlike) {
  Desk desk;
  const app::Actions& actions = desk.window.registry();
  const auto* menu = desk.find<QMenu>("menu");
  std::set<QString> in_menu;
  for (const QAction* a : menu->actions())
    if (!a->isSeparator() && !a->menu()) in_menu.insert(a->objectName());
  std::set<QString> wanted, keys_in_sheet;
  for (const app::Action& a : actions.all())
    if (a.section > 0) wanted.insert(a.id);
  EXPECT_EQ(in_menu, wanted);
  for (const auto& row : actions.sheet()) keys_in_sheet.insert(row.keys);
  for (const app::Action& a : actions.all()) {
    EXPECT_FALSE(a.plain_text().isEmpty()) << a.id.toStdString();
    if (!a.keys_text().isEmpty() && a.in_sheet) {
      EXPECT_TRUE(keys_in_sheet.contains(a.keys_text())) << a.id.toStdString();
    }
  }
}

}  // namespace
}  // namespace handsight::test
