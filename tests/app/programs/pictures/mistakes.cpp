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
#include "fixtures/rare_slip.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/explain/effect_table.h"
#include "window/blunder_bar.h"

namespace handsight::test {
namespace {

/// The arm on the stand, thirty observations with the mount to be found.
Session simulated() {
  Session s = fixture::stand_session(4);
  s.mount.estimate = true;
  SimulationOptions options;
  options.observations = 30;
  return simulate_session(s, options).session;
}

/// A window with the session, and what takes its pictures.
class Pictured {
 public:
  explicit Pictured(Session s) {
    write_text(folder_.path / "arm/robot.urdf", fixture::urdf_text(s.robot));
    s.file = folder_.path / "arm/session.xml";
    save_session(s);
    desk.window.resize(window_size());
  }
  bool open() { return desk.window.open(QString::fromStdString((folder_.path / "arm").string())); }
  bool finds_a_mistake() {
    return open() && desk.wait([&] { return desk.find<app::BlunderBar>("blunders")->isVisible(); }, 120000);
  }

 private:
  TemporaryFolder folder_;

 public:
  Desk desk;
  Photographer photo{desk};
};

TEST(Mistakes, AJointThatCountsTheOtherWay) {
  Session s = simulated();
  for (Observation& o : s.observations) o.position[2] *= -1;
  Pictured p(s);
  ASSERT_TRUE(p.finds_a_mistake());
  p.photo.take("mistakes");
  p.desk.press_button("blunders_write");
  p.photo.take("mistakes_written");
}

TEST(Mistakes, ImagesSortedAsText) {
  Session s = simulated();
  std::map<std::string, Eigen::VectorXd> as_text;
  for (std::size_t i = 0; i < s.observations.size(); ++i) as_text[std::to_string(i)] = s.observations[i].position;
  auto next = s.observations.begin();
  for (const auto& [name, position] : as_text) (next++)->position = position;
  Pictured p(s);
  ASSERT_TRUE(p.finds_a_mistake());
  p.photo.take("mistakes_order");
}

TEST(Mistakes, ASlipThatIsHeldBack) {
  Pictured p(fixture::session_with_rare_slip());
  ASSERT_TRUE(p.open());
  ASSERT_TRUE(p.desk.settle());
  ExplainPage explain{p.desk};
  ASSERT_TRUE(explain.open());
  p.desk.click(explain.cards()->why_not_button());
  auto* table = p.desk.window.findChild<widgets::EffectTable*>();
  table->set_filter("slip");
  auto* rows = table->view();
  rows->setCurrentIndex(rows->model()->index(0, 0));
  p.photo.take_now("explain_held_back");
}

}  // namespace
}  // namespace handsight::test
