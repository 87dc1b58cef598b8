// SPDX-License-Identifier: Apache-2.0
#include "estimation/session_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/chain.h"

namespace handsight {
namespace {

constexpr double most_of_a_turn = 4 * std::numbers::pi;  // rad: no joint of a robot turns farther

bool is_inside(const Vector2& px, int width, int height) {
  return px.x() >= -0.5 && px.y() >= -0.5 && px.x() <= width - 0.5 && px.y() <= height - 0.5;
}

void doubt_points(const Session& session, std::vector<std::string>& doubts) {
  if (!session.rig) return;
  int outside = 0, outside_turned = 0;
  std::int64_t first = -1;
  const auto look = [&](const Vector2& px, const Camera& camera, std::int64_t id) {
    outside_turned += is_inside(px, camera.height, camera.width) ? 0 : 1;
    if (is_inside(px, camera.width, camera.height)) return;
    if (outside++ == 0) first = id;
  };
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings)
      for (const CameraPoint& p : s.in_cameras) look(p.pixel, session.rig->at(p.camera).camera, o.id);
  if (outside == 0) return;
  const Camera& camera = session.rig->at(0).camera;
  std::string text = fmt::format("{} image points lie outside the image of {} x {} px, first in observation {}",
                                 outside, camera.width, camera.height, first);
  text += outside_turned == 0 ? ": are width and height of the cameras swapped?"
                              : "; look whether they are px of these cameras, and relabel or exclude them.";
  doubts.push_back(text);
}

void doubt_markers(const Session& session, std::vector<std::string>& doubts) {
  std::vector<char> seen(static_cast<std::size_t>(session.marker_count), 0);
  bool any = false;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings)
      if (s.marker >= 0 && s.marker < session.marker_count) seen[static_cast<std::size_t>(s.marker)] = any = true;
  const auto unseen = std::count(seen.begin(), seen.end(), 0);
  const bool are_images_left = std::any_of(session.observations.begin(), session.observations.end(),
                                           [](const auto& o) { return o.sightings.empty() && has_images(o); });
  if (!any || unseen == 0 || are_images_left || session.shape) return;
  std::string names;
  for (std::size_t m = 0; m < seen.size(); ++m)
    if (!seen[m]) names += fmt::format("{}{}", names.empty() ? "" : ", ", m);
  doubts.push_back(
      fmt::format("Of {} markers {} {} never seen: count=\"{}\" in session.xml is enough, or labels are missing.",
                  session.marker_count, names, unseen == 1 ? "is" : "are", session.marker_count - unseen));
}

void doubt_angles(const Session& session, const Chain& chain, std::vector<std::string>& doubts) {
  std::string worst;
  double largest = 0;
  for (std::size_t j = 0; j < chain.joints.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[j])];
    if (joint.kind == JointKind::prismatic) continue;
    for (const Observation& o : session.observations)
      if (const double q = std::abs(o.position[static_cast<Eigen::Index>(j)]); q > largest) {
        largest = q;
        worst = joint.name;
      }
  }
  if (largest > most_of_a_turn)
    doubts.push_back(
        fmt::format("Joint {} stands at {:.4g} rad, which is {:.0f} turns: are the angles degrees? Sessions hold rad.",
                    worst, largest, largest / (2 * std::numbers::pi)));
}

void doubt_joints(const Session& session, const Chain& chain, std::vector<std::string>& doubts) {
  const Robot& robot = chain.robot;
  const std::vector<int> hand = joints_to(robot, chain.tcp_link), camera = joints_to(robot, chain.mount_link);
  std::string missing;
  const auto look = [&](const std::vector<int>& own, const std::vector<int>& others) {
    for (const int j : own) {
      const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
      const bool is_between = std::find(others.begin(), others.end(), j) == others.end();
      const bool is_measured = std::find(chain.joints.begin(), chain.joints.end(), j) != chain.joints.end();
      if (is_between && joint.moves() && !joint.is_mimic() && !is_measured)
        missing += (missing.empty() ? "" : ", ") + joint.name;
    }
  };
  look(hand, camera);
  look(camera, hand);
  if (!missing.empty())
    doubts.push_back(
        fmt::format("Between camera and hand {} can move, but the session has no angles of it: it is taken to stand at "
                    "0. Add it to "
                    "the joints, or fix it in the robot's file.",
                    missing));
}

void doubt_masses(const Session& session, const Chain& chain, std::vector<std::string>& doubts) {
  const auto& links = chain.robot.links;
  if (chain.robot.is_of_poses || session.gravity.isZero() ||
      std::any_of(links.begin(), links.end(), [](const Link& l) { return l.mass > 0; }))
    return;
  doubts.emplace_back(
      "No link of the robot has a mass: what gravity does to it cannot be told. Give the masses in the robot's file.");
}

}  // namespace

std::vector<std::string> session_doubts(const Session& session) {
  std::vector<std::string> doubts;
  const Chain chain = chain_of(session);
  doubt_points(session, doubts);
  doubt_markers(session, doubts);
  doubt_angles(session, chain, doubts);
  doubt_joints(session, chain, doubts);
  doubt_masses(session, chain, doubts);
  return doubts;
}

std::string body_doubt(const Rigid& tcp_from_body) {
  constexpr double longest = 1.5;  // m
  const double distance = tcp_from_body.translation.norm();
  if (distance <= longest) return {};
  return fmt::format(
      "The marker body would be {:.2g} m from the TCP: look whether the TCP is the hand's link, and whether lengths "
      "are m.",
      distance);
}

}  // namespace handsight
