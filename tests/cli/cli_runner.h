// SPDX-License-Identifier: Apache-2.0
// Runs handsight-cli as a user would: a process with arguments, its two outputs and its exit code.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace handsight::test {

struct CliResult {
  int exit_code = -1;
  std::string output;  // standard output
  std::string errors;  // standard error
  nlohmann::json json() const { return nlohmann::json::parse(output); }
};

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string quoted_argument(const std::string& argument) {
  std::string quoted = "'";
  for (const char c : argument) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

#ifndef HANDSIGHT_CLI  // else: another program with its commands
#define HANDSIGHT_CLI HANDSIGHT_BINARY_DIR "/app/cli/handsight-cli"
#endif

/// `folder` takes the two outputs; it is the caller's own. `before` stands before the program's name: "timeout 60 ".
inline CliResult run_cli(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                         const std::string& before = "") {
  const auto out = folder / "cli_out.txt", err = folder / "cli_err.txt";
  std::string command = before + quoted_argument(HANDSIGHT_CLI);
  for (const std::string& a : arguments) command += " " + quoted_argument(a);
  command += " >" + quoted_argument(out.string()) + " 2>" + quoted_argument(err.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
}

}  // namespace handsight::test
