// SPDX-License-Identifier: Apache-2.0
// Random markers with known truth and the published fixture, for the detector's tests and trial.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "vision/corners/corner_images.h"

namespace handsight::corner_images {

/// What the markers of a sample are drawn from, uniformly.
struct Variety {
  std::array<double, 2> cell{8, 20};        // px
  std::array<double, 2> contrast{40, 200};  // grey levels
  std::array<double, 2> blur{0.7, 2};       // px
  std::array<double, 2> noise{2, 8};        // grey levels
  double tilt = M_PI / 3;                   // rad, at most
  double gradient = 0.005;                  // 1/px, at most, along either axis
  std::array<double, 2> shade{1, 1};        // factor beyond a shadow's edge
  bool board = false;
};

struct Sample {
  Image image;
  View view;
  Light light;
  double contrast = 0, blur = 0, noise = 0;
};

inline Sample draw(const Variety& variety, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto within = [&](const std::array<double, 2>& range) { return uniform(range[0], range[1]); };
  Sample sample;
  const double corner_v = 32 + uniform(-0.5, 0.5), corner_u = 32 + uniform(-0.5, 0.5);
  const Eigen::Vector2d corner(corner_u, corner_v);
  const double cell = within(variety.cell), tilt = uniform(0, variety.tilt), turn = uniform(0, 2 * M_PI);
  sample.view = find_view(corner, cell, tilt, turn, uniform(0, 2 * M_PI));
  sample.contrast = within(variety.contrast), sample.blur = within(variety.blur), sample.noise = within(variety.noise);
  Light& light = sample.light;
  light.black = uniform(20, 235 - sample.contrast), light.white = light.black + sample.contrast;
  light.around = uniform(20, 235);
  light.gradient = {uniform(-variety.gradient, variety.gradient), uniform(-variety.gradient, variety.gradient)};
  light.shade = within(variety.shade), light.shade_angle = uniform(0, 2 * M_PI), light.shade_distance = uniform(3, 10);
  sample.image = render(65, 65, marker(sample.view, light, variety.board), sample.blur, sample.noise, random);
  return sample;
}

/// Covariance (px^2) by Cramer and Rao of the position of the sample's corner, everything else known, from the rendered
/// image itself: its neighbours' blur, its shadow, its marker's border and the rounding to grey levels are in it. Over
/// the pixels of the 2 x 2 cells.
inline Eigen::Matrix2d rendered_bound(const Sample& sample, bool board) {
  constexpr double step_size = 0.1;  // px
  const auto moved = [&](double du, double dv) {
    View view = sample.view;
    Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
    back.col(2) << -du, -dv, 1;
    view.cells_from_image = view.cells_from_image * back;  // the light stays where it is
    return exact_image(65, 65, marker(view, sample.light, board), sample.blur);
  };
  const cv::Mat by_u = moved(step_size, 0) - moved(-step_size, 0), by_v = moved(0, step_size) - moved(0, -step_size);
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  for (int v = 0; v < 65; ++v)
    for (int u = 0; u < 65; ++u) {
      const Eigen::Vector2d at = sample.view.cells(u, v);
      if (std::abs(at.x()) > 1 || std::abs(at.y()) > 1) continue;
      const Eigen::Vector2d j = Eigen::Vector2d(by_u.at<float>(v, u), by_v.at<float>(v, u)) / (2 * step_size);
      information += j * j.transpose() / (sample.noise * sample.noise + 1 / 12.0);
    }
  return information.inverse();
}

/// The fixture by which chess-corners reports itself: 45 x 45 px, cells of `cell` px along the axes, 30 and 230 grey
/// levels, 8 x 8 samples a pixel, rounded, then blurred and noisy. Those samples place an edge to an eighth of a
/// pixel only: `rendered` is the corner that the image really shows, `corner` the one that was asked for.
struct Fixture {
  Image image;
  Eigen::Vector2d corner, rendered;  // px
};

inline Fixture fixture(const Eigen::Vector2d& corner, double blur, double noise, double cell, std::mt19937& random) {
  constexpr int size_px = 45, sample_count = 8;
  const auto odd_cell = [&](double at, double origin) {
    return static_cast<int>(std::floor((at - origin) / cell)) & 1;
  };
  cv::Mat mat(size_px, size_px, CV_32F);
  for (int v = 0; v < size_px; ++v)
    for (int u = 0; u < size_px; ++u) {
      int white = 0;
      for (int i = 0; i < sample_count * sample_count; ++i)
        white += odd_cell(u + (i % sample_count + 0.5) / sample_count - 0.5, corner.x()) ^
                 odd_cell(v + (i / sample_count + 0.5) / sample_count - 0.5, corner.y());
      mat.at<float>(v, u) = std::round(30 + 200.f * static_cast<float>(white) / (sample_count * sample_count));
    }
  if (blur > 0) {
    const int size = 2 * static_cast<int>(std::ceil(3 * blur)) + 1;
    cv::GaussianBlur(mat, mat, {size, size}, blur, blur, cv::BORDER_REPLICATE);
  }
  std::normal_distribution<double> normal(0, 1);
  Image image(size_px, size_px);
  for (int v = 0; v < size_px; ++v)
    for (int u = 0; u < size_px; ++u) {
      const double value = mat.at<float>(v, u) + (noise > 0 ? noise * normal(random) : 0.0);
      image.row(v)[u] = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
    }
  return {image, corner, (corner.array() * sample_count).round() / sample_count};
}

/// The corner refined by OpenCV from the same start: window 11 x 11, as in OpenCV's own examples.
inline Eigen::Vector2d opencv_corner(const Image& image, const Eigen::Vector2d& start) {
  std::vector<cv::Point2f> points{{static_cast<float>(start.x()), static_cast<float>(start.y())}};
  cv::cornerSubPix(as_mat(image), points, {5, 5}, {-1, -1},
                   {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 40, 1e-3});
  return {points[0].x, points[0].y};
}

/// Scenes without an X-corner, by kind; `texture` is a coarse random grid, interpolated smoothly.
inline const std::vector<std::string>& kinds_of_nothing() {
  static const std::vector<std::string> kinds{"L-corner", "line", "dot",   "T-junction",
                                              "blob",     "edge", "plain", "texture"};
  return kinds;
}

inline Scene nothing(const std::string& kind, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double angle = uniform(0, 2 * M_PI), opening = uniform(0.7, 2.4), size = uniform(1, 6);
  const double black = uniform(20, 100), white = uniform(140, 235), middle = uniform(black, white);
  const double at_v = 32 + uniform(-3, 3), at_u = 32 + uniform(-3, 3);
  const Eigen::Vector2d at(at_u, at_v);
  std::array<float, 32 * 32> grid;
  for (float& value : grid) value = static_cast<float>(uniform(black, white));
  const double pitch = uniform(3, 10);
  return [=](double u, double v) {
    const double x = u - at.x(), y = v - at.y();
    const double along = x * std::cos(angle) + y * std::sin(angle), off = y * std::cos(angle) - x * std::sin(angle);
    const double radius = std::hypot(x, y), turn = std::atan2(off, along);
    if (kind == "L-corner") return turn > 0 && turn < opening ? white : black;
    if (kind == "line") return std::abs(off) < size / 2 ? white : black;
    if (kind == "dot") return radius < size ? white : black;
    if (kind == "T-junction") return off < 0 ? middle : std::sin(turn - opening) > 0 ? white : black;
    if (kind == "blob") return black + (white - black) * std::exp(-radius * radius / (2 * size * size));
    if (kind == "edge") return off < 0 ? white : black;
    if (kind == "plain") return middle;
    const double gu = std::clamp(u / pitch + 1, 0.0, 29.99), gv = std::clamp(v / pitch + 1, 0.0, 29.99);
    const int i = static_cast<int>(gu), j = static_cast<int>(gv);
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const double fu = smooth(gu - i), fv = smooth(gv - j);
    const double upper = grid[j * 32 + i] * (1 - fu) + grid[j * 32 + i + 1] * fu;
    const double lower = grid[(j + 1) * 32 + i] * (1 - fu) + grid[(j + 1) * 32 + i + 1] * fu;
    return upper * (1 - fv) + lower * fv;
  };
}

/// A scene of 640 x 480 px: texture and noise, with `markers` markers spread over it; their corners in `corners`.
inline Image busy_scene(int markers, double noise, std::mt19937& random,
                        std::vector<Eigen::Vector2d>* corners = nullptr) {
  Image image = render(640, 480, nothing("texture", random), 1, noise, random);
  for (int n = 0; n < markers; ++n) {
    const Sample sample = draw({.noise = {noise, noise}}, random);
    const int u = 10 + 68 * (n % 9), v = 10 + 68 * (n / 9 % 6);
    for (int y = 0; y < 65; ++y) std::copy_n(sample.image.row(y), 65, image.row(v + y) + u);
    if (corners) corners->push_back(sample.view.corner + Eigen::Vector2d(u, v));
  }
  return image;
}

}  // namespace handsight::corner_images
