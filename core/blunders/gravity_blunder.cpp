// SPDX-License-Identifier: Apache-2.0
#include "blunders/gravity_blunder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"

namespace handsight {
namespace {

constexpr const char* directions[] = {"-z", "z", "x", "-x", "y", "-y"};

/// The unit vector that a place names.
Vector3 direction_named(const std::string& where) {
  if (std::find(std::begin(directions), std::end(directions), where) == std::end(directions))
    throw InputError(message("gravity_turned: {:?} is no direction; expected one of: {}.", where,
                             fmt::join(std::begin(directions), std::end(directions), " ")));
  return (where.size() > 1 ? -1.0 : 1.0) * Vector3::Unit(where.back() - 'x');
}

double strength(const Session& s) { return s.gravity.norm() > 0 ? s.gravity.norm() : 9.81; }

bool has_torques(const Session& s) {
  return std::any_of(s.observations.begin(), s.observations.end(),
                     [](const Observation& o) { return o.torque.size() > 0; });
}

BlunderKind gravity_turned() {
  BlunderKind k;
  k.id = "gravity_turned";
  k.places = [](const Session& s) {
    return feels_gravity(s) || has_torques(s) ? other_directions(s) : std::vector<std::string>{};
  };
  k.mend = [](const std::string& where, Session& s) { s.gravity = strength(s) * direction_named(where); };
  k.text = [](const std::string& where, const Session&) {
    return message("Gravity does not pull as the session says, but along {} of the robot's root link.", where);
  };
  k.fix = [](const std::string& where, const Session& s) {
    const Vector3 right = strength(s) * direction_named(where);
    return message("Write <gravity xyz=\"{}\"/> into {}.", format_numbers({right.data(), 3}), session_name(s));
  };
  return k;
}

}  // namespace

std::vector<std::string> other_directions(const Session& s) {
  std::vector<std::string> others;
  for (const char* where : directions)
    if ((direction_named(where) - s.gravity / strength(s)).norm() > 0.1) others.emplace_back(where);
  return others;
}

bool feels_gravity(const Session& s) {
  const bool has_springs = std::any_of(s.robot.joints.begin(), s.robot.joints.end(),
                                       [](const Joint& j) { return j.moves() && j.stiffness > 0; });
  const bool has_masses =
      std::any_of(s.robot.links.begin(), s.robot.links.end(), [](const Link& l) { return l.mass > 0; });
  return !s.robot.is_of_poses && has_springs && has_masses;
}

std::vector<BlunderKind> gravity_blunders() { return {gravity_turned()}; }

}  // namespace handsight
