// SPDX-License-Identifier: Apache-2.0
// Pictures of a mistake of a whole kind that was found, before and after it was put right.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "window/blunder_bar.h"

namespace handsight::test {
namespace {

TEST(Mistakes, AJointThatCountsTheOtherWay) {
  const TemporaryFolder folder;
  Session s = fixture::stand_session(4);
  s.mount.estimate = true;
  SimulationOptions options;
  options.observations = 30;
  s = simulate_session(s, options).session;
  for (Observation& o : s.observations) o.position[2] *= -1;
  write_text(folder.path / "wrong/robot.urdf", fixture::urdf_text(s.robot));
  s.file = folder.path / "wrong/session.xml";
  save_session(s);
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "wrong").string())));
  auto* bar = desk.find<app::BlunderBar>("blunders");
  ASSERT_TRUE(desk.wait([&] { return bar->isVisible(); }, 120000));
  photo.take("mistakes");
  desk.press_button("blunders_write");
  photo.take("mistakes_written");
}

}  // namespace
}  // namespace handsight::test
