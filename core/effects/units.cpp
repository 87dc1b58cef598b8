// SPDX-License-Identifier: Apache-2.0
#include "effects/units.h"

namespace handsight {
namespace {

/// Does the number move the joint's own position, and not a frame or a bend beside it?
bool moves_position(const Effect& effect, std::size_t parameter, int place, const Robot& robot) {
  Chain chain;
  chain.robot = robot;
  ObservationState somewhere;
  somewhere.chain = &chain;
  const auto count = static_cast<Eigen::Index>(robot.joints.size());
  somewhere.sensor = somewhere.velocity = somewhere.approach = somewhere.torque = Eigen::VectorXd::Ones(count);
  somewhere.tcp = Vector3::Ones();
  somewhere.elapsed = somewhere.duration = 1;
  std::vector<double> values(effect.parameters.size(), 0.0);
  values[parameter] = 1;
  Sites sites = unmoved_sites(chain);
  effect.move(somewhere, place, values, sites);
  const JointChange& joint = sites.robot.joints[static_cast<std::size_t>(place)];
  return joint.angle != 0 || joint.compliance != 0 || joint.gap != 0;
}

void replace(std::string& text, const std::string& part, const std::string& by) {
  if (const std::size_t at = text.find(part); at != std::string::npos) text.replace(at, part.size(), by);
}

}  // namespace

std::string unit_at(const Effect& effect, std::size_t parameter, int place, const Robot& robot) {
  std::string unit = effect.parameters[parameter].unit;
  if (place < 0 || !moves_one_joint(effect) || unit.find("rad") == std::string::npos) return unit;
  if (robot.joints[static_cast<std::size_t>(place)].kind != JointKind::prismatic) return unit;
  if (!moves_position(effect, parameter, place, robot)) return unit;
  replace(unit, "rad", "m");
  replace(unit, "(N m)", "N");
  return unit;
}

std::pair<std::string, double> readable_unit(const std::string& unit, double size) {
  const bool takes_prefix = unit.starts_with("rad") || unit == "m" || unit.starts_with("m/") || unit == "s";
  if (!takes_prefix || !(size > 0) || size >= 1) return {unit, 1};
  if (size >= 1e-3) return {"m" + unit, 1e3};
  return {"u" + unit, 1e6};
}

}  // namespace handsight
