// SPDX-License-Identifier: GPL-3.0-or-later
// One look at folders into which a robot's cameras write while it moves: which instants have every camera's image whole
// and their joint angles, and what the others wait for. Reads and copies files, knows no window: for a worker thread.
#pragma once

#include <QStringList>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

#include "session/session.h"

namespace handsight::app {

/// Where images and joint angles arrive. The table has a line of joint angles for each instant; with a column `number`
/// it names the instant by the last number in its images' names. Without one, as for a new session, line k belongs to
/// the k-th instant of the folders: then there must be as many lines as instants, and the lines of those that are in
/// the session must say what it says. A column `time` (s) is taken where it is there.
struct LiveSources {
  std::vector<std::filesystem::path> folders;  // by camera; those of two may be the same
  std::filesystem::path table;
  bool operator==(const LiveSources&) const = default;
};

/// The folders of the session's images (`images` where it has none), and joints.csv in the session's folder.
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
  std::vector<RigCamera> cameras;
  std::vector<std::string> joints;
  bool is_of_flange = false;  // the joints stand for the flange's pose, which the table may give as x y z qx qy qz qw
  std::vector<std::map<std::string, Eigen::VectorXd>> known;  // by camera: names of images in the session, its posture
  std::set<std::string> passed_over;                          // images that were taken in this watch, and undone since
  std::map<std::string, FileStamp> stamps;                    // of the last look
  std::chrono::milliseconds settles_in{300};
};

/// What is known of a session's images.
LiveTask task_of(const Session& session, const LiveSources& sources);

/// An instant of which every image is whole: they lie in the session's folder now.
struct LiveInstant {
  std::string name;                 // of the first camera's file that arrived
  std::vector<std::string> images;  // by camera, relative to the session's folder
  Eigen::VectorXd position;
  std::optional<double> time;
};

struct LiveLook {
  std::vector<LiveInstant> instants;  // in order of their numbers
  QStringList remarks;                // what does not come in, and what to do; a sentence or two each
  std::map<std::string, FileStamp> stamps;
};

/// Never throws for what is wrong in the folders: it is said in the remarks. An instant that is not whole holds up
/// no other.
LiveLook look_for_images(const LiveTask& task);

}  // namespace handsight::app
