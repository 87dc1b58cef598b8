// SPDX-License-Identifier: Apache-2.0
// Drivers that die, hang, lie or send nonsense, and experiments that are killed: nothing that was measured is lost.
#include <gmock/gmock.h>

#include <chrono>
#include <random>
#include <thread>

#include "cli/cli_runner.h"
#include "experiment/paths/collision_world.h"
#include "experiment/simulated/faults.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::AnyOf;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

const std::string driver = HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated ";

std::string shell_quoted(const std::filesystem::path& path) { return test::quoted_argument(path.string()); }

struct DriverFaults : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    session = fixture::written_session(fixture::tracker_session(), folder.path);
  }

  test::CliResult experiment(const std::string& options, const std::vector<std::string>& more,
                             const std::string& before = "") {
    std::vector<std::string> arguments = {"experiment", session.string(), "--driver",
                                          driver + shell_quoted(session) + " " + options, "--yes"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_cli(folder.path, arguments, before);
  }

  std::size_t observations() const { return read_session(session).observations.size(); }

  TemporaryFolder folder;
  std::filesystem::path session;
};

TEST_F(DriverFaults, EveryKindStopsWithASentenceAndWhatWasMeasuredIsThere) {
  struct Case {
    const char* fault;
    const char* sentence;
    std::size_t measured;  // observations at least, beside the three of the start
  };
  const Case cases[] = {{"dies@3", "ended with exit code 3", 2},
                        {"dies_at_hello", "ended with exit code 3", 0},
                        {"dies_at_look@3", "ended with exit code 3", 2},
                        {"hangs@3", "has not answered \"move\"", 2},
                        {"hangs_at_look@3", "has not answered \"look\"", 2},
                        {"elsewhere@3", "2.01 degrees from where it was sent", 2},
                        {"nonsense@3", "is no JSON", 2},
                        {"wrong_id@3", "belongs to something else", 2},
                        {"too_few_joints@3", "5 numbers in \"position\", expected 6", 2},
                        {"not_a_number@3", "something else than numbers", 2},
                        {"no_position@3", "does not say in \"position\"", 2},
                        {"endless@3", "longer than 16 MiB", 2},
                        {"closes@3", "has not answered \"move\"", 2},
                        {"refuses@3", "the arm is locked", 2},
                        {"blind@3", "the lens is covered", 2}};
  for (const Case& c : cases) {
    const std::size_t before = observations();
    const auto result = experiment(std::string("--fault ") + c.fault,
                                   {"--wait", std::string(c.sentence).starts_with("has not answered") ? "3" : "60",
                                    "--speed", "10", "--until", "count=40"});
    EXPECT_EQ(result.exit_code, 2) << c.fault << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(c.sentence)) << c.fault;
    const std::string last = result.errors.substr(result.errors.rfind('\n', result.errors.size() - 2) + 1);
    EXPECT_THAT(last.size(), testing::AllOf(Ge(20U), Le(600U))) << last;
    EXPECT_GE(observations(), before + c.measured) << c.fault;
  }
}

TEST_F(DriverFaults, ALieShowsInWhatIsSeenNotInWhatIsSaid) {
  const auto result = experiment("--fault lies@3", {"--until", "count=10"});
  // It cannot be seen from the driver's word; the observations are rejected or stand out of the fit, and are whole.
  EXPECT_THAT(result.exit_code, AnyOf(0, 1, 2)) << result.errors;
  EXPECT_GE(observations(), 5U);
}

TEST_F(DriverFaults, ACommandThatIsNotThereIsSaid) {
  const auto result =
      test::run_cli(folder.path, {"experiment", session.string(), "--driver", "/nowhere/driver", "--yes"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("is its command there?"));
}

TEST_F(DriverFaults, ImagesThatAreNotThereStopIt) {
  session = fixture::written_session(fixture::stand_session(), folder.path, 3, 5, "stereo");
  const auto result = experiment("--fault no_image@2", {"--until", "count=10"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("there is no such file"));
  EXPECT_EQ(observations(), 4U);
}

TEST_F(DriverFaults, NothingMovesWithoutAWord) {
  const auto refused = test::run_cli(
      folder.path, {"experiment", session.string(), "--driver", driver + shell_quoted(session)}, "</dev/null ");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("give --yes"));
  EXPECT_EQ(observations(), 3U);
  const auto dry = experiment("", {"--dry-run", "--json", "-"});
  EXPECT_EQ(dry.exit_code, 0) << dry.errors;
  EXPECT_EQ(dry.json()["stopped"], "dry_run");
  EXPECT_GE(dry.json()["planned"].size(), 3U);
  EXPECT_EQ(dry.json()["moves"], 0);
  EXPECT_EQ(observations(), 3U);
}

/// Is there no such process, or soon? One that nobody has waited for yet has ended too.
bool has_ended(const std::string& process) {
  for (int i = 0; i < 250; ++i) {
    const std::string state = process.empty() ? "" : test::read_text("/proc/" + process + "/stat");
    if (state.empty() || state.find(") Z ") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST_F(DriverFaults, KilledAtAnyMomentTheSessionIsWholeAndNothingMovesOn) {
  int rounds = 12, in_time = 0;
  if (const char* more = std::getenv("HANDSIGHT_KILLS")) rounds = std::atoi(more);
  const auto number = folder.path / "process";
  std::mt19937_64 random(17);
  std::size_t before = observations();
  double most = 1;  // s
  for (int i = 0; i < rounds; ++i) {
    std::filesystem::remove(number);
    const double seconds = most * static_cast<double>(random() % 1000 + 1) / 1000;
    // The first move, at a tenth of the speed, takes tenths of a second; the driver's process is that of the shell.
    test::run_cli(folder.path,
                  {"experiment", session.string(), "--driver",
                   "echo $$ >" + shell_quoted(number) + "; exec " + driver + shell_quoted(session) +
                       " --in-real-time --seed " + std::to_string(i),
                   "--yes", "--speed", "10", "--until", "count=200", "--seed", std::to_string(i)},
                  "timeout -s KILL " + std::to_string(seconds) + " ");
    std::string process = std::filesystem::exists(number) ? test::read_text(number) : "";
    process = process.substr(0, process.find('\n'));
    in_time += process.empty() ? 0 : 1;
    EXPECT_TRUE(has_ended(process)) << "the driver " << process << " goes on after " << seconds << " s";
    const std::size_t now = observations();  // throws where it cannot be read
    EXPECT_GE(now, before);
    if (now == before) most = std::min(1.2 * most, 8.0);  // it has not come to a look: a machine at work
    before = now;
  }
  EXPECT_GT(before, 3U);
  EXPECT_GT(in_time, rounds / 4);
}

TEST_F(DriverFaults, WhatWasInterruptedGoesOn) {
  const auto first = experiment("", {"--until", "count=6", "--json", "-"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const auto second = experiment("", {"--until", "count=6", "--json", "-"});
  ASSERT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(second.json()["observations"], 6);
  EXPECT_EQ(observations(), 15U);
  EXPECT_GE(second.json()["used"].get<int>(), 13);
  const Session session_now = read_session(session);
  for (std::size_t k = 1; k < session_now.observations.size(); ++k)
    EXPECT_GE(session_now.observations[k].time, session_now.observations[k - 1].time);
}

TEST(Faults, AnUnknownKindIsRefusedWithThoseThatThereAre) {
  EXPECT_GE(fault_kinds().size(), 12U);
  EXPECT_EQ(parse_fault("hangs@7").from_move, 7);
  for (const char* text : {"sulks", "hangs@0", "hangs@x"}) EXPECT_THROW(parse_fault(text), InputError) << text;
}

}  // namespace
}  // namespace handsight
