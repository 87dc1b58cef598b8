// SPDX-License-Identifier: Apache-2.0
#include "blunders/hand_eye.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace handsight {
namespace {

constexpr double kept_share = 0.8;  // of the sights: the rest may be outliers

struct Means {
  std::vector<Vector3> of;
  std::vector<double> weights;
};

Vector3 in_tcp(const HandSight& s, const Rigid& mount_from_sensor, const Vector3& in_sensor) {
  return rotated_back(s.mount_from_tcp.rotation, mount_from_sensor * in_sensor - s.mount_from_tcp.translation);
}

Means means_at(const std::vector<HandSight>& sights, const std::vector<double>& weights, int count,
               const Rigid& mount) {
  const auto n = static_cast<std::size_t>(count);
  Means means{std::vector<Vector3>(n, Vector3::Zero()), std::vector<double>(n, 0.0)};
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (const SightedPoint& p : sights[i].points) {
      const auto k = static_cast<std::size_t>(p.number);
      means.of[k] += weights[i] * in_tcp(sights[i], mount, p.in_sensor);
      means.weights[k] += weights[i];
    }
  for (std::size_t k = 0; k < n; ++k)
    if (means.weights[k] > 0) means.of[k] /= means.weights[k];
  return means;
}

/// Least squares of rows that count against the mean of all rows of the same point.
template <int Columns>
struct CentredSystem {
  using Row = Eigen::Matrix<double, 3, Columns>;
  Eigen::Matrix<double, Columns, Columns> h = Eigen::Matrix<double, Columns, Columns>::Zero();
  Eigen::Matrix<double, Columns, 1> g = Eigen::Matrix<double, Columns, 1>::Zero();
  std::vector<Row> rows;
  std::vector<Vector3> rights;
  std::vector<double> weights;

  explicit CentredSystem(int count)
      : rows(static_cast<std::size_t>(count), Row::Zero()),
        rights(static_cast<std::size_t>(count), Vector3::Zero()),
        weights(static_cast<std::size_t>(count), 0.0) {}

  void add(int number, double weight, const Row& row, const Vector3& right) {
    h += weight * row.transpose() * row;
    g += weight * row.transpose() * right;
    const auto k = static_cast<std::size_t>(number);
    rows[k] += weight * row;
    rights[k] += weight * right;
    weights[k] += weight;
  }

  void centre() {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!(weights[k] > 0)) continue;
      h -= rows[k].transpose() * rows[k] / weights[k];
      g -= rows[k].transpose() * rights[k] / weights[k];
    }
  }
};

template <int Columns>
Eigen::Matrix<double, Columns, 1> least_squares(const CentredSystem<Columns>& system) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Columns, Columns>> eigen(system.h);
  Eigen::Matrix<double, Columns, 1> inverse = eigen.eigenvalues();
  const double least = 1e-10 * std::max(inverse.maxCoeff(), 1e-300);
  for (double& x : inverse) x = x > least ? 1 / x : 0;
  return eigen.eigenvectors() * (inverse.asDiagonal() * (eigen.eigenvectors().transpose() * system.g));
}

/// The rotation by a linear system in its nine numbers.
Matrix3 relaxed_rotation(const std::vector<HandSight>& sights, int count) {
  CentredSystem<12> system(count);
  for (const HandSight& s : sights) {
    const Matrix3 back = s.mount_from_tcp.rotation.transpose();
    const Vector3 right = back * s.mount_from_tcp.translation;
    for (const SightedPoint& p : s.points) {
      Eigen::Matrix<double, 3, 12> row;
      row << p.in_sensor.x() * back, p.in_sensor.y() * back, p.in_sensor.z() * back, back;
      system.add(p.number, 1, row, right);
    }
  }
  system.centre();
  const Eigen::Matrix<double, 12, 1> x = least_squares(system);
  const Matrix3 rotation = Eigen::Map<const Matrix3>(x.data());
  return rotation.allFinite() && rotation.norm() > 1e-9 ? nearest_rotation(rotation) : Matrix3(Matrix3::Identity());
}

Vector3 translation_for(const std::vector<HandSight>& sights, int count, const Matrix3& rotation) {
  CentredSystem<3> system(count);
  for (const HandSight& s : sights) {
    const Matrix3 back = s.mount_from_tcp.rotation.transpose();
    for (const SightedPoint& p : s.points)
      system.add(p.number, 1, back, back * (s.mount_from_tcp.translation - rotation * p.in_sensor));
  }
  system.centre();
  return least_squares(system);
}

std::vector<double> squares_at(const std::vector<HandSight>& sights, const HandEye& found) {
  std::vector<double> squares;
  for (const HandSight& s : sights) squares.push_back(left_in(s, found));
  return squares;
}

/// Sights far beyond the usual count less.
std::vector<double> robust_weights(const std::vector<double>& squares) {
  const double usual = 4 * std::max(median(squares), 1e-18);
  std::vector<double> weights;
  for (const double s : squares) weights.push_back(1 / ((1 + s / usual) * (1 + s / usual)));
  return weights;
}

void step(const std::vector<HandSight>& sights, const std::vector<double>& weights, int count, Rigid& mount) {
  CentredSystem<6> system(count);
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const Matrix3 back = sights[i].mount_from_tcp.rotation.transpose();
    for (const SightedPoint& p : sights[i].points) {
      const Vector3 turned = mount.rotation * p.in_sensor;
      Eigen::Matrix<double, 3, 6> row;
      row << back, -back * cross_matrix<double>(turned);
      system.add(p.number, weights[i], row, -in_tcp(sights[i], mount, p.in_sensor));
    }
  }
  system.centre();
  const Vector6 by = least_squares(system);
  mount.rotation = rotation_from_vector<double>(Vector3(by.tail<3>())) * mount.rotation;
  mount.translation += by.head<3>();
}

double trimmed_mean(std::vector<double> squares) {
  std::sort(squares.begin(), squares.end());
  const auto kept =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(kept_share * static_cast<double>(squares.size()))));
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += squares[i];
  return sum / static_cast<double>(kept);
}

HandEye at_mount(const std::vector<HandSight>& sights, const std::vector<double>& weights, int count,
                 const Rigid& mount) {
  HandEye found{mount, means_at(sights, weights, count, mount).of, 0};
  found.mean_square = trimmed_mean(squares_at(sights, found));
  return found;
}

/// A few steps; the best of what they come by.
HandEye refined(const std::vector<HandSight>& sights, int count, Rigid mount, bool held) {
  std::vector<double> weights(sights.size(), 1.0);
  HandEye best = at_mount(sights, weights, count, mount);
  for (int i = 0; i < 10; ++i) {
    if (!held) step(sights, weights, count, mount);
    if (!mount.rotation.allFinite() || !mount.translation.allFinite()) break;
    HandEye now = at_mount(sights, weights, count, mount);
    const bool is_better = now.mean_square < best.mean_square;
    const bool is_there = is_better && now.mean_square > 0.999 * best.mean_square;
    weights = robust_weights(squares_at(sights, now));
    if (is_better) best = std::move(now);
    if (is_there && i > 4) break;
  }
  return best;
}

}  // namespace

double left_in(const HandSight& s, const HandEye& found) {
  double sum = 0;
  for (const SightedPoint& p : s.points)
    sum += (in_tcp(s, found.mount_from_sensor, p.in_sensor) - found.points_in_tcp[static_cast<std::size_t>(p.number)])
               .squaredNorm();
  return s.points.empty() ? 0 : sum / static_cast<double>(s.points.size());
}

std::optional<HandEye> hand_eye(const std::vector<HandSight>& sights, int count, const std::optional<Rigid>& known) {
  if (sights.size() < 3) return std::nullopt;
  if (known) return refined(sights, count, *known, true);
  const Matrix3 rotation = relaxed_rotation(sights, count);
  HandEye found = refined(sights, count, {rotation, translation_for(sights, count, rotation)}, false);
  if (!std::isfinite(found.mean_square)) return std::nullopt;
  return found;
}

}  // namespace handsight
