// SPDX-License-Identifier: Apache-2.0
#include "targets/tag_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "targets/homography.h"
#include "targets/sampling.h"
#include "targets/tag_whiteness.h"

namespace handsight {
namespace {

constexpr int unknowns = 11;  // 8 of the corners, level, contrast, blur
using VectorU = Eigen::Matrix<double, unknowns, 1>;
using MatrixU = Eigen::Matrix<double, unknowns, unknowns>;

constexpr double floor_px = 0.05;               // px: what lens, print and surroundings leave unsaid (trial_targets)
constexpr double most_unexplained = 0.25;       // of a large tag, which the lens may bend
constexpr double most_unexplained_near = 0.12;  // of what a corner is recognised by
constexpr double large_side = 48;               // px: from here on each corner is fitted on its own
constexpr double corner_radius = 24;            // px, of its surroundings
constexpr int most_pixels = 6000;               // of one fit: beyond it every second, third ... row and column

struct State {
  Quad corners;
  double level = 0, contrast = 0, blur = 1;
};

struct Pixel {
  Vector2 at;
  double grey;
};

/// The maps of a state: modules from pixels, and its changes with each coordinate of a corner.
struct Maps {
  Matrix3 module_from_pixel;
  std::array<Matrix3, 8> by_corner;

  Maps(const State& state, int side) {
    module_from_pixel = homography_from_quad(state.corners, side).inverse();
    constexpr double step = 1e-4;  // px
    for (std::size_t i = 0; i < 8; ++i) {
      Quad moved = state.corners;
      moved[i / 2](static_cast<Eigen::Index>(i % 2)) += step;
      Matrix3 other = homography_from_quad(moved, side).inverse();
      other *= module_from_pixel(2, 2) / other(2, 2);
      by_corner[i] = (other - module_from_pixel) / step;
    }
  }
};

struct Sums {
  MatrixU matrix = MatrixU::Zero();
  VectorU vector = VectorU::Zero();
  double squares = 0, light = 0, light_squares = 0;
  int count = 0;
};

void add(Sums& sums, const State& state, const Maps& maps, const TagPattern& pattern, const Pixel& pixel) {
  const Vector3 x = maps.module_from_pixel * pixel.at.homogeneous();
  const Vector2 place = x.hnormalized();
  const Eigen::Matrix2d slope =
      (maps.module_from_pixel.topLeftCorner<2, 2>() - place * maps.module_from_pixel.bottomLeftCorner<1, 2>()) / x.z();
  const double sigma_x = state.blur * slope.row(0).norm(), sigma_y = state.blur * slope.row(1).norm();
  const double correlation = slope.row(0).dot(slope.row(1)) / (slope.row(0).norm() * slope.row(1).norm());
  const Whiteness w = whiteness(pattern, place, sigma_x, sigma_y, correlation);
  VectorU row;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vector3 d = maps.by_corner[i] * pixel.at.homogeneous();
    const Vector2 moved = (d.head<2>() - place * d.z()) / x.z();
    row(static_cast<Eigen::Index>(i)) = state.contrast * (w.by_x * moved.x() + w.by_y * moved.y());
  }
  row(8) = 1;
  row(9) = w.value;
  constexpr double step = 0.02;
  row(10) = state.contrast *
            (whiteness(pattern, place, sigma_x * (1 + step), sigma_y * (1 + step), correlation).value - w.value) /
            (step * state.blur);
  const double residual = pixel.grey - state.level - state.contrast * w.value;
  sums.matrix.selfadjointView<Eigen::Upper>().rankUpdate(row);
  sums.vector += row * residual;
  sums.squares += residual * residual;
  sums.light += pixel.grey, sums.light_squares += pixel.grey * pixel.grey;
  ++sums.count;
}

Sums sums_of(const State& state, const TagPattern& pattern, const std::vector<Pixel>& pixels) {
  const Maps maps(state, pattern.side);
  Sums sums;
  for (const Pixel& pixel : pixels) add(sums, state, maps, pattern, pixel);
  sums.matrix = MatrixU(sums.matrix.selfadjointView<Eigen::Upper>());
  return sums;
}

double side_of(const Quad& q) {
  return 0.25 * ((q[1] - q[0]).norm() + (q[2] - q[1]).norm() + (q[3] - q[2]).norm() + (q[0] - q[3]).norm());
}

/// The pixels on the tag and its quiet zone; with `only`, those around that point.
std::vector<Pixel> pixels_on(const Image& image, const TagPattern& pattern, const Quad& quad,
                             const TagFitOptions& options, const Vector2* only = nullptr) {
  const double side = pattern.side, zone = options.quiet_zone;
  const Matrix3 pixel_from_module = homography_from_quad(quad, side), module_from_pixel = pixel_from_module.inverse();
  Vector2 lowest = Vector2::Constant(1e9), highest = Vector2::Constant(-1e9);
  for (const auto& [x, y] :
       {std::pair{-zone, -zone}, {side + zone, -zone}, {side + zone, side + zone}, {-zone, side + zone}}) {
    const Vector2 corner = mapped(pixel_from_module, Vector2(x, y));
    lowest = lowest.cwiseMin(corner), highest = highest.cwiseMax(corner);
  }
  if (only)
    lowest = lowest.cwiseMax(*only - Vector2::Constant(corner_radius)),
    highest = highest.cwiseMin(*only + Vector2::Constant(corner_radius));
  lowest = lowest.cwiseMax(Vector2::Zero());
  highest = highest.cwiseMin(Vector2(image.width - 1, image.height - 1));
  const double area = std::max((highest - lowest).prod(), 0.0);
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(area / most_pixels))));
  std::vector<Pixel> pixels;
  for (int v = static_cast<int>(std::ceil(lowest.y())); v <= highest.y(); v += stride)
    for (int u = static_cast<int>(std::ceil(lowest.x())); u <= highest.x(); u += stride) {
      const Vector2 at(u, v), place = mapped(module_from_pixel, at);
      const double x = std::max(-place.x(), place.x() - side), y = std::max(-place.y(), place.y() - side);
      if (!(x <= zone && y <= zone)) continue;
      if (options.corners_touch && x > -zone && y > -zone) continue;
      if (only && (at - *only).norm() > corner_radius) continue;
      pixels.push_back({at, static_cast<double>(image.row(v)[u])});
    }
  return pixels;
}

State moved(const State& state, const VectorU& step) {
  State next = state;
  for (std::size_t i = 0; i < 8; ++i)
    next.corners[i / 2](static_cast<Eigen::Index>(i % 2)) += step(static_cast<Eigen::Index>(i));
  next.level += step(8), next.contrast += step(9);
  next.blur = std::clamp(state.blur + std::clamp(step(10), -0.4 * state.blur, 0.6 * state.blur), 0.3, 8.0);
  return next;
}

/// All corners, or the one that is asked for.
bool is_near(const Quad& a, const Quad& b, double distance, std::optional<std::size_t> only) {
  for (std::size_t i = 0; i < 4; ++i)
    if ((!only || i == *only) && !((a[i] - b[i]).norm() < distance)) return false;
  return true;
}

struct Fitted {
  State state;
  Sums sums;
};

/// Gauss-Newton with damping; `belief` (1/px^2) holds the corners near the start. Where one corner is meant alone, the
/// pixels say nothing of the others, which may then go anywhere.
std::optional<Fitted> settle(State state, const TagPattern& pattern, const std::vector<Pixel>& pixels, double most_away,
                             double belief, std::optional<std::size_t> only = {}) {
  if (pixels.size() < 3 * unknowns) return std::nullopt;
  const State start = state;
  const auto with_belief = [&](const State& s, Sums& sums) {
    const double weight = belief * std::max(sums.squares / sums.count, 0.1);
    for (int i = 0; i < 8; ++i) {
      const double away =
          s.corners[static_cast<std::size_t>(i / 2)](i % 2) - start.corners[static_cast<std::size_t>(i / 2)](i % 2);
      sums.matrix(i, i) += weight, sums.vector(i) -= weight * away;
    }
  };
  Sums sums = sums_of(state, pattern, pixels);
  with_belief(state, sums);
  double damping = 1e-4;
  for (int iteration = 0; iteration < 15; ++iteration) {
    MatrixU damped = sums.matrix;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += 1e-9;
    const VectorU step = damped.ldlt().solve(sums.vector);
    const State next = moved(state, step);
    if (!is_near(next.corners, start.corners, most_away, only)) return std::nullopt;
    Sums then = sums_of(next, pattern, pixels);
    with_belief(next, then);
    if (!(then.squares < sums.squares * (1 + 1e-9))) {
      damping *= 20;
      if (damping > 1e3 || step.head<8>().norm() < 1e-4) break;
      continue;
    }
    state = next, sums = then, damping = std::max(damping / 10, 1e-7);
    if (step.head<8>().norm() < 2e-3) break;
  }
  return Fitted{state, sums};
}

double unexplained_share(const Sums& sums, double image_noise) {
  const double count = sums.count, variance = sums.light_squares / count - sums.light / count * sums.light / count;
  return std::max(sums.squares / count - image_noise * image_noise, 0.0) / std::max(variance, 1e-9);
}

/// What the residuals' size says; residuals of a wrong shape are not independent from pixel to pixel.
MatrixU make_covariance(const Fitted& fitted, double image_noise) {
  const double variance = fitted.sums.squares / std::max(fitted.sums.count - unknowns, 1);
  const double noise = std::max(image_noise * image_noise, 0.09);
  const double enlarged = variance > noise ? noise + 4 * (variance - noise) : noise;
  return enlarged * fitted.sums.matrix.ldlt().solve(MatrixU::Identity());
}

State first_state(const Image& image, const TagPattern& pattern, const Quad& quad) {
  const Matrix3 pixel_from_module = homography_from_quad(quad, pattern.side);
  double white = 0, black = 0;
  int whites = 0, blacks = 0;
  for (int row = 0; row < pattern.side; ++row)
    for (int column = 0; column < pattern.side; ++column) {
      const double grey = grey_at(image, mapped(pixel_from_module, Vector2(column + 0.5, row + 0.5)));
      (pattern.is_white(column, row) ? white : black) += grey;
      ++(pattern.is_white(column, row) ? whites : blacks);
    }
  State state;
  state.corners = quad;
  state.level = black / std::max(blacks, 1);
  state.contrast = whites > 0 ? white / whites - state.level : 100;
  return state;
}

/// Each corner with what is around it, the others held near where they are; false where one does not look as it should.
bool fit_corners(const Image& image, const TagPattern& pattern, const TagFitOptions& options, double image_noise,
                 const State& whole, TagFit& fit) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pixels = pixels_on(image, pattern, whole.corners, options, &whole.corners[i]);
    const auto fitted = settle(whole, pattern, pixels, 6, 1, i);
    if (!fitted || unexplained_share(fitted->sums, image_noise) > most_unexplained_near) return false;
    fit.corners[i] = fitted->state.corners[i];
    fit.covariances[i] = make_covariance(*fitted, image_noise)
                             .block<2, 2>(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(i));
  }
  return true;
}

}  // namespace

std::optional<TagFit> fit_tag(const Image& image, const TagPattern& pattern, const Quad& start, double image_noise,
                              const TagFitOptions& options) {
  for (const Vector2& corner : start)
    if (!is_inside(image, corner, 1)) return std::nullopt;
  const double side = side_of(start), module = side / pattern.side;
  if (!(module > 1)) return std::nullopt;
  const auto fitted = settle(first_state(image, pattern, start), pattern, pixels_on(image, pattern, start, options),
                             0.7 * module + 1, 0);
  if (!fitted || !(fitted->state.contrast > 3 * image_noise / std::sqrt(module)) || !(fitted->state.contrast > 8))
    return std::nullopt;
  TagFit fit;
  fit.corners = fitted->state.corners;
  fit.blur = fitted->state.blur;
  fit.contrast = fitted->state.contrast;
  fit.unexplained = unexplained_share(fitted->sums, image_noise);
  if (!(fit.unexplained < most_unexplained)) return std::nullopt;
  const MatrixU covariance = make_covariance(*fitted, image_noise);
  for (Eigen::Index i = 0; i < 4; ++i)
    fit.covariances[static_cast<std::size_t>(i)] = covariance.block<2, 2>(2 * i, 2 * i);
  const bool is_large = side > large_side;
  if (!is_large && fit.unexplained > most_unexplained_near) return std::nullopt;
  if (is_large && !fit_corners(image, pattern, options, image_noise, fitted->state, fit)) return std::nullopt;
  for (const Vector2& corner : fit.corners)
    if (!is_inside(image, corner)) return std::nullopt;
  for (Eigen::Matrix2d& one : fit.covariances) one += Eigen::Matrix2d::Identity() * floor_px * floor_px;
  return fit;
}

}  // namespace handsight
