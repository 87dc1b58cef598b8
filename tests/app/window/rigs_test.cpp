// SPDX-License-Identifier: Apache-2.0
// Sessions of one camera, and of three: nothing empty where there is no second image, and a choice where there is one.
#include <gtest/gtest.h>

#include <QToolButton>

#include "app/window/explain_fixture.h"
#include "app/window/rig_sessions.h"
#include "base/files.h"
#include "base/xml.h"
#include "inspect/inspect_workspace.h"
#include "robot/xml_rigid.h"
#include "widgets/scene/robot_view.h"
#include "workbench/camera_strip.h"

namespace handsight::test {
namespace {

class Rigs : public testing::Test {
 protected:
  void open(const std::string& name, int cameras) {
    session = sample_with_cameras(folder.path, name, cameras);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
  }
  void go(int workspace) {
    desk.key(Qt::Key_0 + workspace, Qt::ControlModifier);
    desk.settle();
  }
  widgets::ImageView* view(const char* name) { return desk.find<widgets::ImageView>(name); }

  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
};

TEST_F(Rigs, OneCameraIsCalibratedInspectedAndExportedWithoutASecondImage) {
  open("hidden_3", 1);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  const char* pairs[][2] = {
      {"label_left", "label_right"}, {"calibrate_left", "calibrate_right"}, {"inspect_left", "inspect_right"}};
  desk.window.workbench().selection.select_observation(7);
  for (int workspace = 1; workspace <= 3; ++workspace) {
    go(workspace);
    EXPECT_TRUE(view(pairs[workspace - 1][0])->isVisible()) << workspace;
    EXPECT_FALSE(view(pairs[workspace - 1][1])->isVisible()) << workspace;
  }
  EXPECT_FALSE(view("inspect_left")->marks().empty());
  for (const auto* strip : desk.window.findChildren<app::CameraStrip*>()) EXPECT_FALSE(strip->isVisible());
  EXPECT_FALSE(desk.find<QWidget>("map_camera")->isVisible());
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::missing);
  go(5);
  desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString((folder.path / "out.xml").string()));
  desk.press_button("report_html");
  ASSERT_TRUE(desk.wait([&] { return std::filesystem::exists(folder.path / "out.html"); }));
}

TEST_F(Rigs, TheLabelsOfOneCameraAreShownAndCannotBeSpoilt) {
  open("first_steps", 1);
  go(1);
  desk.window.workbench().selection.select_observation(desk.document().session().observations[0].id);
  QTest::qWait(50);
  LabelPage label{desk};
  EXPECT_FALSE(label.left()->image().isNull());
  EXPECT_TRUE(label.triangle().sentence.startsWith("Markers are clicked in sessions of two cameras"))
      << label.triangle().sentence.toStdString();
  EXPECT_FALSE(label.triangle().can_use);
  label.click_left(Vector2(200, 200));
  EXPECT_EQ(desk.document().undo_stack().index(), 0);
}

TEST_F(Rigs, OfThreeCamerasTwoAreShownAndTheThirdIsAClickAway) {
  open("hidden_3", 3);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  desk.window.workbench().selection.select_observation(7);
  go(3);
  auto* strip = desk.find<app::InspectWorkspace>("inspect")->findChild<app::CameraStrip*>();
  ASSERT_NE(strip, nullptr);
  ASSERT_TRUE(strip->isVisible());
  EXPECT_EQ(strip->look_up_camera(view("inspect_left")), 0);
  EXPECT_EQ(strip->look_up_camera(view("inspect_right")), 1);
  auto* third = strip->findChild<QToolButton*>("camera_2");
  ASSERT_NE(third, nullptr);
  EXPECT_EQ(third->text(), "side_2");
  desk.click(third);
  EXPECT_EQ(strip->look_up_camera(view("inspect_right")), 2);
  EXPECT_TRUE(third->isChecked());
  EXPECT_FALSE(strip->findChild<QToolButton*>("camera_1")->isChecked());
  for (const widgets::ImageMark& mark : view("inspect_right")->marks())
    EXPECT_EQ(mark.role, widgets::MarkRole::predicted) << "the third camera has seen nothing";
  EXPECT_FALSE(view("inspect_right")->marks().empty());
  desk.click(strip->findChild<QToolButton*>("camera_1"));
  EXPECT_EQ(strip->look_up_camera(view("inspect_left")), 1) << "in place of the one that was chosen longest ago";
}

/// A board names its points itself: nothing is clicked, play and it is calibrated.
TEST_F(Rigs, ASessionWithABoardIsPlayedWithoutALabel) {
  const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/justin_head";
  session = folder.path / "board";
  const CliResult made =
      run_cli(folder.path, {"simulate", "--like", like, "--out", session.string(), "--observations", "12", "--images",
                            "all", "--seed", "5", "--target", "charuco", "columns=6", "rows=5", "square=0.02",
                            "marker=0.015", "dictionary=DICT_5X5_100"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  for (const Observation& o : desk.document().session().observations) ASSERT_TRUE(o.sightings.empty());
  go(2);
  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  // Where the hand turns the board away there is nothing to be found; every other observation is taken, as `online`
  // does.
  const CliResult online = run_cli(folder.path, {"online", session.string(), "--json", "-"});
  int taken = 0;
  for (std::size_t at = online.output.find("\"accepted\""); at != std::string::npos;
       at = online.output.find("\"accepted\"", at + 1))
    ++taken;
  EXPECT_GE(taken, 5);
  EXPECT_EQ(desk.document().model()->report->used, taken);
  for (const Observation& o : desk.document().session().observations)
    EXPECT_TRUE(o.decision == Decision::accepted || o.reason.find("none of its tags was found") != std::string::npos)
        << o.id << ": " << o.reason;
}

/// The sample of one camera: from the start page to the fit without a click on an image, the camera's place unknown.
TEST_F(Rigs, TheSampleOfOneCameraIsPlayedFromTheStartPage) {
  desk.press_button("sample_one_camera");
  ASSERT_TRUE(desk.document().is_open());
  ASSERT_TRUE(desk.settle());
  EXPECT_FALSE(desk.find<QWidget>("label")->isVisible()) << "there is nothing to label";
  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  EXPECT_EQ(desk.document().model()->report->used, 12);
  const std::string text =
      read_file(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/one_camera/truth.xml");
  const auto truth = parse_xml(text, "truth.xml");
  const Rigid tcp_from_body =
      read_rigid(required_child(require_root(*truth, "truth.xml", "handsight_truth"), "tcp_from_body"));
  EXPECT_LT((desk.document().model()->fit->tcp_from_body.translation - tcp_from_body.translation).norm(), 1e-4);
}

}  // namespace
}  // namespace handsight::test
