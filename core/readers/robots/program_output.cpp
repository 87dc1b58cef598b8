// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/program_output.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

namespace handsight {
namespace {

constexpr std::size_t most_bytes = 64u << 20;

struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0) ends[0] = ends[1] = -1;
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(int i) {
    if (ends[i] >= 0) close(ends[i]);
    ends[i] = -1;
  }
};

/// False where nothing more will come.
bool take_some(Pipe& pipe, std::string& into) {
  char piece[65536];
  const ssize_t got = read(pipe.ends[0], piece, sizeof piece);
  if (got > 0) into.append(piece, static_cast<std::size_t>(got));
  if (got <= 0) pipe.close_end(0);
  return got > 0;
}

void read_until_both_end(Pipe& out, Pipe& err, ProgramOutput& all, pid_t child, int seconds) {
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    pollfd wait[2] = {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}};
    poll(wait, 2, 200);
    if (wait[0].revents) take_some(out, all.out);
    if (wait[1].revents) take_some(err, all.err);
    if (std::chrono::steady_clock::now() < last && all.out.size() + all.err.size() < most_bytes) continue;
    kill(child, SIGKILL);
    return;
  }
}

}  // namespace

std::optional<ProgramOutput> run_for_output(const std::vector<std::string>& command, int seconds) {
  Pipe out, err;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], 1);
  posix_spawn_file_actions_adddup2(&actions, err.ends[1], 2);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  out.close_end(1);
  err.close_end(1);
  ProgramOutput all;
  read_until_both_end(out, err, all, child, seconds);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  all.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (all.status == 127 && all.out.empty()) return std::nullopt;
  return all;
}

}  // namespace handsight
