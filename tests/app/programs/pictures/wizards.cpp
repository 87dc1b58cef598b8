// SPDX-License-Identifier: Apache-2.0
// Pictures of the wizards that make sessions.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDir>
#include <QScrollBar>

#include "app/programs/pictures/photographer.h"
#include "base/files.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"
#include "wizard/files_wizard.h"

namespace handsight::test {
namespace {

/// Its fields are below each other: those that are filled in are scrolled to.
TEST(Pictures, OfTheWizard) {
  Desk desk;
  desk.press_button("start_new");
  auto* wizard = desk.window.findChild<QDialog*>("wizard");
  ASSERT_NE(wizard, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  auto* scroll = desk.find<QScrollArea>("wizard_scroll");
  const auto take = [&](const char* name) { take_dialog(*wizard, name); };
  const auto fill = [&](const char* name, const QString& with) {
    auto* field = desk.find<QLineEdit>(name);
    scroll->ensureWidgetVisible(field);
    QTest::qWait(10);
    desk.type_into(field, with);
  };
  take("wizard_empty");
  QDir::setCurrent(HANDSIGHT_SOURCE_DIR);  // the pictures tell nothing of where they were taken
  const auto samples = QString("sample_sessions");
  fill("wizard_robot", samples + "/robots/six_axis.urdf");
  const auto answer = [&](const char* tile) {
    scroll->ensureWidgetVisible(desk.find<QAbstractButton>(tile));
    desk.press_button(tile);
  };
  answer("camera_place_0");
  answer("known_2");
  desk.find<QComboBox>("wizard_tcp")->setCurrentText("hand");
  take("wizard");
  fill("wizard_angles", samples + "/nowhere.csv");
  scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
  take("wizard_files");
  answer("camera_place_2");
  answer("known_6");
  scroll->verticalScrollBar()->setValue(0);
  take("wizard_on_hand");
  static_cast<QDialog*>(wizard)->reject();
}

TEST(Pictures, OfTheWizardOfFiles) {
  Desk desk;
  desk.window.resize(window_size());
  const auto samples = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions";
  auto* wizard = desk.window.bring_files({});
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  const auto take = [&](const char* name) { take_dialog(*wizard, name); };
  take("files_empty");
  wizard->add({samples / "robots/six_axis.urdf", samples / "first_steps/images", samples / "README.md"});
  take("files");
  static_cast<QDialog*>(wizard)->reject();
}

/// At work, stopped, and when it is done.
TEST(Pictures, OfTheWizardOfFilesAtWork) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  const auto like = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/rigs/one_camera_board";
  const Session session = read_session(like);
  std::string angles, flange = "x,y,z,qx,qy,qz,qw\n";
  for (const std::string& joint : session.joints) angles += (angles.empty() ? "" : ",") + joint;
  SimulationOptions options;
  options.observations = 12;
  for (const Observation& o : simulate_session(session, options).session.observations) {
    for (Eigen::Index j = 0; j < o.position.size(); ++j) angles += fmt::format("{}{}", j ? ',' : '\n', o.position[j]);
    const double turn = 0.4 * o.position[0];
    flange += fmt::format("{},0.1,0.9,{},0,0,{}\n", 0.02 * o.position[1], std::sin(turn / 2), std::cos(turn / 2));
  }
  replace_file(folder.path / "angles.csv", angles + '\n');
  replace_file(folder.path / "board.csv", flange);
  auto* wizard = desk.window.bring_files({});
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  const auto take = [&](const char* name) { take_dialog(*wizard, name); };
  wizard->add({session.file.parent_path() / session.robot_file, folder.path / "angles.csv", folder.path / "board.csv"});
  desk.find<QComboBox>("files_tcp")->setCurrentText("hand");
  desk.find<QLineEdit>("files_title")->setText("Monday");
  desk.find<QLineEdit>("files_out")->setText(QString::fromStdString((folder.path / "monday").string()));
  take("files_ready");
  desk.window.workbench().background.hold(true);
  desk.press_button("files_make");
  take("files_working");
  desk.press_button("files_stop");
  take("files_stopping");
  desk.window.workbench().background.hold(false);
  ASSERT_TRUE(desk.wait([&] { return !desk.find<QWidget>("files_stop")->isVisible(); }));
  take("files_stopped");
  desk.press_button("files_make");
  ASSERT_TRUE(desk.wait([&] { return !desk.window.workbench().background.is_busy(); }));
  take("files_made");
  static_cast<QDialog*>(wizard)->reject();
}

}  // namespace
}  // namespace handsight::test
