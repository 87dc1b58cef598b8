// SPDX-License-Identifier: Apache-2.0
// A session that is being made from files can be stopped at any moment, and nothing of it is left.
#include <gtest/gtest.h>

#include <QThread>

#include "app/window/files_page.h"

namespace handsight::test {
namespace {

/// At work on a session of poses, and held there until it is let go.
class StoppedWizard : public BoardWizard {
 protected:
  app::Jobs& jobs() { return desk.window.workbench().background; }
  QAbstractButton* stop() { return desk.find<QAbstractButton>("files_stop"); }
  bool begin_making() {
    const std::vector<Rigid> three{
        {Matrix3::Identity(), {0, 0, 0.1}}, {Matrix3::Identity(), {0.1, 0, 0}}, {Matrix3::Identity(), {0, 0.1, 0}}};
    replace_file(folder.path / "flange.csv", pose_table(three));
    replace_file(folder.path / "target.csv", pose_table(three));
    if (!files.drop({folder.path / "flange.csv", folder.path / "target.csv"}, &desk.window)) return false;
    if (!QTest::qWaitForWindowExposed(files.dialog())) return false;
    files.fill("files_title", "Monday");
    files.fill("files_out", folder.path / "made");
    jobs().hold(true);
    desk.click(files.make());
    return stop()->isVisible();
  }
  void expect_stopped() {
    jobs().hold(false);
    ASSERT_TRUE(desk.wait([this] { return files.said() != "Stopping …"; }));
    EXPECT_EQ(files.said(), "Stopped; nothing was made.");
    EXPECT_TRUE(files.dialog()->isVisible());
    EXPECT_TRUE(files.make()->isEnabled());
    EXPECT_FALSE(jobs().is_busy());
    EXPECT_FALSE(std::filesystem::exists(folder.path / "made"));
  }
  FilesPage files{desk};
};

TEST_F(StoppedWizard, WhatIsBeingMadeCanBeStoppedAndMadeAgain) {
  ASSERT_TRUE(begin_making());
  EXPECT_TRUE(files.said().contains("being made")) << files.said().toStdString();
  EXPECT_FALSE(files.make()->isEnabled());
  EXPECT_FALSE(desk.find<QWidget>("files_title")->isEnabled()) << "what is being made is what was entered";
  desk.click(stop());
  EXPECT_EQ(files.said(), "Stopping …") << "the worker is still at it";
  expect_stopped();
  EXPECT_EQ(files.listed().size(), 2);
  EXPECT_EQ(desk.find<QLineEdit>("files_out")->text().toStdString(), (folder.path / "made").string());
  EXPECT_EQ(desk.find<QLineEdit>("files_title")->text(), "Monday");
  EXPECT_TRUE(desk.find<QWidget>("files_title")->isEnabled());
  EXPECT_FALSE(stop()->isVisible());
  ASSERT_TRUE(files.press_make());
  EXPECT_TRUE(files.said().startsWith("Made: ")) << files.said().toStdString();
  EXPECT_TRUE(std::filesystem::exists(folder.path / "made/session.xml"));
}

TEST_F(StoppedWizard, EscapeStopsWhatIsBeingMadeAndAgainTheWizard) {
  ASSERT_TRUE(begin_making());
  QTest::keyClick(files.dialog()->windowHandle(), Qt::Key_Escape);
  ASSERT_TRUE(files.dialog() && files.dialog()->isVisible()) << "only the making is stopped";
  QTest::keyClick(files.dialog()->windowHandle(), Qt::Key_Escape);
  ASSERT_TRUE(files.dialog() && files.dialog()->isVisible()) << "it is being stopped";
  expect_stopped();
  QTest::keyClick(files.dialog()->windowHandle(), Qt::Key_Escape);
  EXPECT_TRUE(desk.wait([this] { return !files.dialog(); }));
}

TEST_F(StoppedWizard, WhoClosesItWaitsForNothingAndNothingIsMade) {
  for (const bool by_button : {true, false}) {
    ASSERT_TRUE(begin_making());
    if (by_button)
      desk.press_button("files_cancel");
    else
      QCoreApplication::postEvent(files.dialog(), new QCloseEvent);  // as the frame's button does
    EXPECT_TRUE(desk.wait([this] { return !files.dialog(); })) << by_button;
    jobs().hold(false);
    ASSERT_TRUE(desk.wait([this] { return !jobs().is_busy(); }));
    EXPECT_FALSE(std::filesystem::exists(folder.path / "made")) << by_button;
  }
}

TEST_F(StoppedWizard, WhatHasNotBegunIsStoppedAtOnce) {
  jobs().hold(true);
  jobs().start<int>(
      "other", "Something long", [](app::JobControl&) { return 0; }, [](int) {});
  ASSERT_TRUE(begin_making());
  desk.click(stop());
  EXPECT_EQ(files.said(), "Stopped; nothing was made.");
  EXPECT_TRUE(files.make()->isEnabled());
}

TEST_F(StoppedWizard, WhoStopsTooLateIsToldSo) {
  ASSERT_TRUE(begin_making());
  jobs().hold(false);
  for (int i = 0; i < 3000 && !std::filesystem::exists(folder.path / "made/session.xml"); ++i) QThread::msleep(10);
  stop()->click();  // before the window has heard that it is done
  ASSERT_TRUE(desk.wait([this] { return files.said() != "Stopping …"; }));
  EXPECT_TRUE(files.said().startsWith("It was made before it could be stopped: 3 observations"))
      << files.said().toStdString();
  desk.click(files.make());
  EXPECT_TRUE(desk.document().is_open());
}

}  // namespace
}  // namespace handsight::test
