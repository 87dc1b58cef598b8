// SPDX-License-Identifier: Apache-2.0
// Commands with sessions of touches: alone, and in a collection beside a tracker's.
#include <gtest/gtest.h>

#include <fstream>

#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using namespace test;
using Json = nlohmann::json;

const std::filesystem::path samples = HANDSIGHT_SOURCE_DIR "/sample_sessions";

class TouchCommands : public testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [rig, name] : {std::pair{"six_axis_touch", "touches"}, {"six_axis_tracker", "tracker"}}) {
      const auto made = run({"simulate", "--like", (samples / "rigs" / rig).string(), "--out", at(name), "--seed", "3",
                             "--observations", "50", "--effect", "joint_offset:axis_2.offset=0.002"});
      ASSERT_EQ(made.exit_code, 0) << made.errors;
    }
    write_text(folder.path / "collection.xml",
               "<handsight_collection version=\"1\" title=\"Touch and tracker\">"
               "<session folder=\"touches\"/><session folder=\"tracker\"/></handsight_collection>");
  }
  std::string at(const std::string& name) const { return (folder.path / name).string(); }
  CliResult run(std::vector<std::string> arguments) { return run_cli(folder.path, arguments); }

  TemporaryFolder folder;
};

TEST_F(TouchCommands, CheckTellsWhatIsTouched) {
  const CliResult r = run({"check", at("touches")});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  EXPECT_NE(r.output.find("Fixture socket_left on stand, a point: 10 touches"), std::string::npos) << r.output;
  EXPECT_EQ(r.output.find("tracker"), std::string::npos) << r.output;
}

TEST_F(TouchCommands, NoFigureStandsBesideWhatTheyDoNotDetermine) {
  std::ifstream all(samples / "probe_and_plate" / "touches.csv");
  std::string table, line;
  for (int i = 0; i < 6 && std::getline(all, line); ++i) table += line + "\n";
  write_text(folder.path / "five.csv", table);
  const CliResult made = run({"convert", at("five.csv"), "--robot", (samples / "robots" / "six_axis.urdf").string(),
                              "--tcp", "hand", "--fixture", "plane plate_front", "--out", at("five")});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const CliResult r = run({"fit", at("five")});
  EXPECT_EQ(r.output.find("+- 0.0000"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("not determined, left at its start"), std::string::npos) << r.output;
}

TEST_F(TouchCommands, WhatIsToBeTouchedNextIsSaidWhereTheTipIsNotDetermined) {
  const auto made = run({"simulate", "--like", (samples / "rigs" / "six_axis_touch").string(), "--out", at("six"),
                         "--seed", "3", "--observations", "6"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  for (const char* command : {"fit", "diagnose"}) {
    const CliResult r = run({command, at("six")});
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_NE(r.errors.find("2 of its 3 numbers"), std::string::npos) << r.errors;
    EXPECT_NE(r.errors.find("plate_left (+2)"), std::string::npos) << r.errors;
  }
  EXPECT_NE(run({"check", at("six")}).output.find("plate_left (+2)"), std::string::npos);
}

TEST_F(TouchCommands, APlateTouchedTwiceHasNoFigures) {
  const auto made = run({"simulate", "--like", (samples / "rigs" / "six_axis_touch").string(), "--out", at("twice"),
                         "--seed", "3", "--observations", "12"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const CliResult r = run({"fit", at("twice"), "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const Json json = r.json();
  const Json& left = json["fixtures"][1];
  EXPECT_EQ(left["title"], "plate_left");
  EXPECT_TRUE(left["place"].is_null());
  EXPECT_TRUE(left["held_out_rms_m"].is_null()) << "without the fold nothing says where it stands";
  EXPECT_TRUE(json["fixtures"][0]["place"].is_object());
  const Json& named = json["undetermined"].back();
  EXPECT_EQ(named["of"], "plate_left");
  const std::string text = run({"fit", at("twice")}).output;
  EXPECT_NE(text.find("plate_left is not determined by these touches"), std::string::npos) << text;
  EXPECT_NE(text.find("plate_left (+1)"), std::string::npos) << text;
}

TEST_F(TouchCommands, AZeroThatTouchesCannotTellHasNoFigure) {
  const CliResult r = run({"fit", at("touches"), "--effects", "joint_offset", "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  for (const Json& parameter : r.json()["effects"][0]["parameters"]) {
    const bool is_hidden = parameter["of"] == "axis_1" || parameter["of"] == "axis_6";
    EXPECT_EQ(parameter["value"].is_null(), is_hidden) << parameter;
    EXPECT_EQ(parameter["sigma"].is_null(), is_hidden) << parameter;
  }
  const std::string text = run({"fit", at("touches"), "--effects", "joint_offset"}).output;
  EXPECT_NE(text.find("not determined by these touches"), std::string::npos) << text;
  EXPECT_NE(text.find("The zero of axis_1 and axis_6 cannot be known"), std::string::npos) << text;
}

/// A model that misses by 8 mm does not make known what touches cannot tell.
TEST_F(TouchCommands, WhatTouchesCannotTellDoesNotDependOnHowWellTheModelFits) {
  const std::string panda = (samples / "panda_sockets").string();
  for (const std::vector<std::string>& effects : {std::vector<std::string>{}, {"--effects", "link_geometry"}}) {
    std::vector<std::string> arguments = {"fit", panda};
    arguments.insert(arguments.end(), effects.begin(), effects.end());
    const std::string text = run(arguments).output;
    EXPECT_NE(text.find("The zero of panda_joint1 and panda_joint7 cannot be known"), std::string::npos) << text;
  }
}

TEST_F(TouchCommands, AsManyNumbersAsAreAskedForTellNoAccuracy) {
  std::ifstream all(samples / "probe_and_plate" / "touches.csv");
  std::string table, line;
  for (int i = 0; i < 7 && std::getline(all, line); ++i) table += line + "\n";
  write_text(folder.path / "six.csv", table);
  ASSERT_EQ(run({"convert", at("six.csv"), "--robot", (samples / "robots" / "six_axis.urdf").string(), "--tcp", "hand",
                 "--fixture", "plane plate_front", "--out", at("six")})
                .exit_code,
            0);
  const CliResult r = run({"fit", at("six")});
  EXPECT_EQ(r.output.find("+- 0.000"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("how exactly is not known"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("unknown mean held out"), std::string::npos) << r.output;
}

TEST_F(TouchCommands, PlanNamesTheFixture) {
  const CliResult r = run({"plan", at("touches"), "--count", "3", "--effects", "joint_offset:axis_2", "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const Json json = r.json();
  ASSERT_EQ(json["poses"].size(), 3U);
  for (const Json& pose : json["poses"]) {
    EXPECT_TRUE(pose["fixture"].is_string());
    EXPECT_GT(pose["expected_gain"].get<double>(), 0);
  }
}

TEST_F(TouchCommands, ACollectionHoldsThemBesideATracker) {
  const CliResult r = run({"fit", folder.path.string(), "--effects", "joint_offset:axis_2", "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const Json json = r.json();
  ASSERT_EQ(json["sessions"].size(), 6U) << "five fixtures and a tracker";
  EXPECT_EQ(json["sessions"][0]["title"], "touches plate_front");
  EXPECT_EQ(json["sessions"][5]["title"], "tracker");
  const Json& parameter = json["effects"][0]["parameters"][0];
  EXPECT_NEAR(parameter["value"].get<double>(), 2e-3, 4 * parameter["sigma"].get<double>());
}

TEST_F(TouchCommands, WhatCannotBeCertifiedSaysWhy) {
  const CliResult alone = run({"certify", at("touches"), "--out", at("c.pdf")});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.errors.find("a touch tells one to three numbers"), std::string::npos) << alone.errors;
  const CliResult named =
      run({"certify", folder.path.string(), "--session", "touches plate_front", "--out", at("c.pdf")});
  EXPECT_EQ(named.exit_code, 2) << named.output;
  EXPECT_FALSE(std::filesystem::exists(at("c.pdf")));
}

TEST_F(TouchCommands, ARepeatedSimulationIsTheSame) {
  ASSERT_EQ(run({"simulate", "--like", (samples / "rigs" / "six_axis_touch").string(), "--out", at("again"), "--seed",
                 "3", "--observations", "50", "--effect", "joint_offset:axis_2.offset=0.002"})
                .exit_code,
            0);
  EXPECT_EQ(read_text(folder.path / "touches" / "session.xml"), read_text(folder.path / "again" / "session.xml"));
}

TEST_F(TouchCommands, ThreeAreComparedEachWithTheOneBefore) {
  const auto made = run({"simulate", "--like", (samples / "rigs" / "six_axis_touch").string(), "--out", at("later"),
                         "--seed", "3", "--observations", "50", "--effect", "joint_offset:axis_2.offset=0.004"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  std::filesystem::copy(at("touches"), at("again"), std::filesystem::copy_options::recursive);
  const CliResult r = run({"compare", at("touches"), at("again"), at("later"), "--json", "-"});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const Json steps = r.json()["steps"];
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0]["verdict"], "unchanged");
  ASSERT_FALSE(steps[1]["changes"].empty());
  EXPECT_EQ(steps[1]["changes"][0]["id"], "joint_offset");
  EXPECT_EQ(run({"compare", at("touches"), at("again"), at("tracker")}).exit_code, 2);
}

TEST_F(TouchCommands, ADistanceThatTheTouchesContradictIsNamed) {
  EXPECT_TRUE(run({"fit", at("touches"), "--effects", "joint_offset:axis_2", "--json", "-"})
                  .json()["doubtful_distance"]
                  .is_null());
  const std::filesystem::path file = folder.path / "touches" / "session.xml";
  std::string text = read_text(file);
  const std::size_t by = text.find("by=\"", text.find("<apart")) + 4;
  text.replace(by, text.find('"', by) - by, "0.25");
  write_text(file, text);
  const CliResult r = run({"fit", at("touches"), "--effects", "joint_offset:axis_2", "--json", "-"});
  const Json doubt = r.json()["doubtful_distance"];
  ASSERT_TRUE(doubt.is_object()) << r.output;
  EXPECT_EQ(doubt["by"], 0.25);
  EXPECT_NE(run({"check", at("touches")}).output.find("The touches contradict"), std::string::npos);
}

}  // namespace
}  // namespace handsight
