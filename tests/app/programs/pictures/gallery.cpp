// SPDX-License-Identifier: Apache-2.0
// The robots of docs/gallery.md as Calibrate shows them: whole, with what watches them.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

const std::filesystem::path samples = HANDSIGHT_SOURCE_DIR "/sample_sessions";

/// As `simulate --like RIG --observations 60 --seed 7` makes it; in a picture its hidden effects do not show.
std::filesystem::path simulated(const std::filesystem::path& folder, const char* rig) {
  std::filesystem::create_directory(folder / rig);
  const Session like = read_session(samples / "rigs" / rig);
  SimulationOptions options;
  options.observations = 60;
  options.seed = 7;
  Session s = simulate_session(like, options).session;
  s.file = folder / rig / "session.xml";
  std::filesystem::copy(samples / "rigs" / rig / like.robot_file, folder / rig / "robot.urdf");
  s.robot_file = "robot.urdf";
  s.source.reset();
  replace_session(s);
  return folder / rig;
}

void take_robot(const std::filesystem::path& session, const std::string& name) {
  QCursor::setPos(1, 1);  // over nothing
  Desk desk;
  desk.window.resize(window_size());
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  for (widgets::RobotView* view : desk.window.findChildren<widgets::RobotView*>()) {
    if (!view->isVisible()) continue;
    view->setFixedSize(640, 400);
    QTest::qWait(250);
    view->look(widgets::StandardView::all);
    QTest::qWait(250);
    view->picture(1).save(folder_of_pictures + "/" + QString::fromStdString(name) + suffix + ".png");
    return;
  }
  FAIL() << "no robot is shown";
}

TEST(Gallery, Robots) {
  const TemporaryFolder folder;
  take_robot(samples / "hidden_3", "gallery_justin");
  take_robot(samples / "hidden_6", "gallery_light_arm");
  take_robot(samples / "panda_sockets", "gallery_panda");
  take_robot(simulated(folder.path, "camera_on_hand"), "gallery_wrist_camera");
  take_robot(simulated(folder.path, "six_axis_tracker"), "gallery_tracker");
}

}  // namespace
}  // namespace handsight::test
