// SPDX-License-Identifier: Apache-2.0
// What must not happen: a crash, a file that is lost, an answer that did not arrive and is called one.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>

#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using test::CliResult;
using test::read_text;
using test::run_cli;
using test::write_text;

fs::path whole_sample(const std::string& name) { return fs::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name; }

class HardToBreak : public testing::Test {
 protected:
  CliResult run(const std::vector<std::string>& arguments) { return run_cli(folder.path, arguments); }

  /// A small simulated session of the six-axis arm.
  fs::path simulated(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"simulate", "--like", whole_sample("rigs/six_axis_stand").string(), "--out",
                                          (folder.path / name).string()};
    if (std::find(more.begin(), more.end(), "--observations") == more.end())
      arguments.insert(arguments.end(), {"--observations", "20"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CliResult made = run(arguments);
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return folder.path / name;
  }

  void change(const fs::path& file, const std::string& from, const std::string& to) {
    std::string text = read_text(file);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(file, text.replace(at, from.size(), to));
  }

  void expect_refused(const CliResult& result, const std::string& words) {
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_NE(result.errors.find(words), std::string::npos) << words << " in: " << result.errors;
    EXPECT_GE(result.errors.size(), 20u);
    EXPECT_EQ(result.errors.find("error of its own"), std::string::npos) << result.errors;
  }

  std::vector<std::string> names_in(const fs::path& where) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(where)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder folder;
};

TEST_F(HardToBreak, PredictsFromAnExportWithSlippedMarkers) {
  const fs::path session = simulated("s", {"--effect", "marker_slip:1.x=4e-3", "--effect", "marker_slip:1.k=10"});
  const fs::path file = folder.path / "c.xml";
  ASSERT_EQ(run({"fit", session, "--effects", "marker_slip:1", "body_slip", "--export", file}).exit_code, 0);
  const CliResult predicted = run({"predict", file, "--robot", whole_sample("robots/six_axis.urdf"), "--position",
                                   "0 0.3 0.2 0 0.1 0", "--json", "-"});
  ASSERT_EQ(predicted.exit_code, 0) << predicted.errors;
  const CliResult direct = run({"predict", session, "--position", "0 0.3 0.2 0 0.1 0", "--json", "-"});
  EXPECT_EQ(direct.exit_code, 0) << direct.errors;
  expect_refused(run({"fit", session, "--effects", "marker_slip:50"}), "markers 0 to 2");
  expect_refused(run({"fit", session, "--effects", "marker_slip:50.x=1e-3"}), "markers 0 to 2");
}

TEST_F(HardToBreak, NumbersBeyondAllMeasureAreOneSentence) {
  const fs::path session = simulated("s");
  const std::string good = read_text(session / "session.xml");
  const std::vector<std::array<std::string, 2>> changes = {{"left=\"", "left=\"1e154 "},
                                                           {"sigma_pixel=\"0.2\"", "sigma_pixel=\"1e-160\""},
                                                           {"<right_from_left xyz=\"", "<right_from_left xyz=\"1e160 "},
                                                           {"fx=\"", "fx=\"1e-9\" was=\""},
                                                           {"<gravity xyz=\"0 0 -9.81", "<gravity xyz=\"0 0 -1e200"},
                                                           {"time=\"", "time=\"-1e300\" was=\""},
                                                           {"<position>", "<position>1e160 "}};
  for (const auto& [from, to] : changes) {
    const auto at = good.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::string text = good;
    text.replace(at, from.size(), to);
    write_text(session / "session.xml", text);
    for (const char* command : {"check", "fit", "diagnose"})
      expect_refused(run({command, session}), "session.xml, line ");
  }
}

TEST_F(HardToBreak, OptionsTakeOnlyPlausibleNumbers) {
  const std::string like = whole_sample("rigs/six_axis_stand"), out = folder.path / "s";
  const std::vector<std::vector<std::string>> wrong = {{"--noise", "1e308"},
                                                       {"--noise", "nan"},
                                                       {"--shift", "nan", "0", "0"},
                                                       {"--image-blur", "1e9"},
                                                       {"--image-noise", "inf"},
                                                       {"--body-size", "1e9"},
                                                       {"--farthest", "1e99"},
                                                       {"--wrong-corners", "nan"},
                                                       {"--joint-range", "nan"},
                                                       {"--effect", "joint_offset:axis_1.offset=1e300"},
                                                       {"--curve", "axis_1: 1e300*sin(3q)"},
                                                       {"--disturb", "3:joint:axis_1=1e300"},
                                                       {"--disturb", "3:joint:axis_1=nan"}};
  for (const auto& options : wrong) {
    std::vector<std::string> arguments = {"simulate", "--like", like, "--out", out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CliResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << options[0] << " " << options[1] << result.errors;
    EXPECT_FALSE(fs::exists(out)) << options[0];
  }
}

TEST_F(HardToBreak, OutputsGoOverNothingThatTheSessionNeeds) {
  const fs::path session = simulated("s");
  const std::string before = read_text(session / "session.xml"), robot = read_text(session / "six_axis.urdf");
  expect_refused(run({"fit", session, "--export", session / "session.xml"}), "is not written over");
  expect_refused(run({"fit", session, "--json", session / "six_axis.urdf"}), "is not written over");
  expect_refused(run({"diagnose", session, "--json", session / "truth.xml"}), "is not written over");
  fs::create_directory_symlink(session, folder.path / "link");
  expect_refused(run({"fit", session, "--export", folder.path / "link" / "session.xml"}), "is not written over");
  fs::create_hard_link(session / "session.xml", folder.path / "hard.xml");
  expect_refused(run({"fit", session, "--export", folder.path / "hard.xml"}), "is not written over");
  const fs::path other = simulated("other");
  const std::string others = read_text(other / "session.xml");
  expect_refused(run({"fit", session, "--export", other / "session.xml"}), "is not written over");
  expect_refused(run({"fit", session, "--export", other}), "is a folder");
  EXPECT_EQ(read_text(session / "session.xml"), before);
  EXPECT_EQ(read_text(session / "six_axis.urdf"), robot);
  EXPECT_EQ(read_text(other / "session.xml"), others);
  // What was written before is written again.
  ASSERT_EQ(run({"fit", session, "--export", folder.path / "c.xml"}).exit_code, 0);
  EXPECT_EQ(run({"fit", session, "--export", folder.path / "c.xml"}).exit_code, 0);
}

TEST_F(HardToBreak, PipesAndDevicesAreNoPlacesAndNoSources) {
  const fs::path session = simulated("s"), pipe = folder.path / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  expect_refused(run({"fit", session, "--json", pipe}), "a device or a pipe");
  expect_refused(run({"fit", session, "--export", "/dev/null"}), "a device or a pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  expect_refused(run({"fit", pipe}), "a device or a pipe");
  expect_refused(run({"predict", session, "--positions", pipe}), "a device or a pipe");
  expect_refused(run({"predict", pipe, "--robot", session / "six_axis.urdf", "--position", "0"}), "a device or a pipe");
  expect_refused(run({"simulate", "--robot", "/dev/zero", "--like", session, "--out", folder.path / "t"}),
                 "a device or a pipe");
  fs::remove(session / "six_axis.urdf");
  ASSERT_EQ(::mkfifo((session / "six_axis.urdf").c_str(), 0666), 0);
  EXPECT_EQ(run({"fit", session}).exit_code, 2);
}

TEST_F(HardToBreak, TheCalibrationAloneGoesToStandardOutput) {
  const fs::path session = simulated("s");
  const CliResult result = run({"fit", session, "--export", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output.substr(0, 5), "<?xml");
  EXPECT_EQ(result.output.find("TCP->Body\n"), std::string::npos);
  expect_refused(run({"fit", session, "--export", "-", "--json", "-"}), "both want standard output");
}

TEST_F(HardToBreak, AFullStandardOutputIsAnError) {
  const fs::path session = simulated("s");
  const std::string command = test::quoted_argument(HANDSIGHT_BINARY_DIR "/app/cli/handsight-cli") + " fit " +
                              test::quoted_argument(session) + " --json - > /dev/full 2> " +
                              test::quoted_argument(folder.path / "errors.txt");
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(read_text(folder.path / "errors.txt").find("Standard output cannot be written"), std::string::npos);
}

TEST_F(HardToBreak, AFileThatMayNotGrowIsASentence) {
  const fs::path session = simulated("s"), out = folder.path / "result.json";
  const std::string command = "ulimit -f 1; " + test::quoted_argument(HANDSIGHT_BINARY_DIR "/app/cli/handsight-cli") +
                              " fit " + test::quoted_argument(session) + " --json " + test::quoted_argument(out) +
                              " 2>&1 >/dev/null | cat > " + test::quoted_argument(folder.path / "errors.txt") +
                              "; exit ${PIPESTATUS[0]}";
  const int status = std::system(("bash -c " + test::quoted_argument(command)).c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(read_text(folder.path / "errors.txt").find("cannot be written"), std::string::npos);
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(HardToBreak, SimulationsLeaveOthersFoldersAlone) {
  write_text(folder.path / "d.part" / "mine.txt", "mine");
  simulated("d");
  EXPECT_EQ(read_text(folder.path / "d.part" / "mine.txt"), "mine");
  EXPECT_EQ(names_in(folder.path), (std::vector<std::string>{"cli_err.txt", "cli_out.txt", "d", "d.part"}));
  // A robot that is named like the session.
  const fs::path robot = folder.path / "robot" / "session.xml";
  write_text(robot, read_text(whole_sample("robots/six_axis.urdf")));
  simulated("e", {"--robot", robot});
  EXPECT_EQ(run({"check", folder.path / "e"}).exit_code, 0);
  EXPECT_NE(read_text(folder.path / "e" / "session.xml").find("<handsight_session"), std::string::npos);
}

TEST_F(HardToBreak, AFolderOfImagesThatIsGoneIsNoDecision) {
  const fs::path session = folder.path / "first_steps";
  fs::copy(whole_sample("first_steps"), session, fs::copy_options::recursive);
  const std::string before = read_text(session / "session.xml");
  ASSERT_NE(before.find("<images"), std::string::npos);
  for (const auto& entry : fs::directory_iterator(session))
    if (entry.is_directory()) fs::rename(entry.path(), session / (entry.path().filename().string() + "_away"));
  expect_refused(run({"online", session, "--save"}), "nothing is saved");
  EXPECT_EQ(read_text(session / "session.xml"), before);
}

TEST_F(HardToBreak, WhatAnotherProgramSavedMeanwhileStays) {
  const fs::path session = simulated("s", {"--observations", "400"});
  // More lines than a pipe holds: the run waits for its reader, which changes the file after the first of them.
  const std::string program = test::quoted_argument(HANDSIGHT_BINARY_DIR "/app/cli/handsight-cli");
  const std::string command = "(" + program + " online " + test::quoted_argument(session) + " --save --json - 2> " +
                              test::quoted_argument(folder.path / "errors.txt") + "; echo $? > " +
                              test::quoted_argument(folder.path / "code.txt") +
                              ") | (read -r line; sed -i 's/title=\"[^\"]*\"/title=\"theirs\"/' " +
                              test::quoted_argument(session / "session.xml") + "; cat > /dev/null)";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_text(folder.path / "code.txt"), "2\n");
  EXPECT_NE(read_text(folder.path / "errors.txt").find("another program has changed the file"), std::string::npos)
      << read_text(folder.path / "errors.txt");
  EXPECT_NE(read_text(session / "session.xml").find("title=\"theirs\""), std::string::npos);
}

TEST_F(HardToBreak, NamesSteerNoTerminal) {
  const fs::path session = simulated("s");
  change(session / "session.xml", "title=\"", "title=\"a&#27;[2J&#x9b;31m&#127;");
  for (const char* command : {"check", "fit", "diagnose"}) {
    const CliResult result = run({command, session});
    for (const std::string& text : {result.output, result.errors}) {
      EXPECT_EQ(text.find('\x1b'), std::string::npos) << command;
      EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos) << command;
      EXPECT_EQ(text.find('\x7f'), std::string::npos) << command;
    }
  }
  change(session / "session.xml", "tcp=\"hand\"", "tcp=\"hand&#0;x\"");
  expect_refused(run({"fit", session}), "zero byte");
}

TEST_F(HardToBreak, PosesAreTakenInTheirOrderOrByTheirColumns) {
  const fs::path session = simulated("s", {"--effect", "friction_hysteresis:axis_2.gap=2e-2"});
  const fs::path c = folder.path / "c.xml", robot = whole_sample("robots/six_axis.urdf");
  ASSERT_EQ(run({"fit", session, "--effects", "friction_hysteresis:axis_2", "--export", c}).exit_code, 0);
  const auto predicted = [&](const std::string& table, const std::string& said) {
    write_text(folder.path / "poses.csv", table);
    const CliResult result =
        run({"predict", c, "--robot", robot, "--positions", folder.path / "poses.csv", "--json", "-"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.errors.find(said), std::string::npos) << result.errors;
    return result.json();
  };
  const std::string pose = "0,0.3,0.2,0,0.1,0";
  const auto up = predicted("axis_1,axis_2,axis_3,axis_4,axis_5,axis_6\n0,0,0,0,0,0\n" + pose + "\n",
                            "order of the lines")[1],
             down = predicted("axis_1,axis_2,axis_3,axis_4,axis_5,axis_6\n0,1,0,0,0,0\n" + pose + "\n",
                              "order of the lines")[1],
             fast = predicted("axis_1,axis_2,axis_3,axis_4,axis_5,axis_6,velocity_axis_2,time\n" + pose + ",0.1,3\n",
                              "columns velocity_JOINT")[0];
  const auto height = [](const nlohmann::json& p) { return p["root_from_tcp_est"][2][3].get<double>(); };
  EXPECT_GT(std::abs(height(up) - height(down)), 1e-3);
  EXPECT_EQ(height(up), height(fast));
}

/// The session's poses in the opposite order, each with the images of another.
void reverse_poses(const fs::path& file) {
  std::string text = read_text(file);
  const std::string open = "<position>", close = "</position>";
  std::vector<std::string> poses;
  for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const auto from = at + open.size();
    poses.push_back(text.substr(from, text.find(close, from) - from));
  }
  for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const auto from = at + open.size();
    text.replace(from, text.find(close, from) - from, poses.back());
    poses.pop_back();
  }
  write_text(file, text);
}

TEST_F(HardToBreak, NoNumberIsPrintedThatNobodyShouldUse) {
  const fs::path session = simulated("mixed_up");
  reverse_poses(session / "session.xml");
  for (const char* command : {"fit", "improve"}) {
    const CliResult result = run({command, session.string()});
    EXPECT_EQ(result.exit_code, 1) << command;
    EXPECT_NE(result.output.find("NO ANSWER"), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("\n  x  "), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("check"), std::string::npos) << "what to do: " << result.output;
  }
}

}  // namespace
}  // namespace handsight
