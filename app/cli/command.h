// SPDX-License-Identifier: Apache-2.0
// What every command of handsight-cli shares: where results go, exit codes, and how sessions are opened.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/error.h"
#include "options/command_line.h"
#include "session/calibration.h"
#include "session/session.h"

namespace handsight {
struct TargetSearch;
}

namespace handsight::cli {

using Json = nlohmann::ordered_json;

/// Results: a short table for people on standard output, or with --json the whole result in a file ("-": standard
/// output, and nothing else is printed there). So with --export for the calibration.
struct Output {
  std::string json_file, export_file;

  bool to_people() const { return json_file != "-" && export_file != "-"; }
  /// InputError where a result could not be written; asked before the work begins.
  void require_places() const;
  /// Prints one line for people; nothing where standard output belongs to JSON.
  void line(const std::string& text = "") const;
  /// Writes the whole result; the file is replaced whole. Nothing without --json.
  void json(const Json& result) const;
  /// Writes the calibration and says so. Nothing without --export.
  void calibration(const Calibration& calibration) const;
  /// A note on standard error.
  static void note(const std::string& text);
};

/// JSON as text in which no control character stands as it is (JSON itself allows DEL and C1), bytes that are not UTF-8
/// are replaced. `indent` -1: on one line.
std::string json_text(const Json& result, int indent);

/// A bar on standard error, where that is a terminal.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  void at(std::size_t count);

 private:
  std::string what_;
  std::size_t total_;
  bool terminal_;
};

/// One command: its name in the list, how it declares its options, what it does.
struct Command {
  CommandLine line;
  std::function<int()> run;
};

/// Reads a session (folder or session.xml) and prints its notes; no output goes over its files from then on.
Session open_session(const std::string& path);

/// The same, for a command whose outputs must have a place.
Session open_session(const std::string& path, const Output& output);

/// The same, and the points of a target are found in its images where the session does not say them yet; what was found
/// and what was not is noted.
Session open_searched_session(const std::string& path);
Session open_searched_session(const std::string& path, const Output& output);

/// The same, with what became of the search.
Session open_searched_session(const std::string& path, const Output& output, TargetSearch& search);

/// The sessions of a collection, or these as one in which they share what is said, and nothing but the robot otherwise:
/// rigs and bodies by lists of sessions ("A,B"), each as it was given.
struct SharedBySessions {
  std::vector<std::string> same_rig, same_body;
};
Session open_joined_session(const std::vector<std::string>& paths, const SharedBySessions& shared,
                            const Output& output);

/// Adds `SESSION` and `--json` to a command.
void add_session_option(const CommandLine& command, std::string& session);
void add_json_option(const CommandLine& command, Output& output);
void add_export_option(const CommandLine& command, Output& output);

Command add_check(const CommandLine& program);
Command add_detect(const CommandLine& program);
Command add_label(const CommandLine& program);
Command add_online(const CommandLine& program);
Command add_fit(const CommandLine& program);
Command add_inspect(const CommandLine& program);
Command add_diagnose(const CommandLine& program);
Command add_improve(const CommandLine& program);
Command add_predict(const CommandLine& program);
Command add_convert(const CommandLine& program);
Command add_export(const CommandLine& program);
Command add_correct(const CommandLine& program);
Command add_certify(const CommandLine& program);
Command add_compare(const CommandLine& program);
Command add_batch(const CommandLine& program);
Command add_plan(const CommandLine& program);
Command add_effective_mass(const CommandLine& program);
Command add_simulate(const CommandLine& program);
Command add_effects(const CommandLine& program);
Command add_target(const CommandLine& program);
Command add_cameras(const CommandLine& program);
Command add_experiment(const CommandLine& program);
Command add_recheck(const CommandLine& program);

/// InputError where the session has not two cameras, whose images `command` needs.
void require_pair(const Session& session, const char* command);

}  // namespace handsight::cli
