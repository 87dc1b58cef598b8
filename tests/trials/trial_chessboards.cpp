// SPDX-License-Identifier: Apache-2.0
// trial_chessboards [COUNT [SEED [DEGREES [alone]]]] (0 degrees: all): chessboards through lenses of 60 to 190 degrees,
// rendered: of how many boards that are wholly in view (squares of 7 px and more) all points are found, how many of the
// points are wrong, how exact they are and whether their covariance is right; beside OpenCV's two finders on the same
// images.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <span>

#include "fixtures/wide_views.h"
#include "targets/target_detection.h"

namespace {

using namespace handsight;
using namespace handsight::fixtures;
using Clock = std::chrono::steady_clock;

const Target board{.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025};

struct Score {
  const char* name;
  int found = 0, wrong = 0;
  long points = 0;
  double squares = 0, normalised = 0, seconds = 0;
  std::array<double, 3> by_noise{};  // of the normalised squares: below 1, 3 grey levels, above
  std::array<long, 3> points_by_noise{};
};

int band_of(double noise) { return noise < 1 ? 0 : noise < 3 ? 1 : 2; }

/// A board is wrong if any of its points is 2.5 px and more from where it is.
void count(Score& score, const std::vector<Vector2>& points, const std::vector<Vector2>& truth,
           const std::vector<Eigen::Matrix2d>& covariances = {}, double noise = 0) {
  if (points.size() != truth.size()) return;
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) worst = std::max(worst, (points[i] - truth[i]).norm());
  if (worst > 2.5) {
    ++score.wrong;
    return;
  }
  ++score.found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2 e = points[i] - truth[i];
    ++score.points, score.squares += e.squaredNorm();
    if (covariances.empty()) continue;
    const double z2 = e.dot(covariances[i].inverse() * e);
    score.normalised += z2;
    score.by_noise[band_of(noise)] += z2, ++score.points_by_noise[band_of(noise)];
  }
}

/// OpenCV may begin at the other end: it is taken as it fits better.
std::vector<Vector2> as_truth_begins(const std::vector<cv::Point2f>& corners, const std::vector<Vector2>& truth) {
  std::vector<Vector2> points;
  for (const cv::Point2f& c : corners) points.emplace_back(c.x, c.y);
  if (points.size() == truth.size() && (points.back() - truth.front()).norm() < (points.front() - truth.front()).norm())
    std::reverse(points.begin(), points.end());
  return points;
}

double timed(const std::function<void()>& run) {
  const auto start = Clock::now();
  run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void add(std::vector<Score>& scores, const PreparedTarget& target, const Image& image,
         const std::vector<Vector2>& truth, double noise, bool is_alone) {
  TargetSighting sighting;
  scores[0].seconds += timed([&] { sighting = detect_target(image, target); });
  std::vector<Vector2> points;
  std::vector<Eigen::Matrix2d> covariances;
  for (const TargetPixel& p : sighting.points) points.push_back(p.pixel), covariances.push_back(p.covariance);
  count(scores[0], points, truth, covariances, noise);
  if (is_alone) return;
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  std::vector<cv::Point2f> corners;
  scores[1].seconds += timed([&] {
    if (cv::findChessboardCorners(grey, {board.columns, board.rows}, corners))
      cv::cornerSubPix(grey, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    else
      corners.clear();
  });
  count(scores[1], as_truth_begins(corners, truth), truth);
  corners.clear();
  scores[2].seconds += timed([&] {
    if (!cv::findChessboardCornersSB(grey, {board.columns, board.rows}, corners,
                                     cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY))
      corners.clear();
  });
  count(scores[2], as_truth_begins(corners, truth), truth);
}

void run(double degrees, int boards, std::uint64_t seed, bool is_alone) {
  const PreparedTarget target = prepare(board);
  std::mt19937_64 random(seed);
  std::vector<Score> scores{{"ours"}, {"findChessboardCorners"}, {"findChessboardCornersSB"}};
  int images = 0;
  for (int lens_number = 0; images < boards; ++lens_number) {
    const double bend =
        degrees <= 75 ? 1.0 / 3 : std::uniform_real_distribution(-0.05, degrees < 150 ? 0.1 : 0.04)(random);
    const WideLens lens = wide_lens(degrees, bend);
    const auto rays = wide_rays(lens);
    for (int i = 0, of_lens = 0; of_lens < (boards + 3) / 4 && images < boards && i < 4000; ++i) {
      const WideView view = placed_wide(board, lens, random);
      const auto truth = wide_truth(board, view, 7);
      if (!truth) continue;
      add(scores, target, wide_image(board, view, rays), *truth, view.noise, is_alone);
      ++images, ++of_lens;
    }
  }
  for (const Score& s : std::span(scores).first(is_alone ? 1 : 3))
    fmt::print("{:>7.0f}  {:<24} {:>4} of {:<4} {:>5} wrong {:>9.4f} px {:>7} {:>8.1f} ms\n", degrees, s.name, s.found,
               images, s.wrong, std::sqrt(s.squares / std::max(s.points, 1L)),
               s.normalised > 0 ? fmt::format("{:.2f}", s.normalised / static_cast<double>(s.points)) : "-",
               1e3 * s.seconds / images);
  for (int b = 0; b < 3; ++b)
    if (scores[0].points_by_noise[b] > 0)
      fmt::print("         noise {:<18} z^2 {:.2f} of {} points\n", std::array{"below 1", "1 to 3", "above 3"}[b],
                 scores[0].by_noise[b] / static_cast<double>(scores[0].points_by_noise[b]),
                 scores[0].points_by_noise[b]);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int boards = argc > 1 ? std::atoi(argv[1]) : 60;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  fmt::print("degrees  {:<24} {:>12} {:>11} {:>12} {:>7} {:>11}\n", "", "found", "", "rms", "z^2", "time");
  for (const double degrees : {60.0, 90.0, 120.0, 140.0, 160.0, 180.0, 190.0})
    if (argc <= 3 || std::atof(argv[3]) == 0 || std::atof(argv[3]) == degrees) run(degrees, boards, seed, argc > 4);
}
