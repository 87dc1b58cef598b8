// SPDX-License-Identifier: Apache-2.0
// Images of a 9 x 6 board by cameras with known numbers, as corners.
#pragma once

#include <random>

#include "camera_calibration/bundle.h"
#include "fixtures/drawn.h"

namespace handsight::fixture {

inline CameraRig make_rig(const LensModel& model, int cameras) {
  CameraRig rig;
  for (int i = 0; i < cameras; ++i) {
    Lens lens{&model, 640, 480, std::vector<double>(model.numbers.size(), 0)};
    const double fisheye[] = {190, 192, 318, 243, -0.02, 0.008, -0.004, 0.001};
    const double brown[] = {540 + 7.0 * i, 542, 325, 236, -0.25, 0.09, 4e-4, -6e-4, 0.02};
    for (std::size_t k = 0; k < std::min<std::size_t>(lens.numbers.size(), 9); ++k)
      lens.numbers[k] = &model == &fisheye_lens ? fisheye[k % 8] : brown[k];
    rig.lenses.push_back(lens);
    rig.from_first.push_back(
        i == 0 ? Rigid{}
               : Rigid{rotation_from_vector<double>(Vector3(0.02, -0.1 * i, 0.03)), Vector3(-0.11 * i, 0.004, 0.01)});
  }
  return rig;
}

/// Poses from all sides; corners with noise of `sigma` px a coordinate; a few may be quite wrong. `real`: where the
/// points of the board are, in place of where they are described.
inline BoardImages board_views(const CameraRig& rig, int frames, double sigma, std::uint64_t seed, int wrong_every = 0,
                               double nearness = 1, const std::vector<Vector3>& real = {}) {
  BoardImages images;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 9; ++column) images.points.emplace_back(0.03 * column, 0.03 * row, 0);
  images.camera_count = static_cast<int>(rig.lenses.size());
  images.frame_count = frames;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  int count = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const auto off = [&] { return fixture::drawn_3([&] { return uniform(random); }); };
    const Vector3 turn = off().cwiseProduct(Vector3(0.6, 0.6, 1)),
                  place = Vector3(-0.05, -0.07, 0.45) + off().cwiseProduct(Vector3(0.1, 0.08, 0.12));
    const Rigid pose{rotation_from_vector<double>(turn), {place.x(), place.y(), nearness * place.z()}};
    for (std::size_t c = 0; c < rig.lenses.size(); ++c) {
      BoardImage image{static_cast<int>(c), frame, {}};
      for (std::size_t i = 0; i < images.points.size(); ++i) {
        const Vector3 x = rig.from_first[c] * (pose * (real.empty() ? images.points[i] : real[i]));
        Vector2 pixel = project(rig.lenses[c], x) + sigma * fixture::drawn_2([&] { return normal(random); });
        if (wrong_every > 0 && ++count % wrong_every == 0) pixel += Vector2(6, -4);
        if (pixel.x() > 0 && pixel.y() > 0 && pixel.x() < 639 && pixel.y() < 479)
          image.points.push_back({static_cast<int>(i), pixel, sigma * sigma * Eigen::Matrix2d::Identity()});
      }
      images.images.push_back(image);
    }
  }
  return images;
}

}  // namespace handsight::fixture
