// SPDX-License-Identifier: Apache-2.0
// The wizard's three questions, and sessions of one camera and a board from images to the exported calibration.
#include <gtest/gtest.h>

#include <QFileDialog>

#include "app/window/wizard_page.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

/// One camera on a stand and a ChArUco board in the hand: nothing is labelled, and it comes out calibrated.
TEST_F(BoardWizard, FromImagesOfABoardToTheExportedCalibration) {
  simulate_like("one_camera_board");
  ASSERT_TRUE(wizard.open());
  wizard.answer("camera_place", 0);
  wizard.answer("target_place", 0);
  wizard.answer("known", 2);
  describe_board();
  EXPECT_FALSE(wizard.make()->isEnabled());
  fill_in();
  EXPECT_EQ(wizard.link("wizard_mount"), "stand");
  auto* tcp = desk.find<QComboBox>("wizard_tcp");
  tcp->setCurrentText("hand");
  EXPECT_EQ(wizard.said("wizard_left_sentence"), "14 images.");
  EXPECT_TRUE(wizard.said("wizard_calibration_sentence").startsWith("One camera of 880 px"));
  EXPECT_TRUE(wizard.said("wizard_links").startsWith("Camera on stand, target on hand: 6 moving joints"))
      << wizard.said("wizard_links").toStdString();
  const auto calibration = made_played_and_exported();
  ASSERT_TRUE(calibration);
  const Session& made = desk.document().session();
  ASSERT_TRUE(made.target && made.rig);
  EXPECT_EQ(made.rig->count(), 1);
  EXPECT_EQ(made.rig->at(0).camera.width, 1024) << "from the images";
  EXPECT_EQ(made.observations.size(), 14U);
  EXPECT_LT(compute_error(*calibration), 1e-3) << "where the board is on the hand is the simulation's truth";
}

/// The camera on the hand over a board on the table: where the board lies comes out, and where the camera sits.
TEST_F(BoardWizard, ACameraOnTheHandOverABoardOnTheTable) {
  simulate_like("camera_on_hand");
  ASSERT_TRUE(wizard.open());
  wizard.answer("camera_place", 2);
  EXPECT_TRUE(desk.find<QAbstractButton>("target_place_1")->isChecked());
  wizard.answer("known", 2);
  describe_board();
  fill_in();
  desk.find<QComboBox>("wizard_mount")->setCurrentText("hand");
  EXPECT_EQ(wizard.link("wizard_tcp"), "stand");
  EXPECT_TRUE(wizard.said("wizard_links").startsWith("Camera on hand, target on stand: 6 moving joints"))
      << wizard.said("wizard_links").toStdString();
  const auto calibration = made_played_and_exported();
  ASSERT_TRUE(calibration);
  const Session& made = desk.document().session();
  EXPECT_EQ(made.mount.link, "hand");
  EXPECT_EQ(made.tcp, "stand");
  EXPECT_LT(compute_error(*calibration), 1e-3);
  const Rigid& mount = estimate(*desk.document().model()->fit).mount_from_sensor;
  EXPECT_LT((mount.translation - simulated.mount.mount_from_sensor.translation).norm(), 1e-3) << "it was not told";
}

TEST_F(BoardWizard, AnswersChooseTheLinksAndNeverLeaveNothingToMove) {
  ASSERT_TRUE(wizard.open());
  wizard.fill("wizard_robot", urdf);
  wizard.answer("camera_place", 2);
  EXPECT_TRUE(desk.find<QAbstractButton>("target_place_1")->isChecked()) << "on the table, with the camera on the hand";
  EXPECT_EQ(wizard.link("wizard_tcp"), "stand");
  EXPECT_FALSE(desk.find<QComboBox>("wizard_tcp")->isEnabled());
  EXPECT_NE(wizard.link("wizard_mount"), "stand");
  wizard.answer("target_place", 0);
  EXPECT_TRUE(desk.find<QAbstractButton>("camera_place_1")->isChecked());
  EXPECT_NE(wizard.link("wizard_tcp"), "stand");
  desk.find<QComboBox>("wizard_mount")->setCurrentText(wizard.link("wizard_tcp"));
  EXPECT_TRUE(wizard.said("wizard_refusal").startsWith("No joint moves between camera and target"));
  EXPECT_TRUE(wizard.said("wizard_links").contains("0 moving joints"));
  wizard.answer("camera_place", 0);
  EXPECT_EQ(wizard.link("wizard_mount"), "stand");
  EXPECT_EQ(wizard.said("wizard_refusal"), "");
  // Both are in sight in 3D.
  auto* scene = desk.find<widgets::RobotView>("wizard_scene");
  EXPECT_TRUE(scene->isVisible());
  ASSERT_TRUE(scene->to_screen(Vector3(0, 0, 0)));
}

/// What is asked for follows what is known: only that, and all of it.
TEST_F(BoardWizard, WhatIsAskedForFollowsWhatIsKnown) {
  ASSERT_TRUE(wizard.open());
  const auto is_asked = [&](const char* name) { return desk.find<QWidget>(name)->isVisibleTo(wizard.dialog()); };
  const char* fields[] = {"wizard_left",    "wizard_right",  "wizard_more",       "wizard_calibration", "wizard_poses",
                          "wizard_markers", "target_square", "target_tag",        "target_spacing",     "target_ids",
                          "target_columns", "target_sheet",  "target_dictionary", "target_layout"};
  const std::pair<int, std::set<std::string>> wanted[] = {
      {0, {"wizard_left", "wizard_right", "wizard_calibration", "wizard_markers"}},
      {1,
       {"wizard_left", "wizard_right", "wizard_more", "wizard_calibration", "target_square", "target_columns",
        "target_sheet"}},
      {3,
       {"wizard_left", "wizard_right", "wizard_more", "wizard_calibration", "target_tag", "target_spacing",
        "target_columns", "target_sheet", "target_dictionary"}},
      {4,
       {"wizard_left", "wizard_right", "wizard_more", "wizard_calibration", "target_tag", "target_ids", "target_sheet",
        "target_dictionary"}},
      {5, {"wizard_left", "wizard_right", "wizard_more", "wizard_calibration", "target_sheet"}},
      {6, {"wizard_poses"}},
      {7,
       {"wizard_left", "wizard_right", "wizard_more", "wizard_calibration", "target_square", "target_tag",
        "target_columns", "target_sheet", "target_layout"}}};
  for (const auto& [option, asked] : wanted) {
    wizard.answer("known", option);
    for (const char* field : fields)
      EXPECT_EQ(is_asked(field), asked.contains(field)) << "option " << option << ": " << field;
  }
  EXPECT_EQ(wizard.said("target_said"), "asymmetric grid of 4 x 11 circles of 15 mm, unit 20 mm.");
  desk.find<QComboBox>("target_layout")->setCurrentIndex(0);
  EXPECT_TRUE(wizard.said("target_said").contains("an asymmetric grid of an odd number of rows"));
}

TEST_F(BoardWizard, ABoardIsSavedToBePrinted) {
  ASSERT_TRUE(wizard.open());
  wizard.answer("known", 5);
  auto* sheet = desk.find<QAbstractButton>("target_sheet");
  wizard.show(sheet);
  desk.click(sheet);
  auto* dialog = desk.window.findChild<QFileDialog*>("sheet_dialog");
  ASSERT_NE(dialog, nullptr);
  emit dialog->fileSelected(QString::fromStdString((folder.path / "board.pdf").string()));
  dialog->reject();
  ASSERT_TRUE(std::filesystem::exists(folder.path / "board.pdf"));
  EXPECT_TRUE(read_file(folder.path / "board.pdf").starts_with("%PDF"));
  EXPECT_TRUE(wizard.said("target_said").contains("A4"));
}

/// A table of poses in place of images: a session that is fitted as soon as it is made.
TEST_F(BoardWizard, PosesOfAnotherProgramMakeASession) {
  simulate_like("one_camera_board");
  const Rigid tcp_from_body = true_tcp_from_body(folder.path / "simulated");
  std::vector<Rigid> targets;
  for (const Observation& o : simulated.observations)
    targets.push_back(inverse(simulated.mount.mount_from_sensor) * root_from_link(simulated, o, "hand") *
                      tcp_from_body);
  replace_file(folder.path / "poses.csv", pose_table(targets));
  ASSERT_TRUE(wizard.open());
  wizard.answer("camera_place", 0);
  wizard.answer("known", 6);
  wizard.fill("wizard_robot", urdf);
  desk.find<QComboBox>("wizard_tcp")->setCurrentText("hand");
  wizard.fill("wizard_angles", folder.path / "angles.csv");
  wizard.fill("wizard_poses", folder.path / "poses.csv");
  EXPECT_EQ(wizard.said("wizard_poses_sentence"), "14 poses of the target.");
  wizard.fill("wizard_target", folder.path / "made");
  ASSERT_TRUE(wizard.make()->isEnabled()) << wizard.said("wizard_refusal").toStdString();
  desk.click(wizard.make());
  ASSERT_TRUE(desk.document().is_open());
  EXPECT_TRUE(desk.document().session().pose_sensor);
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  EXPECT_FALSE(desk.find<QWidget>("label")->isVisible());
}

}  // namespace
}  // namespace handsight::test
