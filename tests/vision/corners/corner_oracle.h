// SPDX-License-Identifier: Apache-2.0
// What a perfect program could tell of a rendered corner: an observer that knows the board, the blur, the light and
// where to look. What even it cannot tell from something else no detector need find.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "vision/corners/corner_camera.h"

namespace handsight::corner_images {

/// Standard deviations that a false alarm must be away: 0.6 in a million places, as many as the detector reports in a
/// megapixel of photographs.
constexpr double false_alarm = 4.86;

struct OracleVerdict {
  bool is_reported =
      false;         // likelihood ratio of the pixels, true picture against the best rival, beyond a false alarm's
  double apart = 0;  // standard deviations, of the true picture from the best rival
  double sigma = 0;  // px an axis, of the position by Cramer and Rao, with everything else about corner, light and
                     // shadow unknown
};

namespace oracle_detail {

// The pixels of a window round a corner: what the picture shows there with noise and without.
struct Pixels {
  std::vector<Eigen::Vector2d> at;  // px, from the corner
  Eigen::VectorXd seen, exact, light;
};

// Those within `reach` cells along both of the board's directions.
inline Pixels pixels_round(const Picture& picture, const TrueCorner& corner, double reach) {
  Pixels all;
  std::vector<std::array<double, 3>> values;
  const int most = static_cast<int>(std::ceil(3 * reach * picture.cell)) + 2;
  const Eigen::Vector2i middle = corner.position.array().round().cast<int>();
  for (int v = std::max(middle.y() - most, 0); v <= std::min(middle.y() + most, picture.image.height - 1); ++v)
    for (int u = std::max(middle.x() - most, 0); u <= std::min(middle.x() + most, picture.image.width - 1); ++u) {
      if ((picture.cells(u, v) - corner.in_cells).cwiseAbs().maxCoeff() >= reach) continue;
      all.at.push_back(Eigen::Vector2d(u, v) - corner.position);
      values.push_back(
          {static_cast<double>(picture.image.row(v)[u]), picture.exact.at<float>(v, u), picture.light(u, v)});
    }
  const auto count = static_cast<Eigen::Index>(values.size());
  all.seen.resize(count), all.exact.resize(count), all.light.resize(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto& [seen, exact, light] = values[static_cast<std::size_t>(n)];
    all.seen(n) = seen, all.exact(n) = exact, all.light(n) = light;
  }
  return all;
}

// Normals of the two edges through a corner.
inline std::array<Eigen::Vector2d, 2> normals_at(const Picture& picture, const TrueCorner& corner) {
  const Eigen::Vector2d p = corner.position;
  const Eigen::Vector2d by_u = picture.cells(p.x() + 0.5, p.y()) - picture.cells(p.x() - 0.5, p.y());
  const Eigen::Vector2d by_v = picture.cells(p.x(), p.y() + 0.5) - picture.cells(p.x(), p.y() - 0.5);
  return {Eigen::Vector2d(by_u.x(), by_v.x()).normalized(), Eigen::Vector2d(by_u.y(), by_v.y()).normalized()};
}

inline double width_of(const Picture& picture) { return std::sqrt(picture.blur * picture.blur + 1 / 12.0); }

// The best that some functions, times the light, make of the exact picture.
inline Eigen::VectorXd best_of(const Pixels& pixels, const Eigen::MatrixXd& functions) {
  const Eigen::MatrixXd lit = pixels.light.asDiagonal() * functions;
  return lit * (lit.transpose() * lit).ldlt().solve(lit.transpose() * pixels.exact);
}

// Calls act(picture) for each rival, made as like the exact picture as it can be: plain ground; one edge anywhere; a
// T-junction or an L-corner at the corner itself; a smooth saddle, as texture has them. All under the true light.
template <class Act>
void each_rival(const Pixels& pixels, const std::array<Eigen::Vector2d, 2>& normals, double width, const Act& act) {
  const auto count = static_cast<Eigen::Index>(pixels.at.size());
  double most = 0;
  for (const Eigen::Vector2d& at : pixels.at) most = std::max(most, at.norm());
  Eigen::MatrixXd functions(count, 2);
  functions.col(0).setOnes();
  const auto step_at = [&](const Eigen::Vector2d& normal, double offset, Eigen::Index n) {
    return std::erf(M_SQRT1_2 * (normal.dot(pixels.at[static_cast<std::size_t>(n)]) - offset) / width);
  };
  constexpr int direction_count = 24;
  for (int k = 0; k < direction_count; ++k)
    for (double offset = -most; offset <= most; offset += 0.5) {
      const double angle = M_PI * k / direction_count;
      for (Eigen::Index n = 0; n < count; ++n) functions(n, 1) = step_at({std::cos(angle), std::sin(angle)}, offset, n);
      act(best_of(pixels, functions));
    }
  for (int side = 0; side < 4; ++side) {  // one side of an edge plain, the other in two
    Eigen::MatrixXd parts(count, 3);
    for (Eigen::Index n = 0; n < count; ++n) {
      const double across = (side % 2 ? -1 : 1) * step_at(normals[side / 2], 0, n),
                   along = step_at(normals[1 - side / 2], 0, n);
      parts.row(n) << 0.5 * (1 - across), 0.25 * (1 + across) * (1 + along), 0.25 * (1 + across) * (1 - along);
    }
    act(best_of(pixels, parts));
  }
  Eigen::MatrixXd smooth(count, 6);
  for (Eigen::Index n = 0; n < count; ++n) {
    const Eigen::Vector2d x = pixels.at[static_cast<std::size_t>(n)] / std::max(most, 1.0);
    smooth.row(n) << 1, x.x(), x.y(), x.x() * x.x(), x.x() * x.y(), x.y() * x.y();
  }
  act(best_of(pixels, smooth));
}

// Of position (2), the edges' directions (2), width, level, half contrast, shade (2); the shadow's direction, distance,
// depth and softness.
using Numbers = Eigen::Matrix<double, 13, 1>;

inline double value_at(const Numbers& numbers, const Eigen::Vector2d& at) {
  const Eigen::Vector2d x = at - numbers.head<2>();
  const auto edge = [&](int i) {
    return std::erf(M_SQRT1_2 * (std::cos(numbers(i)) * x.x() + std::sin(numbers(i)) * x.y()) / numbers(4));
  };
  const double beyond = std::cos(numbers(9)) * at.x() + std::sin(numbers(9)) * at.y() - numbers(10);
  const double shadow = 1 - 0.5 * numbers(11) * (1 + std::erf(M_SQRT1_2 * beyond / numbers(12)));
  return shadow * (1 + numbers.segment<2>(7).dot(x)) * (numbers(5) + numbers(6) * edge(2) * edge(3));
}

// px an axis. What the detector takes as known beforehand of light and shadows is known here too.
inline double sigma_with_all_unknown(const Pixels& pixels, const Numbers& numbers, bool has_shadow, double noise) {
  constexpr double shade_slope = 0.003, softness_px = 0.5;  // 1/px, px
  const int unknowns = has_shadow ? 13 : 9;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const Eigen::Vector2d& at : pixels.at) {
    Eigen::VectorXd slope(unknowns);
    for (int i = 0; i < unknowns; ++i) {
      Numbers more = numbers, less = numbers;
      const double step = i == 7 || i == 8 ? 1e-6 : 1e-4;
      more(i) += step, less(i) -= step;
      slope(i) = (value_at(more, at) - value_at(less, at)) / (2 * step);
    }
    information += slope * slope.transpose() / (noise * noise);
  }
  information(7, 7) += 1 / (shade_slope * shade_slope), information(8, 8) += 1 / (shade_slope * shade_slope);
  if (has_shadow) information(12, 12) += 1 / (softness_px * softness_px);
  const Eigen::MatrixXd covariance = information.inverse();
  return std::sqrt(std::max(0.5 * (covariance(0, 0) + covariance(1, 1)), 0.0));
}

}  // namespace oracle_detail

/// The picture must tell Picture::exact. Likelihoods are those of white noise as large as it is in the corner's own
/// quarter cells, which alone tell: what lies beyond belongs to the neighbours. The sigma is over the 2 x 2 cells.
inline OracleVerdict ask_oracle(const Picture& picture, const TrueCorner& corner) {
  using namespace oracle_detail;
  constexpr double shadow_reach = 14;  // px: one that is farther is none
  const Pixels own = pixels_round(picture, corner, 0.5);
  if (own.at.size() < 6) return {};
  const double noise =
      std::max(std::sqrt((own.seen - own.exact).squaredNorm() / static_cast<double>(own.at.size())), 0.3);
  const auto normals = normals_at(picture, corner);
  const double width = width_of(picture);
  OracleVerdict verdict{.is_reported = true, .apart = 1e9};
  each_rival(own, normals, width, [&](const Eigen::VectorXd& rival) {
    const double apart = (own.exact - rival).norm() / noise;
    const double ratio =
        0.5 * ((own.seen - rival).squaredNorm() - (own.seen - own.exact).squaredNorm()) / (noise * noise);
    verdict.is_reported &= ratio > -0.5 * apart * apart + false_alarm * apart;
    verdict.apart = std::min(verdict.apart, apart);
  });
  Eigen::MatrixXd cross(static_cast<Eigen::Index>(own.at.size()), 2);
  for (Eigen::Index n = 0; n < cross.rows(); ++n) {
    const Eigen::Vector2d& at = own.at[static_cast<std::size_t>(n)];
    cross.row(n) << own.light(n), own.light(n) * std::erf(M_SQRT1_2 * normals[0].dot(at) / width) *
                                      std::erf(M_SQRT1_2 * normals[1].dot(at) / width);
  }
  const Eigen::Vector2d levels = cross.colPivHouseholderQr().solve(own.exact);
  const ShadowLine shadow = picture.shadow(corner);
  const bool has_shadow = shadow.depth > 0 && std::abs(shadow.distance) < shadow_reach;
  Numbers numbers;
  numbers << 0, 0, std::atan2(normals[0].y(), normals[0].x()), std::atan2(normals[1].y(), normals[1].x()), width,
      levels, 0, 0, shadow.direction, shadow.distance, has_shadow ? shadow.depth : 0,
      std::hypot(width, std::sqrt(1 / 3.0));
  verdict.sigma = sigma_with_all_unknown(pixels_round(picture, corner, 1), numbers, has_shadow, noise);
  return verdict;
}

}  // namespace handsight::corner_images
