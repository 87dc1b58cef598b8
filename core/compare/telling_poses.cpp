// SPDX-License-Identifier: Apache-2.0
// Which poses show best what is most likely to move.
#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "compare/change_watch.h"
#include "compare/watch_parts.h"

namespace handsight {
namespace {

// Changes that a recheck is there to see.
constexpr double small_turn = 2e-4;  // rad
constexpr double small_way = 3e-4;   // m

/// What the session's sensor would see there, by the calibration: markers in the cameras' images, else points.
Observation seen_at_pose(const CalibratedRobot& before, const Session& session, const Eigen::VectorXd& position) {
  const TcpPrediction there = predict_tcp(before.chain, position, before.model);
  const Rigid root_from_sensor =
      there.root_from_sensor_est ? *there.root_from_sensor_est
                                 : chain_ends(before.chain, position).root_from_mount * session.mount.mount_from_sensor;
  Observation o;
  o.position = position;
  for (std::size_t m = 0; m < before.calibration.markers.size(); ++m) {
    Sighting sighting{.marker = static_cast<int>(m)};
    const Vector3 x = inverse(root_from_sensor) * (there.root_from_body_est * before.calibration.markers[m]);
    if (!session.rig) {
      sighting.point = x;
    } else {
      for (int c = 0; c < session.rig->count(); ++c) {
        const RigCamera& camera = session.rig->at(c);
        const Vector3 in_camera = camera.camera_from_first * x;
        if (is_visible(camera.camera, in_camera)) sighting.in_cameras.push_back({c, project(camera.camera, in_camera)});
      }
      if (sighting.in_cameras.empty()) continue;
    }
    o.sightings.push_back(sighting);
  }
  return o;
}

/// Columns of a change that is looked for, and how large a small change is in each.
struct Sought {
  std::vector<Eigen::Index> columns;
  Eigen::VectorXd small;
};

std::vector<Sought> list_sought(const WatchParts& parts) {
  std::vector<Sought> all;
  for (std::size_t u = 0; u < parts.units.size(); ++u) {
    const ChangeUnit& unit = parts.units[u];
    if (unit.group != "camera_mount" && unit.group != "body_slip" && unit.group != "joint_offset") continue;
    Sought sought;
    for (Eigen::Index c = parts.first_of_unit[u]; c < parts.first_of_unit[u + 1]; ++c) sought.columns.push_back(c);
    sought.small.resize(static_cast<Eigen::Index>(sought.columns.size()));
    const std::vector<std::string> names = list_number_units(unit.terms, parts.chain->robot);
    for (std::size_t i = 0; i < names.size(); ++i)
      sought.small[static_cast<Eigen::Index>(i)] =
          (names[i] == "m" ? small_way : small_turn) / parts.sizes[sought.columns[i] - parts.base];
    all.push_back(std::move(sought));
  }
  return all;
}

/// How far small changes are from being seen, each by itself, summed up: 1 of what does not show, one by its sigmas of
/// what shows clearly, so that the weakest counts most.
double missed(const std::vector<Sought>& sought, const Eigen::MatrixXd& information) {
  double sum = 0;
  for (const Sought& s : sought) {
    Eigen::MatrixXd own = s.small.asDiagonal() * information(s.columns, s.columns) * s.small.asDiagonal();
    own.diagonal().array() += 1;
    sum += own.inverse().diagonal().cwiseMax(0).cwiseSqrt().sum();
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> telling_poses(const CalibratedRobot& before, const Session& session,
                                       const std::vector<Eigen::VectorXd>& positions, int count) {
  Session usual = session;
  if (!usual.rig && !usual.sigma_point) usual.sigma_point = 1e-4;
  WatchParts parts;
  parts.before = before;
  std::map<std::size_t, Eigen::MatrixXd> shown;  // by place in `positions`, of those where anything is seen
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Observation seen = seen_at_pose(before, usual, positions[i]);
    if (seen.sightings.empty()) continue;
    Matrix6 repeatability;
    const PoseSums sums = parts.sums_of(usual, seen, repeatability);
    shown[i] = without_pose(sums, 0, repeatability).information;
  }
  std::vector<std::size_t> chosen;
  if (shown.empty()) return chosen;
  const std::vector<Sought> sought = list_sought(parts);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(shown.begin()->second.rows(), shown.begin()->second.cols());
  while (static_cast<int>(chosen.size()) < count && !shown.empty()) {
    const auto best = std::min_element(shown.begin(), shown.end(), [&](const auto& a, const auto& b) {
      return missed(sought, information + a.second) < missed(sought, information + b.second);
    });
    information += best->second;
    chosen.push_back(best->first);
    shown.erase(best);
  }
  return chosen;
}

}  // namespace handsight
