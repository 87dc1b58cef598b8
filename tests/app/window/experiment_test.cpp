// SPDX-License-Identifier: Apache-2.0
// The page of experiments, against the simulated driver: it begins, asks, moves, stops, ends and goes on another day.
#include <gtest/gtest.h>

#include "app/window/measure_page.h"
#include "experiment/drivers.h"
#include "experiment/moving_robot.h"
#include "experiment/paths/collision_world.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"
#include "window/rail_button.h"
#include "workbench/preferences.h"

namespace handsight::test {
namespace {

class ExperimentInWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    session = fixture::written_session(fixture::tracker_session(), folder.path);
    desk.window.resize(1366, 728);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    page.open();
  }
  std::size_t observations() { return desk.document().session().observations.size(); }
  /// Measures so many poses from here on.
  void measure(int poses, const std::string& options = "") {
    page.type_simulated(options);
    ASSERT_TRUE(page.connect()) << page.said().toStdString();
    page.set_count(poses);
    page.set_speed(5);
    page.start();
    ASSERT_TRUE(page.ends()) << page.said().toStdString();
  }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  MeasurePage page{desk};
};

TEST_F(ExperimentInWindow, SaysWhatToDoBeforeThereIsADriver) {
  EXPECT_TRUE(page.said().contains("No robot is connected")) << page.said().toStdString();
  EXPECT_FALSE(desk.find<QAbstractButton>("experiment_begin")->isEnabled()) << "nothing to connect to";
  EXPECT_FALSE(desk.find<QAbstractButton>("experiment_stop")->isEnabled()) << "nothing moves";
  EXPECT_TRUE(desk.find<QAbstractButton>("experiment_try")->isEnabled());
}

TEST_F(ExperimentInWindow, ConnectedItShowsWhereTheRobotStandsAndWhatComesAndNothingMoves) {
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect()) << page.said().toStdString();
  const auto& robot = page.workspace()->page().robot();
  EXPECT_TRUE((robot.position() - desk.document().session().observations.back().position).isZero(1e-9))
      << "the simulated robot stands where the last observation was taken";
  EXPECT_GT(robot.planned().size(), 0U);
  EXPECT_EQ(page.poses()->rowCount(), static_cast<int>(robot.planned().size()));
  QTest::qWait(300);
  EXPECT_EQ(page.state(), app::RunState::asking);
  EXPECT_EQ(observations(), 3U);
}

TEST_F(ExperimentInWindow, StartAsksOnceAndNotNowMovesNothing) {
  page.type_simulated();
  ASSERT_TRUE(page.connect());
  desk.press_button("experiment_begin");
  EXPECT_TRUE(page.said().contains("The robot moves now")) << page.said().toStdString();
  desk.key(Qt::Key_Escape);
  EXPECT_EQ(page.state(), app::RunState::asking);
  EXPECT_TRUE(page.said().contains("nothing has moved")) << page.said().toStdString();
  desk.press_button("experiment_begin");
  desk.press_button("experiment_no");
  QTest::qWait(200);
  EXPECT_EQ(page.state(), app::RunState::asking);
  desk.press_button("experiment_disconnect");
  ASSERT_TRUE(page.ends(10000));
  EXPECT_TRUE(page.said().contains("nothing has moved")) << page.said().toStdString();
  EXPECT_EQ(observations(), 3U);
}

TEST_F(ExperimentInWindow, MeasuresWhatWasAskedForAndSaysWhyItStopped) {
  measure(4);
  EXPECT_EQ(observations(), 7U);
  EXPECT_TRUE(page.said().contains("4 observations")) << page.said().toStdString();
  EXPECT_GE(page.poses()->rowCount(), 4);
  EXPECT_TRUE(desk.find<QLabel>("experiment_hand")->text().contains("mm"));
  EXPECT_TRUE(desk.find<QAbstractButton>("experiment_begin")->isEnabled()) << "it can go on";
  const int actions = desk.document().undo_stack().index();
  EXPECT_EQ(actions, 4) << "each observation with its decision is one action to undo";
}

TEST_F(ExperimentInWindow, AfterEachLookTheHandsErrorIsKnownAnew) {
  std::vector<std::size_t> used;
  QObject::connect(&page.workspace()->run(), &app::ExperimentRun::learned, &desk.window,
                   [&](const std::shared_ptr<const Knowledge>& known) { used.push_back(known->used); });
  measure(3);
  for (const std::size_t count : {4U, 5U, 6U}) EXPECT_TRUE(std::count(used.begin(), used.end(), count) > 0) << count;
}

TEST_F(ExperimentInWindow, TheStopButtonStopsWithinAFifthOfASecond) {
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect());
  page.set_speed(0.05);  // the first move at a tenth of it: it takes many seconds
  page.start();
  ASSERT_TRUE(page.moves());
  QTest::qWait(200);
  desk.click(desk.find<QWidget>("experiment_stop"));
  const qint64 ms = page.time_to_stand();
  EXPECT_GE(ms, 0);
  EXPECT_LE(ms, 200 * patience);
  RecordProperty("ms", static_cast<int>(ms));
  ASSERT_TRUE(page.ends());
  EXPECT_TRUE(page.said().contains("interrupted")) << page.said().toStdString();
  EXPECT_EQ(observations(), 3U);
}

TEST_F(ExperimentInWindow, EscStopsFromEveryWorkspace) {
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect());
  page.set_speed(0.05);
  page.start();
  ASSERT_TRUE(page.moves());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(desk.find<QWidget>("rail_experiment")->accessibleDescription().contains("moves"));
  desk.key(Qt::Key_Escape);
  const qint64 ms = page.time_to_stand();
  EXPECT_GE(ms, 0);
  EXPECT_LE(ms, 200 * patience);
  ASSERT_TRUE(page.ends());
}

TEST_F(ExperimentInWindow, AMoveIsDrawnWhileItLasts) {
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect());
  page.set_speed(0.5);
  page.start();
  ASSERT_TRUE(page.moves());
  const Eigen::VectorXd before = page.workspace()->page().robot().position();
  QTest::qWait(600);
  if (page.state() == app::RunState::moving) {
    EXPECT_GT((page.workspace()->page().robot().position() - before).cwiseAbs().maxCoeff(), 1e-4);
  }
  page.workspace()->run().stop();
  ASSERT_TRUE(page.ends());
}

TEST_F(ExperimentInWindow, ADriverThatDiesEndsItWithASentenceAndNothingIsLost) {
  page.type_simulated("--fault dies@3");
  ASSERT_TRUE(page.connect());
  page.set_speed(5);
  page.start();
  ASSERT_TRUE(page.ends());
  EXPECT_TRUE(page.said().contains("exit code 3")) << page.said().toStdString();
  EXPECT_EQ(observations(), 5U) << "two moves were made before";
}

TEST_F(ExperimentInWindow, ADriverThatIsNotThereIsSaid) {
  page.type_driver("/nowhere/at/all_driver");
  EXPECT_FALSE(page.connect());
  EXPECT_TRUE(page.said().contains("exit code 127")) << page.said().toStdString();
  EXPECT_TRUE(desk.find<QAbstractButton>("experiment_begin")->isEnabled());
}

TEST_F(ExperimentInWindow, GoesOnAnotherDay) {
  measure(2);
  ASSERT_EQ(observations(), 5U);
  desk.document().close();  // not saved: the journal keeps it
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_EQ(observations(), 5U);
  page.open();
  measure(2);
  EXPECT_EQ(observations(), 7U);
  desk.document().save();
  EXPECT_EQ(read_session(session).observations.size(), 7U);
}

TEST_F(ExperimentInWindow, ASessionThatIsClosedMeanwhileStopsTheRobot) {
  page.type_simulated("--in-real-time");
  ASSERT_TRUE(page.connect());
  page.set_speed(0.05);
  page.start();
  ASSERT_TRUE(page.moves());
  desk.document().close();
  EXPECT_EQ(page.state(), app::RunState::resting);
  QTest::qWait(400);
}

TEST_F(ExperimentInWindow, ACommandIsRememberedAndNeverTakenFromASession) {
  page.type_driver("python3 my_driver.py --port 7");
  desk.press_button("experiment_begin");
  ASSERT_TRUE(page.ends(20000));
  EXPECT_EQ(app::recent_drivers().value(0), "python3 my_driver.py --port 7");
  const std::string text = read_file(session / "session.xml");
  EXPECT_EQ(text.find("my_driver"), std::string::npos);
}

TEST_F(ExperimentInWindow, TheSimulatedRobotIsTriedInASessionOfItsOwn) {
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", QByteArray(HANDSIGHT_BINARY_DIR "/app/cli:") + path);
  const std::string before = read_file(session / "session.xml");
  desk.press_button("experiment_try");
  ASSERT_TRUE(desk.wait([this] { return page.state() == app::RunState::asking; }, 60000)) << page.said().toStdString();
  EXPECT_TRUE(app::is_to_try(desk.document().file()));
  page.set_count(2);
  page.set_speed(8);
  page.start();
  ASSERT_TRUE(page.ends());
  EXPECT_EQ(observations(), 5U);
  EXPECT_EQ(read_file(session / "session.xml"), before) << "nothing invented comes among what was measured";
  qputenv("PATH", path);
}

}  // namespace
}  // namespace handsight::test
