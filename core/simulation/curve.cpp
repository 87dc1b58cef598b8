// SPDX-License-Identifier: Apache-2.0
#include "simulation/curve.h"

#include <fmt/format.h>

#include <cmath>

#include "base/bounds.h"
#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "robot/joint_names.h"

namespace handsight {
namespace {

/// Size, function and order of "0.0015*sin(3q)"; false where it is something else.
bool read_formula(const std::string& formula, Curve& curve) {
  const auto times = formula.find('*'), open = formula.find('(');
  if (times == std::string::npos || open == std::string::npos || open < times) return false;
  if (formula.size() < open + 3 || formula.substr(formula.size() - 2) != "q)") return false;
  const std::string function = trimmed(formula.substr(times + 1, open - times - 1));
  if (function != "sin" && function != "cos") return false;
  const std::string order = trimmed(formula.substr(open + 1, formula.size() - open - 3));
  const auto size = parse_number(trimmed(formula.substr(0, times)));
  const auto factor = order.empty() ? std::optional(1.0) : parse_number(order);
  if (!size || !factor) return false;
  curve.size = *size;
  curve.cosine = function == "cos";
  curve.order = *factor;
  return bounds::joint.hold(curve.size) && bounds::joint.hold(curve.order);
}

}  // namespace

Curve parse_curve(const std::string& text, const Robot& robot) {
  const auto colon = text.rfind(':');
  Curve curve;
  if (colon == std::string::npos || !read_formula(trimmed(text.substr(colon + 1)), curve))
    throw InputError(message(
        "Curve \"{}\": write JOINT: SIZE*sin(ORDERq), with sin or cos, for example \"arm_3: 0.0015*sin(3q)\".", text));
  const std::string name = trimmed(text.substr(0, colon));
  curve.joint = find_joint(robot, name);
  if (curve.joint < 0 || !robot.joints[static_cast<std::size_t>(curve.joint)].moves())
    throw InputError(message("Curve \"{}\": the robot has no moving joint \"{}\"; it has: {}.", text, name,
                             list_moving_joints(robot)));
  return curve;
}

Sites moved_sites(const ObservationState& states, const std::vector<EffectTerm>& terms,
                  const std::vector<Curve>& curves) {
  Sites sites = moved_sites(states, terms);
  if (!curves.empty() && sites.robot.joints.empty()) sites.robot.joints.resize(states.chain->robot.joints.size());
  for (const Curve& curve : curves) {
    const double phase = curve.order * states.sensor[curve.joint];
    sites.robot.joints[static_cast<std::size_t>(curve.joint)].angle +=
        curve.size * (curve.cosine ? std::cos(phase) : std::sin(phase));
  }
  return sites;
}

std::string curve_formula(const Curve& curve) {
  return fmt::format("{}*{}({}q)", format_number(curve.size), curve.cosine ? "cos" : "sin", format_number(curve.order));
}

}  // namespace handsight
