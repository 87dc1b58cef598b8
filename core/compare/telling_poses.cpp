// SPDX-License-Identifier: Apache-2.0
// Which poses show best what is most likely to move.
#include <Eigen/Cholesky>
#include <algorithm>

#include "compare/change_watch.h"
#include "compare/watch_parts.h"

namespace handsight {
namespace {

/// What a sensor that measures points would see there, by the calibration.
Observation seen_at_pose(const CalibratedRobot& before, const Session& session, const Eigen::VectorXd& position) {
  const TcpPrediction there = predict_tcp(before.chain, position, before.model);
  const Rigid root_from_sensor =
      there.root_from_sensor_est ? *there.root_from_sensor_est
                                 : chain_ends(before.chain, position).root_from_mount * session.mount.mount_from_sensor;
  Observation o;
  o.position = position;
  for (std::size_t m = 0; m < before.calibration.markers.size(); ++m) {
    Sighting sighting{.marker = static_cast<int>(m)};
    sighting.point = inverse(root_from_sensor) * (there.root_from_body_est * before.calibration.markers[m]);
    o.sightings.push_back(sighting);
  }
  return o;
}

}  // namespace

std::vector<std::size_t> telling_poses(const CalibratedRobot& before, const Session& session,
                                       const std::vector<Eigen::VectorXd>& positions, int count) {
  Session by_points = session;
  by_points.rig.reset();
  by_points.sigma_point = 1e-4;
  WatchParts parts;
  parts.before = before;
  std::vector<Normal> normals;
  for (const Eigen::VectorXd& q : positions) {
    Matrix6 repeatability;
    const PoseSums sums = parts.sums_of(by_points, seen_at_pose(before, session, q), repeatability);
    normals.push_back(without_pose(sums, 0, repeatability));
  }
  std::vector<Eigen::Index> columns;
  for (std::size_t u = 0; u < parts.units.size(); ++u)
    for (Eigen::Index c = parts.first_of_unit[u]; c < parts.first_of_unit[u + 1]; ++c)
      for (const char* group : {"camera_mount", "body_slip", "joint_offset"})
        if (parts.units[u].group == group) columns.push_back(c);
  std::vector<std::size_t> chosen;
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(columns.size()));
  while (static_cast<int>(chosen.size()) < std::min<int>(count, static_cast<int>(positions.size()))) {
    std::size_t best = positions.size();
    double most = -1e300;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
      const Eigen::LLT<Eigen::MatrixXd> llt(information + normals[i].information(columns, columns));
      const double gain = llt.matrixLLT().diagonal().array().log().sum();
      if (gain > most) most = gain, best = i;
    }
    information += normals[best].information(columns, columns);
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace handsight
