// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "blunders/zero_search.h"

namespace handsight {
namespace {

/// Does something with every vector by joint of the session.
template <class Act>
void each_vector(Session& session, const Act& act) {
  for (Observation& o : session.observations)
    for (Eigen::VectorXd* v : {&o.position, &o.velocity, &o.torque})
      if (v->size() == static_cast<Eigen::Index>(session.joints.size())) act(*v);
}

BlunderKind joint_sense() {
  BlunderKind k;
  k.id = "joint_sense";
  k.places = telling_joints;
  k.mend = [](const std::string& where, Session& s) {
    const Eigen::Index j = joint_place(s, where, "joint_sense");
    each_vector(s, [&](Eigen::VectorXd& v) { v[j] = -v[j]; });
  };
  k.text = [](const std::string& where, const Session&) {
    return message("Joint {} counts the other way than the robot's description says.", where);
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Turn the sign of the readings of {} in {} (or, where the description is wrong, its <axis> in {}).",
                   where, session_name(s), robot_name(s));
  };
  return k;
}

/// Every pair of joints of which one at least tells something.
std::vector<std::string> swap_places(const Session& s) {
  const std::vector<std::string> telling = telling_joints(s);
  const auto tells = [&](const std::string& name) {
    return std::find(telling.begin(), telling.end(), name) != telling.end();
  };
  std::vector<std::string> places;
  for (std::size_t j = 0; j < s.joints.size() && !telling.empty(); ++j)
    for (std::size_t k = j + 1; k < s.joints.size(); ++k)
      if (tells(s.joints[j]) || tells(s.joints[k])) places.push_back(s.joints[j] + "," + s.joints[k]);
  return places;
}

BlunderKind joint_swap() {
  BlunderKind k;
  k.id = "joint_swap";
  k.places = swap_places;
  k.mend = [](const std::string& where, Session& s) {
    const auto [first, second] = two_words(where, "joint_swap");
    const Eigen::Index j = joint_place(s, first, "joint_swap"), l = joint_place(s, second, "joint_swap");
    each_vector(s, [&](Eigen::VectorXd& v) { std::swap(v[j], v[l]); });
  };
  k.text = [](const std::string& where, const Session&) {
    const auto [first, second] = two_words(where, "joint_swap");
    return message("The readings of joints {} and {} are exchanged.", first, second);
  };
  k.fix = [](const std::string& where, const Session& s) {
    const auto [first, second] = two_words(where, "joint_swap");
    return message("Exchange the names {} and {} in <joints> of {} (in the header of the table that it was made of).",
                   first, second, session_name(s));
  };
  return k;
}

std::vector<std::string> coupled_places(const Session& s) {
  std::vector<std::string> places;
  const std::vector<std::string> telling = telling_joints(s);
  for (std::size_t j = 0; j < telling.size(); ++j)
    for (std::size_t k = 0; k < j; ++k) {
      const bool both_turn = joint_named(s, telling[j]).kind != JointKind::prismatic &&
                             joint_named(s, telling[k]).kind != JointKind::prismatic;
      if (!both_turn) continue;
      places.push_back(telling[j] + "," + telling[k]);
      places.push_back(telling[j] + ",-" + telling[k]);
    }
  return places;
}

struct Coupling {
  std::string joint, other;
  double ratio = 1;
};

Coupling coupling_at(const std::string& where, const Session& s) {
  auto [joint, other] = two_words(where, "joint_coupled");
  const bool is_named_so = std::find(s.joints.begin(), s.joints.end(), other) != s.joints.end();
  if (is_named_so || other[0] != '-') return {joint, other, 1};
  return {joint, other.substr(1), -1};
}

BlunderKind joint_coupled() {
  BlunderKind k;
  k.id = "joint_coupled";
  k.places = coupled_places;
  k.mend = [](const std::string& where, Session& s) {
    const Coupling c = coupling_at(where, s);
    const Eigen::Index j = joint_place(s, c.joint, "joint_coupled"), l = joint_place(s, c.other, "joint_coupled");
    for (Observation& o : s.observations)
      for (Eigen::VectorXd* v : {&o.position, &o.velocity})
        if (v->size() > std::max(j, l)) (*v)[j] += c.ratio * (*v)[l];
  };
  k.text = [](const std::string& where, const Session& s) {
    const Coupling c = coupling_at(where, s);
    return message(
        "Joint {} is not reckoned against the link before it: the angle of {} has to be {} it (some makers reckon a "
        "joint against the horizontal).",
        c.joint, c.other, c.ratio > 0 ? "added to" : "taken from");
  };
  k.fix = [](const std::string& where, const Session& s) {
    const Coupling c = coupling_at(where, s);
    return message("In {} write {} {} {} in place of the readings of {}.", session_name(s), c.joint,
                   c.ratio > 0 ? "+" : "-", c.other, c.joint);
  };
  return k;
}

Message shift_text(const std::string& where, const Session& s) {
  const auto [joint, value] = name_and_value(where);
  const double shift = number_in(value, "joint_zero");
  if (joint_named(s, joint).kind == JointKind::prismatic) return message("{:+.1f} mm", 1e3 * shift);
  return message("{:+.2f} degrees", shift * 180 / std::numbers::pi);
}

BlunderKind joint_zero() {
  BlunderKind k;
  k.id = "joint_zero";
  k.numbers = 1;
  k.places = telling_joints;
  k.settle = [](const std::string& where, const Session& points) {
    const auto [joint, value] = name_and_value(where);
    joint_place(points, joint, "joint_zero");
    if (!value.empty()) return where;
    return fmt::format("{}={:.6g}", joint, find_zero(points, joint));
  };
  k.mend = [](const std::string& where, Session& s) {
    const auto [joint, value] = name_and_value(where);
    const Eigen::Index j = joint_place(s, joint, "joint_zero");
    const double shift = number_in(value, "joint_zero");
    for (Observation& o : s.observations) o.position[j] += shift;
  };
  k.text = [](const std::string& where, const Session& s) {
    return message("Joint {} has another zero than the robot's description: {} are missing in its readings.",
                   name_and_value(where).first, shift_text(where, s));
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Add {} to the readings of {} in {} (or set the zero of that joint so).", shift_text(where, s),
                   name_and_value(where).first, session_name(s));
  };
  return k;
}

std::vector<std::string> degree_places(const Session& s) {
  std::vector<std::string> places;
  for (const std::string& name : telling_joints(s)) {
    double largest = 0;
    for (const Observation& o : s.observations)
      largest = std::max(largest, std::abs(o.position[joint_place(s, name, "")]));
    // Where no reading is larger than this, in degrees the joint would not have moved.
    if (joint_named(s, name).kind != JointKind::prismatic && largest > 3) places.push_back(name);
  }
  if (places.size() > 1) places.emplace_back("all");
  return places;
}

BlunderKind joint_degrees() {
  BlunderKind k;
  k.id = "joint_degrees";
  k.places = degree_places;
  k.mend = [](const std::string& where, Session& s) {
    const bool all = where == "all";
    if (!all) joint_place(s, where, "joint_degrees");
    for (std::size_t j = 0; j < s.joints.size(); ++j)
      if (s.joints[j] == where || (all && joint_named(s, s.joints[j]).kind != JointKind::prismatic))
        for (Observation& o : s.observations)
          for (Eigen::VectorXd* v : {&o.position, &o.velocity})
            if (v->size() > static_cast<Eigen::Index>(j)) (*v)[static_cast<Eigen::Index>(j)] *= std::numbers::pi / 180;
  };
  k.text = [](const std::string& where, const Session&) {
    return where == "all" ? Message("All joints are in degrees, where radians are expected.")
                          : message("Joint {} is in degrees, where radians are expected.", where);
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Write the readings of {} in {} in radians (times pi / 180).",
                   where == "all" ? Message("all joints") : verbatim(where), session_name(s));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> joint_blunders() {
  return {joint_sense(), joint_swap(), joint_coupled(), joint_zero(), joint_degrees()};
}

}  // namespace handsight
