// SPDX-License-Identifier: Apache-2.0
// Is the robot of two sessions one?
#include "base/error.h"
#include "session/joined.h"

namespace handsight {

namespace {

[[noreturn]] void refuse_robot(const Session& a, const Session& b, const Message& what) {
  throw InputError(message("{} and {} have other robots: {}; a collection is of one robot.",
                           a.file.parent_path().filename().string(), b.file.parent_path().filename().string(), what));
}

std::string shown_place(const Rigid& m) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", m.translation.x(), m.translation.y(), m.translation.z());
}

bool is_near(const Rigid& a, const Rigid& b) {
  return (a.translation - b.translation).isZero(1e-9) && (a.rotation - b.rotation).isZero(1e-9);
}

void require_same_joint(const Session& a, const Session& b, const Joint& x, const Joint& y) {
  const auto differs = [&](const char* what, const std::string& of_a, const std::string& of_b) {
    refuse_robot(a, b, message("joint {} has {} {} in one and {} in the other", x.name, what, of_a, of_b));
  };
  if (x.name != y.name) refuse_robot(a, b, message("the one has a joint {} where the other has {}", x.name, y.name));
  if (x.kind != y.kind || x.parent_link != y.parent_link || x.child_link != y.child_link)
    refuse_robot(a, b, message("joint {} is of another kind or between other links", x.name));
  if (!is_near(x.parent_from_joint, y.parent_from_joint))
    differs("its place at", shown_place(x.parent_from_joint), shown_place(y.parent_from_joint));
  if (!is_near(x.joint_from_child, y.joint_from_child))
    differs("its link at", shown_place(x.joint_from_child), shown_place(y.joint_from_child));
  if (x.moves() && !(x.axis - y.axis).isZero(1e-9))
    differs("its axis along", shown_place({Matrix3::Identity(), x.axis}), shown_place({Matrix3::Identity(), y.axis}));
  if (x.stiffness != y.stiffness)
    differs("a stiffness of", fmt::format("{:g}", x.stiffness), fmt::format("{:g}", y.stiffness));
}

}  // namespace

void require_same_robot(const Session& a, const Session& b) {
  const Robot &x = a.robot, &y = b.robot;
  if (x.links.size() != y.links.size() || x.joints.size() != y.joints.size())
    refuse_robot(a, b,
                 message("{} links and {} joints in one, {} and {} in the other", x.links.size(), x.joints.size(),
                         y.links.size(), y.joints.size()));
  for (std::size_t i = 0; i < x.links.size(); ++i) {
    if (x.links[i].name != y.links[i].name)
      refuse_robot(a, b, message("the one has a link {} where the other has {}", x.links[i].name, y.links[i].name));
    if (x.links[i].mass != y.links[i].mass)
      refuse_robot(a, b,
                   message("link {} has a mass of {:g} kg in one and {:g} kg in the other", x.links[i].name,
                           x.links[i].mass, y.links[i].mass));
  }
  for (std::size_t i = 0; i < x.links.size(); ++i)
    if (!(x.links[i].center_of_mass - y.links[i].center_of_mass).isZero(1e-9))
      refuse_robot(a, b,
                   message("link {} has its centre of mass at {} in one and {} in the other", x.links[i].name,
                           shown_place({Matrix3::Identity(), x.links[i].center_of_mass}),
                           shown_place({Matrix3::Identity(), y.links[i].center_of_mass})));
  for (std::size_t j = 0; j < x.joints.size(); ++j) require_same_joint(a, b, x.joints[j], y.joints[j]);
}

}  // namespace handsight
