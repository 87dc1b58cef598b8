// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/cli_runner.h"
#include "diagnosis/planning/planning_sessions.h"
#include "readers/csv.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using fixture::simulated;

class PlanCommand : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path sample = HANDSIGHT_SOURCE_DIR "/sample_sessions/first_steps";
    std::filesystem::copy(sample, folder.path / "session", std::filesystem::copy_options::recursive);
    const Session like = read_session(folder.path / "session");
    Session labelled = simulated(like, 12, 11).session;
    labelled.file = like.file;
    labelled.source = nullptr;
    save_session(labelled);
  }

  test::CliResult plan_with(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plan", (folder.path / "session").string()});
    return test::run_cli(folder.path, arguments);
  }

  TemporaryFolder folder;
};

TEST_F(PlanCommand, WritesJsonAndATableThatReadsBack) {
  const auto csv = folder.path / "poses.csv";
  const test::CliResult r = plan_with({"--count", "3", "--json", "-", "--csv", csv.string()});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const nlohmann::json json = r.json();
  const Session session = read_session(folder.path / "session");
  const std::vector<Eigen::VectorXd> poses = read_poses(csv, session.joints);
  ASSERT_EQ(poses.size(), 3u);
  ASSERT_EQ(json["poses"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& pose = json["poses"][i];
    EXPECT_EQ(pose["joints"].get<std::vector<std::string>>(), session.joints);
    EXPECT_EQ(pose["position"].get<std::vector<double>>(),
              std::vector<double>(poses[i].data(), poses[i].data() + poses[i].size()));
    EXPECT_GT(pose["expected_gain"].get<double>(), 0);
    EXPECT_EQ(pose["sigma"].size(), 6u);
  }
}

TEST_F(PlanCommand, RefusesBadInputInASentence) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--count", "0"},
           {"--count", "1000"},
           {"--effects", "joint_ofset"},
           {"--between", "joint_scale"},
           {"--between", "joint_scale,nothing"},
           {"--between", "joint_scale,joint_scale"},
           {"--between", "joint_scale,joint_offset:arm_1.offset=1e-3"},
           {"--count", "many"},
       }) {
    const test::CliResult r = plan_with(arguments);
    EXPECT_EQ(r.exit_code, 2) << arguments[1];
    EXPECT_GE(r.errors.size(), 20u) << arguments[1];
    EXPECT_EQ(r.output, "") << arguments[1];
  }
}

}  // namespace
}  // namespace handsight
