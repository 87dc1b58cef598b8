// SPDX-License-Identifier: Apache-2.0
// Commands take a collection wherever they take a session.
#include <gtest/gtest.h>

#include "base/files.h"
#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using namespace test;
using Json = nlohmann::json;

const std::filesystem::path samples = HANDSIGHT_SOURCE_DIR "/sample_sessions";

/// Two sessions of one robot with one body on its hand; a joint's zero is off in both.
class CollectionCommands : public testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [name, count] : {std::pair{"june", "40"}, {"august", "60"}}) {
      const auto made = run_cli(folder.path, {"simulate", "--like", (samples / "hidden_2").string(), "--out",
                                              (folder.path / name).string(), "--seed", "3", "--observations", count,
                                              "--effect", "joint_offset:" + joint() + ".offset=0.002"});
      ASSERT_EQ(made.exit_code, 0) << made.errors;
    }
    write_text(folder.path / "collection.xml",
               "<handsight_collection version=\"1\" title=\"Two days\">"
               "<session folder=\"june\" body=\"hand\"/><session folder=\"august\" body=\"hand\"/>"
               "</handsight_collection>");
  }
  /// The first joint that the session of the sample names.
  static std::string joint() {
    const std::string text = read_text(samples / "hidden_2" / "session.xml");
    const std::size_t begin = text.find("<joints>") + 8;
    const std::size_t second = text.find(' ', begin) + 1;
    return text.substr(second, text.find(' ', second) - second);
  }
  CliResult run(std::vector<std::string> arguments) { return run_cli(folder.path, arguments); }

  TemporaryFolder folder;
};

TEST_F(CollectionCommands, FitTellsWhatIsEachSessionsOwn) {
  const CliResult r = run({"fit", folder.path.string(), "--effects", "joint_offset:" + joint(), "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const Json json = r.json();
  ASSERT_EQ(json["sessions"].size(), 2U);
  EXPECT_EQ(json["sessions"][0]["title"], "june");
  EXPECT_EQ(json["sessions"][1]["used"], 60);
  EXPECT_TRUE(json["sessions"][1]["held_out_session_pixel"].is_number() ||
              json["sessions"][1]["held_out_session_rms_m"].is_number());
  EXPECT_EQ(json["sessions"][0]["tcp_from_body"], json["sessions"][1]["tcp_from_body"]) << "one body";
  const double offset = json["effects"][0]["parameters"][0]["value"],
               sigma = json["effects"][0]["parameters"][0]["sigma"];
  EXPECT_NEAR(offset, 0.002, 4 * sigma + 1e-4);
}

TEST_F(CollectionCommands, FitTakesSeveralSessions) {
  const std::string june = (folder.path / "june").string(), august = (folder.path / "august").string();
  const Json apart = run({"fit", june, august, "--json", "-"}).json();
  EXPECT_NE(apart["sessions"][0]["tcp_from_body"], apart["sessions"][1]["tcp_from_body"]);
  const Json shared = run({"fit", june, august, "--same-body", june + "," + august, "--json", "-"}).json();
  EXPECT_EQ(shared["sessions"][0]["tcp_from_body"], shared["sessions"][1]["tcp_from_body"]);
  const CliResult wrong = run({"fit", june, august, "--same-body", "july"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("none of the sessions that were given"), std::string::npos) << wrong.errors;
}

TEST_F(CollectionCommands, OneCalibrationIsPredictedFromAndExported) {
  const std::string calibration = (folder.path / "both.xml").string();
  ASSERT_EQ(
      run({"fit", folder.path.string(), "--effects", "joint_offset:" + joint(), "--export", calibration}).exit_code, 0);
  const std::string robot = (folder.path / "june" / "seven_axis.urdf").string();
  const std::string position = "0.1 0.4 0.2 0.3 0.1 0.2 0.1";
  const CliResult from_file =
      run({"predict", calibration, "--robot", robot, "--session", "august", "--position", position, "--json", "-"});
  ASSERT_EQ(from_file.exit_code, 0) << from_file.errors;
  const CliResult from_sessions = run({"predict", folder.path.string(), "--session", "august", "--effects",
                                       "joint_offset:" + joint(), "--position", position, "--json", "-"});
  ASSERT_EQ(from_sessions.exit_code, 0) << from_sessions.errors;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(from_file.json()[0]["root_from_tcp_est"][i][3].get<double>(),
                from_sessions.json()[0]["root_from_tcp_est"][i][3].get<double>(), 1e-9);
  EXPECT_EQ(
      run({"export", calibration, "--robot", robot, "--as", "urdf", "--out", (folder.path / "right.urdf").string()})
          .exit_code,
      0);
  const CliResult none = run({"predict", calibration, "--robot", robot, "--session", "may", "--position", position});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.errors.find("it has june, august"), std::string::npos) << none.errors;
}

TEST_F(CollectionCommands, AMistakeIsThatOfItsSession) {
  // One joint of august counts the other way.
  const std::string mistake = "joint_sense:" + joint(), wrong = (folder.path / "wrong").string();
  ASSERT_EQ(run({"convert", (folder.path / "august").string(), "--fix", mistake, "--out", wrong}).exit_code, 0);
  const std::string june = (folder.path / "june").string();
  const CliResult fitted = run({"fit", june, wrong, "--json", "-"});
  const Json blunders = fitted.json()["blunders"];
  ASSERT_EQ(blunders.size(), 1U) << fitted.errors;
  EXPECT_EQ(blunders[0]["id"], "joint_sense");
  EXPECT_EQ(blunders[0]["where"], joint());
  EXPECT_EQ(blunders[0]["session"], "wrong");
  const CliResult reported = run({"fit", june, wrong});
  EXPECT_NE(reported.output.find("Session wrong: A mistake explains it"), std::string::npos) << reported.output;
  EXPECT_NE(reported.output.find("convert " + wrong + " --fix " + mistake), std::string::npos) << reported.output;
  EXPECT_EQ(run({"fit", folder.path.string(), "--json", "-"}).json()["blunders"], Json::array());
}

TEST_F(CollectionCommands, WhatHasChangedIsTold) {
  const std::string changed = (folder.path / "changed").string(), june = (folder.path / "june").string();
  const std::string august = (folder.path / "august").string();
  ASSERT_EQ(
      run({"simulate", "--like", (samples / "hidden_2").string(), "--out", changed, "--seed", "3", "--observations",
           "50", "--effect", "joint_offset:" + joint() + ".offset=0.002", "--effect", "camera_mount:rx=0.004"})
          .exit_code,
      0);
  const Json three = run({"compare", june, august, changed, "--json", "-"}).json();
  EXPECT_EQ(three["verdict"], "changed") << three["reason"];
  EXPECT_EQ(three["sessions"], Json({"june", "august", "changed"}));
  const Json change = three["changes"][0];
  EXPECT_EQ(change["id"], "camera_mount");
  EXPECT_EQ(change["before"], Json({"june", "august"}));
  EXPECT_EQ(change["after"], Json({"changed"}));
  EXPECT_GT(change["probability"].get<double>(), 0.9);
  EXPECT_NEAR(change["parameters"][3]["value"].get<double>(), 0.004,
              4 * change["parameters"][3]["sigma"].get<double>());
  EXPECT_GT(change["hand_mean_m"].get<double>(), -1e-12);
  const Json two = run({"compare", folder.path.string(), "--json", "-"}).json();
  EXPECT_EQ(two["verdict"], "unchanged") << two["reason"];
  EXPECT_EQ(two["same_rig"], Json({Json::array({"june"}), Json::array({"august"})}));
  EXPECT_EQ(run({"compare", june}).exit_code, 2);
  EXPECT_EQ(run({"compare", june, august, folder.path.string()}).exit_code, 2);
}

TEST_F(CollectionCommands, OtherRobotsAreRefusedWithBothValues) {
  const auto urdf = folder.path / "august" / "seven_axis.urdf";
  std::string text = read_text(urdf);
  const std::size_t at = text.find("<origin xyz=\"", text.find("<joint "));
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 13, "<origin xyz=\"7");
  write_text(urdf, text);
  const CliResult r = run({"fit", folder.path.string()});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_NE(r.errors.find("a collection is of one robot"), std::string::npos) << r.errors;
}

}  // namespace
}  // namespace handsight
