// SPDX-License-Identifier: Apache-2.0
// The commands of docs/ten_minutes_one_camera.md and docs/ten_minutes_probe.md, run as they stand.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "cli/cli_runner.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

/// The lines between ``` and ``` (not ```sh or ```xml) that call the program.
std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  std::istringstream lines(page);
  bool is_fenced = false, is_shell = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_shell = !is_fenced && line == "```";
      is_fenced = !is_fenced;
    }
    if (is_shell && line.starts_with("handsight-cli ")) commands.push_back(line);
  }
  return commands;
}

const std::filesystem::path source = HANDSIGHT_SOURCE_DIR;

/// Runs a command of a page in a folder beside the sample sessions.
void expect_done(const std::filesystem::path& folder, const std::string& command) {
  const std::string line = "cd " + test::quoted_argument(folder.string()) +
                           " && PATH=" HANDSIGHT_BINARY_DIR "/app/cli:\"$PATH\" " + command + " >out.txt 2>err.txt";
  EXPECT_EQ(std::system(line.c_str()), 0) << command << '\n'
                                          << test::read_text(folder / "out.txt") << test::read_text(folder / "err.txt");
}

TEST(Tour, TheCommandsOfTenMinutesWithAProbeDoWhatThePageSays) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(source / "sample_sessions", folder.path / "sample_sessions");
  const auto commands = commands_of(test::read_text(source / "docs" / "ten_minutes_probe.md"));
  ASSERT_GE(commands.size(), 9u);
  for (const std::string& command : commands) {
    expect_done(folder.path, command);
    const std::string printed = test::read_text(folder.path / "out.txt");
    if (command.starts_with("handsight-cli fit ")) {
      EXPECT_NE(printed.find("axis_1"), std::string::npos) << "what cannot be known is named";
    }
    if (command.starts_with("handsight-cli diagnose ")) {
      EXPECT_NE(printed.find("joint_offset"), std::string::npos);
    }
  }
  const Calibration improved = read_calibration(folder.path / "improved.xml");
  ASSERT_EQ(improved.effects.size(), 1u);
  EXPECT_EQ(improved.effects.front().parameters.size(), 2u);
  const std::map<std::string, double> hidden{{"axis_2", 1.8e-3}, {"axis_3", -2.6e-3}};
  for (const auto& effect : improved.effects) {
    EXPECT_EQ(effect.id, "joint_offset");
    for (const auto& parameter : effect.parameters) {
      ASSERT_TRUE(hidden.contains(parameter.of)) << parameter.of;
      EXPECT_NEAR(parameter.value, hidden.at(parameter.of), 4 * parameter.sigma.value_or(0));
    }
  }
  const Session practice = read_session(folder.path / "practice");
  const Session sample = read_session(source / "sample_sessions" / "probe_and_plate");
  EXPECT_EQ(practice.observations.size(), sample.observations.size()) << "the sample is made of its table";
  EXPECT_EQ(practice.distances.front().by, sample.distances.front().by) << "the page's distance is the sample's";
  const std::string next = test::read_text(folder.path / "next.csv");
  EXPECT_TRUE(next.starts_with("fixture,axis_1,")) << next;
}

TEST(Tour, TheCommandsOfTenMinutesWithOneCameraDoWhatThePageSays) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(source / "sample_sessions", folder.path / "sample_sessions");
  const auto commands = commands_of(test::read_text(source / "docs" / "ten_minutes_one_camera.md"));
  ASSERT_GE(commands.size(), 10u);
  for (const std::string& command : commands) {
    expect_done(folder.path, command);
    if (command.starts_with("handsight-cli diagnose")) {
      EXPECT_NE(test::read_text(folder.path / "out.txt").find("joint_elasticity"), std::string::npos);
    }
  }
  EXPECT_GT(std::filesystem::file_size(folder.path / "board.pdf"), 1000u);
  const Session practice = read_session(folder.path / "practice");
  const auto accepted = std::count_if(practice.observations.begin(), practice.observations.end(),
                                      [](const Observation& o) { return o.decision == Decision::accepted; });
  EXPECT_GE(accepted, 15);
  const Calibration improved = read_calibration(folder.path / "improved.xml");
  ASSERT_FALSE(improved.effects.empty());
  EXPECT_EQ(improved.effects.front().id, "joint_elasticity");
  const Calibration table = read_calibration(folder.path / "table.xml");
  EXPECT_LT(std::sqrt(table.tcp_from_body.covariance.topLeftCorner<3, 3>().trace()), 1e-4);
}

}  // namespace
}  // namespace handsight
