// SPDX-License-Identifier: Apache-2.0
#include "targets/homography.h"

#include <Eigen/Dense>
#include <cmath>

namespace handsight {
namespace {

using Vector10 = Eigen::Matrix<double, 10, 1>;

/// To mean 0 and mean distance sqrt 2 (Hartley).
Matrix3 conditioning(const std::vector<PlacePixel>& points, Vector2 PlacePixel::*member) {
  Vector2 mean = Vector2::Zero();
  for (const PlacePixel& p : points) mean += p.*member;
  mean /= static_cast<double>(points.size());
  double distance = 0;
  for (const PlacePixel& p : points) distance += (p.*member - mean).norm();
  const double scale = distance > 0 ? std::sqrt(2.0) * static_cast<double>(points.size()) / distance : 1;
  Matrix3 m;
  m << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
  return m;
}

double unfolded_up_to(double r2, double k1, double k2) { return 1 + 3 * k1 * r2 + 5 * k2 * r2 * r2; }

PlaneMap with_step(const PlaneMap& map, const Vector10& step) {
  PlaneMap moved = map;
  for (int i = 0; i < 8; ++i) moved.homography(i / 3, i % 3) += step(i);
  moved.k1 += step(8), moved.k2 += step(9);
  return moved;
}

/// Residual (px) and its derivatives by the homography's first eight numbers, k1 and k2.
struct Row {
  Vector2 residual;
  Eigen::Matrix<double, 2, 10> jacobian;
};

std::optional<Row> find_row(const PlaneMap& map, const PlacePixel& p) {
  const Vector3 place = p.place.homogeneous(), x = map.homography * place;
  if (!(x.z() > 0)) return std::nullopt;
  const Vector2 straight = x.hnormalized();
  const double r2 = straight.squaredNorm(), radial = 1 + r2 * (map.k1 + r2 * map.k2);
  if (!(unfolded_up_to(r2, map.k1, map.k2) > 0.05)) return std::nullopt;
  Row row;
  row.residual = map.scale * radial * straight + map.centre - p.pixel;
  const Eigen::Matrix2d bent = map.scale * (radial * Eigen::Matrix2d::Identity() +
                                            2 * (map.k1 + 2 * map.k2 * r2) * straight * straight.transpose());
  Eigen::Matrix<double, 2, 8> by_homography = Eigen::Matrix<double, 2, 8>::Zero();
  by_homography.block<1, 3>(0, 0) = by_homography.block<1, 3>(1, 3) = place.transpose() / x.z();
  by_homography.block<2, 2>(0, 6) = -straight * place.head<2>().transpose() / x.z();
  row.jacobian.leftCols<8>() = bent * by_homography;
  row.jacobian.col(8) = map.scale * r2 * straight;
  row.jacobian.col(9) = map.scale * r2 * r2 * straight;
  return row;
}

struct Normal {
  Eigen::Matrix<double, 10, 10> matrix = Eigen::Matrix<double, 10, 10>::Zero();
  Vector10 vector = Vector10::Zero();
  double cost = 0;
};

Normal normal_equations(const PlaneMap& map, const std::vector<PlacePixel>& points, bool bends) {
  constexpr double usual = 1.0;    // px: residuals beyond count less and less
  constexpr double lost_px = 100;  // px
  constexpr double k1_sigma = 0.3, k2_sigma = 0.2;
  Normal n;
  for (const PlacePixel& p : points) {
    const auto row = find_row(map, p);
    const double square = row ? row->residual.squaredNorm() / (usual * usual) : lost_px * lost_px;
    n.cost += std::log1p(square);
    if (!row) continue;
    const double weight = 1 / (1 + square) / (usual * usual);
    n.matrix += weight * row->jacobian.transpose() * row->jacobian;
    n.vector -= weight * row->jacobian.transpose() * row->residual;
  }
  const double w1 = 1 / (k1_sigma * k1_sigma), w2 = 1 / (k2_sigma * k2_sigma);
  n.cost += w1 * map.k1 * map.k1 + w2 * map.k2 * map.k2;
  n.matrix(8, 8) += w1, n.matrix(9, 9) += w2;
  n.vector(8) -= w1 * map.k1, n.vector(9) -= w2 * map.k2;
  if (!bends) {
    n.matrix.rightCols<2>().setZero();
    n.matrix.bottomRows<2>().setZero();
    n.matrix(8, 8) = n.matrix(9, 9) = 1;
    n.vector.tail<2>().setZero();
  }
  return n;
}

}  // namespace

std::optional<Matrix3> linear_homography(const std::vector<PlacePixel>& points) {
  if (points.size() < 4) return std::nullopt;
  const Matrix3 from = conditioning(points, &PlacePixel::place), to = conditioning(points, &PlacePixel::pixel);
  Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
  for (const PlacePixel& p : points) {
    const Vector3 a = from * p.place.homogeneous();
    const Vector2 b = (to * p.pixel.homogeneous()).hnormalized();
    Eigen::Matrix<double, 2, 9> rows = Eigen::Matrix<double, 2, 9>::Zero();
    rows.block<1, 3>(0, 0) = a.transpose();
    rows.block<1, 3>(1, 3) = a.transpose();
    rows.block<2, 3>(0, 6) = -b * a.transpose();
    normal += rows.transpose() * rows;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> solver(normal);
  const auto& values = solver.eigenvalues();
  if (!(values(1) > 1e-9 * values(8))) return std::nullopt;  // more than one answer
  const Eigen::Matrix<double, 9, 1> h = solver.eigenvectors().col(0);
  Matrix3 m;
  m << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), h(8);
  m = (to.inverse() * m * from).eval();
  // Places in front of the camera have a positive third number.
  if ((m * points.front().place.homogeneous()).z() < 0) m = -m;
  return m;
}

Matrix3 homography_from_quad(const Quad& q, double side) {
  // Heckbert, Fundamentals of texture mapping and image warping (1989), section 2.2.3.
  const Vector2 sum = q[0] - q[1] + q[2] - q[3], a = q[1] - q[2], b = q[3] - q[2];
  const double det = a.x() * b.y() - b.x() * a.y();
  const double g = (sum.x() * b.y() - b.x() * sum.y()) / det, h = (a.x() * sum.y() - sum.x() * a.y()) / det;
  Matrix3 m;
  m.col(0) << q[1] - q[0] + g * q[1], g;
  m.col(1) << q[3] - q[0] + h * q[3], h;
  m.col(2) << q[0], 1;
  m.leftCols<2>() /= side;
  return m;
}

std::optional<Vector2> mapped(const PlaneMap& map, const Vector2& place) {
  const Vector3 x = map.homography * place.homogeneous();
  if (!(x.z() > 0)) return std::nullopt;
  const Vector2 straight = x.hnormalized();
  const double r2 = straight.squaredNorm();
  if (!(unfolded_up_to(r2, map.k1, map.k2) > 0.05)) return std::nullopt;
  return Vector2(map.scale * (1 + r2 * (map.k1 + r2 * map.k2)) * straight + map.centre);
}

std::optional<Eigen::Matrix2d> mapped_slope(const PlaneMap& map, const Vector2& place, double step) {
  Eigen::Matrix2d slope;
  for (int i = 0; i < 2; ++i) {
    const auto forth = mapped(map, place + step * Vector2::Unit(i)),
               back = mapped(map, place - step * Vector2::Unit(i));
    if (!forth || !back) return std::nullopt;
    slope.col(i) = (*forth - *back) / (2 * step);
  }
  return slope;
}

std::optional<PlaneMap> fit_plane_map(const std::vector<PlacePixel>& points, int width, int height) {
  if (points.size() < 4) return std::nullopt;
  PlaneMap map;
  map.centre = {0.5 * (width - 1), 0.5 * (height - 1)};
  map.scale = 0.5 * std::hypot(width, height);
  std::vector<PlacePixel> scaled = points;
  for (PlacePixel& p : scaled) p.pixel = (p.pixel - map.centre) / map.scale;
  const auto start = linear_homography(scaled);
  if (!start || !(std::abs((*start)(2, 2)) > 1e-12)) return std::nullopt;
  map.homography = *start / std::abs((*start)(2, 2));
  const bool bends = points.size() >= 12;
  double damping = 1e-6;
  Normal now = normal_equations(map, points, bends);
  for (int iteration = 0; iteration < 25; ++iteration) {
    Eigen::Matrix<double, 10, 10> damped = now.matrix;
    damped.diagonal() *= 1 + damping;
    const PlaneMap next = with_step(map, damped.ldlt().solve(now.vector));
    const Normal then = normal_equations(next, points, bends);
    if (!(then.cost < now.cost)) {
      damping *= 10;
      if (damping > 1e6) break;
      continue;
    }
    const bool is_settled = now.cost - then.cost < 1e-9 * (1 + now.cost);
    map = next, now = then, damping = std::max(damping / 10, 1e-9);
    if (is_settled) break;
  }
  return map;
}

}  // namespace handsight
