// SPDX-License-Identifier: Apache-2.0
// `recheck` as a timer or a cron job runs it, and what an interrupted experiment does.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "cli/cli_runner.h"
#include "experiment/paths/collision_world.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

struct RecheckCommand : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    session = fixture::written_session(fixture::tracker_session(4), folder.path, 40);
    const auto fitted = test::run_cli(folder.path, {"fit", session.string(), "--export", calibration()});
    ASSERT_EQ(fitted.exit_code, 0) << fitted.errors;
    std::filesystem::copy(session, folder.path / "rechecks", std::filesystem::copy_options::recursive);
    ::unsetenv("HANDSIGHT_CHANGE");
  }

  std::string calibration() const { return (folder.path / "calibration.xml").string(); }

  test::CliResult recheck(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"recheck", calibration()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_cli(folder.path, arguments);
  }

  /// Of a robot in which this has changed since the session was measured.
  test::CliResult driven(const std::string& change, int seed) const {
    return recheck({(folder.path / "rechecks").string(), "--driver",
                    HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated " +
                        test::quoted_argument(session.string()) + " --seed " + std::to_string(seed) +
                        (change.empty() ? "" : " --change " + change),
                    "--csv", (folder.path / "log.csv").string(), "--speed", "10", "--yes", "--json", "-"});
  }

  std::ptrdiff_t lines_of_log() const {
    const std::string log = test::read_text(folder.path / "log.csv");
    return std::count(log.begin(), log.end(), '\n');
  }

  TemporaryFolder folder;
  std::filesystem::path session;
};

TEST_F(RecheckCommand, FivePosesAreDrivenToAndTheExitCodeSaysWhetherAnythingHasChanged) {
  const auto unchanged = driven("", 3);
  EXPECT_EQ(unchanged.exit_code, 0) << unchanged.errors;
  EXPECT_EQ(std::count(unchanged.output.begin(), unchanged.output.end(), '\n'), 5) << unchanged.output;
  EXPECT_EQ(lines_of_log(), 6);
  EXPECT_EQ(read_session(folder.path / "rechecks").observations.size(), 45U);
  // An hour later: what was looked at before is counted, and said no more.
  const auto changed = driven("body_slip:x=0.003", 4);
  EXPECT_EQ(changed.exit_code, 1) << changed.errors;
  EXPECT_EQ(std::count(changed.output.begin(), changed.output.end(), '\n'), 5) << changed.output;
  EXPECT_EQ(lines_of_log(), 11);
  const auto last =
      nlohmann::json::parse(changed.output.substr(changed.output.rfind('\n', changed.output.size() - 2) + 1));
  EXPECT_TRUE(last["changed"]);
  EXPECT_EQ(last["what"], "body_slip");
  EXPECT_NEAR(last["size"][0]["value"].get<double>(), 0.003, 3e-4) << last.dump();
  // And once more: a change that was seen stays seen.
  EXPECT_EQ(driven("body_slip:x=0.003", 5).exit_code, 1);
}

TEST_F(RecheckCommand, ASessionOrAFolderThatIsWatchedIsLookedAt) {
  const auto looked = recheck({session.string()});
  EXPECT_EQ(looked.exit_code, 0) << looked.errors;
  EXPECT_THAT(looked.output, HasSubstr("Nothing speaks for a change after 40 observations"));
  const auto watched = recheck({"--watch", session.string(), "--for", "0.3"});
  EXPECT_EQ(watched.exit_code, 0) << watched.errors;
  EXPECT_THAT(watched.output, HasSubstr("after 40 observations"));
  const auto nothing = recheck({});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.errors, HasSubstr("--driver"));
}

/// Says in a file when it begins to move and when it is told to stop, by the clock of the whole machine.
const char* const noting_driver = R"(
import json, sys, time
joints = json.loads(sys.argv[2])
for line in sys.stdin:
    message = json.loads(line)
    with open(sys.argv[1], "a") as file:
        file.write(message["do"] + " " + str(time.clock_gettime(time.CLOCK_MONOTONIC)) + "\n")
    if message["do"] == "move":
        continue  # it never arrives
    said = {"joints": joints, "can": ["move", "look"], "name": "slow"} if message["do"] == "hello" else {"ok": True}
    print(json.dumps({"id": message["id"], **said}), flush=True)
)";

/// Seconds from the interruption of an experiment that moves to the driver's stop; nothing where none came.
std::optional<double> seconds_to_stop(const std::filesystem::path& folder, const std::filesystem::path& session) {
  const auto heard = folder / "heard";
  std::filesystem::remove(heard);
  test::write_text(folder / "driver.py", noting_driver);
  const std::string joints = nlohmann::json(read_session(session).joints).dump();
  const std::string command = "exec python3 " + test::quoted_argument((folder / "driver.py").string()) + " " +
                              test::quoted_argument(heard.string()) + " " + test::quoted_argument(joints);
  const pid_t process = fork();
  if (process == 0) {
    if (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr)) _exit(126);
    execl(HANDSIGHT_CLI, "handsight-cli", "experiment", session.c_str(), "--driver", command.c_str(), "--yes",
          "--until", "count=3", nullptr);
    _exit(127);
  }
  const auto time_of = [&](const std::string& word) -> std::optional<double> {
    const std::string text = test::read_text(heard);
    const auto at = text.find(word + " ");
    return at == std::string::npos ? std::nullopt : std::optional(std::atof(text.c_str() + at + word.size()));
  };
  for (int i = 0; i < 1200 && !time_of("move"); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const double interrupted = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  kill(process, SIGINT);
  waitpid(process, nullptr, 0);
  const auto stopped = time_of("stop");
  return stopped ? std::optional(*stopped - interrupted) : std::nullopt;
}

TEST_F(RecheckCommand, AnInterruptedExperimentStopsTheRobotWithinAFifthOfASecond) {
  double least = 1e9;
  for (int i = 0; i < 3 && least > 0.2; ++i) {  // where a machine is at work, one of three
    const auto seconds = seconds_to_stop(folder.path, session);
    ASSERT_TRUE(seconds) << "the driver was told nothing";
    least = std::min(least, *seconds);
  }
  RecordProperty("ms", static_cast<int>(1e3 * least));
  EXPECT_LE(least, 0.2);
  EXPECT_EQ(read_session(session).observations.size(), 40U);
}

}  // namespace
}  // namespace handsight
