// SPDX-License-Identifier: Apache-2.0
#include "command.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "base/files.h"
#include "session/session_xml.h"

namespace handsight::cli {

void Output::line(const std::string& text) const {
  if (to_people()) std::cout << text << '\n';
}

void Output::json(const Json& result) const {
  if (json_file.empty()) return;
  // A number that is not finite has no JSON; nlohmann writes null for it.
  const std::string text = result.dump(1) + '\n';
  if (json_file == "-") {
    std::cout << text;
  } else {
    replace_file(json_file, text);
  }
}

void Output::note(const std::string& text) { std::cerr << "note: " << text << '\n'; }

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_) std::cerr << "\r\033[K";
}

void Progress::at(std::size_t count) {
  if (!terminal_ || total_ == 0) return;
  const std::size_t width = 30, full = width * count / total_;
  std::cerr << '\r' << what_ << " [" << std::string(full, '=') << std::string(width - full, ' ') << "] " << count
            << " of " << total_ << std::flush;
}

Session open_session(const std::string& path) {
  Session session = read_session(path);
  for (const std::string& note : session.notes) Output::note(note);
  return session;
}

void add_session_option(CLI::App& app, std::string& session) {
  app.add_option("SESSION", session, "A session's folder or its session.xml")->required();
}

void add_json_option(CLI::App& app, Output& output) {
  app.add_option("--json", output.json_file, "Write the whole result as JSON to this file; - is standard output");
}

}  // namespace handsight::cli
