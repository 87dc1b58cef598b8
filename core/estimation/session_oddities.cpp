// SPDX-License-Identifier: Apache-2.0
#include "estimation/session_oddities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handsight {
namespace {

using Sentences = std::vector<std::string>;

constexpr double degrees = 180 / std::numbers::pi;

/// Arms turn by less than a whole turn to either side; a few joints may turn on and on.
void look_at_positions(const Session& session, Sentences& said) {
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
    said.push_back(
        fmt::format("{} of {} joint positions are beyond a whole turn (up to {:.4g} rad): are they in degrees?", large,
                    all, largest));
  const auto same = [&](const Observation& o) { return o.position == session.observations.front().position; };
  if (session.observations.size() > 1 && std::all_of(session.observations.begin(), session.observations.end(), same))
    said.emplace_back("All observations have the same joint positions: nothing can be told from one pose.");
}

void look_at_camera(const std::string& name, const Camera& c, Sentences& said) {
  const double view = 2 * degrees * std::atan(0.5 * c.width / c.fx);
  if (view < 1 || view > 170)
    said.push_back(fmt::format("The {} camera sees {:.3g} degrees across (fx {:g} px, {} px wide): is fx in px?", name,
                               view, c.fx, c.width));
  if (const double ratio = c.fx / c.fy; ratio < 0.5 || ratio > 2)
    said.push_back(fmt::format("The {} camera's fx {:g} and fy {:g} are far from each other.", name, c.fx, c.fy));
  if (c.cx < 0 || c.cy < 0 || c.cx > c.width || c.cy > c.height)
    said.push_back(
        fmt::format("The {} camera's principal point {:g}, {:g} lies outside of its image.", name, c.cx, c.cy));
}

/// The first camera and another one.
void look_at_pair(const Session& session, int camera, Sentences& said) {
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
    said.push_back(fmt::format("In {} of {} sightings the {} point is the {} one: is one column copied?", equal, pairs,
                               first, other));
  if (files > 0) said.push_back(fmt::format("In {} observations the {} image is the {} one.", files, first, other));
  const double baseline = rig.at(camera).camera_from_first.translation.norm();
  if (baseline >= 2e-3 && baseline <= 10) return;
  if (is_left_and_right(rig))
    said.push_back(fmt::format("The cameras are {:.4g} m apart: is right_from_left in m?", baseline));
  else
    said.push_back(
        fmt::format("The cameras {} and {} are {:.4g} m apart: is from_first in m?", first, other, baseline));
}

}  // namespace

std::vector<std::string> session_oddities(const Session& session) {
  Sentences said;
  look_at_positions(session, said);
  if (session.rig) {
    for (const RigCamera& c : session.rig->cameras) look_at_camera(c.name, c.camera, said);
    for (int c = 1; c < session.rig->count(); ++c) look_at_pair(session, c, said);
  }
  if (const double g = session.gravity.norm(); std::abs(g - 9.81) > 0.2)
    said.push_back(fmt::format("Gravity is {:.4g} m/s^2; on Earth it is 9.78 to 9.83.", g));
  return said;
}

}  // namespace handsight
