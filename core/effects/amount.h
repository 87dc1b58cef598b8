// SPDX-License-Identifier: Apache-2.0
// By how much an effect moves a site, where that depends on the observation. It is written once, as a function that
// takes numbers of any kind: called with doubles it moves the chain, called with symbols it writes the formula that
// exported programs hold.
//
//   effect.parameters = {{"sine", "rad", 1e-3}};
//   moves_angle(effect, [](const auto& joint, const auto& number) { return number[0] * sin(joint.q); });
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "effects/effect.h"
#include "effects/symbol.h"

namespace handsight {

/// What an amount may read of a joint in one observation; N is double or Symbol.
template <class N>
struct JointReading {
  N q;         // rad (m), as the sensor reads
  N velocity;  // rad/s (m/s)
  N approach;  // the sign of its last motion
};

/// ... and of the observation.
template <class N>
struct Moment {
  N order;  // observations counted from 0
};

inline JointReading<double> read_joint(const ObservationState& c, int joint) {
  return {c.sensor[joint], c.velocity[joint], c.approach[joint]};
}

/// The effect's own joint, as formulas call it.
JointReading<Symbol> own_joint();

/// Another joint, of which formulas know the angle alone.
JointReading<Symbol> named_joint(const Chain& chain, int joint);

/// The effect's parameters by their names.
std::vector<Symbol> parameter_symbols(const Effect& effect);

/// The effect, of joint scope, adds amount(JointReading of its joint, its numbers) to its joint's angle (rad or m). Set
/// the parameters before.
template <class Amount>
void moves_angle(Effect& effect, Amount amount) {
  effect.move = [amount](const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
    sites.robot.joints[static_cast<std::size_t>(place)].angle += amount(read_joint(c, place), values);
  };
  effect.formulas = [amount, names = parameter_symbols(effect)](const Chain&, int, std::span<const double>) {
    return std::vector<DefinedMove>{{"angle", amount(own_joint(), names).text()}};
  };
}

/// The same with the reading of another joint, other(chain, place, values); where that is nothing, it adds nothing.
template <class Amount, class Other>
void moves_angle_with(Effect& effect, Other other, Amount amount) {
  effect.move = [amount, other](const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
    if (const std::optional<int> joint = other(*c.chain, place, values))
      sites.robot.joints[static_cast<std::size_t>(place)].angle += amount(read_joint(c, *joint), values);
  };
  effect.formulas = [amount, other, names = parameter_symbols(effect)](const Chain& chain, int place,
                                                                       std::span<const double> values) {
    std::vector<DefinedMove> moves;
    if (const std::optional<int> joint = other(chain, place, values))
      moves.push_back({"angle", amount(named_joint(chain, *joint), names).text()});
    return moves;
  };
}

/// The effect, of session scope, adds amount(JointReading of a joint, its numbers) to the angle of every joint that
/// moves by itself: mimic joints follow.
template <class Amount>
void moves_every_angle(Effect& effect, Amount amount) {
  effect.move = [amount](const ObservationState& c, int, std::span<const double> values, Sites& sites) {
    const std::vector<Joint>& joints = c.chain->robot.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (joints[j].moves() && !joints[j].is_mimic())
        sites.robot.joints[j].angle += amount(read_joint(c, static_cast<int>(j)), values);
  };
  effect.formulas = [amount, names = parameter_symbols(effect)](const Chain&, int, std::span<const double>) {
    return std::vector<DefinedMove>{{every_angle, amount(own_joint(), names).text()}};
  };
}

/// The effect, of session scope, adds amount(Moment, its numbers, axis) to the body's motion along or about each of its
/// six axes (m, rad).
template <class Amount>
void moves_body(Effect& effect, Amount amount) {
  effect.move = [amount](const ObservationState& c, int, std::span<const double> values, Sites& sites) {
    for (int axis = 0; axis < 6; ++axis)
      sites.body[axis] += amount(Moment<double>{static_cast<double>(c.order)}, values, static_cast<std::size_t>(axis));
  };
  effect.formulas = [amount, names = parameter_symbols(effect)](const Chain&, int, std::span<const double>) {
    std::vector<DefinedMove> moves;
    for (std::size_t axis = 0; axis < 6; ++axis)
      moves.push_back(
          {std::string("body_") + motion_axes[axis], amount(Moment<Symbol>{Symbol("order")}, names, axis).text()});
    return moves;
  };
}

}  // namespace handsight
