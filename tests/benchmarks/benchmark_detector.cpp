// SPDX-License-Identifier: Apache-2.0
// Time of the whole detector on one core, 640 x 480, beside OpenCV's sector-based chessboard detector.
#include <benchmark/benchmark.h>

#include <opencv2/calib3d.hpp>

#include "vision/corners/corner_detector.h"
#include "vision/corners/corner_truth.h"

namespace handsight {
namespace {

Image board_scene() {
  std::mt19937 random(1);
  const auto view = corner_images::find_view({320, 240}, 40, 0.4, 0.7, 0.2);
  const auto cells = [=](double u, double v) -> double {
    const Eigen::Vector2d at = view.cells(u, v);
    if (std::abs(at.x()) > 5 || std::abs(at.y()) > 3.5) return 150;
    return ((static_cast<int>(std::floor(at.x())) + static_cast<int>(std::floor(at.y() + 0.5))) & 1) ? 200 : 40;
  };
  return corner_images::render(640, 480, cells, 1, 3, random);
}

Image busy_scene(double noise) {
  std::mt19937 random(2);
  return corner_images::busy_scene(54, noise, random);
}

void detect(benchmark::State& state, const Image& image) {
  for (auto _ : state) benchmark::DoNotOptimize(detect_corners(image));
  state.counters["corners"] = static_cast<double>(detect_corners(image).size());
}

void opencv_sector_based(benchmark::State& state, const Image& image) {
  cv::setNumThreads(1);
  std::vector<cv::Point2f> corners;
  for (auto _ : state) cv::findChessboardCornersSB(corner_images::as_mat(image), {9, 6}, corners);
}

BENCHMARK_CAPTURE(detect, board, board_scene())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(detect, texture_noise_3, busy_scene(3))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(detect, texture_noise_8, busy_scene(8))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_sector_based, board, board_scene())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handsight

BENCHMARK_MAIN();
