// SPDX-License-Identifier: Apache-2.0
// The page of experiments with a session of touches: a look is a touch, each pose names what is touched from there.
#include <gtest/gtest.h>

#include "app/window/measure_page.h"
#include "experiment/moving_robot.h"
#include "experiment/paths/collision_world.h"
#include "experiment/written_session.h"
#include "fixtures/touch_session.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

class TouchExperimentInWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    Session like = fixture::probe_session();
    fixture::add_plates(like);
    fixture::add_sockets(like);
    session = fixture::written_session(like, folder.path, touches_before);
    desk.window.resize(1366, 728);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    page.open();
  }
  std::size_t observations() { return desk.document().session().observations.size(); }
  QString cell(int row, int column) { return page.poses()->item(row, column)->text(); }
  bool names_a_fixture(const QString& text) {
    const auto& fixtures = desk.document().session().fixtures;
    return std::any_of(fixtures.begin(), fixtures.end(),
                       [&](const Fixture& f) { return text.endsWith(QString::fromStdString(f.id)); });
  }
  static constexpr int touches_before = 24;
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  MeasurePage page{desk};
};

TEST_F(TouchExperimentInWindow, EachPoseThatComesNamesItsFixtureAndTheQuestionSaysThatItTouches) {
  EXPECT_TRUE(desk.find<QAbstractButton>("experiment_try")->isEnabled()) << page.said().toStdString();
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect()) << page.said().toStdString();
  const auto& planned = page.workspace()->page().robot().planned();
  ASSERT_GT(planned.size(), 0U);
  for (int row = 0; row < page.poses()->rowCount(); ++row)
    EXPECT_TRUE(names_a_fixture(cell(row, 0))) << cell(row, 0).toStdString();
  EXPECT_TRUE(desk.find<QLabel>("experiment_next")->text().startsWith("touches "));
  desk.press_button("experiment_begin");
  EXPECT_TRUE(page.said().contains("feels for its fixtures")) << page.said().toStdString();
  EXPECT_EQ(observations(), static_cast<std::size_t>(touches_before)) << "nothing has moved";
}

TEST_F(TouchExperimentInWindow, WhatWasTouchedIsInTheSessionWithItsFixtureAndIsThereAgain) {
  int felt = 0;
  QObject::connect(&page.workspace()->run(), &app::ExperimentRun::feeling, &desk.window,
                   [&](const Eigen::VectorXd& at) { felt += at.size() == 6; });
  page.type_simulated("");
  ASSERT_TRUE(page.connect()) << page.said().toStdString();
  page.set_count(4);
  page.set_speed(5);
  page.start();
  ASSERT_TRUE(page.ends()) << page.said().toStdString();
  EXPECT_TRUE(page.said().contains("4 observations")) << page.said().toStdString();
  ASSERT_EQ(observations(), touches_before + 4U);
  EXPECT_GE(felt, 4);
  EXPECT_TRUE(desk.find<QLabel>("experiment_hand")->text().contains("touch"))
      << desk.find<QLabel>("experiment_hand")->text().toStdString();
  const std::vector<Observation> made = desk.document().session().observations;
  for (std::size_t i = touches_before; i < made.size(); ++i) {
    EXPECT_EQ(made[i].decision, Decision::accepted) << made[i].reason;
    EXPECT_EQ(made[i].sightings.size(), 1U);
  }
  EXPECT_EQ(desk.document().undo_stack().index(), 4) << "each touch with its decision is one action to undo";
  // Written, and read again, each is of the fixture that its row names.
  desk.document().save();
  const Session read = read_session(session);
  ASSERT_EQ(read.observations.size(), made.size());
  int row = 0;
  for (std::size_t i = touches_before; i < made.size(); ++i, ++row) {
    EXPECT_EQ(read.observations[i].part, made[i].part);
    const std::string& id = read.fixtures[static_cast<std::size_t>(made[i].part)].id;
    EXPECT_TRUE(cell(row, 0).endsWith(QString::fromStdString(id))) << cell(row, 0).toStdString() << ", " << id;
  }
}

TEST_F(TouchExperimentInWindow, ATryTouchesInACopyOfThisSession) {
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", QByteArray(HANDSIGHT_BINARY_DIR "/app/cli:") + path);
  desk.press_button("experiment_try");
  qputenv("PATH", path);
  ASSERT_TRUE(desk.wait([this] { return page.state() == app::RunState::asking; }, 60000)) << page.said().toStdString();
  EXPECT_NE(desk.document().file().parent_path(), session);
  EXPECT_GT(page.poses()->rowCount(), 0);
}

}  // namespace
}  // namespace handsight::test
