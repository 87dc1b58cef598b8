// SPDX-License-Identifier: Apache-2.0
// Experiments in the window that end by force: the driver dies at any moment, or the window does. What was measured is
// there, nothing moves on, and the experiment goes on. HANDSIGHT_KILLS says how often.
#include <gtest/gtest.h>
#include <signal.h>

#include <random>

#include "app/document/kills.h"
#include "app/window/measure_page.h"
#include "base/files.h"
#include "experiment/paths/collision_world.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

/// Simulated drivers of this session that run.
std::vector<pid_t> drivers_of(const std::filesystem::path& session) {
  std::vector<pid_t> found;
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    const std::string name = process.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::string command;
    try {
      command = read_file(process.path() / "cmdline");
    } catch (const std::exception&) {
      continue;  // it has ended meanwhile
    }
    const std::string program = command.substr(0, command.find('\0'));
    if (program.ends_with("handsight-driver-simulated") && command.find(session.string()) != std::string::npos)
      found.push_back(std::stoi(name));
  }
  return found;
}

class ExperimentKills : public testing::Test {
 protected:
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    session = fixture::written_session(fixture::tracker_session(), folder.path);
  }
  TemporaryFolder folder;
  std::filesystem::path session;
  std::mt19937 random{11};
};

TEST_F(ExperimentKills, ADriverThatDiesAtAnyMomentLosesNothingAndTheExperimentGoesOn) {
  Desk desk;
  MeasurePage page{desk};
  desk.window.resize(1366, 728);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  page.open();
  std::uniform_int_distribution<int> milliseconds(0, 1500);
  const auto observations = [&] { return desk.document().session().observations.size(); };
  for (int round = 0; round < kills(3); ++round) {
    std::size_t taken = observations();
    page.type_simulated("--in-real-time");
    ASSERT_TRUE(page.connect()) << page.said().toStdString();
    const auto counting =
        QObject::connect(&page.workspace()->run(), &app::ExperimentRun::measured, &desk.window, [&taken] { ++taken; });
    page.set_count(1000);
    page.set_speed(5);
    page.start();
    QTest::qWait(milliseconds(random));
    for (const pid_t driver : drivers_of(session)) ::kill(driver, SIGKILL);
    ASSERT_TRUE(page.ends()) << "round " << round;
    QObject::disconnect(counting);
    EXPECT_TRUE(page.said().contains("driver", Qt::CaseInsensitive)) << page.said().toStdString();
    EXPECT_TRUE(drivers_of(session).empty()) << "nothing moves on";
    EXPECT_EQ(observations(), taken) << "round " << round;
    if (round % 3 == 2) {
      desk.document().close();
      ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
      ASSERT_TRUE(desk.settle());
      EXPECT_EQ(observations(), taken) << "the journal has all of them, round " << round;
      page.open();
    }
  }
  page.type_simulated();
  ASSERT_TRUE(page.connect()) << page.said().toStdString();
  const std::size_t before = observations();
  page.set_count(1);
  page.start();
  ASSERT_TRUE(page.ends());
  EXPECT_EQ(observations(), before + 1) << "and it goes on";
}

TEST_F(ExperimentKills, AWindowThatIsKilledLosesNoObservationAndTheRobotStops) {
  std::uniform_int_distribution<useconds_t> microseconds(1000, 2500000);
  std::size_t known = 3;
  for (int round = 0; round < kills(3); ++round) {
    const auto said = said_before_killed("--measure-until-killed", {session.string()}, microseconds(random));
    ASSERT_FALSE(said.empty()) << "the window ended by itself, round " << round;
    EXPECT_TRUE(QTest::qWaitFor([&] { return drivers_of(session).empty(); }, 3000 * patience))
        << "a lost pipe ends the driver, round " << round;
    const auto taken = known + static_cast<std::size_t>(std::count(said.begin(), said.end(), "observation\n"));
    app::Document document;
    document.open(session);
    const std::size_t found = document.session().observations.size();
    EXPECT_TRUE(found == taken || found == taken + 1) << "round " << round << ": said " << taken << ", found " << found;
    known = found;
    if (round % 5 == 4) document.save();
  }
  EXPECT_NO_THROW(read_session(session));
}

}  // namespace
}  // namespace handsight::test
