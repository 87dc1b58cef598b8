// SPDX-License-Identifier: Apache-2.0
// `convert` of two hands on the command line: what may be said twice, and what comes of it.
#include <gmock/gmock.h>

#include <random>

#include "chain/chain.h"
#include "cli/cli_runner.h"
#include "fixtures/robot_texts.h"
#include "fixtures/two_arms.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;
using test::write_text;
using testing::AllOf;
using testing::HasSubstr;

/// Joint readings of both arms, and the poses of a tag on each hand as a camera in the head tells them.
class ConvertTwoHands : public testing::Test {
 protected:
  ConvertTwoHands() {
    const Robot robot = fixture::two_armed_robot();
    write_text(folder.path / "robot.urdf", fixture::urdf_text(robot));
    std::string joints;
    for (const Joint& joint : robot.joints) joints += (joints.empty() ? "" : ",") + joint.name;
    std::string tags[2] = {"x,y,z,qx,qy,qz,qw\n", "x,y,z,qx,qy,qz,qw\n"};
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> share(-0.7, 0.7);
    joints += "\n";
    for (int i = 0; i < 25; ++i) {
      std::vector<double> q;
      for (const Joint& joint : robot.joints) q.push_back(share(random) * joint.upper);
      joints += fmt::format("{}\n", fmt::join(q, ","));
      for (const int side : {0, 1}) tags[side] += line(seen(fixture::head_session(side ? 'r' : 'l'), robot, q) * tag);
    }
    write_text(folder.path / "joints.csv", joints);
    write_text(folder.path / "left_hand.csv", tags[0]);
    write_text(folder.path / "right_hand.csv", tags[1]);
  }

  static Rigid seen(const Session& s, const Robot& robot, const std::vector<double>& all) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(s.joints.size()));
    for (std::size_t j = 0; j < s.joints.size(); ++j)
      q[static_cast<Eigen::Index>(j)] = all[static_cast<std::size_t>(find_joint(robot, s.joints[j]))];
    return sensor_from_tcp(chain_ends(make_chain(s), q), s.mount.mount_from_sensor);
  }

  static std::string line(const Rigid& p) {
    const Eigen::Quaterniond q(p.rotation);
    const Vector3& t = p.translation;
    return fmt::format("{},{},{},{},{},{},{}\n", t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }

  std::string at(const std::string& name) const { return (folder.path / name).string(); }

  test::CliResult convert(std::vector<std::string> more) {
    std::vector<std::string> all{"convert",        at("joints.csv"), at("left_hand.csv"), at("right_hand.csv"),
                                 at("robot.urdf"), "--out",          at("both")};
    all.insert(all.end(), more.begin(), more.end());
    return run_cli(folder.path, all);
  }

  TemporaryFolder folder;
  const Rigid tag{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
};

TEST_F(ConvertTwoHands, BecomeACollectionThatFits) {
  const auto made = convert({"--tcp", "left_hand", "--tcp", "right_hand", "--mount", "head", "--one-sensor", "--sigma",
                             "0.0005", "--sigma-angle", "0.001", "--json", "-"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const nlohmann::json json = made.json();
  ASSERT_EQ(json["sessions"].size(), 2U);
  EXPECT_EQ(json["sessions"][0]["title"], "left_hand");
  EXPECT_EQ(json["sessions"][1]["rig"], "head");
  EXPECT_EQ(json["sessions"][1]["observations"], 25);
  const auto fitted = run_cli(folder.path, {"fit", at("both"), "--json", "-"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.errors;
  for (const auto& one : fitted.json()["sessions"])
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(one["tcp_from_body"]["matrix"][i][3].get<double>(), tag.translation[i], 1e-5);
  EXPECT_EQ(run_cli(folder.path, {"check", at("both")}).exit_code, 0);
  const auto again = convert({"--tcp", "left_hand", "--tcp", "right_hand"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("there is a collection.xml already"));
}

TEST_F(ConvertTwoHands, SayWhatIsMadeToPeople) {
  const auto made = convert({"--tcp", "left_hand", "--tcp", "right_hand", "--title", "Both hands"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(made.output, AllOf(HasSubstr("both/left_hand: 25 observations"), HasSubstr("both/right_hand: 25"),
                                 HasSubstr("Next: handsight-cli check ")));
  EXPECT_THAT(made.errors, HasSubstr("No two sessions have one sensor at one place"));
  EXPECT_THAT(test::read_text(folder.path / "both/collection.xml"), HasSubstr("title=\"Both hands\""));
}

TEST_F(ConvertTwoHands, OptionsThatDoNotFitTogetherAreRefused) {
  const auto refusal = [&](const std::vector<std::string>& more) {
    const auto r = convert(more);
    EXPECT_EQ(r.exit_code, 2) << r.output;
    EXPECT_FALSE(std::filesystem::exists(folder.path / "both")) << r.errors;
    return r.errors;
  };
  EXPECT_THAT(
      refusal({"--tcp", "left_hand", "--tcp", "right_hand", "--mount", "head", "--mount", "chest", "--mount", "base"}),
      HasSubstr("--tcp is given 2 times and --mount 3 times"));
  EXPECT_THAT(refusal({"--tcp", "left_hand", "--tcp", "left_hand"}), HasSubstr("would be the same"));
  EXPECT_THAT(refusal({"--tcp", "left_hand", "--tcp", "gripper"}),
              HasSubstr("Session \"left_hand\": There are 2 things with poses"));
  EXPECT_THAT(refusal({"--tcp", "left_hand", "--one-sensor"}), HasSubstr("--one-sensor is of a collection"));
  EXPECT_THAT(refusal({"--tcp", "left_hand", "--target-frame", "left_hand", "--camera", "/head/"}),
              HasSubstr("no bag is among the files"));
}

}  // namespace
}  // namespace handsight
