// SPDX-License-Identifier: GPL-3.0-or-later
// One look at folders into which a robot's cameras write while it moves: which pairs of images are whole and have their
// joint angles, and what the others wait for. Reads and copies files, knows no window: for a worker thread.
#pragma once

#include <QStringList>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

#include "session/session.h"

namespace handsight::app {

/// Where images and joint angles arrive. The table has a line of joint angles for each pair; with a column `number` it
/// names the pair by the last number in its images' names. Without one, as for a new session, line k belongs to the
/// k-th pair of the folders: then there must be as many lines as pairs, and the lines of pairs that are in the session
/// must say what it says. A column `time` (s) is taken where it is there.
struct LiveSources {
  std::filesystem::path left_folder, right_folder;  // may be the same
  std::filesystem::path table;
  bool operator==(const LiveSources&) const = default;
};

/// The folder of the session's images (`images` where it has none), and joints.csv in the session's folder.
LiveSources own_sources(const Session& session);

/// Size and time of a file, and since when they are so: what has not changed for a while is written to its end.
struct FileStamp {
  std::uintmax_t size = 0;
  std::filesystem::file_time_type written;
  std::chrono::steady_clock::time_point since;
};

struct LiveTask {
  LiveSources sources;
  std::filesystem::path session_folder;
  StereoRig rig;
  std::vector<std::string> joints;
  std::map<std::string, Eigen::VectorXd> known_left;  // names of left images that are in the session, with its posture
  std::set<std::string> known_right;
  std::set<std::string> passed_over;        // left images that were taken in this watch, and undone since
  std::map<std::string, FileStamp> stamps;  // of the last look
  std::chrono::milliseconds settles_in{300};
};

/// What is known of a session's images.
LiveTask task_of(const Session& session, const LiveSources& sources);

/// A pair that is whole: its images lie in the session's folder now.
struct LivePair {
  std::string left_name;    // of the file that arrived
  std::string left, right;  // relative to the session's folder
  Eigen::VectorXd position;
  std::optional<double> time;
};

struct LiveLook {
  std::vector<LivePair> pairs;  // in order of their numbers
  QStringList remarks;          // what does not come in, and what to do; a sentence or two each
  std::map<std::string, FileStamp> stamps;
};

/// Never throws for what is wrong in the folders: it is said in the remarks. A pair that is not whole holds up no
/// other.
LiveLook look_for_pairs(const LiveTask& task);

}  // namespace handsight::app
