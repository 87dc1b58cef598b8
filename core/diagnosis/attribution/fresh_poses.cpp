// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/fresh_poses.h"

#include <Eigen/Dense>
#include <boost/math/distributions/fisher_f.hpp>

namespace handsight {

std::vector<FreshPose> fresh_poses(const Inspection& inspection) {
  constexpr int fewest = 8;
  Matrix3 moments = Matrix3::Zero();
  int n = 0;
  for (const InspectionRow& row : inspection.rows) {
    if (!row.is_used || !row.tcp_from_tcp_est) continue;
    const Vector3& d = row.tcp_from_tcp_est->translation;
    moments += d * d.transpose();
    ++n;
  }
  std::vector<FreshPose> poses;
  if (n < fewest) return poses;
  moments /= n;
  const Eigen::LDLT<Matrix3> inverse(moments);
  if (inverse.info() != Eigen::Success || !inverse.isPositive() || inverse.vectorD().minCoeff() <= 0) return poses;
  const double limit =
      3.0 * n / (n - 2) * boost::math::quantile(boost::math::fisher_f(3, static_cast<double>(n - 2)), 0.95);
  for (const InspectionRow& row : inspection.rows) {
    if (row.is_used || !row.tcp_from_tcp_est) continue;
    const Vector3& d = row.tcp_from_tcp_est->translation;
    const double squared = d.dot(inverse.solve(d));
    FreshPose pose{.id = row.id, .distance = row.hand_m.value_or(d.norm()), .is_hit = squared <= limit};
    pose.is_known_bad =
        row.at_second_look || row.attribution.cause == ErrorCause::cameras || row.attribution.cause == ErrorCause::body;
    if (squared > 0) pose.allowed = pose.distance * std::sqrt(limit / squared);
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace handsight
