// SPDX-License-Identifier: Apache-2.0
// The 13 real stereo pairs of a chessboard (OpenCV's samples), where they are at hand.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "vision/corners/corner_detector.h"
#include "vision/corners/corner_images.h"

namespace handsight::corner_images {

using BoardCorners = std::vector<std::vector<cv::Point2f>>;  // by view

struct StereoBoards {
  std::vector<Image> images[2];  // left, right
  BoardCorners opencv[2];        // findChessboardCorners and cornerSubPix, in order
};

/// Empty where the folder is absent.
inline StereoBoards stereo_boards(const std::filesystem::path& folder) {
  StereoBoards boards;
  for (int view = 1; view <= 14; ++view)
    for (int side = 0; side < 2; ++side) {
      const auto file = folder / fmt::format("{}{:02}.jpg", side == 0 ? "left" : "right", view);
      if (!std::filesystem::exists(file)) continue;
      const cv::Mat mat = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
      std::vector<cv::Point2f> corners;
      cv::findChessboardCorners(mat, {9, 6}, corners);
      cv::cornerSubPix(mat, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 30, 0.01});
      boards.images[side].push_back(as_image(mat));
      boards.opencv[side].push_back(corners);
    }
  return boards;
}

/// Those of our corners that are nearest to OpenCV's, which stay where none of ours is within 3 px: `lost` counts them.
inline BoardCorners our_corners(const StereoBoards& boards, int side, int& lost) {
  BoardCorners ours = boards.opencv[side];
  for (std::size_t view = 0; view < ours.size(); ++view) {
    const std::vector<Corner> found = detect_corners(boards.images[side][view]);
    for (cv::Point2f& point : ours[view]) {
      const cv::Point2f theirs = point;
      double nearest = 3;
      for (const Corner& corner : found) {
        const double distance = std::hypot(corner.position.x() - theirs.x, corner.position.y() - theirs.y);
        if (distance >= nearest) continue;
        nearest = distance;
        point = {static_cast<float>(corner.position.x()), static_cast<float>(corner.position.y())};
      }
      lost += nearest == 3;
    }
  }
  return ours;
}

struct StereoRms {
  double left = 0, right = 0, stereo = 0;  // px
};

/// Each camera by itself, then the pair with the cameras held: with OpenCV's corners 0.195, 0.207, 0.217 px.
inline StereoRms calibrate(const BoardCorners& left, const BoardCorners& right) {
  std::vector<cv::Point3f> board;
  for (int i = 0; i < 54; ++i)
    board.emplace_back(25.f * static_cast<float>(i % 9), 25.f * static_cast<float>(i / 9), 0.f);
  const std::vector<std::vector<cv::Point3f>> boards(left.size(), board);
  const cv::Size size(640, 480);
  cv::Mat camera[2], distortion[2], rotation, translation, essential, fundamental;
  std::vector<cv::Mat> rotations, translations;
  StereoRms rms;
  rms.left = cv::calibrateCamera(boards, left, size, camera[0], distortion[0], rotations, translations);
  rms.right = cv::calibrateCamera(boards, right, size, camera[1], distortion[1], rotations, translations);
  rms.stereo = cv::stereoCalibrate(boards, left, right, camera[0], distortion[0], camera[1], distortion[1], size,
                                   rotation, translation, essential, fundamental, cv::CALIB_FIX_INTRINSIC,
                                   {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-6});
  return rms;
}

}  // namespace handsight::corner_images
