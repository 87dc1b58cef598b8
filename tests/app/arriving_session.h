// SPDX-License-Identifier: Apache-2.0
// A session of which only the first observations are there; the others wait outside to arrive in its folder.
#pragma once

#include <string>

#include "base/files.h"
#include "base/numbers.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {

struct ArrivingSession {
  /// first_steps with its first observations.
  explicit ArrivingSession(std::size_t first_count) {
    namespace fs = std::filesystem;
    all = read_session(sample);
    fs::create_directories(home / "images");
    fs::copy_file(sample / all.robot_file, home / all.robot_file);
    Session some = all;
    some.file = home / "session.xml";
    some.observations.resize(first_count);
    for (const Observation& o : some.observations) bring(o.id);
    save_session(some);
  }
  const Observation& one(std::int64_t id) { return all.observations[static_cast<std::size_t>(id)]; }
  void bring(std::int64_t id, bool left = true, bool right = true) {
    if (left) std::filesystem::copy_file(sample / one(id).images[0], home / one(id).images[0]);
    if (right) std::filesystem::copy_file(sample / one(id).images[1], home / one(id).images[1]);
  }
  /// The table's first line, and an observation's; `first` stands in a column before the joints.
  std::string header(const std::string& first = {}) {
    std::string text = first;
    for (const std::string& joint : all.joints) text += (text.empty() ? "" : ",") + joint;
    return text + "\n";
  }
  std::string line(std::int64_t id, const std::string& first = {}) {
    std::string text = first;
    for (const double q : one(id).position) text += (text.empty() ? "" : ",") + format_number(q);
    return text + "\n";
  }
  void table(const std::string& text) { replace_file(home / "joints.csv", text); }

  TemporaryFolder folder;
  std::filesystem::path sample = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps";
  std::filesystem::path home = folder.path / "session";
  Session all;
};

}  // namespace handsight::test
