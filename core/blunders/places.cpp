// SPDX-License-Identifier: Apache-2.0
#include "blunders/places.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

/// The joints that a joint's value moves: itself, and those that follow it.
std::vector<int> moved_by(const Robot& robot, int joint) {
  std::vector<int> moved{joint};
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    for (const Mimic& mimic : robot.joints[j].mimics)
      if (mimic.joint == joint) moved.push_back(static_cast<int>(j));
  return moved;
}

bool tells(const Session& session, const std::string& name) {
  const Robot& robot = session.robot;
  const int tcp = find_link(robot, session.tcp), mount = find_link(robot, session.mount.link);
  const std::vector<int> moved = moved_by(robot, find_joint(robot, name));
  return std::any_of(moved.begin(), moved.end(),
                     [&](int j) { return is_distal(robot, j, tcp) != is_distal(robot, j, mount); });
}

}  // namespace

std::pair<std::string, std::string> two_words(const std::string& where, const std::string& id) {
  const std::size_t comma = where.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == where.size())
    throw InputError(message("{}: {} names no two joints; expected {}:FIRST,SECOND.", id, in_quotes(where), id));
  return {where.substr(0, comma), where.substr(comma + 1)};
}

std::pair<std::string, std::string> name_and_value(const std::string& where) {
  const std::size_t equals = where.find('=');
  if (equals == std::string::npos) return {where, ""};
  return {where.substr(0, equals), where.substr(equals + 1)};
}

std::vector<std::string> words_of_list(const std::string& where) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= where.size();) {
    const std::size_t end = std::min(where.find(',', begin), where.size());
    words.push_back(where.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

double number_in(const std::string& value, const std::string& id) {
  const auto numbers = parse_numbers(value);
  if (!numbers || numbers->size() != 1) throw InputError(message("{}: {} is no number.", id, in_quotes(value)));
  return numbers->front();
}

Eigen::Index joint_place(const Session& session, const std::string& name, const std::string& id) {
  const auto found = std::find(session.joints.begin(), session.joints.end(), name);
  if (found == session.joints.end())
    throw InputError(message("{}: the session has no joint {}; it has: {}.", id, in_quotes(name),
                             shortened(fmt::format("{}", fmt::join(session.joints, " ")), 300)));
  return found - session.joints.begin();
}

const Joint& joint_named(const Session& session, const std::string& name) {
  return session.robot.joints[static_cast<std::size_t>(find_joint(session.robot, name))];
}

std::vector<std::string> telling_joints(const Session& session) {
  std::vector<std::string> telling;
  if (session.robot.is_of_poses) return telling;
  for (const std::string& name : session.joints)
    if (tells(session, name)) telling.push_back(name);
  return telling;
}

std::string session_name(const Session& session) {
  const std::string name = session.file.filename().string();
  return name.empty() ? "session.xml" : name;
}

Message robot_name(const Session& session) {
  return session.robot_file.empty() ? "the robot's URDF" : verbatim(shown_path(session.robot_file));
}

}  // namespace handsight
