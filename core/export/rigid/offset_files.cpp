// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/offset_files.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {
namespace {

using Json = nlohmann::ordered_json;
using tinyxml2::XMLElement;

const Joint& joint_at(const CalibratedRobot& robot, std::size_t i) {
  return robot.chain.robot.joints[static_cast<std::size_t>(robot.chain.joints[i])];
}

JointChange& change_at(const CalibratedRobot& robot, RobotChange& change, std::size_t i) {
  return change.joints[static_cast<std::size_t>(robot.chain.joints[i])];
}

constexpr double ticks_a_turn = 4096, radians_a_tick = 2 * M_PI / ticks_a_turn;

long integer_of(const Json& motor, const char* key, const std::string& joint) {
  if (!motor.is_object() || !motor.contains(key) || !motor[key].is_number())
    throw InputError(message("lerobot's calibration has no number {} for {}; expected the JSON that lerobot wrote.",
                             in_quotes(key), in_quotes(joint)));
  return std::lround(motor[key].get<double>());
}

Json read_before(const std::string& text) {
  if (text.empty()) return Json::object();
  Json before = Json::parse(text, nullptr, false);
  if (!before.is_object())
    throw InputError(
        "lerobot's calibration cannot be read; expected the JSON object that lerobot wrote, a motor each.");
  return before;
}

/// What the arm had, or a motor that reads a whole turn.
Json motor_before(const Json& before, const std::string& joint, std::size_t number) {
  if (before.empty())
    return {{"id", number + 1}, {"drive_mode", 0}, {"homing_offset", 0}, {"range_min", 0}, {"range_max", 4095}};
  if (!before.contains(joint))
    throw InputError(
        message("lerobot's calibration has no motor {}; the joints of the session need the names that "
                "it gives its motors.",
                in_quotes(joint)));
  return before[joint];
}

}  // namespace

std::string ros2_control_file(const CalibratedRobot& robot, const RigidFit& fit) {
  tinyxml2::XMLDocument document;
  std::string comment = fmt::format(
      " Calibrated by Handsight from {}. offset: true angle = reading + offset (rad, m); give it to the hardware "
      "interface. This file holds the joints' zeros alone, fitted again without all else: the hand is {} from where "
      "the whole calibration has it, {:.3f} mm rms without them. ",
      in_quotes(robot.calibration.session, 200), missed_text(fit), 1e3 * fit.nominal.rms);
  for (std::size_t at; (at = comment.find("--")) != std::string::npos;) comment.replace(at, 2, "- -");
  document.InsertEndChild(document.NewComment(comment.c_str()));
  XMLElement& root = *document.NewElement("ros2_control");
  document.InsertEndChild(&root);
  root.SetAttribute("name", robot.chain.robot.name.c_str());
  root.SetAttribute("type", "system");
  for (std::size_t i = 0; i < robot.joint_names.size(); ++i) {
    XMLElement& joint = *root.InsertNewChildElement("joint");
    joint.SetAttribute("name", robot.joint_names[i].c_str());
    joint.InsertNewChildElement("command_interface")->SetAttribute("name", "position");
    joint.InsertNewChildElement("state_interface")->SetAttribute("name", "position");
    XMLElement& offset = *joint.InsertNewChildElement("param");
    offset.SetAttribute("name", "offset");
    offset.SetText(format_number(fit.change.joints[static_cast<std::size_t>(robot.chain.joints[i])].angle).c_str());
  }
  return xml_text(document);
}

std::string lerobot_file(const CalibratedRobot& robot, RigidFit& fit, const std::string& before) {
  const Json known = read_before(before);
  Json all = known;
  for (std::size_t i = 0; i < robot.joint_names.size(); ++i) {
    const std::string& name = robot.joint_names[i];
    if (joint_at(robot, i).kind == JointKind::prismatic)
      throw InputError(
          message("Joint {} slides, and lerobot's calibration is of motors that turn; export as urdf or "
                  "ros2_control.",
                  in_quotes(name)));
    Json motor = motor_before(known, name, i);
    double& angle = change_at(robot, fit.change, i).angle;
    const long sense = integer_of(motor, "drive_mode", name) != 0 ? -1 : 1;
    const long ticks = std::lround(angle / radians_a_tick);
    motor["homing_offset"] = integer_of(motor, "homing_offset", name) - sense * ticks;
    angle = static_cast<double>(ticks) * radians_a_tick;
    all[name] = motor;
  }
  fit.left = missed_with(robot, fit.change);
  return all.dump(4) + "\n";
}

}  // namespace handsight
