// SPDX-License-Identifier: Apache-2.0
// The wizard's three questions, and a session of one camera and a board from images to the exported calibration.
#include <gtest/gtest.h>

#include <QDialog>
#include <QFileDialog>
#include <QScrollArea>
#include <opencv2/core.hpp>

#include "app/window/pages.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/xml.h"
#include "cli/cli_runner.h"
#include "robot/posture.h"
#include "robot/xml_rigid.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/robot_view.h"

namespace handsight::test {
namespace {

struct WizardPage {
  Desk& desk;
  QDialog* dialog() { return desk.window.findChild<QDialog*>("wizard"); }
  bool open() {
    desk.press_button("start_new");
    return dialog() && QTest::qWaitForWindowExposed(dialog());
  }
  void show(QWidget* widget) {
    desk.find<QScrollArea>("wizard_scroll")->ensureWidgetVisible(widget);
    QTest::qWait(10);
  }
  void answer(const char* question, int option) {
    auto* tile = desk.find<QAbstractButton>(QString("%1_%2").arg(question).arg(option).toLatin1());
    show(tile);
    desk.click(tile);
    EXPECT_TRUE(tile->isChecked()) << question << " " << option;
  }
  void fill(const char* name, const std::filesystem::path& with) {
    auto* field = desk.find<QLineEdit>(name);
    show(field);
    desk.type_into(field, QString::fromStdString(with.string()));
  }
  QString said(const char* name) { return desk.find<QLabel>(name)->text(); }
  QString link(const char* box) { return desk.find<QComboBox>(box)->currentText(); }
  QAbstractButton* make() { return desk.find<QAbstractButton>("wizard_make"); }
};

std::string joint_table(const Session& s) {
  std::string table;
  for (const std::string& joint : s.joints) table += (table.empty() ? "" : ",") + joint;
  table += '\n';
  for (const Observation& o : s.observations) {
    std::string line;
    for (const double q : o.position) line += (line.empty() ? "" : ",") + format_number(q);
    table += line + '\n';
  }
  return table;
}

void write_camera(const std::filesystem::path& file, const Camera& c) {
  cv::FileStorage storage(file.string(), cv::FileStorage::WRITE);
  storage << "camera_matrix" << cv::Mat((cv::Mat_<double>(3, 3) << c.fx, c.skew, c.cx, 0, c.fy, c.cy, 0, 0, 1))
          << "distortion_coefficients" << cv::Mat((cv::Mat_<double>(1, 5) << c.k1, c.k2, c.p1, c.p2, c.k3));
}

/// Where the target is on its link, by the simulation.
Rigid true_tcp_from_body(const std::filesystem::path& session) {
  const std::string text = read_file(session / "truth.xml");
  const auto document = parse_xml(text, "truth.xml");
  return read_rigid(required_child(root_of(*document, "truth.xml", "handsight_truth"), "tcp_from_body"));
}

Rigid root_from_link(const Session& s, const Observation& o, const char* link) {
  std::vector<int> joints;
  for (const std::string& name : s.joints) joints.push_back(find_joint(s.robot, name));
  const Posture posture = solve_posture(s.robot, joint_values(s.robot, joints, o.position), s.gravity);
  return posture.root_from_link[static_cast<std::size_t>(find_link(s.robot, link))];
}

class BoardWizard : public testing::Test {
 protected:
  /// Images, joint angles and calibration of a simulated session like a sample, as a user would have them.
  void simulate_like(const std::string& sample) {
    const auto like = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/rigs" / sample;
    const CliResult made =
        run_cli(folder.path, {"simulate", "--like", like.string(), "--out", (folder.path / "simulated").string(),
                              "--images", "all", "--observations", "14", "--seed", "3"});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    simulated = read_session(folder.path / "simulated");
    std::filesystem::create_directories(folder.path / "photos");
    for (const Observation& o : simulated.observations)
      std::filesystem::copy_file(folder.path / "simulated" / o.images[0],
                                 folder.path / "photos" / fmt::format("shot_{}.png", 100 + o.id));
    replace_file(folder.path / "angles.csv", joint_table(simulated));
    write_camera(folder.path / "camera.yml", simulated.rig->at(0).camera);
  }
  void fill_in() {
    wizard.fill("wizard_robot", urdf);
    wizard.fill("wizard_angles", folder.path / "angles.csv");
    wizard.fill("wizard_left", folder.path / "photos");
    wizard.fill("wizard_calibration", folder.path / "camera.yml");
    wizard.fill("wizard_target", folder.path / "made");
  }
  TemporaryFolder folder;
  std::filesystem::path urdf = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/robots/six_axis.urdf";
  Session simulated;
  Desk desk;
  WizardPage wizard{desk};
};

/// One camera on a stand and a ChArUco board in the hand: nothing is labelled, and it comes out calibrated.
TEST_F(BoardWizard, FromImagesOfABoardToTheExportedCalibration) {
  simulate_like("one_camera_board");
  ASSERT_TRUE(wizard.open());
  wizard.answer("camera_place", 0);
  wizard.answer("target_place", 0);
  wizard.answer("known", 2);
  const auto set = [&](const char* name, const QString& text) {
    auto* box = desk.find<QAbstractSpinBox>(name);
    wizard.show(box);
    desk.type_into(box, text);
    desk.key(Qt::Key_Tab);
  };
  set("target_columns", "7");
  set("target_rows", "5");
  set("target_square", "35");
  set("target_tag", "26");
  desk.find<QComboBox>("target_dictionary")->setCurrentText("DICT_4X4_50");
  EXPECT_TRUE(wizard.said("target_said").startsWith("ChArUco board of 7 x 5 squares of 35 mm"))
      << wizard.said("target_said").toStdString();
  EXPECT_FALSE(wizard.make()->isEnabled());
  fill_in();
  EXPECT_EQ(wizard.link("wizard_mount"), "stand");
  auto* tcp = desk.find<QComboBox>("wizard_tcp");
  tcp->setCurrentText("hand");
  EXPECT_EQ(wizard.said("wizard_left_sentence"), "14 images.");
  EXPECT_TRUE(wizard.said("wizard_calibration_sentence").startsWith("One camera of 880 px"));
  EXPECT_TRUE(wizard.said("wizard_links").startsWith("Camera on stand, target on hand: 6 moving joints"))
      << wizard.said("wizard_links").toStdString();
  ASSERT_TRUE(wizard.make()->isEnabled()) << wizard.said("wizard_refusal").toStdString();
  desk.click(wizard.make());
  ASSERT_TRUE(desk.document().is_open());
  const Session& made = desk.document().session();
  ASSERT_TRUE(made.target && made.rig);
  EXPECT_EQ(made.rig->count(), 1);
  EXPECT_EQ(made.rig->at(0).camera.width, 1024) << "from the images";
  EXPECT_EQ(made.observations.size(), 14U);
  EXPECT_FALSE(desk.find<QWidget>("label")->isVisible()) << "there is nothing to label";

  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  EXPECT_GE(desk.document().model()->report->used, 10);
  desk.window.activateWindow();  // no window manager does it where the dialog has gone
  ASSERT_TRUE(QTest::qWaitForWindowActive(&desk.window));
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  ExportPage page{desk};
  ASSERT_TRUE(page.save_as(folder.path / "calibration.xml"));
  const Calibration calibration = read_calibration(folder.path / "calibration.xml");
  // Where the board is on the hand is the simulation's truth.
  EXPECT_LT(
      (calibration.tcp_from_body.motion.translation - true_tcp_from_body(folder.path / "simulated").translation).norm(),
      1e-3);
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
  const char* fields[] = {"wizard_left",    "wizard_right",  "wizard_more",      "wizard_calibration", "wizard_poses",
                          "wizard_markers", "target_square", "target_tag",       "target_spacing",     "target_ids",
                          "target_columns", "target_sheet",  "target_dictionary"};
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
      {6, {"wizard_poses"}}};
  for (const auto& [option, asked] : wanted) {
    wizard.answer("known", option);
    for (const char* field : fields)
      EXPECT_EQ(is_asked(field), asked.contains(field)) << "option " << option << ": " << field;
  }
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
  std::string table = "x,y,z,qx,qy,qz,qw\n";
  const Rigid tcp_from_body = true_tcp_from_body(folder.path / "simulated");
  for (const Observation& o : simulated.observations) {
    const Rigid sensor_from_target =
        inverse(simulated.mount.mount_from_sensor) * root_from_link(simulated, o, "hand") * tcp_from_body;
    const Eigen::Quaterniond q(sensor_from_target.rotation);
    for (const double x : {sensor_from_target.translation.x(), sensor_from_target.translation.y(),
                           sensor_from_target.translation.z(), q.x(), q.y(), q.z()})
      table += format_number(x) + ",";
    table += format_number(q.w()) + "\n";
  }
  replace_file(folder.path / "poses.csv", table);
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
