// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/angle_axis.h"

#include <cmath>

#include "estimation/problem/body_pose.h"
#include "estimation/solvers/covariance_factor.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"

namespace handsight {
namespace {

struct MeasuredPose {
  const ProblemObservation* observation;
  Rigid sensor_from_body;
  Matrix6 covariance;  // of the motion at the body's origin, noise included
};

/// xi about the sensor's origin -> the same motion taken at the body's origin.
Matrix6 at_body(const Rigid& sensor_from_body) {
  Matrix6 m = Matrix6::Identity();
  m.topRightCorner<3, 3>() = -cross_matrix(sensor_from_body.translation);
  return m;
}

std::vector<MeasuredPose> measure(const Problem& problem, const std::vector<Vector3>& markers_in_body,
                                  const Rigid& tcp_from_body, const Rigid& mount_from_sensor, double noise) {
  std::vector<MeasuredPose> poses;
  for (const ProblemObservation& o : problem.observations) {
    const Rigid guess = sensor_from_tcp_at(o, mount_from_sensor) * tcp_from_body;
    const auto pose = estimate_body_pose(problem.rig_or_null(), o.sightings, markers_in_body, guess);
    if (!pose) continue;
    const Matrix6 shift = at_body(pose->sensor_from_body);
    poses.push_back({&o, pose->sensor_from_body, noise * noise * shift * pose->unit_covariance * shift.transpose()});
  }
  return poses;
}

/// Inverse of the left Jacobian of the rotation group at rotation vector w: how exp(d) exp(w) moves w.
Matrix3 inverse_left_jacobian(const Vector3& w) {
  const double a = w.norm();
  const Matrix3 k = cross_matrix(w);
  if (a < 1e-6) return Matrix3::Identity() - 0.5 * k + k * k / 12;
  return Matrix3::Identity() - 0.5 * k + (1 / (a * a) - (1 + std::cos(a)) / (2 * a * std::sin(a))) * k * k;
}

struct Rows {
  Vector6 error;                    // measured against predicted, m and rad
  Eigen::Matrix<double, 6, 12> by;  // d of -error / d (xi of tcp_from_body, v of the mount)
};

Rows take_rows(const MeasuredPose& pose, const Rigid& tcp_from_body, const Rigid& mount_from_sensor) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(*pose.observation, mount_from_sensor);
  const Rigid predicted = sensor_from_tcp * tcp_from_body;
  const Vector3 turn = vector_from_rotation(predicted.rotation * pose.sensor_from_body.rotation.transpose());
  const Matrix3 turn_by = inverse_left_jacobian(turn);
  Rows rows;
  rows.error << pose.sensor_from_body.translation - predicted.translation, -turn;
  const Matrix3& r = sensor_from_tcp.rotation;
  rows.by.setZero();
  rows.by.block<3, 3>(0, 0) = r;
  rows.by.block<3, 3>(0, 3) = -r * cross_matrix(tcp_from_body.translation);
  rows.by.block<3, 3>(3, 3) = turn_by * r;
  rows.by.block<3, 3>(0, 6) = -Matrix3::Identity();
  rows.by.block<3, 3>(0, 9) = cross_matrix(predicted.translation);
  rows.by.block<3, 3>(3, 9) = -turn_by;
  return rows;
}

}  // namespace

std::optional<AngleAxisResult> fit_angle_axis(const Problem& problem, const std::vector<Vector3>& markers_in_body,
                                              const Rigid& start_tcp_from_body, const Rigid& start_mount_from_sensor,
                                              double noise, Loss loss) {
  const auto poses = measure(problem, markers_in_body, start_tcp_from_body, start_mount_from_sensor, noise);
  if (poses.empty() || (problem.mount_is_estimated && poses.size() < 3)) return std::nullopt;

  AngleAxisResult result{start_tcp_from_body, start_mount_from_sensor};
  result.used = static_cast<int>(poses.size());
  for (const MeasuredPose& p : poses) {
    result.sigma_m += p.covariance.topLeftCorner<3, 3>().trace() / 3;
    result.sigma_rad += p.covariance.bottomRightCorner<3, 3>().trace() / 3;
  }
  result.sigma_m = std::sqrt(result.sigma_m / result.used);
  result.sigma_rad = std::sqrt(result.sigma_rad / result.used);
  Vector6 weight;
  weight << Vector3::Constant(1 / (result.sigma_m * result.sigma_m)),
      Vector3::Constant(1 / (result.sigma_rad * result.sigma_rad));

  const Eigen::Index columns = problem.mount_is_estimated ? 12 : 6;
  Eigen::MatrixXd h(columns, columns), middle(columns, columns);
  const int most_iterations = loss == Loss::none ? 50 : 500;  // weights that follow the residuals settle linearly
  for (int iteration = 0; iteration < most_iterations && !result.converged; ++iteration) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(columns);
    h.setZero();
    middle.setZero();
    result.rms_m = result.rms_rad = 0;
    for (const MeasuredPose& p : poses) {
      const Rows rows = take_rows(p, result.tcp_from_body, result.mount_from_sensor);
      const double squared = rows.error.dot(weight.asDiagonal() * rows.error);
      const double counts = loss_at(loss, squared, 6, 1).weight;
      const Eigen::MatrixXd weighted = counts * weight.asDiagonal() * rows.by.leftCols(columns);
      h += rows.by.leftCols(columns).transpose() * weighted;
      gradient += weighted.transpose() * rows.error;
      middle += weighted.transpose() * p.covariance * weighted;
      result.rms_m += rows.error.head<3>().squaredNorm();
      result.rms_rad += rows.error.tail<3>().squaredNorm();
    }
    const Eigen::VectorXd step = pseudo_inverse(h) * gradient;
    result.tcp_from_body = small_motion<double>(step.head<6>()) * result.tcp_from_body;
    if (problem.mount_is_estimated)
      result.mount_from_sensor = result.mount_from_sensor * small_motion<double>(step.tail<6>());
    result.converged = step.cwiseAbs().maxCoeff() < 1e-11;
  }
  result.covariance_factor = sandwich_factor(pseudo_inverse_factor(h), middle);
  result.rms_m = std::sqrt(result.rms_m / result.used);
  result.rms_rad = std::sqrt(result.rms_rad / result.used);
  return result;
}

}  // namespace handsight
