// SPDX-License-Identifier: Apache-2.0
#include "command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text.h"
#include "blunders/blunders_in_files.h"
#include "detection/target_finding.h"
#include "estimation/start/target_symmetry.h"
#include "options/joined_source.h"
#include "printing/outputs.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::cli {

void Output::line(const std::string& text) const {
  if (to_people()) std::cout << printable(text) << '\n';
}

void Output::json(const Json& result) const {
  if (json_file.empty()) return;
  // A number that is not finite has no JSON; nlohmann writes null for it.
  const std::string text = json_text(result, 1) + '\n';
  if (json_file == "-") {
    std::cout << text;
  } else {
    write_output(json_file, text, "--json");
  }
}

void Output::require_places() const {
  if (json_file == "-" && export_file == "-")
    throw InputError("--json - and --export - both want standard output; give one of them a file.");
  require_output(json_file, "--json");
  require_output(export_file, "--export");
}

void Output::calibration(const Calibration& calibration) const {
  if (export_file.empty()) return;
  const std::string text = readable_text(calibration);
  if (export_file == "-") {
    std::cout << text;
    return;
  }
  write_output(export_file, text, "--export");
  line("Written: " + export_file);
}

void Output::note(const std::string& text) { std::cerr << "note: " << printable(text) << '\n'; }

std::string json_text(const Json& result, int indent) {
  const std::string plain = result.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const auto byte = static_cast<unsigned char>(plain[i]);
    const auto next = static_cast<unsigned char>(i + 1 < plain.size() ? plain[i + 1] : 0);
    if (byte == 0x7F) {
      text += "\\u007f";
    } else if (byte == 0xC2 && next < 0xA0) {
      text += fmt::format("\\u{:04x}", next);
      ++i;
    } else {
      text += plain[i];
    }
  }
  return text;
}

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

namespace {

Session open_one(const std::string& path) {
  Session session = read_session(path);
  note_inputs(session);
  for (const Message& note : session.notes) Output::note(note);
  return session;
}

/// How the observations of several sessions are numbered through.
std::string numbering(const Session& joined) {
  std::string text;
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    std::int64_t first = 0, last = -1;
    for (const Observation& o : joined.observations) {
      if (o.part != static_cast<int>(p)) continue;
      first = last < 0 ? o.id : std::min(first, o.id);
      last = std::max(last, o.id);
    }
    if (last >= 0) text += fmt::format("{}{} {} to {}", text.empty() ? "" : ", ", joined.parts[p].title, first, last);
  }
  return text;
}

Session opened(const Collection& collection, const OpenOne& open) {
  for (const Message& note : collection.notes) Output::note(note);
  Session session = join_collection(collection, open);
  if (!session.parts.empty()) Output::note(fmt::format("Observations are numbered through: {}.", numbering(session)));
  return session;
}

}  // namespace

Session open_session(const std::string& path) {
  return is_collection(path) ? opened(read_collection(path), open_one) : open_one(path);
}

Session open_session(const std::string& path, const Output& output) {
  Session session = open_session(path);
  output.require_places();
  return session;
}

namespace {

Session searched(const std::string& path, TargetSearch& search) {
  if (is_collection(path))
    return opened(read_collection(path), [&](const std::string& one) { return searched(one, search); });
  Session session = open_one(path);
  std::optional<Progress> progress;
  search = find_targets(session, [&](std::size_t done, std::size_t all) {
    if (!progress) progress.emplace("looking for the target", all);
    progress->at(done);
  });
  progress.reset();
  for (const Message& note : search.notes) Output::note(note);
  if (search.looked_at > 0 && search.found == 0)
    for (const Blunder& b : blunders_in_files(session)) Output::note(b.text + " " + b.fix);
  if (const int turned = undo_target_symmetry(session); turned > 0)
    Output::note(fmt::format("The board was numbered the other way round in {} observations; the robot's motion tells.",
                             turned));
  return session;
}

}  // namespace

Session open_searched_session(const std::string& path) {
  TargetSearch search;
  return searched(path, search);
}

Session open_searched_session(const std::string& path, const Output& output) {
  output.require_places();
  return open_searched_session(path);
}

Session open_searched_session(const std::string& path, const Output& output, TargetSearch& search) {
  output.require_places();
  return searched(path, search);
}

Session open_joined_session(const std::vector<std::string>& paths, const SharedBySessions& shared,
                            const Output& output) {
  output.require_places();
  TargetSearch search;
  if (paths.size() == 1) return searched(paths.front(), search);
  return opened(gather_collection(paths, shared.same_rig, shared.same_body),
                [&](const std::string& one) { return searched(one, search); });
}

void add_session_option(const CommandLine& command, std::string& session) {
  command
      .option("SESSION", session, "A session's folder or its session.xml, or a collection of sessions (collection.xml)")
      .required();
}

void add_json_option(const CommandLine& command, Output& output) {
  command.option("--json", output.json_file, "Write the whole result as JSON to this file; - is standard output");
}

void add_export_option(const CommandLine& command, Output& output) {
  command.option("--export", output.export_file, "Write the calibration XML to this file; - is standard output");
}

void require_pair(const Session& session, const char* command) {
  if (!session.rig || is_pair(*session.rig)) return;
  throw InputError(
      message("{}: {} looks for corners in the images of two cameras, and this session has {} ({}); bring its "
              "markers' image points as <marker> elements, and fit and diagnose work with any number of cameras.",
              session.file.filename().string(), command, session.rig->count(), listed_names(*session.rig)));
}

}  // namespace handsight::cli
