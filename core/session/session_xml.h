// SPDX-License-Identifier: Apache-2.0
// Sessions in and out: session.xml in a folder with its robot and images. Every refusal is an InputError of
// one sentence with the file, the line, what was found and what was expected. Children may stand in any
// order; elements and attributes that are not known are counted in Session::notes and kept by save_session.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// Points of a target that a session may have.
inline constexpr int most_session_points = 4096;

/// Lines of the text that later refusals name; 0: not known.
struct SessionLines {
  int robot = 0;
  int device = 0;  // <stereo>, <cameras> or <tracker>
  int joints = 0;
  std::vector<int> observations;  // in the order of Session::observations
};

/// Names folders, with ':' between, in which the robots of sessions may lie beside the session's own folder.
inline constexpr char robot_folders_variable[] = "HANDSIGHT_ROBOTS";

/// Reads a session with its robot; `path` is the folder or the file in it. Robot and images lie inside the folder,
/// links followed; the robot may also lie in a folder "robots" beside the session's folder or above it, which several
/// sessions share, or in one that HANDSIGHT_ROBOTS names. Image files are not opened.
Session read_session(const std::filesystem::path& path);

/// Reads the text alone, without the robot; `file` is what sentences call it. Session::file, robot and links
/// are not set or looked at: see bind_robot and check_image_paths. Defaults: gravity 0 0 -9.81;
/// estimate="no"; a mount without xyz or rpy has zeros there, but with estimate="yes" and neither it is
/// unknown (Mount::known); camera terms that are missing 0; marker without `by`: import.
Session parse_session(const std::string& text, const std::string& file, SessionLines* lines = nullptr);

/// Gives the session its robot. InputError where a joint of <joints> is not there, does not move or is a
/// mimic, or where the tcp or mount link is not there.
void bind_robot(Session& session, Robot robot, const SessionLines& lines = {});

/// InputError where an image path leads out of the session's folder through a symbolic link. (parse_session
/// has refused absolute paths and "..".)
void check_image_paths(const Session& session, const SessionLines& lines = {});

/// The files that a session consists of, there or not: its XML, robot, images, truth and own effects.
std::vector<std::filesystem::path> list_files(const Session& session);

/// InputError where a result would be written over one of them.
void require_no_session_file(const Session& session, const std::filesystem::path& output);

/// The session as XML. With Session::source, that text with the markers and decisions of this session in it
/// (observations matched by id; new ones appended, those that are gone left out) and all else as it was;
/// numbers that have not changed keep their spelling. Without it, everything from scratch; a mount's or rig's
/// rotation is then written as rpy, which reads back within rounding.
std::string session_text(const Session& session);

/// Replaces (or makes) Session::file by session_text, whole or not at all. InputError where it cannot be written.
void save_session(const Session& session);

/// The same, but only where the file still holds Session::source, what was read: InputError where another program has
/// written it since, and what that wrote stays.
void replace_session(const Session& session);

}  // namespace handsight
