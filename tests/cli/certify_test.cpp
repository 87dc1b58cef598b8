// SPDX-License-Identifier: Apache-2.0
// Certificates and what exports miss, as a user gets them.
#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "cli/cli_runner.h"
#include "robot/posture.h"
#include "robot/urdf.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;
using testing::HasSubstr;

std::string certify_sample(const std::string& name) {
  return std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/" + name;
}

TEST(CertifyCommand, WritesAPdfAndTheSameAsJson) {
  const TemporaryFolder folder;
  const std::string pdf = (folder.path / "c.pdf").string();
  const auto made = run_cli(folder.path, {"certify", certify_sample("hidden_3"), "--effects", "joint_elasticity",
                                          "--out", pdf, "--json", "-"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const auto json = made.json();
  const std::string bytes = test::read_text(pdf);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  EXPECT_THAT(bytes, HasSubstr(json["number"].get<std::string>()));
  for (const auto& file : json["files"]) EXPECT_THAT(bytes, HasSubstr(file["sha256"].get<std::string>()));
  EXPECT_LT(json["after"]["rms_mm"].get<double>(), json["before"]["rms_mm"].get<double>());
  EXPECT_EQ(json["coverage"]["all"], json["per_observation"].size());
  EXPECT_EQ(json["iso9283"]["plan"].size(), 5u);
  EXPECT_FALSE(json["map"]["top"]["cells"].empty());
}

/// A certificate with joint offsets, as JSON.
nlohmann::json certified(const TemporaryFolder& folder, const std::string& session) {
  const std::string pdf = (folder.path / "certificate.pdf").string();
  const auto made =
      run_cli(folder.path, {"certify", session, "--effects", "joint_offset", "--out", pdf, "--json", "-"});
  EXPECT_EQ(made.exit_code, 0) << session << made.errors;
  EXPECT_EQ(test::read_text(pdf).substr(0, 5), "%PDF-");
  return made.json();
}

/// One camera before a board on the hand, and a camera on the hand: what a certificate promises holds for both.
TEST(CertifyCommand, IsOfOneCameraAndOfACameraOnTheHand) {
  const TemporaryFolder folder;
  for (const char* like : {"one_camera_board", "camera_on_hand"}) {
    const std::string session = (folder.path / like).string();
    const auto simulated =
        run_cli(folder.path, {"simulate", "--like", certify_sample(std::string("rigs/") + like), "--out", session,
                              "--observations", "60", "--effect", "joint_offset:axis_3.offset=0.03"});
    ASSERT_EQ(simulated.exit_code, 0) << simulated.errors;
    const auto json = certified(folder, session);
    EXPECT_LT(json["after"]["rms_mm"].get<double>(), 0.5 * json["before"]["rms_mm"].get<double>()) << like;
    EXPECT_EQ(json["coverage"]["all"], 60) << like;
    EXPECT_GE(json["coverage"]["high"].get<double>(), 0.95) << like;
  }
}

/// A laser tracker before an IRB 120, and poses of a board before a camera on a Franka's hand.
TEST(CertifyCommand, IsOfATrackerAndOfASensorOfPoses) {
  const TemporaryFolder folder;
  for (const char* name : {"irb120_some", "fr3_hand_eye_even"}) {
    const auto session = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / name;
    if (!std::filesystem::exists(session)) GTEST_SKIP() << session << " is not there";
    const auto json = certified(folder, session.string());
    EXPECT_LT(json["after"]["rms_mm"].get<double>(), 0.6 * json["before"]["rms_mm"].get<double>()) << name;
    EXPECT_GE(json["coverage"]["high"].get<double>(), 0.95) << name;
  }
}

TEST(CertifyCommand, RefusesWhatItCannotCertify) {
  const TemporaryFolder folder;
  const std::string pdf = (folder.path / "c.pdf").string();
  EXPECT_EQ(run_cli(folder.path, {"certify", certify_sample("hidden_3")}).exit_code, 2) << "no --out";
  EXPECT_EQ(run_cli(folder.path,
                    {"certify", certify_sample("hidden_3"), certify_sample("hidden_3") + "/session.xml", "--out", pdf})
                .exit_code,
            2)
      << "a session is no calibration";
  EXPECT_FALSE(std::filesystem::exists(pdf));
}

/// How far a URDF's link is from where `predict` has the hand, mm, at most over these poses.
double missed_mm(const std::string& urdf, const std::string& link, const Session& session,
                 const nlohmann::json& reported) {
  const Robot robot = parse_urdf(urdf, "calibrated.urdf", nullptr);
  std::vector<int> joints;
  for (const std::string& name : session.joints) joints.push_back(find_joint(robot, name));
  double largest = 0;
  for (std::size_t i = 0; i < reported.size(); ++i) {
    const Eigen::VectorXd& position = session.observations[i].position;
    const Posture p = solve_posture(robot, joint_values(robot, joints, position), session.gravity);
    const Rigid& hand = p.root_from_link.at(static_cast<std::size_t>(find_link(robot, link)));
    Vector3 wanted;
    for (std::size_t r = 0; r < 3; ++r)
      wanted[static_cast<Eigen::Index>(r)] = reported[i]["root_from_tcp_est"][r][3].get<double>();
    largest = std::max(largest, 1e3 * (hand.translation - wanted).norm());
  }
  return largest;
}

/// A camera on the hand, and a model with what no URDF holds: its URDF misses what it says, and far less than the
/// robot.
TEST(ExportCommand, TheUrdfOfAModelWithMoreIsTheBestAndSaysWhatItMisses) {
  const auto field = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/robots/wrist_camera";
  if (!std::filesystem::exists(field)) GTEST_SKIP() << field << " is not there";
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path / name).string(); };
  const std::string robot = (field / "arm.urdf").string();
  ASSERT_EQ(run_cli(folder.path, {"convert", (field / "joints.csv").string(), (field / "target.csv").string(), robot,
                                  "--tcp", "base", "--mount", "tool", "--out", at("s")})
                .exit_code,
            0);
  ASSERT_EQ(run_cli(folder.path, {"fit", at("s"), "--effects", "link_geometry", "encoder_eccentricity:j3+j5",
                                  "transmission_ripple:j2", "--export", at("c.xml")})
                .exit_code,
            0);
  const auto exported = run_cli(folder.path, {"export", at("c.xml"), "--robot", robot, "--as", "urdf", "--out",
                                              at("calibrated.urdf"), "--json", "-"});
  ASSERT_EQ(exported.exit_code, 0) << exported.errors;
  const Session session = read_session(folder.path / "s");
  std::vector<std::string> arguments{"predict", at("c.xml"), "--robot", robot, "--json", "-"};
  for (const Observation& o : session.observations) {
    std::string position;
    for (const double q : o.position) position += fmt::format("{} ", q);
    arguments.insert(arguments.end(), {"--position", position});
  }
  const auto reported = run_cli(folder.path, arguments);
  ASSERT_EQ(reported.exit_code, 0) << reported.errors;
  const auto json = exported.json();
  EXPECT_GT(json["left_mm"].get<double>(), 1e-3);
  EXPECT_LT(json["left_mm"].get<double>(), 0.3 * json["nominal_mm"].get<double>());
  EXPECT_EQ(json["poses"], session.observations.size());
  const std::string urdf = test::read_text(at("calibrated.urdf"));
  EXPECT_NEAR(missed_mm(urdf, "tool", session, reported.json()), json["left_max_mm"].get<double>(), 1e-3);
  EXPECT_THAT(urdf, HasSubstr(fmt::format("{:.3f} mm rms", json["left_mm"].get<double>())));
}

}  // namespace
}  // namespace handsight
