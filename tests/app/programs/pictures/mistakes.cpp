// SPDX-License-Identifier: Apache-2.0
// Pictures of a mistake of a whole kind that was found, before and after it was put right.
#include <gtest/gtest.h>

#include <QTableView>
#include <map>

#include "app/programs/pictures/photographer.h"
#include "app/window/pages.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/explain/effect_table.h"
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

TEST(Mistakes, ImagesSortedAsText) {
  const TemporaryFolder folder;
  Session s = fixture::stand_session(4);
  s.mount.estimate = true;
  SimulationOptions options;
  options.observations = 30;
  s = simulate_session(s, options).session;
  std::map<std::string, Eigen::VectorXd> as_text;
  for (std::size_t i = 0; i < s.observations.size(); ++i) as_text[std::to_string(i)] = s.observations[i].position;
  auto next = s.observations.begin();
  for (const auto& [name, position] : as_text) (next++)->position = position;
  write_text(folder.path / "mixed/robot.urdf", fixture::urdf_text(s.robot));
  s.file = folder.path / "mixed/session.xml";
  save_session(s);
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "mixed").string())));
  ASSERT_TRUE(desk.wait([&] { return desk.find<app::BlunderBar>("blunders")->isVisible(); }, 120000));
  photo.take("mistakes_order");
}

TEST(Mistakes, ASlipThatIsHeldBack) {
  const TemporaryFolder folder;
  SimulationOptions options;
  options.observations = 60;
  options.seed = 9;
  options.noise = 0.2;
  options.declare_noise = false;
  options.effects = {{"mount_slip", -1, {8e-5, 0, -8e-5, 1.6e-4, 0, 0, 31}}};
  Session s = simulate_session(fixture::stand_session(), options).session;
  write_text(folder.path / "slip/robot.urdf", fixture::urdf_text(s.robot));
  s.file = folder.path / "slip/session.xml";
  save_session(s);
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "slip").string())));
  ASSERT_TRUE(desk.settle());
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  desk.click(explain.cards()->why_not_button());
  auto* table = desk.window.findChild<widgets::EffectTable*>();
  table->set_filter("slip");
  auto* rows = table->view();
  rows->setCurrentIndex(rows->model()->index(0, 0));
  photo.take_now("explain_held_back");
}

}  // namespace
}  // namespace handsight::test
