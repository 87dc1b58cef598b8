// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/residuals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "chain/sighting.h"
#include "estimation/problem/body_pose.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/start/shape_start.h"

namespace handsight {
namespace {

/// One step of Gauss and Newton of the body's own pose about the middle of its markers: how far cameras see it from
/// where it is predicted. Markers on a line, and fewer than three, tell a shift alone.
std::optional<HandResidual> hand_of(const std::vector<std::pair<Vector3, SightingNormal>>& seen) {
  constexpr double least_turned = 1e-9;  // of the largest eigenvalue: less turns freely
  if (seen.empty()) return std::nullopt;
  Vector3 middle = Vector3::Zero();
  for (const auto& [x, n] : seen) middle += x / static_cast<double>(seen.size());
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  for (const auto& [x, n] : seen) {
    Eigen::Matrix<double, 3, 6> by_pose;
    by_pose << Matrix3::Identity(), -cross_matrix(Vector3(x - middle));
    information += by_pose.transpose() * n.information * by_pose;
    gradient += by_pose.transpose() * n.gradient;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6> turned(information);
  if (seen.size() >= 3 && turned.eigenvalues()[0] > least_turned * turned.eigenvalues()[5]) {
    const Matrix6 covariance = information.inverse();
    return HandResidual{(covariance * gradient).head<3>().norm(), covariance.topLeftCorner<3, 3>()};
  }
  const Matrix3 shifts = information.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Matrix3> shifted(shifts);
  if (!(shifted.eigenvalues()[0] > least_turned * shifted.eigenvalues()[2])) return std::nullopt;
  const Matrix3 covariance = shifts.inverse();
  return HandResidual{(covariance * gradient.head<3>()).norm(), covariance};
}

/// One camera shows no points, but of a body of known shape its pose: the points are then where that has them.
void add_lengths_of_pose(const Problem& images, const ProblemObservation& o, const Unknowns& unknowns,
                         Residuals& residuals) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
  const std::vector<Vector3> markers = markers_at(o, unknowns);
  for (const std::vector<Sighting>& piece : by_piece(*images.shape, o.sightings)) {
    const auto pose = estimate_body_pose(images.rig_or_null(), piece, markers, sensor_from_tcp);
    if (!pose) continue;
    for (const Sighting& s : piece) {
      const Vector3& in_tcp = markers[static_cast<std::size_t>(s.marker)];
      const Vector3 measured = pose->sensor_from_body * in_tcp;
      Eigen::Matrix<double, 3, 6> by_pose;
      by_pose << Matrix3::Identity(), -cross_matrix(measured);
      residuals.lengths.push_back((measured - sensor_from_tcp * in_tcp).norm());
      residuals.length_squares_of_noise += (by_pose * pose->unit_covariance * by_pose.transpose()).trace();
    }
  }
}

}  // namespace

Residuals compute_residuals(const Problem& images, const ProblemObservation& o, const Unknowns& unknowns) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
  Residuals residuals;
  std::vector<std::pair<Vector3, SightingNormal>> seen;
  for (const Sighting& s : o.sightings) {
    const Vector3 predicted = sensor_from_tcp * marker_at(o, unknowns, s.marker);
    const SightingNormal n = sighting_normal(images.rig_or_null(), s, predicted);
    if (images.rig) seen.emplace_back(predicted, n);
    residuals.squares += n.cost;
    residuals.rows += n.rows;
    if (s.reading || (s.along && !images.shape)) {  // a reading of one coordinate
      const SightingResidual one = sighting_residual(images.rig_or_null(), s, predicted);
      residuals.lengths.push_back(std::abs(one.error[0]) *
                                  (s.point_sigma && s.usual_sigma > 0 ? *s.point_sigma / s.usual_sigma : 1));
      residuals.length_squares_of_noise += 1;
    } else if (s.point && !s.along) {
      residuals.lengths.push_back((*s.point - predicted).norm());
      residuals.length_squares_of_noise += 3;
    }
    if (!images.rig) continue;
    if (const auto point = triangulate_unweighed(*images.rig, s)) {
      residuals.lengths.push_back((point->point - predicted).norm());
      residuals.length_squares_of_noise += point->covariance.trace();
    }
  }
  if (images.rig && images.shape && residuals.lengths.empty()) add_lengths_of_pose(images, o, unknowns, residuals);
  if (const auto pose = pose_residual(images, o, unknowns)) {
    residuals.lengths.push_back(pose->place.norm());
    residuals.length_squares_of_noise += 3;
  }
  residuals.hand = hand_of(seen);
  return residuals;
}

double rms(const std::vector<double>& values) {
  double squares = 0;
  for (const double v : values) squares += v * v;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

ErrorSummary summary(const std::vector<Residuals>& all, bool pixels) {
  ErrorSummary s;
  double squares = 0;
  int rows = 0;
  std::vector<double> lengths, hands;
  for (const Residuals& r : all) {
    squares += r.squares;
    rows += r.rows;
    if (r.hand) hands.push_back(r.hand->size_m);
    lengths.insert(lengths.end(), r.lengths.begin(), r.lengths.end());
  }
  if (pixels && rows > 0) s.rms_pixel = std::sqrt(squares / rows);
  if (!hands.empty()) s.hand_m = rms(hands);
  if (lengths.empty()) return s;
  s.rms_m = rms(lengths);
  s.mean_m = 0;
  for (const double l : lengths) *s.mean_m += l / static_cast<double>(lengths.size());
  s.max_m = *std::max_element(lengths.begin(), lengths.end());
  return s;
}

}  // namespace handsight
