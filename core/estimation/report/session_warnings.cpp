// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/session_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chain/chain.h"
#include "estimation/report/stood_still.h"

namespace handsight {
namespace {

constexpr double most_of_a_turn = 4 * std::numbers::pi;  // rad: no joint of a robot turns farther

bool is_inside(const Vector2& px, int width, int height) {
  return px.x() >= -0.5 && px.y() >= -0.5 && px.x() <= width - 0.5 && px.y() <= height - 0.5;
}

void warn_of_points(const Session& session, std::vector<Message>& warnings) {
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
  Message text = message("{} image points lie outside the image of {} x {} px, first in observation {}", outside,
                         camera.width, camera.height, first);
  text += outside_turned == 0 ? ": are width and height of the cameras swapped?"
                              : "; look whether they are px of these cameras, and relabel or exclude them.";
  warnings.push_back(text);
}

void warn_of_markers(const Session& session, std::vector<Message>& warnings) {
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
  warnings.push_back(
      message("Of {} markers {} {} never seen: count=\"{}\" in session.xml is enough, or labels are missing.",
              session.marker_count, names, unseen == 1 ? "is" : "are", session.marker_count - unseen));
}

/// Boards of metres are millimetres, mostly.
void warn_of_target(const Session& session, std::vector<Message>& warnings) {
  constexpr double largest = 0.7;  // m: of one square or tag
  if (!session.target) return;
  const Target& t = *session.target;
  const bool has_squares = t.kind == TargetKind::chessboard || t.kind == TargetKind::charuco;
  const double length = has_squares ? t.square : t.tag;
  if (length <= largest) return;
  warnings.push_back(
      message("The target's {} are of {:g} m: if millimetres are meant, write {:g} into <target>; its lengths are m.",
              has_squares ? "squares" : "tags", length, 1e-3 * length));
}

void warn_of_angles(const Session& session, const Chain& chain, std::vector<Message>& warnings) {
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
    warnings.push_back(
        message("Joint {} stands at {:.4g} rad, which is {:.0f} turns: are the angles degrees? Sessions hold rad.",
                worst, largest, largest / (2 * std::numbers::pi)));
}

void warn_of_joints(const Session& session, const Chain& chain, std::vector<Message>& warnings) {
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
    warnings.push_back(
        message("Between camera and hand {} can move, but the session has no angles of it: it is taken to stand at "
                "0. Add it to "
                "the joints, or fix it in the robot's file.",
                missing));
}

void warn_of_masses(const Session& session, const Chain& chain, std::vector<Message>& warnings) {
  const auto& links = chain.robot.links;
  if (chain.robot.is_of_poses || session.gravity.isZero() ||
      std::any_of(links.begin(), links.end(), [](const Link& l) { return l.mass > 0; }))
    return;
  warnings.emplace_back(
      "No link of the robot has a mass: what gravity does to it cannot be told. Give the masses in the robot's file.");
}

/// Arms turn by less than a whole turn to either side; a few joints may turn on and on.
void warn_of_turns(const Session& session, std::vector<Message>& warnings) {
  int large = 0, all = 0;
  double largest = 0;
  for (const Observation& o : session.observations)
    for (std::size_t j = 0; j < session.joints.size(); ++j) {
      const int joint = find_joint(session.robot, session.joints[j]);
      if (joint < 0 || session.robot.joints[static_cast<std::size_t>(joint)].kind != JointKind::revolute) continue;
      const double q = std::abs(o.position[static_cast<Eigen::Index>(j)]);
      ++all;
      large += q > 2 * std::numbers::pi;
      largest = std::max(largest, q);
    }
  if (5 * large > all)
    warnings.push_back(
        message("{} of {} joint positions are beyond a whole turn (up to {:.4g} rad): are they in degrees?", large, all,
                largest));
}

void warn_of_poses(const Session& session, std::vector<Message>& warnings) {
  if (session.observations.size() > 1 && never_moved(session))
    warnings.emplace_back("All observations have the same joint positions: nothing can be told from one pose.");
}

void warn_of_camera(const std::string& name, const Camera& c, std::vector<Message>& warnings) {
  const double view = 2 * 180 / std::numbers::pi * std::atan(0.5 * c.width / c.fx);
  if (view < 1 || view > 170)
    warnings.push_back(message("The {} camera sees {:.3g} degrees across (fx {:g} px, {} px wide): is fx in px?", name,
                               view, c.fx, c.width));
  if (const double ratio = c.fx / c.fy; ratio < 0.5 || ratio > 2)
    warnings.push_back(message("The {} camera's fx {:g} and fy {:g} are far from each other.", name, c.fx, c.fy));
  if (c.cx < 0 || c.cy < 0 || c.cx > c.width || c.cy > c.height)
    warnings.push_back(
        message("The {} camera's principal point {:g}, {:g} lies outside of its image.", name, c.cx, c.cy));
}

/// The first camera and another one.
void warn_of_pair(const Session& session, int camera, std::vector<Message>& warnings) {
  const Rig& rig = *session.rig;
  const std::string &first = rig.at(0).name, &other = rig.at(camera).name;
  int pairs = 0, equal = 0, files = 0;
  for (const Observation& o : session.observations) {
    files += !o.images[0].empty() && o.images[0] == o.images[static_cast<std::size_t>(camera)];
    for (const Sighting& s : o.sightings) {
      const CameraPoint *a = seen_by(s, 0), *b = seen_by(s, camera);
      pairs += a && b;
      equal += a && b && a->pixel == b->pixel;
    }
  }
  if (2 * equal > pairs)
    warnings.push_back(
        message("In {} of {} sightings the {} point is the {} one: is one column copied?", equal, pairs, first, other));
  if (files > 0) warnings.push_back(message("In {} observations the {} image is the {} one.", files, first, other));
  const double baseline = rig.at(camera).camera_from_first.translation.norm();
  if (baseline >= 2e-3 && baseline <= 10) return;
  if (is_left_and_right(rig))
    warnings.push_back(message("The cameras are {:.4g} m apart: is right_from_left in m?", baseline));
  else
    warnings.push_back(
        message("The cameras {} and {} are {:.4g} m apart: is from_first in m?", first, other, baseline));
}

void warn_of_gravity(const Session& session, std::vector<Message>& warnings) {
  if (const double g = session.gravity.norm(); std::abs(g - 9.81) > 0.2)
    warnings.push_back(message("Gravity is {:.4g} m/s^2; on Earth it is 9.78 to 9.83.", g));
}

}  // namespace

bool never_moved(const Session& session) {
  constexpr double still = 1e-6;  // rad, m: less than any encoder tells
  const Eigen::VectorXd first =
      session.observations.empty() ? Eigen::VectorXd() : session.observations.front().position;
  return std::all_of(session.observations.begin(), session.observations.end(), [&](const Observation& o) {
    return o.position.size() == first.size() &&
           (first.size() == 0 || (o.position - first).cwiseAbs().maxCoeff() < still);
  });
}

std::vector<Message> session_warnings(const Session& session) {
  std::vector<Message> warnings;
  const Chain chain = make_chain(session);
  warn_of_points(session, warnings);
  warn_of_markers(session, warnings);
  warn_of_target(session, warnings);
  const std::size_t before = warnings.size();
  warn_of_angles(session, chain, warnings);
  if (warnings.size() == before) warn_of_turns(session, warnings);
  warn_of_poses(session, warnings);
  warn_of_joints(session, chain, warnings);
  warn_of_masses(session, chain, warnings);
  if (session.rig) {
    for (const RigCamera& c : session.rig->cameras) warn_of_camera(c.name, c.camera, warnings);
    // The cameras of several sessions are no rig together; each session has been doubted by itself.
    for (int c = 1; session.parts.empty() && c < session.rig->count(); ++c) warn_of_pair(session, c, warnings);
  }
  warn_of_gravity(session, warnings);
  const std::vector<Message> old = standstill_warnings(session);
  warnings.insert(warnings.end(), old.begin(), old.end());
  return warnings;
}

Message body_warning(const Rigid& tcp_from_body) {
  constexpr double longest = 1.5;  // m
  const double distance = tcp_from_body.translation.norm();
  if (distance <= longest) return {};
  return message(
      "The marker body would be {:.2g} m from the TCP: look whether the TCP is the hand's link, and whether lengths "
      "are m.",
      distance);
}

}  // namespace handsight
