// SPDX-License-Identifier: Apache-2.0
// trial_cameras [FOLDER] [--markdown]: our calibration of two cameras beside OpenCV's, in one run, on the stereo pairs
// of a 9 x 6 chessboard of 25 mm that come with OpenCV: errors, errors of pairs held out, times, and the triangulated
// squares.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "camera_calibration/board_images.h"
#include "camera_calibration/bundle.h"
#include "camera_calibration/camera_calibration.h"
#include "trials/table.h"
#include "vision/image/image_file.h"

namespace {

using namespace handsight;
using Clock = std::chrono::steady_clock;
constexpr int board_columns = 9, board_rows = 6;
constexpr double square_size = 0.025;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// OpenCV's way: corners by findChessboardCorners and cornerSubPix, numbered as ours are (from the nearer end).
BoardImages opencv_corners(const GroupedImages& grouped, const BoardImages& ours) {
  BoardImages images = ours;
  for (BoardImage& image : images.images) {
    const auto& camera = grouped.cameras[static_cast<std::size_t>(image.camera)];
    const auto at =
        std::find(camera.keys.begin(), camera.keys.end(), grouped.frames[static_cast<std::size_t>(image.frame)]) -
        camera.keys.begin();
    const Image read = read_image(camera.files[static_cast<std::size_t>(at)]);
    const cv::Mat grey(read.height, read.width, CV_8U, const_cast<std::uint8_t*>(read.pixels.data()));
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCorners(grey, {board_columns, board_rows}, corners)) {
      image.points.clear();
      continue;
    }
    cv::cornerSubPix(grey, corners, {11, 11}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 30, 0.01});
    const Vector2 first(corners[0].x, corners[0].y);
    if ((first - image.points.front().pixel).norm() > (first - image.points.back().pixel).norm())
      std::reverse(corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) image.points[i].pixel = {corners[i].x, corners[i].y};
  }
  return images;
}

Lens lens_from(const cv::Mat& k, const cv::Mat& d, const std::pair<int, int>& size) {
  Lens lens{&brown_lens,
            size.first,
            size.second,
            {k.at<double>(0, 0), k.at<double>(1, 1), k.at<double>(0, 2), k.at<double>(1, 2)}};
  for (int i = 0; i < 5; ++i) lens.numbers.push_back(d.at<double>(i));
  return lens;
}

struct OpenCvResult {
  CameraRig rig;
  double rms = 0, mono[2] = {0, 0};
};

/// calibrateCamera for each, then stereoCalibrate over everything.
OpenCvResult opencv_calibration(const BoardImages& images, const std::pair<int, int>& size, int left_out) {
  std::vector<std::vector<cv::Point3f>> objects;
  std::vector<std::vector<cv::Point2f>> pixels[2];
  for (int frame = 0; frame < images.frame_count; ++frame) {
    if (frame == left_out) continue;
    objects.emplace_back();
    for (const Vector3& x : images.points) objects.back().emplace_back(x.x(), x.y(), 0);
    for (const BoardImage& image : images.images) {
      if (image.frame != frame) continue;
      pixels[image.camera].emplace_back();
      for (const TargetPixel& p : image.points) pixels[image.camera].back().emplace_back(p.pixel.x(), p.pixel.y());
    }
  }
  OpenCvResult result;
  cv::Mat k[2], d[2], r, t, e, f;
  std::vector<cv::Mat> rs, ts;
  const cv::Size image_size(size.first, size.second);
  for (int c = 0; c < 2; ++c) result.mono[c] = cv::calibrateCamera(objects, pixels[c], image_size, k[c], d[c], rs, ts);
  result.rms =
      cv::stereoCalibrate(objects, pixels[0], pixels[1], k[0], d[0], k[1], d[1], image_size, r, t, e, f,
                          cv::CALIB_USE_INTRINSIC_GUESS, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-9});
  Rigid placed;
  for (int i = 0; i < 3; ++i) {
    placed.translation(i) = t.at<double>(i);
    for (int j = 0; j < 3; ++j) placed.rotation(i, j) = r.at<double>(i, j);
  }
  result.rig = {{lens_from(k[0], d[0], size), lens_from(k[1], d[1], size)}, {Rigid{}, placed}};
  return result;
}

/// mm: mean and deviation of the sides of the squares, each pair's points triangulated.
std::pair<double, double> sides(const BoardImages& images, const CameraRig& rig) {
  const StereoRig stereo{*look_up_camera(rig.lenses[0]), *look_up_camera(rig.lenses[1]), rig.from_first[1]};
  double sum = 0, squares = 0, count = 0;
  for (int frame = 0; frame < images.frame_count; ++frame) {
    const BoardImage* pair[2] = {};
    for (const BoardImage& image : images.images)
      if (image.frame == frame) pair[image.camera] = &image;
    std::vector<Vector3> points;
    for (std::size_t i = 0; i < images.points.size(); ++i) {
      const auto point = triangulate(stereo, pair[0]->points[i].pixel, pair[1]->points[i].pixel);
      points.push_back(point ? point->point : Vector3::Constant(NAN));
    }
    const auto add = [&](int a, int b) {
      const double side = 1e3 * (points[static_cast<std::size_t>(a)] - points[static_cast<std::size_t>(b)]).norm();
      sum += side, squares += side * side, ++count;
    };
    for (int row = 0; row < board_rows; ++row)
      for (int column = 0; column < board_columns; ++column) {
        const int i = row * board_columns + column;
        if (column + 1 < board_columns) add(i, i + 1);
        if (row + 1 < board_rows) add(i, i + board_columns);
      }
  }
  return {sum / count, std::sqrt(std::max(squares / count - sum / count * sum / count, 0.0))};
}

double mean_square(const std::vector<std::optional<double>>& frames) {
  double sum = 0;
  for (const auto& frame : frames) sum += frame.value_or(0) * frame.value_or(0) / static_cast<double>(frames.size());
  return std::sqrt(sum);
}

}  // namespace

int main(int argc, char** argv) {
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const std::string folder = argc > 1 ? argv[1] : HANDSIGHT_SHARED_DIR "/real/opencv_stereo";
  const Target board{
      .kind = TargetKind::chessboard, .columns = board_columns, .rows = board_rows, .square = square_size};
  const GroupedImages grouped = group_images({folder});
  auto start = Clock::now();
  const DetectedImages detected = detect_in_images(grouped, board);
  const double our_detection = seconds_since(start);
  for (const ReadImage& image : detected.images)
    if (image.points == 0) fmt::print("{}: {}\n", image.file.filename().string(), image.reason);
  start = Clock::now();
  const CameraCalibration best = calibrate_cameras(detected.board, detected.sizes, detected.names, {});
  const double our_choice = seconds_since(start);
  start = Clock::now();
  const BundleResult first = start_bundle(detected.board, brown_lens, detected.sizes, detected.names);
  const BundleResult plain = adjust_bundle(detected.board, first.rig, first.first_from_target, {}, true);
  const double our_time = seconds_since(start);

  start = Clock::now();
  const BoardImages corners = opencv_corners(grouped, detected.board);
  const double their_detection = seconds_since(start);
  start = Clock::now();
  const OpenCvResult theirs = opencv_calibration(corners, detected.sizes[0], -1);
  const double their_time = seconds_since(start);
  const OpenCvResult on_ours = opencv_calibration(detected.board, detected.sizes[0], -1);
  std::vector<std::optional<double>> their_held_out, on_ours_held_out;
  for (int frame = 0; frame < corners.frame_count; ++frame) {
    their_held_out.push_back(frame_rms(corners, opencv_calibration(corners, detected.sizes[0], frame).rig, frame));
    on_ours_held_out.push_back(
        frame_rms(detected.board, opencv_calibration(detected.board, detected.sizes[0], frame).rig, frame));
  }
  for (const TriedModel& model : best.tried)
    fmt::print("model {:<9} rms {:.4f} px, held out {:.4f} px {}\n", model.name, model.rms_pixel,
               model.held_out_rms_pixel, model.failure);
  const auto ours_side = sides(detected.board, best.bundle.rig), their_side = sides(corners, theirs.rig);
  trials::Table table({{.heading = "calibration", .width = 66},
                       {"rms px", 4},
                       {"held out px", 4},
                       {"find, ms"},
                       {"solve, ms"},
                       {.heading = "side of a square, mm", .width = 18}},
                      output);
  const auto text = [](std::pair<double, double> side) {
    return fmt::format("{:.3f} +- {:.3f}", side.first, side.second);
  };
  table.print({fmt::format("`cameras`, lens chosen ({}) and folds included", best.bundle.rig.lenses[0].model->name),
               best.bundle.rms_pixel, best.held_out.rms_pixel, 1e3 * our_detection, 1e3 * our_choice, text(ours_side)});
  table.print({"the same, brown alone, with covariances", plain.rms_pixel, {}, {}, 1e3 * our_time});
  table.print({"OpenCV's `calibrateCamera` and `stereoCalibrate` on its own corners", theirs.rms,
               mean_square(their_held_out), 1e3 * their_detection, 1e3 * their_time, text(their_side)});
  table.print({"OpenCV's on our corners", on_ours.rms, mean_square(on_ours_held_out)});
  fmt::print("OpenCV's single cameras: {:.4f} and {:.4f} px; on our corners {:.4f} and {:.4f}\n", theirs.mono[0],
             theirs.mono[1], on_ours.mono[0], on_ours.mono[1]);
  fmt::print("held out by pair (ours / OpenCV):");
  for (std::size_t i = 0; i < their_held_out.size(); ++i)
    fmt::print(" {}: {:.3f} / {:.3f};", grouped.frames[i], best.held_out.frames[i].value_or(NAN),
               their_held_out[i].value_or(NAN));
  fmt::print("\n");
}
