// SPDX-License-Identifier: Apache-2.0
// Processes of the test program itself that are killed at random moments.
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace handsight::test {

/// How often to kill: HANDSIGHT_KILLS, else what ./test has the time for.
inline int kills(int usual) {
  const char* wanted = std::getenv("HANDSIGHT_KILLS");
  return wanted ? std::atoi(wanted) : usual;
}

/// Runs this program again with one option and its values, kills it so many microseconds after its first line, and
/// gives the lines that it has said; none where it died by itself.
inline std::vector<std::string> said_before_killed(const char* option, const std::vector<std::string>& values,
                                                   useconds_t microseconds) {
  int ends[2];
  if (::pipe(ends) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], 1);
    ::close(ends[0]);
    std::vector<char*> arguments = {const_cast<char*>("test"), const_cast<char*>(option)};
    for (const std::string& value : values) arguments.push_back(const_cast<char*>(value.c_str()));
    arguments.push_back(nullptr);
    ::execv("/proc/self/exe", arguments.data());
    ::_exit(9);
  }
  ::close(ends[1]);
  std::FILE* said = ::fdopen(ends[0], "r");
  std::vector<std::string> lines;
  char line[64];
  const auto take = [&] {
    if (!std::fgets(line, sizeof line, said)) return false;
    lines.push_back(line);
    return true;
  };
  if (take()) ::usleep(microseconds);
  ::kill(child, SIGKILL);
  while (take()) continue;
  std::fclose(said);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSIGNALED(status)) lines.clear();
  return lines;
}

}  // namespace handsight::test
