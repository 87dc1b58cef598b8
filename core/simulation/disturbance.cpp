// SPDX-License-Identifier: Apache-2.0
#include <charconv>

#include "base/bounds.h"
#include "base/error.h"
#include "robot/joint_names.h"
#include "simulation/simulated_session.h"

namespace handsight {

Disturbance parse_disturbance(const std::string& text, const Robot& robot) {
  auto refuse = [&]() -> InputError {
    return InputError(message(
        "Disturbance \"{}\": write ID:joint:NAME=RAD, ID:marker:INDEX=METRES or ID:right_image:NAME=RAD.", text));
  };
  const auto first = text.find(':');
  const auto second = first == std::string::npos ? first : text.find(':', first + 1);
  const auto equals = second == std::string::npos ? second : text.find('=', second + 1);
  if (equals == std::string::npos) throw refuse();
  Disturbance d;
  auto number = [&](std::size_t from, std::size_t to, auto& value) {
    const auto [stop, error] = std::from_chars(text.data() + from, text.data() + to, value);
    if (error != std::errc() || stop != text.data() + to) throw refuse();
  };
  number(0, first, d.id);
  number(equals + 1, text.size(), d.size);
  if (!bounds::joint.hold(d.size)) throw refuse();
  const std::string kind = text.substr(first + 1, second - first - 1);
  d.name = text.substr(second + 1, equals - second - 1);
  if (kind == "marker") {
    d.kind = Disturbance::Kind::marker;
    number(second + 1, equals, d.index);
    return d;
  }
  if (kind != "joint" && kind != "right_image") throw refuse();
  d.kind = kind == "joint" ? Disturbance::Kind::joint : Disturbance::Kind::right_image;
  if (find_joint(robot, d.name) < 0)
    throw InputError(message("Disturbance \"{}\": the robot has no joint \"{}\"; it has: {}.", text, d.name,
                             list_moving_joints(robot)));
  return d;
}

}  // namespace handsight
