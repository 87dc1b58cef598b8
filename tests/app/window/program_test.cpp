// SPDX-License-Identifier: Apache-2.0
// The program itself: what it says without a display, and to wrong arguments.
#include <gtest/gtest.h>

#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

CliResult run_program(const std::filesystem::path& folder, const std::string& arguments) {
  const auto out = folder / "out.txt", err = folder / "err.txt";
  const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM " HANDSIGHT_BINARY_DIR
                              "/handsight " +
                              arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
}

TEST(Program, WithoutADisplayItPointsToTheCommandLine) {
  const TemporaryFolder folder;
  const CliResult result = run_program(folder.path, "/tmp/some_session");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.errors.find("handsight-cli"), std::string::npos) << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << "one sentence: " << result.errors;
}

TEST(Program, WrongArgumentsAreOneSentence) {
  const TemporaryFolder folder;
  for (const char* wrong : {"--colour", "--theme pink", "--sample", "one two"}) {
    const CliResult result = run_program(folder.path, wrong);
    EXPECT_EQ(result.exit_code, 2) << wrong;
    EXPECT_GE(result.errors.size(), 20U) << wrong;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << wrong;
  }
}

TEST(Program, HelpAndVersionNeedNoDisplay) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder.path, "--help").exit_code, 0);
  EXPECT_EQ(run_program(folder.path, "--version").output.substr(0, 10), "handsight ");
}

TEST(Program, IsLinkedToOneQt) {
  const TemporaryFolder folder;
  ASSERT_EQ(std::system(("ldd " HANDSIGHT_BINARY_DIR "/handsight >" + (folder.path / "ldd.txt").string()).c_str()), 0);
  const std::string libraries = read_text(folder.path / "ldd.txt");
  EXPECT_NE(libraries.find("libQt6Widgets"), std::string::npos);
  EXPECT_EQ(libraries.find("libQt5"), std::string::npos);
}

}  // namespace
}  // namespace handsight::test
