// SPDX-License-Identifier: Apache-2.0
// What `improve` writes of real robots is read by predict, correct and export. Sessions that take longer are left to
// tests/trials/trial_written.cpp.
#include <gtest/gtest.h>

#include "cli/cli_runner.h"
#include "export/exported.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;

constexpr int wrong_input = 2;

class WrittenCalibrations : public testing::TestWithParam<const char*> {};

TEST_P(WrittenCalibrations, AreReadByEveryCommand) {
  const auto folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / GetParam();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const TemporaryFolder temporary;
  const std::string file = (temporary.path / "x.xml").string();
  const test::CliResult improved = run_cli(temporary.path, {"improve", folder.string(), "--export", file});
  ASSERT_LT(improved.exit_code, wrong_input) << improved.errors;
  EXPECT_TRUE(read_calibration(file).notes.empty());
  const Session session = read_session(folder);
  const std::string robot = (folder / session.robot_file).string();
  std::string position;
  for (const double q : session.observations.front().position) position += fmt::format("{} ", q);
  for (const char* command : {"predict", "correct"}) {
    const test::CliResult r = run_cli(temporary.path, {command, file, "--robot", robot, "--position", position});
    EXPECT_LT(r.exit_code, wrong_input) << command << ": " << r.errors;
  }
  for (const char* kind : export_kinds) {
    const test::CliResult r =
        run_cli(temporary.path, {"export", file, "--robot", robot, "--as", kind, "--out", file + "." + kind});
    const bool is_of_another_make = std::string(kind) == "ur_calibration";
    EXPECT_EQ(r.exit_code, is_of_another_make ? wrong_input : 0) << kind << ": " << r.errors;
  }
}

INSTANTIATE_TEST_SUITE_P(OfRealRobots, WrittenCalibrations,
                         testing::Values("motoman_left_even", "mukca_panda_2", "mukca_panda_6", "mukca_kuka_14",
                                         "fr3_hand_eye_even"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace handsight
