// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/body_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "chain/sighting.h"

namespace handsight {
namespace {

struct PoseNormal {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  double cost = 0;
  int rows = 0;
  bool in_front = true;
};

/// By the small motion xi in exp(xi) sensor_from_body: a point moves by v + w cross x.
PoseNormal pose_normal(const Rig* rig, const std::vector<Sighting>& sightings,
                       const std::vector<Vector3>& markers_in_body, const Rigid& sensor_from_body) {
  PoseNormal pose;
  for (const Sighting& s : sightings) {
    const Vector3 x = sensor_from_body * markers_in_body[static_cast<std::size_t>(s.marker)];
    const SightingNormal n = sighting_normal(rig, s, x);
    const Matrix3 k = cross_matrix(x);
    const Matrix3 information_k = n.information * k;
    pose.information.topLeftCorner<3, 3>() += n.information;
    pose.information.topRightCorner<3, 3>() -= information_k;
    pose.information.bottomLeftCorner<3, 3>() += k * n.information;
    pose.information.bottomRightCorner<3, 3>() -= k * information_k;
    pose.gradient.head<3>() += n.gradient;
    pose.gradient.tail<3>() += k * n.gradient;
    pose.cost += n.cost;
    pose.rows += n.rows;
    pose.in_front = pose.in_front && n.in_front;
  }
  return pose;
}

/// Is every one of the six motions determined? Judged with rotations scaled to the size of the body.
bool is_determined(const Matrix6& information) {
  Matrix6 scaled = information;
  Vector6 scale;
  for (int i = 0; i < 6; ++i) {
    if (!(information(i, i) > 0)) return false;
    scale[i] = 1 / std::sqrt(information(i, i));
  }
  scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(scaled, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues()[0] > 1e-10 * eigen.eigenvalues()[5];
}

}  // namespace

std::optional<BodyPose> estimate_body_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                           const std::vector<Vector3>& markers_in_body, const Rigid& guess) {
  if (sightings.size() < 3) return std::nullopt;
  Rigid pose = guess;
  PoseNormal normal = pose_normal(rig, sightings, markers_in_body, pose);
  if (normal.rows < 6) return std::nullopt;
  double damping = 1e-8;
  for (int iteration = 0; iteration < 60; ++iteration) {
    Matrix6 damped = normal.information;
    damped.diagonal() *= 1 + damping;
    const Vector6 step = damped.ldlt().solve(normal.gradient);
    if (!step.allFinite()) return std::nullopt;
    const Rigid next = small_motion<double>(step) * pose;
    const PoseNormal next_normal = pose_normal(rig, sightings, markers_in_body, next);
    if (next_normal.cost <= normal.cost) {
      pose = next;
      normal = next_normal;
      damping = std::max(damping * 0.1, 1e-15);
    } else {
      damping = std::max(damping * 10, 1e-6);
    }
    if (step.cwiseAbs().maxCoeff() < 1e-11 || damping > 1e10) break;
  }
  if (!normal.in_front || !is_determined(normal.information)) return std::nullopt;
  return BodyPose{pose, normal.information.inverse(), normal.cost, normal.rows};
}

std::optional<Rigid> refined_body_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                       const std::vector<Vector3>& markers_in_body, const Rigid& guess,
                                       double near_enough) {
  if (sightings.size() < 3) return std::nullopt;
  Rigid pose = guess;
  for (int iteration = 0; iteration < 10; ++iteration) {
    const PoseNormal normal = pose_normal(rig, sightings, markers_in_body, pose);
    if (normal.rows < 6 || !normal.in_front) break;
    const Eigen::LLT<Matrix6> llt(normal.information);
    if (llt.info() != Eigen::Success) break;
    const Vector6 step = llt.solve(normal.gradient);
    if (!step.allFinite()) break;
    const double size = step.cwiseAbs().maxCoeff();
    if (size < near_enough) return pose;
    pose = small_motion<double>(step) * pose;
    if (size < 0.01) return pose;  // m, rad: Newton's next step would be its square
  }
  const auto pose_by_damping = estimate_body_pose(rig, sightings, markers_in_body, guess);
  return pose_by_damping ? std::optional(pose_by_damping->sensor_from_body) : std::nullopt;
}

std::optional<Rigid> body_pose_from_points(const Rig* rig, const std::vector<Sighting>& sightings,
                                           const std::vector<Vector3>& markers_in_body) {
  Eigen::Matrix3Xd in_sensor(3, 0), in_body(3, 0);
  for (const Sighting& s : sightings) {
    std::optional<Vector3> point = s.point;
    if (!point && rig)
      if (const auto p = triangulate_unweighed(*rig, s)) point = p->point;
    if (!point) continue;
    in_sensor.conservativeResize(3, in_sensor.cols() + 1);
    in_body.conservativeResize(3, in_body.cols() + 1);
    in_sensor.rightCols<1>() = *point;
    in_body.rightCols<1>() = markers_in_body[static_cast<std::size_t>(s.marker)];
  }
  if (in_sensor.cols() < 3) return std::nullopt;
  return align_points(in_sensor, in_body, Eigen::VectorXd::Ones(in_sensor.cols()));
}

}  // namespace handsight
