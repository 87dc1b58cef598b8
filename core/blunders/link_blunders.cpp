// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"

namespace handsight {
namespace {

/// The first link of those that are fixed to this one.
int first_of_body(const Robot& robot, int link) {
  while (robot.links[static_cast<std::size_t>(link)].parent_joint >= 0) {
    const Joint& joint =
        robot.joints[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(link)].parent_joint)];
    if (joint.moves()) break;
    link = joint.parent_link;
  }
  return link;
}

/// One link of every body that is not the one of `link`.
std::vector<std::string> other_bodies(const Robot& robot, const std::string& link) {
  const int own = first_of_body(robot, find_link(robot, link));
  std::vector<std::string> others;
  for (int l = 0; l < static_cast<int>(robot.links.size()); ++l)
    if (first_of_body(robot, l) == l && l != own) others.push_back(robot.links[static_cast<std::size_t>(l)].name);
  return others;
}

std::vector<std::string> link_places(const Session& s) {
  std::vector<std::string> places;
  if (s.robot.is_of_poses) return places;
  places = other_bodies(s.robot, s.tcp);
  for (const std::string& link : other_bodies(s.robot, s.mount.link)) places.push_back("mount=" + link);
  if (s.tcp != s.mount.link) places.emplace_back("exchanged");
  return places;
}

void require_link(const Session& s, const std::string& link) {
  if (find_link(s.robot, link) < 0)
    throw InputError(message("wrong_link: the robot has no link {}; it has: {}.", in_quotes(link),
                             shortened(fmt::format("{}", fmt::join(link_names(s.robot), " ")), 300)));
}

/// "hand" or "hand (or tool, flange, which are fixed to it)".
Message body_text(const Session& s, const std::string& link) {
  const int own = first_of_body(s.robot, find_link(s.robot, link));
  std::vector<std::string> others;
  for (int l = 0; l < static_cast<int>(s.robot.links.size()); ++l) {
    const std::string& name = s.robot.links[static_cast<std::size_t>(l)].name;
    if (first_of_body(s.robot, l) == own && name != link) others.push_back(name);
  }
  if (others.empty()) return verbatim(link);
  return message("{} (or a link that is fixed to it: {})", link,
                 shortened(fmt::format("{}", fmt::join(others, ", ")), 200));
}

BlunderKind wrong_link() {
  BlunderKind k;
  k.id = "wrong_link";
  k.places = link_places;
  k.mend = [](const std::string& where, Session& s) {
    const auto [what, link] = name_and_value(where);
    if (where == "exchanged") {
      std::swap(s.tcp, s.mount.link);
    } else {
      require_link(s, link.empty() ? what : link);
      (link.empty() ? s.tcp : s.mount.link) = link.empty() ? what : link;
    }
  };
  k.text = [](const std::string& where, const Session& s) {
    const auto [what, link] = name_and_value(where);
    if (where == "exchanged")
      return message("Hand and mount are exchanged: the sensor is on {}, and what it sees on {}.", s.tcp, s.mount.link);
    return link.empty() ? message("What the sensor sees is not on {}, but on {}.", s.tcp, body_text(s, what))
                        : message("The sensor is not on {}, but on {}.", s.mount.link, body_text(s, link));
  };
  k.fix = [](const std::string& where, const Session& s) {
    const auto [what, link] = name_and_value(where);
    if (where == "exchanged")
      return message("Write tcp=\"{}\" and mount=\"{}\" into {}.", s.mount.link, s.tcp, session_name(s));
    return link.empty() ? message("Write tcp=\"{}\" into <robot> of {}.", what, session_name(s))
                        : message("Write mount=\"{}\" into {}.", link, session_name(s));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> link_blunders() { return {wrong_link()}; }

}  // namespace handsight
