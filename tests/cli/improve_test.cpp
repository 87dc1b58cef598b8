// SPDX-License-Identifier: Apache-2.0
// `improve` on sessions with known truth: exactly what was hidden is added, and the error falls to the noise.
#include <Eigen/Dense>

#include "base/files.h"
#include "cli/hidden_sessions.h"
#include "geometry/rigid.h"
#include "session/calibration_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using namespace test;

class Improve : public testing::Test {
 protected:
  CliResult run(const std::filesystem::path& session, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"improve", session.string(), "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_cli(folder.path, arguments);
  }
  void expect_found(const std::string& name);
  TemporaryFolder folder;
};

Matrix4 make_matrix(const Json& rows) {
  Matrix4 m;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) m(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  return m;
}

/// tcp_from_body is where it truly is, by its own covariance (chi-squared of 6, 1 in 10,000).
void expect_body(const Json& result, const HiddenTruth& truth) {
  Matrix4 hidden;
  for (int i = 0; i < 16; ++i) hidden(i / 4, i % 4) = truth.tcp_from_body[static_cast<std::size_t>(i)];
  const Json& body = result["tcp_from_body"];
  Eigen::Matrix<double, 6, 6> covariance;
  for (int i = 0; i < 36; ++i)
    covariance(i / 6, i % 6) = body["covariance"][static_cast<std::size_t>(i / 6)][static_cast<std::size_t>(i % 6)];
  const Matrix4 found = make_matrix(body["matrix"]);
  const Vector6 off = small_motion_between(Rigid{hidden.topLeftCorner<3, 3>(), hidden.topRightCorner<3, 1>()},
                                           Rigid{found.topLeftCorner<3, 3>(), found.topRightCorner<3, 1>()});
  EXPECT_LT(off.dot(covariance.inverse() * off), 27.9) << off.transpose();
}

/// The steps add exactly what was hidden, where it was hidden; the held-out error falls at each and ends at the noise.
void Improve::expect_found(const std::string& name) {
  const HiddenTruth truth = hidden_truth(sample_session(name));
  const CliResult result = run(sample_session(name));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const Json r = result.json();
  EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
  const Json& steps = r["steps"];
  ASSERT_EQ(steps.size(), 1 + truth.effects.size()) << steps.dump(1);
  EXPECT_TRUE(steps[0]["added"].is_null());
  Names added;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_LT(steps[i]["held_out_rms_pixel"].get<double>(), steps[i - 1]["held_out_rms_pixel"].get<double>());
    const std::string id = steps[i]["added"];
    ASSERT_EQ(truth.effects.count(id), 1u) << id << " was not hidden";
    expect_where(steps[i]["where"], truth, id);
    added.insert(id);
  }
  EXPECT_EQ(added, truth.ids());
  for (const Json& effect : r["effects"]) expect_values(effect["parameters"], truth, effect["id"]);
  EXPECT_NEAR(r["held_out_rms_pixel"].get<double>(), truth.noise, 0.05 * truth.noise);
  EXPECT_EQ(r["held_out_rms_pixel"], steps.back()["held_out_rms_pixel"]);
  expect_body(r, truth);
}

TEST_F(Improve, Hidden1) { expect_found("hidden_1"); }
TEST_F(Improve, Hidden2NeedsNothing) { expect_found("hidden_2"); }
TEST_F(Improve, Hidden3) { expect_found("hidden_3"); }
TEST_F(Improve, Hidden4) { expect_found("hidden_4"); }
TEST_F(Improve, Hidden5) { expect_found("hidden_5"); }
TEST_F(Improve, Hidden6HasExactlyTwo) { expect_found("hidden_6"); }
TEST_F(Improve, Hidden7AmongWrongCorners) { expect_found("hidden_7"); }

TEST_F(Improve, Hidden8StaysUnexplained) {
  const HiddenTruth truth = hidden_truth(sample_session("hidden_8"));
  const CliResult result = run(sample_session("hidden_8"));
  EXPECT_EQ(result.exit_code, 1);
  const Json r = result.json();
  EXPECT_EQ(r["verdict"], "unexplained") << r["reason"];
  EXPECT_NE(r["reason"].get<std::string>().find(truth.curve_at), std::string::npos) << r["reason"];
  ASSERT_EQ(r["steps"].size(), 2u);
  const Json& step = r["steps"][1];
  EXPECT_EQ(step["added"], "curve_1");
  EXPECT_EQ(step["where"], Json::array({truth.curve_at}));
  EXPECT_EQ(step["variable"], "angle of " + truth.curve_at);
  EXPECT_NE(step["formula"].get<std::string>().find("sin("), std::string::npos) << step["formula"];
  EXPECT_NEAR(r["held_out_rms_pixel"].get<double>(), truth.noise, 0.05 * truth.noise);
  EXPECT_GT(r["left"]["unnamed_share"].get<double>(), 0.9);
  EXPECT_LT(r["left"]["named_share"].get<double>(), 0.1);
  EXPECT_EQ(run(sample_session("hidden_8"), {"--names-only"}).json()["steps"].size(), 1u);
}

/// docs/own_effects.md: the same session with the effect that the page defines, and the export read by `predict`.
TEST_F(Improve, Hidden8WithANameOfOnesOwn) {
  const HiddenTruth truth = hidden_truth(sample_session("hidden_8"));
  const auto session = folder.path / "named";
  std::filesystem::copy(sample_session("hidden_8"), session, std::filesystem::copy_options::recursive);
  const std::string page = read_file(std::string(HANDSIGHT_SOURCE_DIR) + "/docs/own_effects.md");
  const auto first = page.find("<handsight_effects"), last = page.find("</handsight_effects>");
  ASSERT_NE(first, std::string::npos);
  replace_file(session / "effects.xml", page.substr(first, last - first) + "</handsight_effects>\n");
  const auto exported = folder.path / "calibration.xml";
  const CliResult result = run(session, {"--export", exported.string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const Json r = result.json();
  EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
  ASSERT_EQ(r["steps"].size(), 2u);
  EXPECT_EQ(r["steps"][1]["added"], "planet_wave");
  EXPECT_EQ(r["steps"][1]["where"], Json::array({truth.curve_at}));
  const CliResult listed = run_cli(folder.path, {"effects", "--session", session.string()});
  EXPECT_NE(listed.output.find("planet_wave"), std::string::npos);
  EXPECT_NE(read_file(exported).find("sine*sin(3*q)"), std::string::npos);
}

TEST_F(Improve, HasTheKeysOfTheContract) {
  const Json r = run(sample_session("hidden_6")).json();
  for (const char* key : {"converged",
                          "observations",
                          "used",
                          "rejected",
                          "rms_pixel",
                          "rms_m",
                          "mean_m",
                          "max_m",
                          "held_out_rms_pixel",
                          "held_out_rms_m",
                          "held_out_mean_m",
                          "noise_pixel",
                          "noise_estimated_pixel",
                          "chi2_per_dof",
                          "tcp_from_body",
                          "markers",
                          "effects",
                          "per_observation",
                          "steps",
                          "verdict"})
    EXPECT_TRUE(r.contains(key)) << key;
  EXPECT_TRUE(r["converged"].get<bool>());
  EXPECT_EQ(r["per_observation"].size(), 80u);
  EXPECT_EQ(r["markers"].size(), 4u);
  for (const Json& step : r["steps"]) {
    EXPECT_TRUE(step.contains("added"));
    EXPECT_TRUE(step["where"].is_array());
    for (const char* key : {"rms", "held_out_rms", "noise"}) expect_error_twins(step, key, false);
  }
  for (const Json& effect : r["effects"])
    for (const Json& p : effect["parameters"])
      for (const char* key : {"of", "name", "value", "sigma", "unit"}) EXPECT_TRUE(p.contains(key)) << key;
}

TEST_F(Improve, ATrackerSessionIsInMetres) {
  const auto rig = tracker_rig(folder.path);
  const auto session = folder.path / "tracked";
  ASSERT_EQ(run_cli(folder.path, {"simulate", "--like", rig.string(), "--out", session.string(), "--seed", "32",
                                  "--effect", "joint_scale:axis_1.scale=2e-3"})
                .exit_code,
            0);
  const CliResult result = run(session);
  EXPECT_EQ(result.exit_code, 0);
  const Json r = result.json();
  ASSERT_EQ(r["steps"].size(), 2u) << r["steps"].dump(1);
  EXPECT_EQ(r["steps"][1]["added"], "joint_scale");
  for (const Json& step : r["steps"])
    for (const char* key : {"rms", "held_out_rms", "noise"}) expect_error_twins(step, key, true);
  EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
}

/// A steep saturation of the torque and backlash are nearly alike: neither may come and go for the other, step after
/// step.
TEST_F(Improve, ANameAndACurveDoNotTakeTurns) {
  const auto session = folder.path / "s";
  const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/one_camera_board";
  ASSERT_EQ(
      run_cli(folder.path, {"simulate", "--like", like, "--out", session.string(), "--observations", "40", "--seed",
                            "2", "--noise", "1", "--images", "none", "--undeclared", "--wrong-corners", "0.3",
                            "--effect", "backlash:axis_5.gap=0.009881", "joint_offset:axis_5.offset=0.002"})
          .exit_code,
      0);
  const Json r = run(session).json();
  EXPECT_LE(r["steps"].size(), 4u) << r["steps"].dump(1);
  EXPECT_EQ(r["steps"][1]["added"], "backlash");
}

/// Twenty times what is plausible is one fault, however much less surprising two halves of it would be.
TEST_F(Improve, AZeroWrongBySixDegreesIsOneName) {
  const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/six_axis_stand";
  for (const std::string joint : {"axis_2", "axis_3"}) {
    const auto session = folder.path / joint;
    ASSERT_EQ(
        run_cli(folder.path, {"simulate", "--like", like, "--out", session.string(), "--observations", "80", "--seed",
                              "4", "--images", "none", "--effect", "joint_offset:" + joint + ".offset=0.1"})
            .exit_code,
        0);
    const Json r = run(session).json();
    EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
    ASSERT_EQ(r["steps"].size(), 2u) << r["steps"].dump(1);
    EXPECT_EQ(r["steps"][1]["added"], "joint_offset");
    EXPECT_EQ(r["steps"][1]["where"], Json::array({joint}));
    EXPECT_TRUE(r["refused"].empty()) << r["refused"].dump(1);
  }
}

/// Two wrong zeros and a mount that is off: the geometry of several joints can nearly imitate all of them, and alone
/// it is the likelier.
TEST_F(Improve, WhatCouldStandInForSeveralDoesNotComeFirst) {
  const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/six_axis_stand";
  for (const std::string seed : {"5", "7", "12"}) {
    const auto session = folder.path / seed;
    const CliResult made = run_cli(folder.path, {"simulate",
                                                 "--like",
                                                 like,
                                                 "--out",
                                                 session.string(),
                                                 "--seed",
                                                 seed,
                                                 "--images",
                                                 "none",
                                                 "--observations",
                                                 "80",
                                                 "--effect",
                                                 "camera_mount:x=0.002",
                                                 "camera_mount:y=-0.004",
                                                 "camera_mount:z=0.003",
                                                 "camera_mount:rx=0.006",
                                                 "camera_mount:ry=-0.003",
                                                 "camera_mount:rz=-0.005",
                                                 "joint_offset:axis_2.offset=-0.004",
                                                 "joint_offset:axis_3.offset=0.003"});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    const Json r = run(session).json();
    EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
    const HiddenTruth truth = hidden_truth(session);
    Names named;
    for (const Json& e : r["effects"]) {
      named.insert(e["id"]);
      Names where;
      for (const Json& p : e["parameters"])
        if (p["of"].is_string()) where.insert(p["of"]);
      EXPECT_EQ(where, truth.effects.at(e["id"])) << seed;
      expect_values(e["parameters"], truth, e["id"]);
    }
    EXPECT_EQ(named, truth.ids()) << seed;
    for (const Json& refused : r["refused"]) EXPECT_FALSE(named.count(refused["id"])) << refused.dump();
    ASSERT_EQ(r["steps"].size(), 3U) << r["steps"].dump(1);
    EXPECT_EQ(r["steps"][1]["added"], "camera_mount") << seed;
    EXPECT_EQ(r["steps"][2]["added"], "joint_offset") << seed;
  }
}

TEST_F(Improve, WhatWasComputedWithoutNoiseHasItsNamesAndIsAdequate) {
  const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/six_axis_stand";
  for (const std::string seed : {"3", "4", "5"}) {
    const auto session = folder.path / seed;
    ASSERT_EQ(run_cli(folder.path, {"simulate", "--like", like, "--out", session.string(), "--seed", seed, "--images",
                                    "none", "--observations", "60", "--noise", "0", "--effect",
                                    "joint_offset:axis_2.offset=1e-3", "joint_scale:axis_4.scale=0.001"})
                  .exit_code,
              0);
    const Json r = run(session).json();
    EXPECT_EQ(r["verdict"], "adequate") << r["reason"];
    Names named;
    for (const Json& e : r["effects"]) named.insert(e["id"]);
    EXPECT_EQ(named, (Names{"joint_offset", "joint_scale"})) << seed;
  }
}

TEST_F(Improve, EightObservationsAreTooFew) {
  ASSERT_EQ(simulate(folder.path, "few", "six_axis_stand",
                     {"--observations", "8", "--seed", "52", "--effect", "joint_offset:axis_2.offset=0.01"})
                .exit_code,
            0);
  const CliResult result = run(folder.path / "few");
  EXPECT_EQ(result.exit_code, 1);
  const Json r = result.json();
  EXPECT_EQ(r["verdict"], "too_few_observations");
  for (const Json& step : r["steps"]) EXPECT_TRUE(step["added"].is_null()) << step.dump();
}

TEST_F(Improve, TheExportIsTheLastModelBitForBit) {
  const auto file = folder.path / "calibration.xml";
  const CliResult result = run(sample_session("hidden_5"), {"--export", file.string()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const Json r = result.json();
  const Calibration calibration = read_calibration(file);
  EXPECT_EQ(matrix_from_rigid(calibration.tcp_from_body.motion), make_matrix(r["tcp_from_body"]["matrix"]));
  const std::string text = read_text(file);
  ASSERT_FALSE(r["effects"].empty());
  for (const Json& effect : r["effects"]) {
    EXPECT_NE(text.find("id=\"" + effect["id"].get<std::string>() + "\""), std::string::npos);
    for (const Json& p : effect["parameters"])
      EXPECT_NE(text.find("value=\"" + format_number(p["value"].get<double>()) + "\""), std::string::npos) << p.dump();
  }
}

/// A plate is read along one direction: what noise makes of an error there is less than of a point's three coordinates.
TEST_F(Improve, TheNoiseBesideAnErrorOfTouchesIsTheVerdictsOwn) {
  const Json r = run(sample_session("probe_and_plate")).json();
  const double noise = r["left"]["story"]["noise"], of_a_coordinate = r["steps"].back()["noise_m"];
  EXPECT_GT(noise, of_a_coordinate);
  EXPECT_LT(noise, 1.5 * of_a_coordinate);
  EXPECT_EQ(r["steps"].back()["noise_rms_m"], noise);
}

TEST_F(Improve, TheFitOfWhatItAddedIsTheSame) {
  const Json improved = run(sample_session("hidden_1")).json();
  EXPECT_EQ(improved.at("inclusion_probabilities"), improved.at("certainty")) << "its older name";
  const CliResult fitted = run_cli(folder.path, {"fit", sample_session("hidden_1").string(), "--effects",
                                                 "encoder_eccentricity:axis_2", "--json", "-"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.errors;
  const Json fit = fitted.json();
  EXPECT_NEAR(improved["held_out_rms_pixel"].get<double>(), fit["held_out_rms_pixel"].get<double>(), 1e-4);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json &a = improved["effects"][0]["parameters"][i], &b = fit["effects"][0]["parameters"][i];
    EXPECT_EQ(a["name"], b["name"]);
    EXPECT_NEAR(a["value"].get<double>(), b["value"].get<double>(), 0.01 * b["sigma"].get<double>());
  }
}

TEST_F(Improve, LeavesTheSessionAsItIs) {
  const auto session = folder.path / "mine";
  std::filesystem::copy(sample_session("hidden_1"), session, std::filesystem::copy_options::recursive);
  const std::string before = read_text(session / "session.xml");
  ASSERT_EQ(run(session).exit_code, 0);
  EXPECT_EQ(read_text(session / "session.xml"), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(session), std::filesystem::directory_iterator()), 3);
}

/// What explains everything is the end, however much time there is.
TEST_F(Improve, ThoroughOnesStopWhereAllIsExplained) {
  const Json quick = run(sample_session("hidden_3")).json(),
             thorough = run(sample_session("hidden_3"), {"--thorough"}).json();
  EXPECT_EQ(thorough["steps"], quick["steps"]);
  EXPECT_EQ(thorough["models"]["tried"], quick["models"]["tried"]);
  EXPECT_EQ(thorough["models"]["most"], 400);
}

}  // namespace
}  // namespace handsight
