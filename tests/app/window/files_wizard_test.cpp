// SPDX-License-Identifier: Apache-2.0
// New sessions from what other programs write: bags, Kalibr's camchain, camera_info, samples of easy_handeye.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>

#include "app/window/files_page.h"
#include "app/window/wizard_page.h"
#include "convert/bag_fixture.h"
#include "estimation/fit/fit.h"
#include "widgets/base/picture_choice.h"

namespace handsight::test {
namespace {

class FilesWizardTest : public BoardWizard {
 protected:
  /// What a detector and the robot's driver publish while the robot goes from pose to pose and stands a second in each.
  void write_bag(const std::filesystem::path& bag_folder, const std::vector<std::string>& tags = {"tag_7"}) {
    const Rigid hand_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
    fixture::BagWriter bag(bag_folder);
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
              tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage");
    const auto& all = simulated.observations;
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      for (double t = 0; t < 2; t += 0.02) {
        Observation now = all[k];
        now.position += std::min(1.0, t) * (all[k + 1].position - all[k].position);
        const double stamp = 1.7e9 + 2.0 * static_cast<double>(k) + t;
        std::vector<double> position(now.position.data(), now.position.data() + now.position.size());
        bag.message(joints, stamp, fixture::joint_state(stamp, simulated.joints, position));
        for (std::size_t tag = 0; tag < tags.size(); ++tag) {
          const Rigid beside{Matrix3::Identity(), {0.06 * static_cast<double>(tag), 0, 0}};
          bag.message(tf, stamp,
                      fixture::transform(stamp, "camera", tags[tag],
                                         root_from_link(simulated, now, "hand") * hand_from_target * beside));
        }
      }
  }
  FilesPage files{desk};
};

TEST_F(FilesWizardTest, ABagThatIsDroppedBecomesASessionAndSaysWhatItTook) {
  simulate_like("one_camera_board");
  write_bag(folder.path / "morning");
  ASSERT_TRUE(files.drop({folder.path / "morning"}, &desk.window));
  ASSERT_NE(files.dialog(), nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  EXPECT_EQ(files.listed(), QStringList{"morning: a bag of ROS"});
  EXPECT_TRUE(files.said().contains("add the robot's URDF")) << files.said().toStdString();
  EXPECT_FALSE(files.make()->isEnabled());
  ASSERT_TRUE(files.drop({urdf}, files.dialog()));
  EXPECT_EQ(files.said(), "");
  desk.find<QComboBox>("files_tcp")->setCurrentText("hand");
  EXPECT_EQ(desk.find<QComboBox>("files_mount")->currentIndex(), 0) << "the root: the sensor stands";
  EXPECT_FALSE(desk.find<QWidget>("files_degrees")->isVisible()) << "of a bag nobody asks for degrees";
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.make()->isEnabled()) << files.said().toStdString();
  ASSERT_TRUE(files.press_make());
  EXPECT_TRUE(files.said().startsWith("Made: ")) << files.said().toStdString();
  const QString report = desk.find<QPlainTextEdit>("files_report")->toPlainText();
  EXPECT_TRUE(report.contains("tag_7"));
  EXPECT_FALSE(report.contains("touch") || report.contains("-angle")) << "nobody asked: " << report.toStdString();
  EXPECT_FALSE(desk.document().is_open()) << "first one reads what was understood";
  desk.click(files.make());
  ASSERT_TRUE(desk.document().is_open());
  ASSERT_TRUE(desk.settle());
  EXPECT_GE(desk.document().session().observations.size(), 12U);
  ASSERT_TRUE(desk.document().model() && desk.document().model()->fit);
  EXPECT_LT(desk.document().model()->fit->residual_rms, 1e-4);
}

TEST_F(FilesWizardTest, ABagWithTwoTargetsBecomesACollectionThatOpens) {
  simulate_like("one_camera_board");
  write_bag(folder.path / "morning", {"tag_7", "tag_8"});
  ASSERT_TRUE(files.drop({folder.path / "morning", urdf}, &desk.window));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  desk.find<QComboBox>("files_tcp")->setCurrentText("hand");
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.make()->isEnabled()) << files.said().toStdString();
  ASSERT_TRUE(files.press_make());
  EXPECT_TRUE(files.said().startsWith("Made: a collection of 2 sessions with ")) << files.said().toStdString();
  const QString report = desk.find<QPlainTextEdit>("files_report")->toPlainText();
  EXPECT_TRUE(report.contains("several targets in /tf (tag_7, tag_8)")) << report.toStdString();
  EXPECT_FALSE(report.contains("--")) << "the window has no options: " << report.toStdString();
  desk.click(files.make());
  ASSERT_TRUE(desk.settle());  // a collection is read beside the window
  ASSERT_TRUE(desk.document().is_open());
  ASSERT_EQ(desk.document().session().parts.size(), 2U);
  EXPECT_TRUE(desk.find<QWidget>("sessions")->isVisible());
  ASSERT_TRUE(desk.document().model() && desk.document().model()->fit);
  EXPECT_LT(desk.document().model()->fit->residual_rms, 1e-4);
}

TEST_F(FilesWizardTest, ATableOfTouchesAsksWhatItsFixturesAre) {
  const auto samples = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions";
  std::filesystem::copy(samples / "probe_and_plate/touches.csv", folder.path / "touches.csv");
  ASSERT_TRUE(files.drop({folder.path / "touches.csv", samples / "robots/six_axis.urdf"}, &desk.window));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  EXPECT_TRUE(files.listed().contains("touches.csv: a table of touches")) << files.listed().join('\n').toStdString();
  EXPECT_EQ(files.said(), "");
  desk.find<QComboBox>("files_tcp")->setCurrentText("hand");
  EXPECT_FALSE(desk.find<QWidget>("files_still")->isVisible());
  ASSERT_TRUE(desk.find<QWidget>("files_touches")->isVisible());
  // A plate is a plane by its name; that one is an edge is said by its picture, and taken back.
  const auto chosen = [&](const char* fixture) { return desk.find<widgets::PictureChoice>(fixture)->current(); };
  EXPECT_EQ(chosen("fixture_plate_high"), 0);
  EXPECT_EQ(chosen("fixture_socket_left"), 1);
  desk.press_button("fixture_plate_high_2");
  EXPECT_EQ(chosen("fixture_plate_high"), 2);
  desk.press_button("fixture_plate_high_0");
  files.fill("touch_apart", "socket_left socket_right by=0.2999814769 sigma=1e-5");
  desk.find<QDoubleSpinBox>("touch_sigma")->setValue(20);
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.press_make());
  ASSERT_TRUE(files.said().startsWith("Made: ")) << files.said().toStdString();
  desk.click(files.make());
  ASSERT_TRUE(desk.document().is_open());
  ASSERT_TRUE(desk.settle());
  const Session& s = desk.document().session();
  EXPECT_TRUE(s.is_touch());
  EXPECT_EQ(s.fixtures.size(), 5U);
  EXPECT_EQ(s.distances.size(), 1U);
  EXPECT_EQ(s.observations.size(), 100U);
  ASSERT_TRUE(s.fixtures.front().sigma);
  EXPECT_DOUBLE_EQ(*s.fixtures.front().sigma, 2e-5);
}

TEST_F(FilesWizardTest, SamplesOfEasyHandEyeNeedNothingElse) {
  simulate_like("one_camera_board");
  const auto pose = [](const Rigid& m) {
    const Eigen::Quaterniond q(m.rotation);
    return fmt::format("    translation: {{x: {}, y: {}, z: {}}}\n    rotation: {{x: {}, y: {}, z: {}, w: {}}}\n",
                       m.translation.x(), m.translation.y(), m.translation.z(), q.x(), q.y(), q.z(), q.w());
  };
  const Rigid hand_from_target{rotation_from_rpy({0.2, 0.1, 0.3}), {0.0, 0.03, 0.1}};
  const Rigid base_from_camera{rotation_from_rpy({-2.0, 0.0, 1.2}), {1.2, -0.3, 0.7}};
  std::string text = "parameters:\n  name: ''\n  calibration_type: 'eye_on_base'\nsamples:\n";
  for (const Observation& o : simulated.observations) {
    const Rigid hand = root_from_link(simulated, o, "hand");
    text += "- robot:\n" + pose(hand) + "  tracking:\n" + pose(inverse(base_from_camera) * hand * hand_from_target);
  }
  replace_file(folder.path / "robot.samples", text);
  ASSERT_TRUE(files.drop({folder.path / "robot.samples"}, &desk.window));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  EXPECT_EQ(files.listed(), QStringList{"robot.samples: samples of easy_handeye"});
  EXPECT_FALSE(desk.find<QWidget>("files_tcp")->isVisible());
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.press_make());
  desk.click(files.make());
  ASSERT_TRUE(desk.document().is_open()) << files.said().toStdString();
  EXPECT_TRUE(desk.document().session().robot.is_of_poses);
}

TEST_F(FilesWizardTest, ImagesWithACamchainOfKalibrAndAnglesInDegrees) {
  simulate_like("one_camera_board");
  const Camera& c = simulated.rig->at(0).camera;
  replace_file(
      folder.path / "camchain.yaml",
      fmt::format("cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n  distortion_coeffs: [{}, {}, {}, "
                  "{}]\n  intrinsics: [{}, {}, {}, {}]\n  resolution: [{}, {}]\n  rostopic: /camera\n",
                  c.k1, c.k2, c.p1, c.p2, c.fx, c.fy, c.cx, c.cy, c.width, c.height));
  Session in_degrees = simulated;
  for (Observation& o : in_degrees.observations) o.position *= 57.29577951308232;
  replace_file(folder.path / "angles.csv", joint_table(in_degrees));
  desk.press_button("start_new");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard.dialog()));
  desk.press_button("wizard_bring");
  ASSERT_NE(files.dialog(), nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  EXPECT_EQ(files.said(), "Nothing is there yet.");
  files.drop({urdf, folder.path / "angles.csv", folder.path / "photos"}, files.dialog());
  EXPECT_TRUE(files.said().contains("calibration is missing")) << files.said().toStdString();
  files.drop({folder.path / "camchain.yaml"}, files.dialog());
  EXPECT_EQ(files.listed().last(), "camchain.yaml: a camchain of Kalibr");
  desk.find<QComboBox>("files_shown")->setCurrentIndex(2);
  QTest::qWait(20);
  const auto set = [&](const char* name, const QString& to) {
    auto* box = desk.find<QAbstractSpinBox>(name);
    desk.find<QScrollArea>("files_scroll")->ensureWidgetVisible(box);
    QTest::qWait(10);
    desk.type_into(box, to);
    QTest::keyClick(box->window()->windowHandle(), Qt::Key_Tab);
  };
  set("target_columns", "7");
  set("target_rows", "5");
  set("target_square", "35");
  set("target_tag", "26");
  desk.find<QComboBox>("target_dictionary")->setCurrentText("DICT_4X4_50");
  auto* degrees = desk.find<QAbstractButton>("files_degrees");
  desk.click(degrees, QPoint(8, degrees->height() / 2));
  desk.find<QComboBox>("files_tcp")->setCurrentText("hand");
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.make()->isEnabled()) << files.said().toStdString();
  ASSERT_TRUE(files.press_make());
  ASSERT_TRUE(files.said().startsWith("Made: 14 observations")) << files.said().toStdString();
  desk.click(files.make());
  ASSERT_TRUE(desk.document().is_open());
  const Session& made = desk.document().session();
  EXPECT_TRUE((made.observations[3].position - simulated.observations[3].position).isZero(1e-9));
  EXPECT_DOUBLE_EQ(made.rig->at(0).camera.fx, c.fx);
}

TEST_F(FilesWizardTest, WhatIsNothingIsSaidAndWhatCannotBeMadeLeavesTheWizardOpen) {
  replace_file(folder.path / "letter.txt", "Dear all,\nthe robot is off.\n");
  ASSERT_TRUE(files.drop({folder.path / "letter.txt"}, &desk.window));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  ASSERT_EQ(files.listed().size(), 1);
  EXPECT_TRUE(files.listed().first().startsWith("✗ letter.txt: ")) << files.listed().first().toStdString();
  EXPECT_FALSE(files.make()->isEnabled());
  desk.find<QListWidget>("files_list")->setCurrentRow(0);
  desk.press_button("files_remove");
  EXPECT_TRUE(files.listed().isEmpty());
  const Rigid somewhere{Matrix3::Identity(), {0.3, 0, 0.5}};  // poses of nothing but zeros are none
  replace_file(folder.path / "flange.csv", pose_table({somewhere, somewhere, somewhere}));
  replace_file(folder.path / "target.csv", pose_table({somewhere, somewhere}));
  files.drop({folder.path / "flange.csv", folder.path / "target.csv"}, files.dialog());
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.make()->isEnabled()) << files.said().toStdString();
  ASSERT_TRUE(files.press_make());
  EXPECT_TRUE(files.said().contains("3 poses of the flange and 2 of the target")) << files.said().toStdString();
  EXPECT_TRUE(files.make()->isEnabled());
  EXPECT_TRUE(files.dialog()->isVisible());
  EXPECT_FALSE(desk.document().is_open());
}

TEST_F(FilesWizardTest, RefusalsSpeakOfTheQuestionsAndOfNoOption) {
  simulate_like("one_camera_board");
  const Camera& c = simulated.rig->at(0).camera;
  replace_file(folder.path / "camchain.yaml",
               fmt::format("cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n  distortion_coeffs: [0, 0, 0, "
                           "0]\n  intrinsics: [{}, {}, {}, {}]\n  resolution: [{}, {}]\n  rostopic: /camera\n",
                           c.fx, c.fy, c.cx, c.cy, c.width, c.height));
  replace_file(folder.path / "angles.csv", joint_table(simulated));
  ASSERT_TRUE(files.drop({urdf, folder.path / "angles.csv", folder.path / "photos", folder.path / "camchain.yaml"},
                         &desk.window));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(files.dialog()));
  files.fill("files_out", folder.path / "made");
  ASSERT_TRUE(files.make()->isEnabled()) << files.said().toStdString();
  ASSERT_TRUE(files.press_make());
  EXPECT_TRUE(files.said().contains("say what with “What the images show”")) << files.said().toStdString();
  EXPECT_FALSE(files.said().contains("--")) << files.said().toStdString();
}

TEST_F(FilesWizardTest, ASessionThatIsDroppedIsOpened) {
  const auto session = copy_of_sample(folder.path, "hidden_1");
  ASSERT_TRUE(files.drop({session}, &desk.window));
  EXPECT_EQ(files.dialog(), nullptr);
  EXPECT_TRUE(desk.document().is_open());
}

TEST_F(FilesWizardTest, TheWizardOfImagesReadsCalibrationsOfRosAndKalibrToo) {
  ASSERT_TRUE(wizard.open());
  replace_file(
      folder.path / "camera.yaml",
      "image_width: 640\nimage_height: 480\ncamera_name: head\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [600, "
      "0, 320, 0, 601, 240, 0, 0, 1]\ndistortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: "
      "5\n  data: [0.1, 0, 0, 0, 0]\nrectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, "
      "0, 1]\nprojection_matrix:\n  rows: 3\n  cols: 4\n  data: [600, 0, 320, 0, 0, 601, 240, 0, 0, 0, 1, 0]\n");
  wizard.answer("known", 2);
  wizard.fill("wizard_calibration", folder.path / "camera.yaml");
  EXPECT_EQ(wizard.said("wizard_calibration_sentence"), "One camera of 600 px focal length.");
  wizard.dialog()->reject();
}

}  // namespace
}  // namespace handsight::test
