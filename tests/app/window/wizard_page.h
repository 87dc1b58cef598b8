// SPDX-License-Identifier: Apache-2.0
// The wizard in the user's words, and what a user would bring to it: images, tables and a calibration of a simulated
// session.
#pragma once

#include <QDialog>
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

namespace handsight::test {

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

inline std::string joint_table(const Session& s) {
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

inline void write_camera(const std::filesystem::path& file, const Camera& c) {
  cv::FileStorage storage(file.string(), cv::FileStorage::WRITE);
  storage << "camera_matrix" << cv::Mat((cv::Mat_<double>(3, 3) << c.fx, c.skew, c.cx, 0, c.fy, c.cy, 0, 0, 1))
          << "distortion_coefficients" << cv::Mat((cv::Mat_<double>(1, 5) << c.k1, c.k2, c.p1, c.p2, c.k3));
}

/// Where the target is on its link, by the simulation.
inline Rigid true_tcp_from_body(const std::filesystem::path& session) {
  const std::string text = read_file(session / "truth.xml");
  const auto document = parse_xml(text, "truth.xml");
  return read_rigid(required_child(require_root(*document, "truth.xml", "handsight_truth"), "tcp_from_body"));
}

inline Rigid root_from_link(const Session& s, const Observation& o, const char* link) {
  std::vector<int> joints;
  for (const std::string& name : s.joints) joints.push_back(find_joint(s.robot, name));
  const Posture posture = solve_posture(s.robot, joint_values(s.robot, joints, o.position), s.gravity);
  return posture.root_from_link[static_cast<std::size_t>(find_link(s.robot, link))];
}

/// A line `x,y,z,qx,qy,qz,qw` for each pose.
inline std::string pose_table(const std::vector<Rigid>& poses) {
  std::string table = "x,y,z,qx,qy,qz,qw\n";
  for (const Rigid& pose : poses) {
    const Eigen::Quaterniond q(pose.rotation);
    for (const double x : {pose.translation.x(), pose.translation.y(), pose.translation.z(), q.x(), q.y(), q.z()})
      table += format_number(x) + ",";
    table += format_number(q.w()) + "\n";
  }
  return table;
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
  /// The board of both samples, in the form's fields.
  void describe_board() {
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
  }
  /// Makes it, plays it to the end and exports what comes out.
  std::optional<Calibration> made_played_and_exported() {
    EXPECT_TRUE(wizard.make()->isEnabled()) << wizard.said("wizard_refusal").toStdString();
    desk.click(wizard.make());
    if (!desk.document().is_open()) return std::nullopt;
    EXPECT_FALSE(desk.find<QWidget>("label")->isVisible()) << "there is nothing to label";
    CalibratePage calibrate{desk};
    calibrate.set_fastest();
    if (!calibrate.play_to_the_end() || !desk.document().model() || !desk.document().model()->fit) return std::nullopt;
    EXPECT_GE(desk.document().model()->report->used, 10);
    desk.window.activateWindow();  // no window manager does it where the dialog has gone
    EXPECT_TRUE(QTest::qWaitForWindowActive(&desk.window));
    desk.key(Qt::Key_5, Qt::ControlModifier);
    EXPECT_TRUE(desk.settle());
    ExportPage page{desk};
    if (!page.save_as(folder.path / "calibration.xml")) return std::nullopt;
    return read_calibration(folder.path / "calibration.xml");
  }
  /// How far a calibration's target is from where the simulation has it, m.
  double compute_error(const Calibration& calibration) {
    return (calibration.tcp_from_body.motion.translation - true_tcp_from_body(folder.path / "simulated").translation)
        .norm();
  }
  TemporaryFolder folder;
  std::filesystem::path urdf = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/robots/six_axis.urdf";
  Session simulated;
  Desk desk;
  WizardPage wizard{desk};
};

}  // namespace handsight::test
