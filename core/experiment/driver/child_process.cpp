// SPDX-License-Identifier: Apache-2.0
#include "experiment/driver/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "base/error.h"
#include "base/text.h"

namespace handsight {
namespace {

constexpr std::size_t longest_line = 16 << 20;  // bytes
constexpr int slice_ms = 50;                    // how long a wait is deaf to an interruption

using Clock = std::chrono::steady_clock;

int left_ms(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, slice_ms));
}

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// write(), without the signal by which a pipe that nobody reads any more would end the whole program, the window too.
ssize_t write_quietly(int file, const char* bytes, std::size_t count) {
  sigset_t of_pipes, pending, before;
  sigemptyset(&of_pipes);
  sigaddset(&of_pipes, SIGPIPE);
  sigpending(&pending);
  const bool was_pending = sigismember(&pending, SIGPIPE) == 1;
  pthread_sigmask(SIG_BLOCK, &of_pipes, &before);
  const ssize_t written = write(file, bytes, count);
  const int error = errno;
  if (written < 0 && error == EPIPE && !was_pending) {  // the signal waits for this thread: it is taken back
    const timespec at_once{};
    while (sigtimedwait(&of_pipes, nullptr, &at_once) < 0 && errno == EINTR) {
    }
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return written;
}

}  // namespace

ChildProcess::ChildProcess(const std::string& command) {
  std::array<int, 2> in{}, out{};
  if (pipe2(in.data(), O_CLOEXEC) != 0) throw InputError(message("The driver cannot be begun: {}", system_text(errno)));
  if (pipe2(out.data(), O_CLOEXEC) != 0) {
    close(in[0]), close(in[1]);
    throw InputError(message("The driver cannot be begun: {}", system_text(errno)));
  }
  process_ = fork();
  if (process_ == 0) {
    setpgid(0, 0);
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    signal(SIGPIPE, SIG_DFL);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(in[0]), close(out[1]);
  to_child_ = in[1];
  from_child_ = out[0];
  if (process_ < 0) {
    close(to_child_), close(from_child_);
    throw InputError(message("The driver cannot be begun: {}", system_text(errno)));
  }
  setpgid(process_, process_);
  fcntl(to_child_, F_SETFL, O_NONBLOCK);
  fcntl(from_child_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  close(to_child_);
  if (!has_ended(0.5)) {
    kill(-process_, SIGTERM);
    if (!has_ended(0.5)) {
      kill(-process_, SIGKILL);
      has_ended(5);
    }
  }
  close(from_child_);
}

bool ChildProcess::has_ended(double within_seconds) {
  const auto end = after(within_seconds);
  while (!is_over_) {
    if (waitpid(process_, &status_, WNOHANG) == process_) is_over_ = true;
    if (is_over_ || Clock::now() >= end) break;
    poll(nullptr, 0, 5);
  }
  return is_over_;
}

Message ChildProcess::ending() {
  if (!has_ended(0.2)) return {};
  if (WIFSIGNALED(status_)) return message("was ended by signal {}", WTERMSIG(status_));
  const int code = WEXITSTATUS(status_);
  return message("ended with exit code {}{}", code, code == 127 ? " (is its command there?)" : "");
}

LineEnd ChildProcess::write_line(const std::string& line, double seconds, const std::function<bool()>& is_interrupted) {
  const std::string bytes = line + '\n';
  const auto end = after(seconds);
  for (std::size_t done = 0; done < bytes.size();) {
    if (is_interrupted && is_interrupted()) return LineEnd::interrupted;
    const ssize_t written = write_quietly(to_child_, bytes.data() + done, bytes.size() - done);
    if (written > 0) {
      done += static_cast<std::size_t>(written);
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) return LineEnd::ended;
    if (Clock::now() >= end) return LineEnd::timed_out;
    pollfd wait{to_child_, POLLOUT, 0};
    poll(&wait, 1, left_ms(end));
  }
  return LineEnd::whole;
}

LineEnd ChildProcess::read_line(std::string& line, double seconds, const std::function<bool()>& is_interrupted) {
  const auto end = after(seconds);
  std::array<char, 65536> buffer{};
  std::size_t searched = 0;
  while (true) {
    if (const auto place = unread_.find('\n', searched); place != std::string::npos) {
      line = unread_.substr(0, place);
      unread_.erase(0, place + 1);
      return LineEnd::whole;
    }
    searched = unread_.size();
    if (unread_.size() > longest_line) return LineEnd::too_long;
    if (is_interrupted && is_interrupted()) return LineEnd::interrupted;
    const ssize_t got = read(from_child_, buffer.data(), buffer.size());
    if (got > 0) {
      unread_.append(buffer.data(), static_cast<std::size_t>(got));
      continue;
    }
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) return LineEnd::ended;
    if (Clock::now() >= end) return LineEnd::timed_out;
    pollfd wait{from_child_, POLLIN, 0};
    poll(&wait, 1, left_ms(end));
  }
}

}  // namespace handsight
