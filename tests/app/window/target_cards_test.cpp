// SPDX-License-Identifier: Apache-2.0
// What is wrong with a target itself is a card that says so in the words of who printed it, and stands in the model
// panel under the target.
#include <gtest/gtest.h>

#include "app/window/reported_story.h"
#include "cli/cli_runner.h"
#include "fixtures/robot_texts.h"
#include "fixtures/targets.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "workbench/model_effects.h"

namespace handsight::test {
namespace {

TEST(TargetCards, ABoardThatWasPrintedLargerIsNamedWithItsShare) {
  const TemporaryFolder folder;
  SimulationOptions options;
  options.observations = 40;
  options.seed = 5;
  Session s = simulate_session(fixture::target_session(fixture::charuco(), 2), options).session;
  constexpr double by = 0.02;
  for (Vector3& x : s.shape->markers) x /= 1 + by;
  s.target->square /= 1 + by;
  s.target->tag /= 1 + by;
  write_text(folder.path / "board/robot.urdf", fixture::urdf_text(s.robot));
  s.file = folder.path / "board/session.xml";
  s.robot_file = "robot.urdf";
  save_session(s);

  Desk desk;
  ExplainPage explain{desk};
  Told reported{desk};
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "board").string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  reported.expect_one_story("a board that is 2 % larger");
  EXPECT_EQ(explain.first().id, "target_scale");
  EXPECT_EQ(explain.first().title, "Size of the target");
  EXPECT_NEAR(explain.first().words.section(' ', 3, 3).toDouble(), 100 * by, 0.1)
      << explain.first().words.toStdString();
  EXPECT_TRUE(explain.first().words.contains("% larger than described")) << explain.first().words.toStdString();
  EXPECT_EQ(explain.cards()->add_button()->text(), "Add size of the target");
  int of_target = 0;
  for (const widgets::ModelEffect& e :
       app::model_effects(desk.document(), desk.window.workbench().diagnosing.diagnosis().get()))
    if (e.id.startsWith("target_")) {
      EXPECT_TRUE(e.group == "Target" || e.is_out_of_sight) << e.id.toStdString() << ": " << e.group.toStdString();
      of_target += e.group == "Target" ? 1 : 0;
    }
  EXPECT_GE(of_target, 1);
  desk.click(explain.cards()->add_button());
  ASSERT_TRUE(explain.is_settled());
  EXPECT_EQ(reported.story().state, StoryState::at_the_noise);
  reported.expect_one_story("added");
}

}  // namespace
}  // namespace handsight::test
