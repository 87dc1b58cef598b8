// SPDX-License-Identifier: Apache-2.0
// Images of corners, and of what is none, with known truth, for the detector's tests, trial and benchmark.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>

#include "vision/image/image.h"

namespace handsight::corner_images {

/// Grey level of the scene at an image point (px), before blur.
using Scene = std::function<double(double u, double v)>;

inline cv::Mat as_mat(const Image& image) {
  return {image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data())};
}

inline Image as_image(const cv::Mat& mat) {
  Image image(mat.cols, mat.rows);
  for (int v = 0; v < mat.rows; ++v) std::copy_n(mat.ptr<std::uint8_t>(v), mat.cols, image.row(v));
  return image;
}

/// What a camera sees, without noise and not rounded: the scene (9 points in each of 16 parts of a pixel, no two in a
/// row or column) blurred by the lens and averaged over the pixel. Blurring whole pixels instead would skew the edges.
inline cv::Mat exact_image(int width, int height, const Scene& scene, double blur) {
  constexpr int fine_steps = 4, points_in_all = 9;
  cv::Mat fine(fine_steps * height, fine_steps * width, CV_32F);
  for (int y = 0; y < fine.rows; ++y)
    for (int x = 0; x < fine.cols; ++x) {
      double sum = 0;
      for (int i = 0; i < points_in_all; ++i)
        sum += scene((x + (i + 0.5) / points_in_all) / fine_steps - 0.5,
                     (y + ((2 * i + 5) % points_in_all + 0.5) / points_in_all) / fine_steps - 0.5);
      fine.at<float>(y, x) = static_cast<float>(sum / points_in_all);
    }
  if (blur > 0) {
    const int size = 2 * static_cast<int>(std::ceil(4 * blur * fine_steps)) + 1;
    cv::GaussianBlur(fine, fine, {size, size}, blur * fine_steps, blur * fine_steps, cv::BORDER_REPLICATE);
  }
  cv::Mat exact;
  cv::resize(fine, exact, {width, height}, 0, 0, cv::INTER_AREA);
  return exact;
}

/// The same as an image: white noise, 8 bit.
inline Image render(int width, int height, const Scene& scene, double blur, double noise, std::mt19937& random) {
  const cv::Mat exact = exact_image(width, height, scene, blur);
  Image image(width, height);
  std::normal_distribution<double> normal(0, 1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const double value = exact.at<float>(v, u) + (noise > 0 ? noise * normal(random) : 0.0);
      image.row(v)[u] = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
    }
  return image;
}

/// A plane seen by a camera of focal length `focal` px: plane coordinates in cells, the corner at (0, 0).
struct View {
  Eigen::Vector2d corner{0, 0};  // px
  Eigen::Matrix3d cells_from_image = Eigen::Matrix3d::Identity();
  double cell = 10;  // px, of a cell seen at right angles
  Eigen::Vector2d cells(double u, double v) const {
    return (cells_from_image * Eigen::Vector3d(u, v, 1)).hnormalized();
  }
};

/// `tilt`: rad, between the plane's normal and the view; `turn`: rad, of the axis of the tilt; `spin`: rad, in plane.
inline View find_view(const Eigen::Vector2d& corner, double cell, double tilt, double turn, double spin,
                      double focal = 600) {
  const Eigen::Vector3d axis(std::cos(turn), std::sin(turn), 0);
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(spin, Eigen::Vector3d::UnitZ())).toRotationMatrix();
  Eigen::Matrix3d ray_from_cells;
  ray_from_cells << rotation.col(0), rotation.col(1), Eigen::Vector3d(0, 0, focal / cell);
  Eigen::Matrix3d ray_from_image;
  ray_from_image << 1 / focal, 0, -corner.x() / focal, 0, 1 / focal, -corner.y() / focal, 0, 0, 1;
  return {corner, ray_from_cells.inverse() * ray_from_image, cell};
}

struct Light {
  double black = 40, white = 160, around = 100;  // grey levels
  Eigen::Vector2d gradient{0, 0};                // 1/px, relative to the corner
  double shade = 1;                              // factor beyond the shadow's edge
  double shade_angle = 0, shade_distance = 0;    // rad, px: the shadow's edge as seen from the corner
  double penumbra = 2;                           // px, over which light fades to shade
  double shade_bend = 0;                         // 1/px, of the edge
};

/// The light's factor.
inline double light_at(const Light& light, const Eigen::Vector2d& from_corner) {
  const Eigen::Vector2d normal(std::cos(light.shade_angle), std::sin(light.shade_angle));
  const double aside = normal.x() * from_corner.y() - normal.y() * from_corner.x();
  const double along = light.shade_distance + 0.5 * light.shade_bend * aside * aside - normal.dot(from_corner);
  const double lit = std::clamp(0.5 + along / light.penumbra, 0.0, 1.0);
  const double shadow = light.shade == 1 ? 1 : light.shade + (1 - light.shade) * lit;
  return (1 + light.gradient.dot(from_corner)) * shadow;
}

/// A marker of 2 x 2 cells on a plain ground, or with `board` a board of cells that fills the image.
inline Scene marker(const View& view, const Light& light, bool board = false) {
  return [=](double u, double v) {
    const Eigen::Vector2d at = view.cells(u, v);
    const bool in_marker = board || (std::abs(at.x()) < 1 && std::abs(at.y()) < 1);
    const bool odd = (static_cast<int>(std::floor(at.x())) + static_cast<int>(std::floor(at.y()))) & 1;
    const double paper = !in_marker ? light.around : odd ? light.white : light.black;
    return paper * light_at(light, {u - view.corner.x(), v - view.corner.y()});
  };
}

/// Covariance (px^2) by Cramer and Rao of the corner's position: gradient of the blurred X by its position over the
/// pixels of the marker's 2 x 2 cells, over the noise; everything else known.
inline Eigen::Matrix2d bound(const View& view, double contrast, double blur, double noise) {
  const Eigen::Vector2d c = view.corner;
  const auto edge = [&](const Eigen::Vector2d& direction) {  // image direction of a plane direction
    const Eigen::Vector3d image = view.cells_from_image.inverse() * Eigen::Vector3d(direction.x(), direction.y(), 1e6);
    const Eigen::Vector2d d = image.hnormalized() - c;
    return Eigen::Vector2d(d.normalized());
  };
  const Eigen::Vector2d t1 = edge({1, 0}), t2 = edge({0, 1});
  const Eigen::Vector2d n1(-t1.y(), t1.x()), n2(-t2.y(), t2.x());
  const double s = std::sqrt(blur * blur + 1 / 12.0), k = M_SQRT1_2 / s, half = contrast / 2;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  const int reach = static_cast<int>(1.6 * view.cell) + 2;
  for (int dv = -reach; dv <= reach; ++dv)
    for (int du = -reach; du <= reach; ++du) {
      const Eigen::Vector2d at = view.cells(std::round(c.x()) + du, std::round(c.y()) + dv);
      if (std::abs(at.x()) > 1 || std::abs(at.y()) > 1) continue;
      const Eigen::Vector2d x(std::round(c.x()) + du - c.x(), std::round(c.y()) + dv - c.y());
      const double a = k * n1.dot(x), b = k * n2.dot(x), slope = half * M_2_SQRTPI * k;
      const Eigen::Vector2d j = slope * (std::exp(-a * a) * std::erf(b) * n1 + std::exp(-b * b) * std::erf(a) * n2);
      information += j * j.transpose() / (noise * noise);
    }
  return information.inverse();
}

}  // namespace handsight::corner_images
