// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "blunders/seen_points.h"

namespace handsight {
namespace {

int shift_in(const std::string& where) {
  const double number = number_in(where, "pairing_shift");
  if (number != std::round(number) || number == 0 || std::abs(number) > 1000)
    throw InputError(message("pairing_shift: {} is no number of places; expected 1, -1, 2 ...", where));
  return static_cast<int>(number);
}

/// The robot of observation i + shift to what was seen in observation i; those that lose their partner are left out.
void pair_with(Session& session, int shift) {
  const int count = static_cast<int>(session.observations.size());
  std::vector<Observation> paired;
  for (int i = 0; i < count; ++i) {
    if (i + shift < 0 || i + shift >= count) continue;
    Observation o = session.observations[static_cast<std::size_t>(i)];
    const Observation& robot = session.observations[static_cast<std::size_t>(i + shift)];
    o.position = robot.position;
    o.velocity = robot.velocity;
    o.torque = robot.torque;
    o.whole = nullptr;
    paired.push_back(std::move(o));
  }
  if (paired.empty())
    throw InputError(message("pairing_shift: the session has {} observations, fewer than that.", count));
  session.observations = std::move(paired);
}

BlunderKind pairing_shift() {
  BlunderKind k;
  k.id = "pairing_shift";
  k.places = [](const Session&) {
    std::vector<std::string> places;
    for (int n = 1; n <= farthest_shift; ++n)
      for (const int signed_n : {n, -n}) places.push_back(std::to_string(signed_n));
    return places;
  };
  k.mend = [](const std::string& where, Session& s) { pair_with(s, shift_in(where)); };
  k.text = [](const std::string& where, const Session& s) {
    const int n = shift_in(where);
    return message(
        "What was seen and where the robot stood are paired {} off: each {} belongs to the robot's {} {} "
        "{}.",
        std::abs(n), s.rig ? "image" : "measurement", s.robot.is_of_poses ? "pose" : "angles",
        std::abs(n) == 1 ? "one line" : message("{} lines", std::abs(n)), n > 0 ? "later" : "earlier");
  };
  k.fix = [](const std::string& where, const Session& s) {
    const int n = shift_in(where);
    return message(
        "In {} give each observation the robot's readings of the one {} place{} {} (leave out the {} {} of "
        "the table of the robot that it was made of).",
        session_name(s), std::abs(n), std::abs(n) == 1 ? "" : "s", n > 0 ? "later" : "before", n > 0 ? "first" : "last",
        std::abs(n) == 1 ? "line" : message("{} lines", std::abs(n)));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> pairing_blunders() { return {pairing_shift()}; }

}  // namespace handsight
