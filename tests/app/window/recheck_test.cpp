// SPDX-License-Identifier: Apache-2.0
// Rechecks in the window: the history of a log, and one more recheck with the driver.
#include <gtest/gtest.h>

#include "app/window/measure_page.h"
#include "experiment/paths/collision_world.h"
#include "experiment/recheck/recheck_log.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"
#include "widgets/plots/history_plot.h"
#include "window/language.h"

namespace handsight::test {
namespace {

class RecheckInWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    // A robot that was calibrated, and an empty session of later looks at it.
    const auto calibrated = fixture::written_session(fixture::tracker_session(), folder.path, 40, 5, "calibrated");
    const auto made = run_cli(folder.path, {"fit", calibrated.string(), "--export", calibration().string()});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    session = calibrated;
    desk.window.resize(1366, 728);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    page.open();
    page.show_tab(1);
  }
  std::filesystem::path calibration() const { return folder.path / "calibration.xml"; }
  void recheck(const std::string& options = "") {
    auto* field = desk.find<QLineEdit>("recheck_calibration");
    field->setText(QString::fromStdString(calibration().string()));
    page.type_simulated(options);
    ASSERT_TRUE(page.connect()) << page.said().toStdString();
    page.workspace()->run().start({}, 8);
    ASSERT_TRUE(page.ends()) << page.said().toStdString();
  }
  std::vector<RecheckEntry> log() const { return read_recheck_log(session / "recheck.csv"); }
  QString reported() { return desk.find<QLabel>("recheck_said")->text(); }
  std::size_t points(const char* plot) { return desk.find<widgets::HistoryPlot>(plot)->points().size(); }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  MeasurePage page{desk};
};

TEST_F(RecheckInWindow, WithoutACalibrationItSaysWhatIsNeeded) {
  page.type_simulated();
  desk.press_button("experiment_begin");
  EXPECT_TRUE(page.said().contains("calibration")) << page.said().toStdString();
  EXPECT_EQ(page.state(), app::RunState::resting);
}

TEST_F(RecheckInWindow, FivePosesAreLookedAtAndNothingHasChanged) {
  recheck();
  ASSERT_EQ(log().size(), 5U);
  EXPECT_FALSE(log().back().changed);
  ASSERT_TRUE(desk.wait([this] { return points("recheck_e_values") == 5; }, 5000));
  EXPECT_EQ(reported(), "Nothing speaks for a change.");
  EXPECT_EQ(points("recheck_history"), 5U);
  EXPECT_GE(desk.find<QComboBox>("recheck_number")->count(), 6) << "mount, hand and joints";
  EXPECT_EQ(desk.find<widgets::HistoryPlot>("recheck_e_values")->limit(), 1000);
  EXPECT_EQ(desk.find<widgets::HistoryPlot>("recheck_history")->title(), "") << "the choice above it says what it is";
}

TEST_F(RecheckInWindow, AHandThatHasSlippedIsNamed) {
  recheck("--change body_slip:x=0.004");
  ASSERT_TRUE(desk.wait([this] { return points("recheck_e_values") == 5; }, 5000));
  EXPECT_TRUE(log().back().changed);
  EXPECT_EQ(log().back().what, "body_slip");
  EXPECT_TRUE(reported().contains("Something has changed")) << reported().toStdString();
}

TEST_F(RecheckInWindow, WhatHasChangedIsSaidInTheReadersLanguage) {
  app::Translation german("de");
  QCoreApplication::installTranslator(&german);
  const Message text = message("The marker body slipped on the hand by {} and turned by {}", message("{} mm", 3.0),
                               message("{} degrees", 0.5));
  add_to_log(
      session / "recheck.csv",
      {.utc = "2026-11-26T05:09:00Z", .id = 1, .e_value = 1e200, .changed = true, .what = "body_slip", .text = text});
  page.show_tab(0);
  page.show_tab(1);
  EXPECT_TRUE(desk.wait([this] { return reported().contains("verrutscht"); }, 5000)) << reported().toStdString();
  EXPECT_FALSE(reported().contains("slipped"));
  const QString more = desk.find<QLabel>("recheck_more")->text();
  EXPECT_TRUE(more.contains(QString::fromUtf8("10¹⁵"))) << "as far as the plot goes: " << more.toStdString();
  QCoreApplication::removeTranslator(&german);
}

TEST_F(RecheckInWindow, AFileThatIsNoLogIsSaid) {
  replace_file(session / "recheck.csv", "a,b\n1,2\n");
  page.show_tab(0);
  page.show_tab(1);
  ASSERT_TRUE(desk.wait([this] { return reported().contains("no log of recheck"); }, 5000)) << reported().toStdString();
}

}  // namespace
}  // namespace handsight::test
