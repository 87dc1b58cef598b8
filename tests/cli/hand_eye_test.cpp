// SPDX-License-Identifier: Apache-2.0
// Hand-eye without a URDF as a user runs it: from two tables of poses to the files that others read.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "cli/cli_runner.h"
#include "geometry/rigid.h"
#include "readers/opencv_storage.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HandEyeCommands : public testing::Test {
 protected:
  HandEyeCommands() {
    std::string flange = "x,y,z,qx,qy,qz,qw\n", target = flange;
    for (int i = 0; i < 14; ++i) {
      const double a = 0.7 * i;
      const Rigid hand{rotation_from_rpy({3.1 + 0.3 * std::sin(a), 0.35 * std::cos(1.3 * a), 0.4 * std::sin(2.1 * a)}),
                       {0.5 + 0.1 * std::sin(a), 0.1 * std::cos(a), 0.5 + 0.05 * std::sin(3 * a)}};
      flange += line(hand);
      target += line(inverse(hand * mount) * board);
    }
    test::write_text(folder.path / "flange.csv", flange);
    test::write_text(folder.path / "target.csv", target);
    made = run_cli(folder.path, {"convert", at("flange.csv"), at("target.csv"), "--out", at("s"), "--sigma", "0.0005",
                                 "--sigma-angle", "0.001"});
  }

  static std::string line(const Rigid& p) {
    const Eigen::Quaterniond q(p.rotation);
    const Vector3& t = p.translation;
    std::string text;
    for (const double n : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      text += (text.empty() ? "" : ",") + std::to_string(n);
    return text + "\n";
  }
  std::string at(const std::string& name) const { return (folder.path / name).string(); }

  TemporaryFolder folder;
  test::CliResult made;
  const Rigid mount{rotation_from_rpy({0.03, -0.05, 1.5}), {0.062, -0.034, 0.047}},
      board{rotation_from_rpy({0.02, 0.03, 0.5}), {0.55, 0.08, 0.01}};
};

TEST_F(HandEyeCommands, SigmasThatAreGivenStandInTheSession) {
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(test::read_text(folder.path / "s/session.xml"), HasSubstr("sigma_angle"));
  EXPECT_THAT(made.errors, Not(HasSubstr("is estimated")));
}

TEST_F(HandEyeCommands, ExportsHoldWhereTheSensorSits) {
  for (const char* kind : {"opencv", "static_tf", "yaml", "csv"}) {
    const auto written = run_cli(folder.path, {"export", at("s"), "--as", kind, "--out", at(kind)});
    ASSERT_EQ(written.exit_code, 0) << kind << written.errors;
  }
  const auto storage = parse_opencv_storage(test::read_text(folder.path / "opencv"), "opencv");
  const std::vector<double>& m = storage.at("mount_from_sensor").numbers;
  ASSERT_EQ(m.size(), 16u);
  for (int r = 0; r < 3; ++r) {
    EXPECT_NEAR(m[static_cast<std::size_t>(4 * r + 3)], mount.translation[r], 1e-4);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(m[static_cast<std::size_t>(4 * r + c)], mount.rotation(r, c), 1e-4);
  }
  EXPECT_THAT(test::read_text(folder.path / "static_tf"), AllOf(HasSubstr("\"flange\""), HasSubstr("\"base\"")));
  EXPECT_THAT(test::read_text(folder.path / "yaml"), HasSubstr("mount_from_sensor"));
  EXPECT_THAT(test::read_text(folder.path / "csv"), HasSubstr("mount_from_sensor,flange,x"));
}

TEST_F(HandEyeCommands, ACalibrationOfItNeedsNoRobot) {
  ASSERT_EQ(run_cli(folder.path, {"fit", at("s"), "--export", at("c.xml")}).exit_code, 0);
  const auto written = run_cli(folder.path, {"export", at("c.xml"), "--as", "static_tf", "--out", at("tf.py")});
  EXPECT_EQ(written.exit_code, 0) << written.errors;
  EXPECT_THAT(test::read_text(folder.path / "tf.py"), HasSubstr("handsight_sensor"));
}

TEST_F(HandEyeCommands, WhatNeedsJointsSaysSo) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"export", at("s"), "--as", "urdf", "--out", at("u")},
                                             {"export", at("s"), "--as", "cpp", "--out", at("u")},
                                             {"correct", at("s"), "--position", "0 0 0 0 0 0"}}) {
    const auto refused = run_cli(folder.path, arguments);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("static_tf"), HasSubstr("joints"))) << arguments[0];
    EXPECT_THAT(refused.errors, Not(HasSubstr("directory")));
  }
}

TEST_F(HandEyeCommands, PredictTellsWhereTheSensorIsForAPoseOfTheFlange) {
  const auto predicted =
      run_cli(folder.path, {"predict", at("s"), "--position", "0.4 -0.1 0.5 3.0 0.2 -0.4", "--json", "-"});
  ASSERT_EQ(predicted.exit_code, 0) << predicted.errors;
  const Rigid wanted = Rigid{rotation_from_rpy({3.0, 0.2, -0.4}), {0.4, -0.1, 0.5}} * mount;
  const auto json = predicted.json()[0];
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_NEAR(json["root_from_body_est"][r][3].get<double>(), wanted.translation[static_cast<Eigen::Index>(r)], 1e-4);
    EXPECT_GT(json["sigma"][r].get<double>(), 0);
    EXPECT_LT(json["sigma"][r].get<double>(), 1e-3);
  }
  EXPECT_THAT(predicted.errors, HasSubstr("taken as the robot tells it"));
}

TEST_F(HandEyeCommands, PredictRefusesBeforeItPrints) {
  for (const std::vector<std::string>& poses : {std::vector<std::string>{}, {"--position", "0.4 -0.1"}}) {
    std::vector<std::string> words{"predict", at("s")};
    words.insert(words.end(), poses.begin(), poses.end());
    const auto refused = run_cli(folder.path, words);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.output, "");
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("--position"), Not(HasSubstr("taken as the robot tells it"))));
  }
  EXPECT_THAT(run_cli(folder.path, {"predict", at("s")}).errors, HasSubstr("x y z roll pitch yaw"));
}

/// Where the sensor sits stands nowhere in the session: what is simulated like it has it where the fit has it.
TEST_F(HandEyeCommands, WhatIsSimulatedHasTheSensorWhereTheFitHasIt) {
  const auto simulated = run_cli(folder.path, {"simulate", "--like", at("s"), "--out", at("like"), "--noise", "1e-5"});
  ASSERT_EQ(simulated.exit_code, 0) << simulated.errors;
  const std::vector<std::string> asked{"--position", "0.4 -0.1 0.5 3.0 0.2 -0.4", "--json", "-"};
  const auto predicted = [&](const std::string& session) {
    std::vector<std::string> words{"predict", at(session)};
    words.insert(words.end(), asked.begin(), asked.end());
    return run_cli(folder.path, words);
  };
  const auto of_it = predicted("like"), of_this = predicted("s");
  ASSERT_EQ(of_it.exit_code, 0) << of_it.errors;
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_NEAR(of_it.json()[0]["root_from_body_est"][r][3].get<double>(),
                of_this.json()[0]["root_from_body_est"][r][3].get<double>(), 2e-4);
}

/// What a mistake leaves is the figure that `fit` begins with, before and once it is put right.
TEST_F(HandEyeCommands, AMistakeIsMeasuredAsFitMeasures) {
  ASSERT_EQ(run_cli(folder.path, {"convert", at("flange.csv"), at("target.csv"), "--eye-on-base", "--out", at("w")})
                .exit_code,
            0);
  const auto wrong = run_cli(folder.path, {"fit", at("w"), "--json", "-"}).json();
  ASSERT_EQ(wrong["blunders"].size(), 1u);
  EXPECT_NEAR(wrong["blunders"][0]["mean_before_m"].get<double>(), wrong["mean_m"].get<double>(), 1e-6);
  const std::string fix = "pose_inverted:" + wrong["blunders"][0]["where"].get<std::string>();
  ASSERT_EQ(run_cli(folder.path, {"convert", at("w"), "--fix", fix, "--out", at("r")}).exit_code, 0);
  const auto right = run_cli(folder.path, {"fit", at("r"), "--json", "-"}).json();
  EXPECT_NEAR(wrong["blunders"][0]["mean_after_m"].get<double>(), right["mean_m"].get<double>(), 1e-6);
  EXPECT_THAT(run_cli(folder.path, {"fit", at("w")}).output, HasSubstr("without it a mean of"));
}

/// Rows in another order: no mistake of a kind explains it, and nothing works.
TEST_F(HandEyeCommands, CheckDoesNotSayThatEverythingWorksWhereRowsOrTurnsAreWrong) {
  EXPECT_THAT(run_cli(folder.path, {"check", at("s")}).output, HasSubstr("Everything in the session works."));
  std::istringstream table(test::read_text(folder.path / "target.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  const std::string head = lines.front() + "\n";
  lines.erase(lines.begin());
  const auto other = [&](std::size_t i) { return lines[5 * i % lines.size()]; };
  // Rows in another order are found out; places of some rows with the turns of others are nobody's poses.
  std::string mixed = head, nobodys = head;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    mixed += other(i) + "\n";
    std::size_t place = 0, turn = 0;
    for (int comma = 0; comma < 3; ++comma) place = lines[i].find(',', place) + 1, turn = other(i).find(',', turn) + 1;
    nobodys += lines[i].substr(0, place) + other(i).substr(turn) + "\n";
  }
  const auto checked = [&](const std::string& name, const std::string& text) {
    test::write_text(folder.path / (name + ".csv"), text);
    EXPECT_EQ(run_cli(folder.path, {"convert", at("flange.csv"), at(name + ".csv"), "--out", at(name)}).exit_code, 0);
    return run_cli(folder.path, {"check", at(name)}).output;
  };
  EXPECT_THAT(checked("mixed", mixed), AllOf(Not(HasSubstr("Everything in the session works.")),
                                             HasSubstr("for 14 of 14 measurements which belongs to which")));
  EXPECT_THAT(checked("nobodys", nobodys),
              AllOf(Not(HasSubstr("Everything in the session works.")), HasSubstr("and its turns only to")));
}

TEST_F(HandEyeCommands, EffectsMayBeNamedWithCommas) {
  const std::string session = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/hidden_3";
  const auto apart =
                 run_cli(folder.path, {"fit", session, "--effects", "joint_elasticity", "joint_offset", "--json", "-"}),
             together =
                 run_cli(folder.path, {"fit", session, "--effects", "joint_elasticity,joint_offset", "--json", "-"});
  ASSERT_EQ(together.exit_code, 0) << together.errors;
  EXPECT_EQ(together.json()["effects"], apart.json()["effects"]);
  const auto wrong = run_cli(folder.path, {"fit", session, "--effects", "joint_elasticity,nonsense"});
  EXPECT_EQ(wrong.exit_code, 2);
}

}  // namespace
}  // namespace handsight
