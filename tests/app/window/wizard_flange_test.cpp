// SPDX-License-Identifier: Apache-2.0
// Robots of which only the flange's pose is known, by the wizard: beside images of a board, and beside poses.
#include <gtest/gtest.h>

#include "app/window/wizard_page.h"

namespace handsight::test {
namespace {

class FlangeWizard : public BoardWizard {
 protected:
  std::vector<Rigid> flange_poses() {
    std::vector<Rigid> poses;
    for (const Observation& o : simulated.observations) poses.push_back(root_from_link(simulated, o, "hand"));
    return poses;
  }
  void tick_flange_only() {
    auto* box = desk.find<QAbstractButton>("wizard_flange_only");
    wizard.show(box);
    desk.click(box, QPoint(8, box->height() / 2));
    EXPECT_TRUE(box->isChecked());
  }
  bool can_answer(const char* tile) { return desk.find<QAbstractButton>(tile)->isEnabled(); }
};

TEST_F(FlangeWizard, ImagesOfABoardBesidePosesOfTheFlange) {
  simulate_like("camera_on_hand");
  replace_file(folder.path / "flange.csv", pose_table(flange_poses()));
  ASSERT_TRUE(wizard.open());
  wizard.answer("camera_place", 2);
  wizard.answer("known", 2);
  describe_board();
  tick_flange_only();
  EXPECT_FALSE(can_answer("camera_place_1")) << "there is no other link";
  EXPECT_FALSE(desk.find<QWidget>("wizard_robot")->isVisibleTo(wizard.dialog())) << "no URDF is asked for";
  wizard.fill("wizard_angles", folder.path / "flange.csv");
  EXPECT_EQ(wizard.said("wizard_angles_sentence"), "14 poses of the flange.");
  wizard.fill("wizard_left", folder.path / "photos");
  wizard.fill("wizard_calibration", folder.path / "camera.yml");
  wizard.fill("wizard_target", folder.path / "made");
  EXPECT_EQ(wizard.link("wizard_mount"), "flange");
  EXPECT_EQ(wizard.link("wizard_tcp"), "base");
  EXPECT_TRUE(wizard.said("wizard_links").startsWith("Camera on flange, target on base: the flange moves"))
      << wizard.said("wizard_links").toStdString();
  const auto calibration = made_played_and_exported();
  ASSERT_TRUE(calibration);
  EXPECT_TRUE(desk.document().session().robot.is_of_poses);
  EXPECT_LT(compute_error(*calibration), 1e-3);
}

/// The classical hand-eye problem: two tables of poses, no robot, no image.
TEST_F(FlangeWizard, PosesOfATargetBesidePosesOfTheFlange) {
  simulate_like("one_camera_board");
  const Rigid tcp_from_body = true_tcp_from_body(folder.path / "simulated");
  std::vector<Rigid> targets;
  for (const Rigid& flange : flange_poses())
    targets.push_back(inverse(simulated.mount.mount_from_sensor) * flange * tcp_from_body);
  replace_file(folder.path / "flange.csv", pose_table(flange_poses()));
  replace_file(folder.path / "target.csv", pose_table(targets));
  ASSERT_TRUE(wizard.open());
  wizard.answer("known", 6);
  tick_flange_only();
  EXPECT_TRUE(desk.find<QAbstractButton>("camera_place_0")->isChecked()) << "on a stand: what was chosen cannot be";
  wizard.fill("wizard_angles", folder.path / "flange.csv");
  wizard.fill("wizard_poses", folder.path / "target.csv");
  EXPECT_EQ(wizard.said("wizard_poses_sentence"), "14 poses of the target.");
  wizard.fill("wizard_target", folder.path / "made");
  ASSERT_TRUE(wizard.make()->isEnabled()) << wizard.said("wizard_refusal").toStdString();
  desk.click(wizard.make());
  ASSERT_TRUE(desk.document().is_open());
  const Session& made = desk.document().session();
  EXPECT_TRUE(made.robot.is_of_poses && made.pose_sensor);
  EXPECT_EQ(made.tcp, "flange");
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  EXPECT_LT((desk.document().model()->fit->tcp_from_body.translation - tcp_from_body.translation).norm(), 1e-6);
}

/// What does not fit is said, and the box can be taken back.
TEST_F(FlangeWizard, WhatDoesNotFitIsSaid) {
  simulate_like("one_camera_board");
  std::vector<Rigid> some = flange_poses();
  replace_file(folder.path / "target.csv", pose_table(some));
  some.pop_back();
  replace_file(folder.path / "flange.csv", pose_table(some));
  replace_file(folder.path / "no_poses.csv", "a,b\n1,2\n");
  ASSERT_TRUE(wizard.open());
  wizard.answer("known", 6);
  tick_flange_only();
  wizard.fill("wizard_angles", folder.path / "no_poses.csv");
  EXPECT_TRUE(wizard.said("wizard_angles_sentence").contains("no_poses.csv"));
  wizard.fill("wizard_angles", folder.path / "flange.csv");
  wizard.fill("wizard_poses", folder.path / "target.csv");
  wizard.fill("wizard_target", folder.path / "made");
  EXPECT_TRUE(wizard.said("wizard_refusal").startsWith("There are 13 poses of the flange for 14 poses"))
      << wizard.said("wizard_refusal").toStdString();
  EXPECT_FALSE(wizard.make()->isEnabled());
  auto* box = desk.find<QAbstractButton>("wizard_flange_only");
  wizard.show(box);
  desk.click(box, QPoint(8, box->height() / 2));
  EXPECT_TRUE(desk.find<QWidget>("wizard_robot")->isVisibleTo(wizard.dialog()));
  EXPECT_TRUE(can_answer("camera_place_1"));
}

}  // namespace
}  // namespace handsight::test
