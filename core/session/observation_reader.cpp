// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/message_xml.h"
#include "base/numbers.h"
#include "base/text.h"
#include "robot/xml_rigid.h"
#include "session/observation_xml.h"
#include "session/touch_xml.h"

namespace handsight {

namespace {

Eigen::VectorXd read_joint_vector(const XmlNode& node, const Session& session, const Bounds& within, Ignored& ignored) {
  note_unknown(ignored, node, {}, {}, true);
  const std::vector<double> numbers = inner_numbers(node, session.joints.size(), "one for each of <joints>", within);
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

Eigen::VectorXd find_joint_vector(const XmlNode& observation, const char* tag, const Session& session,
                                  const Bounds& within, Ignored& ignored) {
  const auto node = find_child(observation, tag);
  return node ? read_joint_vector(*node, session, within, ignored) : Eigen::VectorXd();
}

Eigen::VectorXd read_flange_pose(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {"xyz", "quaternion", "rpy"}, {});
  return make_position(read_pose(node));
}

/// Images are looked for in the session's folder and nowhere else.
std::string find_image(const XmlNode& node, const char* attribute) {
  const std::optional<std::string> text = find_name(node, attribute);
  if (!text) return {};
  const std::filesystem::path path = *text;
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.empty() || path.is_absolute() || climbs)
    refuse(node, message("has {}={}, expected a path relative to the session's folder and inside it.",
                         verbatim(attribute), in_quotes(*text, 100)));
  return *text;
}

/// The cameras' names as attributes; of a tracker's session, which has none, those of a pair.
void read_images(const XmlNode& node, const Session& session, Observation& observation, Ignored& ignored) {
  const std::vector<std::string> names = camera_names(session.rig.value_or(make_rig(StereoRig{})));
  note_unknown(ignored, node, names, {});
  for (std::size_t c = 0; c < names.size(); ++c) observation.images[c] = find_image(node, names[c].c_str());
}

std::optional<Vector2> find_pixel(const XmlNode& node, const char* attribute) {
  const auto numbers = find_numbers(node, attribute, 2, bounds::pixel);
  if (!numbers) return std::nullopt;
  return Vector2(numbers->data());
}

std::optional<PixelSigma> find_pixel_sigma(const XmlNode& node, const char* attribute, bool is_seen) {
  const auto numbers = find_numbers(node, attribute, 3);
  if (!numbers) return std::nullopt;
  const PixelSigma sigma{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  const bool is_covariance =
      bounds::sigma_pixel.hold(sigma.u) && bounds::sigma_pixel.hold(sigma.v) && std::abs(sigma.uv) < sigma.u * sigma.v;
  if (!is_covariance || !is_seen)
    refuse(node, message("has {}={}, expected {}.", verbatim(attribute), in_quotes(*find_text(node, attribute), 100),
                         is_seen ? "\"su sv suv\": two standard deviations of 1e-9 to 1e4 px, and a covariance in px^2 "
                                   "that is smaller than their product"
                                 : "none, as that camera did not see the marker"));
  return sigma;
}

Message neither_of(const Rig& rig) {
  if (rig.count() == 1) return message("has no {}", rig.at(0).name);
  return message("has neither {}", joined(verbatim(camera_names(rig)), " nor "));
}

void read_camera_points(const XmlNode& node, const Rig& rig, Sighting& sighting, Ignored& ignored) {
  std::vector<std::string> known{"index", "by"};
  for (const RigCamera& c : rig.cameras) known.insert(known.end(), {c.name, c.name + "_sigma"});
  note_unknown(ignored, node, known, {});
  for (int c = 0; c < rig.count(); ++c) {
    const std::string& name = rig.at(c).name;
    const auto pixel = find_pixel(node, name.c_str());
    const auto sigma = find_pixel_sigma(node, (name + "_sigma").c_str(), pixel.has_value());
    if (pixel) see(sighting, c, *pixel, sigma);
  }
  if (sighting.in_cameras.empty())
    refuse(node, message("{}{} marker that is not seen has no element.", neither_of(rig),
                         rig.count() == 1 ? "; a" : ", expected at least one; a"));
}

Sighting read_sighting(const XmlNode& node, const Session& session, Ignored& ignored) {
  Sighting sighting;
  sighting.marker = static_cast<int>(required_integer(node, "index", 0, session.marker_count - 1));
  if (session.is_tracker()) {
    note_unknown(ignored, node, {"index", "by", "point", "sigma"}, {});
    if (const auto point = find_numbers(node, "point", 3, bounds::length)) sighting.point = Vector3(point->data());
    sighting.point_sigma = find_positive(node, "sigma", bounds::sigma_point);
    if (!sighting.point) refuse(node, "has no point, expected point=\"x y z\" as this is a tracker session.");
  } else {
    read_camera_points(node, *session.rig, sighting, ignored);
  }
  constexpr std::array makers{MarkedBy::hand, MarkedBy::tracker, MarkedBy::import};
  sighting.by = makers[find_choice(node, "by", {"hand", "tracker", "import"}).value_or(2)];
  return sighting;
}

void read_sightings(const XmlNode& node, const Session& session, Observation& observation, Ignored& ignored) {
  std::vector<char> seen(static_cast<std::size_t>(session.marker_count), 0);
  for (const XmlNode& marker : children(node, "marker")) {
    const Sighting sighting = read_sighting(marker, session, ignored);
    if (seen[static_cast<std::size_t>(sighting.marker)])
      refuse(marker,
             message("has index=\"{}\" a second time in its observation, expected each marker once.", sighting.marker));
    seen[static_cast<std::size_t>(sighting.marker)] = 1;
    observation.sightings.push_back(sighting);
  }
  std::sort(observation.sightings.begin(), observation.sightings.end(),
            [](const Sighting& a, const Sighting& b) { return a.marker < b.marker; });
}

/// With its parts where they stand beside the text and say the same: another program may have changed the text alone. A
/// text alone is looked up as it is: sentences without parts are known in each language.
Message read_reason(const XmlNode& node) {
  const std::string text = find_text(node, "reason").value_or("");
  for (const XmlNode& part : children(node))
    if (part.tag() == "form" || part.tag() == "sequence")
      if (Message with_parts = read_message(part); with_parts == text) return with_parts;
  return looked_up(text);
}

void read_decision(const XmlNode& node, Observation& observation, Ignored& ignored) {
  note_unknown(ignored, node, {"state", "reason"}, {"form", "sequence"});
  constexpr std::array decisions{Decision::accepted, Decision::rejected, Decision::excluded};
  required_text(node, "state");
  observation.decision = decisions[*find_choice(node, "state", {"accepted", "rejected", "excluded"})];
  observation.reason = read_reason(node);
}

}  // namespace

Observation read_observation(const XmlNode& node, const Session& session, Ignored& ignored) {
  note_unknown(
      ignored, node, {"id", "time"},
      {"position", "velocity", "torque", "images", "marker", "touched", "decision", "target_pose", "flange_pose"});
  Observation observation;
  observation.id = required_integer(node, "id", 0, INT64_MAX);
  observation.time = required_number(node, "time", bounds::time);
  observation.position = session.robot.is_of_poses
                             ? read_flange_pose(required_child(node, "flange_pose"), ignored)
                             : read_joint_vector(required_child(node, "position"), session, bounds::joint, ignored);
  observation.velocity = find_joint_vector(node, "velocity", session, bounds::joint, ignored);
  observation.torque = find_joint_vector(node, "torque", session, bounds::torque, ignored);
  if (const auto images = find_child(node, "images")) read_images(*images, session, observation, ignored);
  if (session.is_touch())
    read_touched(node, session, observation, ignored);
  else if (!session.pose_sensor)
    read_sightings(node, session, observation, ignored);
  if (const auto pose = find_child(node, "target_pose"); pose && session.pose_sensor) {
    note_unknown(ignored, *pose, {"xyz", "quaternion", "rpy"}, {});
    observation.target_pose = read_pose(*pose);
  }
  if (const auto decision = find_child(node, "decision")) read_decision(*decision, observation, ignored);
  return observation;
}

}  // namespace handsight
