// SPDX-License-Identifier: Apache-2.0
// The command line's main job on the sample sessions, compared with their truth.
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <Eigen/Dense>
#include <map>

#include "base/numbers.h"
#include "chain/body_frame.h"
#include "cli/cli_runner.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;

std::filesystem::path sample(const std::string& name) {
  return std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name;
}

std::vector<double> numbers(const char* text) { return *parse_numbers(text); }

struct Truth {
  std::vector<Vector3> markers_in_tcp;
  Rigid tcp_from_body() const {
    return body_frame(choose_sides({markers_in_tcp.begin(), markers_in_tcp.end()}), markers_in_tcp).tcp_from_body;
  }
};

Truth load_truth(const std::filesystem::path& session) {
  tinyxml2::XMLDocument document;
  document.LoadFile((session / "truth.xml").c_str());
  Truth truth;
  for (auto* m = document.RootElement()->FirstChildElement("markers_in_tcp")->FirstChildElement(); m;
       m = m->NextSiblingElement()) {
    const auto n = numbers(m->Attribute("xyz"));
    truth.markers_in_tcp.emplace_back(n[0], n[1], n[2]);
  }
  return truth;
}

Matrix4 make_matrix(const nlohmann::json& rows) {
  Matrix4 m;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) m(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  return m;
}

class Story : public testing::Test {
 protected:
  std::filesystem::path make_copy(const std::string& name) {
    const auto copy = folder.path / name;
    std::filesystem::copy(sample(name), copy, std::filesystem::copy_options::recursive);
    return copy;
  }
  std::vector<std::string> clicks(const std::string& name) {
    // The sample's README names them; here they come from the same place: the command that `simulate` printed.
    if (name == "first_steps") return {"421,338", "408,411", "473,378"};
    return {"519,98", "515,132", "576,113"};
  }
  test::CliResult label(const std::filesystem::path& session, const std::string& name) {
    std::vector<std::string> arguments = {"label", session.string(), "--observation", "0", "--left"};
    for (const std::string& click : clicks(name)) arguments.push_back(click);
    return run_cli(folder.path, arguments);
  }
  TemporaryFolder folder;
};

TEST_F(Story, FirstStepsFromImagesToACalibration) {
  const auto session = make_copy("first_steps");
  ASSERT_EQ(label(session, "first_steps").exit_code, 0);
  const auto online = run_cli(folder.path, {"online", session.string(), "--save", "--json", "-"});
  ASSERT_EQ(online.exit_code, 0) << online.errors;
  std::istringstream lines(online.output);
  std::string line;
  int accepted = 0;
  nlohmann::json last;
  while (std::getline(lines, line)) {
    last = nlohmann::json::parse(line);
    for (const char* key : {"id", "state", "reason", "milliseconds", "tcp_from_body", "sigma", "tcp_from_tcp_est"})
      EXPECT_TRUE(last.contains(key)) << key;
    accepted += last["state"] == "accepted" ? 1 : 0;
  }
  EXPECT_EQ(accepted, 12);

  const auto calibration_file = folder.path / "calibration.xml";
  const auto fit =
      run_cli(folder.path, {"fit", session.string(), "--json", "-", "--export", calibration_file.string()});
  ASSERT_EQ(fit.exit_code, 0) << fit.errors;
  const auto result = fit.json();
  for (const char* key :
       {"converged", "observations", "used", "rejected", "rms_pixel", "rms_m", "mean_m", "max_m", "held_out_rms_pixel",
        "held_out_rms_m", "held_out_mean_m", "noise_pixel", "noise_estimated_pixel", "chi2_per_dof", "tcp_from_body",
        "markers", "effects", "per_observation"})
    EXPECT_TRUE(result.contains(key)) << key;
  const Calibration calibration = read_calibration(calibration_file);
  EXPECT_EQ(matrix_from_rigid(calibration.tcp_from_body.motion),
            make_matrix(result["tcp_from_body"]["matrix"]));  // bit for bit

  const Vector6 error = small_motion_between(load_truth(session).tcp_from_body(), calibration.tcp_from_body.motion);
  EXPECT_LT(error.dot(calibration.tcp_from_body.covariance.inverse() * error), 27.9);  // chi-squared of 6, 1 in 10,000
  EXPECT_LT(error.head<3>().norm(), 1e-4);
  for (int i = 0; i < 6; ++i)  // what online said last is what the batch fit says
    EXPECT_NEAR(last["tcp_from_body"][static_cast<std::size_t>(i)].get<double>(),
                i < 3 ? calibration.tcp_from_body.motion.translation[i]
                      : rpy_from_rotation(calibration.tcp_from_body.motion.rotation)[i - 3],
                1e-3 * last["sigma"][static_cast<std::size_t>(i)].get<double>() + 1e-9);
}

TEST_F(Story, HundredPosesTakesAllButTheThreeBadOnes) {
  const auto session = make_copy("hundred_poses");
  ASSERT_EQ(label(session, "hundred_poses").exit_code, 0);
  const auto online = run_cli(folder.path, {"online", session.string(), "--save"});
  ASSERT_EQ(online.exit_code, 0);
  for (const Observation& o : read_session(session).observations) {
    const bool bad = o.id == 58 || o.id == 75 || o.id == 98;
    EXPECT_EQ(o.decision, bad ? Decision::rejected : Decision::accepted) << o.id << ": " << o.reason;
    EXPECT_EQ(o.reason.empty(), !bad) << o.id;
  }
}

TEST_F(Story, SavingKeepsWhatIsNotUnderstood) {
  const auto session = make_copy("first_steps");
  std::string text = test::read_text(session / "session.xml");
  text.insert(text.find("<markers"), "<lighting lamp=\"left\">dim</lighting>\n  ");
  test::write_text(session / "session.xml", text);
  ASSERT_EQ(label(session, "first_steps").exit_code, 0);
  EXPECT_NE(test::read_text(session / "session.xml").find("<lighting lamp=\"left\">dim</lighting>"), std::string::npos);
}

TEST_F(Story, ARefusedLabelChangesNothing) {
  const auto session = make_copy("first_steps");
  const std::string before = test::read_text(session / "session.xml");
  const auto result =
      run_cli(folder.path, {"label", session.string(), "--observation", "0", "--left", "5,5", "408,411", "473,378"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.errors.find("Marker 0: no corner within"), std::string::npos) << result.errors;
  EXPECT_EQ(test::read_text(session / "session.xml"), before);
}

TEST_F(Story, PredictFromSessionAndFromCalibrationAgree) {
  const auto session = sample("thesis_simulation");
  const auto calibration = folder.path / "calibration.xml";
  ASSERT_EQ(run_cli(folder.path, {"fit", session.string(), "--export", calibration.string()}).exit_code, 0);
  const std::string position = "0.1 -0.2 0.5 -0.6 -0.9 0.2 1.4 0 0.2 0.4 -0.3 0.4";
  const auto from_session = run_cli(folder.path, {"predict", session.string(), "--position", position, "--json", "-"});
  const auto from_file =
      run_cli(folder.path, {"predict", calibration.string(), "--robot", (session / "justin.urdf").string(),
                            "--position", position, "--json", "-"});
  ASSERT_EQ(from_session.exit_code, 0) << from_session.errors;
  ASSERT_EQ(from_file.exit_code, 0) << from_file.errors;
  EXPECT_EQ(from_session.json()[0]["root_from_tcp_est"], from_file.json()[0]["root_from_tcp_est"]);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(from_session.json()[0]["sigma"][i].get<double>(), from_file.json()[0]["sigma"][i].get<double>(), 1e-9);
  EXPECT_EQ(run_cli(folder.path, {"predict", calibration.string(), "--position", position}).exit_code, 2);  // no robot
}

TEST_F(Story, EffectiveMassDetectEffectsAndSimulateRun) {
  EXPECT_EQ(run_cli(folder.path, {"effective-mass", sample("thesis_simulation").string(), "--json", "-"})
                .json()["observations"]
                .size(),
            6u);
  const auto images = sample("first_steps") / "images";
  const auto detect =
      run_cli(folder.path, {"detect", (images / "000_left.png").string(), (images / "000_right.png").string(),
                            "--session", sample("first_steps").string(), "--json", "-"});
  ASSERT_EQ(detect.exit_code, 0) << detect.errors;
  EXPECT_GE(detect.json()["pairs"].size(), 3u);
  const auto effects = run_cli(folder.path, {"effects", "--json", "-"}).json();
  EXPECT_GE(effects.size(), 1u);
  const std::map<std::string, std::string> scopes = {{"joint_offset", "joint"},
                                                     {"mimic_error", "mimic_joint"},
                                                     {"marker_slip", "marker"},
                                                     {"rig", "camera"},
                                                     {"payload", "session"}};
  std::size_t reported = 0;
  for (const auto& e : effects)
    if (const auto scope = scopes.find(e["id"]); scope != scopes.end()) {
      EXPECT_EQ(e["scope"], scope->second);
      ++reported;
    }
  EXPECT_EQ(reported, scopes.size());
  const auto out = folder.path / "made";
  const std::vector<std::string> arguments = {"simulate",
                                              "--like",
                                              sample("first_steps").string(),
                                              "--robot",
                                              (sample("first_steps") / "justin.urdf").string(),
                                              "--effect",
                                              "joint_elasticity:right_arm_2.compliance=1e-4",
                                              "--observations",
                                              "5",
                                              "--seed",
                                              "3",
                                              "--out",
                                              out.string()};
  ASSERT_EQ(run_cli(folder.path, arguments).exit_code, 0);
  EXPECT_EQ(read_session(out).observations.size(), 5u);
  const std::string text = test::read_text(out / "session.xml");
  EXPECT_EQ(run_cli(folder.path, arguments).exit_code, 2);  // it is there already: never overwritten
  std::filesystem::remove_all(out);
  ASSERT_EQ(run_cli(folder.path, arguments).exit_code, 0);
  EXPECT_EQ(test::read_text(out / "session.xml"), text);  // one seed, one session
}

TEST_F(Story, ForeignSessionsFitToTheirTruth) {
  const std::filesystem::path shared(HANDSIGHT_SHARED_DIR);
  const auto foreign = shared / "examples" / "nothing_hidden";
  if (!std::filesystem::exists(foreign)) GTEST_SKIP() << "the foreign sessions are not here";
  const auto result = run_cli(folder.path, {"fit", foreign.string(), "--json", "-"}).json();
  const auto truth = nlohmann::json::parse(test::read_text(foreign / "truth.json"));
  std::vector<Vector3> markers;
  for (const auto& m : truth["tcp_from_markers"]) markers.emplace_back(m[0], m[1], m[2]);
  const Matrix4 matrix = make_matrix(result["tcp_from_body"]["matrix"]);
  const Rigid found{matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
  const Vector6 error =
      small_motion_between(body_frame(choose_sides({markers.begin(), markers.end()}), markers).tcp_from_body, found);
  Matrix6 covariance;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      covariance(r, c) =
          result["tcp_from_body"]["covariance"][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  EXPECT_LT(error.dot(covariance.inverse() * error), 22.5);  // chi-squared of 6, 1 in 1000
  EXPECT_NEAR(result["noise_pixel"].get<double>(), 0.2, 0.02);
}

TEST_F(Story, JustinsRealMeasurementsGiveTheKnownRigidError) {
  const auto real = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / "justin_right_even";
  if (!std::filesystem::exists(real)) GTEST_SKIP() << "the real measurements are not here";
  const auto result = run_cli(folder.path, {"fit", real.string(), "--json", "-"}).json();
  EXPECT_NEAR(result["mean_m"].get<double>(), 0.02047, 5e-5);  // a plain reference gives 20.47 mm
}

}  // namespace
}  // namespace handsight
