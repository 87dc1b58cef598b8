// SPDX-License-Identifier: Apache-2.0
// Theme and motion, chosen in the window and remembered.
#include "window/appearance.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>

#include "app/window/pages.h"
#include "temporary_folder.h"
#include "widgets/base/apply_theme.h"
#include "workbench/preferences.h"

namespace handsight::test {
namespace {

class AppearanceTest : public testing::Test {
 protected:
  ~AppearanceTest() override {
    for (const char* name : {"theme", "motion"}) app::remember_preference(name, "desktop");
    widgets::set_motion(widgets::MotionChoice::as_desktop);
    widgets::apply_theme(*qApp, widgets::ThemeKind::light);
  }
  void open(Desk& desk) {
    const auto session = folder.path / "thesis_simulation";
    std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/thesis_simulation", session,
                          std::filesystem::copy_options::recursive);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
  }
  static void find(Desk& desk, const char* words) {
    desk.key(Qt::Key_K, Qt::ControlModifier);
    for (const char* c = words; *c; ++c) QTest::keyClick(desk.window.windowHandle(), *c);
    desk.key(Qt::Key_Return);
    QTest::qWait(30);
  }
  TemporaryFolder folder;
};

TEST_F(AppearanceTest, ChosenByTheKeyboardAndRemembered) {
  {
    app::Appearance appearance(*qApp, {});
    Desk desk;
    desk.window.offer(appearance);
    open(desk);
    EXPECT_FALSE(widgets::motion_is_reduced());
    find(desk, "motion reduced");
    EXPECT_TRUE(widgets::motion_is_reduced());
    find(desk, "theme dark");
    EXPECT_EQ(widgets::theme(), widgets::ThemeKind::dark);
    auto* choices = desk.window.findChild<QMenu*>("menu_motion");
    ASSERT_NE(choices, nullptr);
    EXPECT_TRUE(choices->actions()[2]->isChecked()) << "the menu marks what is in force";
    EXPECT_FALSE(choices->actions()[0]->isChecked());
  }
  widgets::set_motion(widgets::MotionChoice::as_desktop);
  widgets::apply_theme(*qApp, widgets::ThemeKind::light);
  const app::Appearance next(*qApp, {});
  EXPECT_TRUE(widgets::motion_is_reduced());
  EXPECT_EQ(widgets::theme(), widgets::ThemeKind::dark);
}

TEST_F(AppearanceTest, AThemeNamedAtTheStartIsForThisStart) {
  app::Appearance appearance(*qApp, "dark");
  EXPECT_EQ(widgets::theme(), widgets::ThemeKind::dark);
  EXPECT_NE(app::preference("theme"), "dark");
}

}  // namespace
}  // namespace handsight::test
