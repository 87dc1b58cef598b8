// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_knowledge.h"

namespace handsight {

Eigen::VectorXd change_of_rig(const Rig& from, const Rig& to) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(rig_number_count(from.count()));
  for (int c = 0; c < from.count(); ++c) {
    const RigCamera &a = from.at(c), &b = to.at(c);
    if (c > 0)
      change.segment<6>(motion_number(c)) =
          small_motion_between(Rigid{}, b.camera_from_first * inverse(a.camera_from_first));
    const auto numbers = camera_numbers(a.camera);
    for (int i = 0; i < camera_number_count; ++i) {
      const CameraNumber& number = numbers[static_cast<std::size_t>(i)];
      change[first_number(from.count(), c) + i] = b.camera.*number.value - a.camera.*number.value;
    }
  }
  return change;
}

double disagreement(const CameraKnowledge& k, const Rig& rig) {
  const Eigen::VectorXd y = change_of_rig(k.rig, rig);
  return k.residual + 2 * k.pull.dot(y) + y.dot(k.information * y);
}

}  // namespace handsight
