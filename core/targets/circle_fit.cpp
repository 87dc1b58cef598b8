// SPDX-License-Identifier: Apache-2.0
#include "targets/circle_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace handsight {
namespace {

/// The ring in which the edge is looked for, in radii.
constexpr double innermost = 0.55, outermost = 1.45;

/// Of the centre, from what the gradients tell of a shift (Cramer and Rao), times what the fit loses against it.
Eigen::Matrix2d make_covariance(const std::vector<Tangent>& tangents, double noise) {
  constexpr double loss = 2, least = 5e-3;  // least: px, the grid of pixels
  Eigen::Matrix2d reported = Eigen::Matrix2d::Zero();
  for (const Tangent& t : tangents) reported += t.weight * t.normal * t.normal.transpose();
  reported -= 0.25 * noise * noise * static_cast<double>(tangents.size()) * Eigen::Matrix2d::Identity();  // noise's own
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(reported);
  const Vector2 variances = (loss * noise * noise / solver.eigenvalues().array().max(1.0)).matrix();
  return solver.eigenvectors() * variances.asDiagonal() * solver.eigenvectors().transpose() +
         least * least * Eigen::Matrix2d::Identity();
}

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

FittedEllipse ellipse_of(const Vector5& conic, const Vector2& about, double size) {
  const Vector2 middle = 0.5 * conic.tail<2>();
  Eigen::Matrix2d quadratic;
  quadratic << conic[0], 0.5 * conic[1], 0.5 * conic[1], conic[2];
  FittedEllipse ellipse;
  ellipse.centre = about + size * middle;
  ellipse.shape = size * size * (middle * middle.transpose() - quadratic);
  return ellipse;
}

}  // namespace

std::optional<FittedEllipse> fit_ellipse(const std::vector<Tangent>& tangents, const Vector2& about, double size) {
  Matrix5 normal = Matrix5::Zero();
  Vector5 vector = Vector5::Zero();
  for (const Tangent& t : tangents) {
    const double a = t.normal.x(), b = t.normal.y(), c = -t.normal.dot(t.point - about) / size;
    const Vector5 row{{a * a, a * b, b * b, a * c, b * c}}, weighted = t.weight * row;
    normal += weighted * row.transpose();
    vector -= weighted * (c * c);
  }
  const Eigen::LDLT<Matrix5> solver(normal);
  if (tangents.size() < 12 || !(solver.rcond() > 1e-12)) return std::nullopt;
  const Vector5 conic = solver.solve(vector);
  FittedEllipse ellipse = ellipse_of(conic, about, size);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(ellipse.shape);
  if (!(axes.eigenvalues()[0] > 1) || !ellipse.centre.allFinite()) return std::nullopt;
  return ellipse;
}

std::optional<FittedEllipse> ellipse_in(const Image& image, const Vector2& centre, const Eigen::Matrix2d& shape,
                                        double noise) {
  const Eigen::Matrix2d inverse = shape.inverse();
  const Vector2 reach = outermost * shape.diagonal().cwiseSqrt();
  const int left = static_cast<int>(centre.x() - reach.x()) - 1, right = static_cast<int>(centre.x() + reach.x()) + 2,
            top = static_cast<int>(centre.y() - reach.y()) - 1, bottom = static_cast<int>(centre.y() + reach.y()) + 2;
  if (!inverse.allFinite() || left < 1 || top < 1 || right > image.width - 2 || bottom > image.height - 2)
    return std::nullopt;
  std::vector<Tangent> tangents;
  for (int v = top; v <= bottom; ++v)
    for (int u = left; u <= right; ++u) {
      const Vector2 from = Vector2(u, v) - centre;
      const double out = from.dot(inverse * from);
      if (out < innermost * innermost || out > outermost * outermost) continue;
      const Vector2 gradient(0.5 * (image.row(v)[u + 1] - image.row(v)[u - 1]),
                             0.5 * (image.row(v + 1)[u] - image.row(v - 1)[u]));
      // From dark to bright is outwards: another thing's edge is no part of the disc's.
      if (gradient.dot(inverse * from) <= 0) continue;
      tangents.push_back({Vector2(u, v), gradient.normalized(), gradient.squaredNorm()});
    }
  auto ellipse = fit_ellipse(tangents, centre, std::sqrt(std::sqrt(shape.determinant())));
  if (ellipse) ellipse->covariance = make_covariance(tangents, noise);
  return ellipse;
}

}  // namespace handsight
