// SPDX-License-Identifier: Apache-2.0
// A child process that is spoken to in lines.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "base/message.h"

namespace handsight {

/// What became of reading or writing a line.
enum class LineEnd { whole, timed_out, ended, too_long, interrupted };

/// Runs a command by the shell, in a process group of its own; its standard error is ours. InputError where it cannot
/// be begun.
class ChildProcess {
 public:
  explicit ChildProcess(const std::string& command);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Its input is closed; what still runs half a second later is ended.
  ~ChildProcess();

  /// Waits for `seconds` at most. `is_interrupted` is asked twenty times a second; where it says yes the wait ends.
  LineEnd write_line(const std::string& line, double seconds, const std::function<bool()>& is_interrupted = {});
  LineEnd read_line(std::string& line, double seconds, const std::function<bool()>& is_interrupted = {});

  /// "ended with exit code 3", "was ended by signal 9"; empty while it runs.
  Message ending();

 private:
  bool has_ended(double within_seconds);

  pid_t process_ = -1;
  int to_child_ = -1, from_child_ = -1;
  std::string unread_;
  bool is_over_ = false;
  int status_ = 0;
};

}  // namespace handsight
