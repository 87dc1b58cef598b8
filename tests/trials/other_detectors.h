// SPDX-License-Identifier: Apache-2.0
// OpenCV's detectors of boards and tags, and libapriltag.
#pragma once

#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>

#include "targets/target_detection.h"
#ifdef HANDSIGHT_APRILTAG
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}
#endif

namespace handsight::fixtures {

/// Numbers of a target's points and where they were found, px.
using Points = std::vector<std::pair<int, Vector2>>;

/// OpenCV's: findChessboardCorners and cornerSubPix; detectMarkers, interpolateCornersCharuco; detectMarkers refined.
inline Points opencv(const Image& image, const PreparedTarget& target, int refinement) {
  const Target& t = target.target;
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  Points points;
  if (t.kind == TargetKind::chessboard) {
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCorners(grey, {t.columns, t.rows}, corners)) return points;
    cv::cornerSubPix(grey, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    for (std::size_t i = 0; i < corners.size(); ++i)
      points.emplace_back(static_cast<int>(i), Vector2(corners[i].x, corners[i].y));
    return points;
  }
  const bool is_apriltag = t.dictionary.starts_with("tag");
  const int index = is_apriltag                     ? cv::aruco::DICT_APRILTAG_36h11
                    : t.dictionary == "DICT_4X4_50" ? cv::aruco::DICT_4X4_50
                                                    : cv::aruco::DICT_5X5_100;
  const auto dictionary = cv::aruco::getPredefinedDictionary(index);
  auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = t.border;
  if (t.kind != TargetKind::charuco) parameters->cornerRefinementMethod = refinement;
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
  cv::aruco::detectMarkers(grey, dictionary, corners, ids, parameters);
  if (t.kind == TargetKind::charuco) {
    if (ids.empty() || t.old_layout) return points;
    const auto board = cv::aruco::CharucoBoard::create(t.columns, t.rows, static_cast<float>(t.square),
                                                       static_cast<float>(t.tag), dictionary);
    std::vector<cv::Point2f> found;
    std::vector<int> numbers;
    cv::aruco::interpolateCornersCharuco(corners, ids, grey, board, found, numbers);
    for (std::size_t i = 0; i < found.size(); ++i) points.emplace_back(numbers[i], Vector2(found[i].x, found[i].y));
    return points;
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t tag = 0; tag < target.tags.size(); ++tag)
      if (target.tags[tag].id == ids[i])
        for (std::size_t k = 0; k < 4; ++k) {
          const cv::Point2f p = corners[i][is_apriltag ? (k + 2) % 4 : k];
          points.emplace_back(static_cast<int>(4 * tag + k), Vector2(p.x, p.y));
        }
  return points;
}

#ifdef HANDSIGHT_APRILTAG
inline Points apriltag(const Image& image, const PreparedTarget& target) {
  static apriltag_detector_t* detector = nullptr;
  if (!detector) {
    auto* family = tag36h11_create();
    const int more = target.target.border - 1;
    family->width_at_border += 2 * more, family->total_width += 2 * more;
    for (std::uint32_t i = 0; i < family->nbits; ++i) family->bit_x[i] += more, family->bit_y[i] += more;
    detector = apriltag_detector_create();
    detector->quad_decimate = 1;
    apriltag_detector_add_family(detector, family);
  }
  image_u8_t raw{image.width, image.height, image.width, const_cast<std::uint8_t*>(image.pixels.data())};
  zarray_t* found = apriltag_detector_detect(detector, &raw);
  Points points;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* d;
    zarray_get(found, i, &d);
    for (std::size_t tag = 0; tag < target.tags.size(); ++tag)
      if (target.tags[tag].id == d->id)  // counter-clockwise from the lower left; pixel corners are integers
        for (int k = 0; k < 4; ++k)
          points.emplace_back(static_cast<int>(4 * tag) + (3 - k), Vector2(d->p[k][0] - 0.5, d->p[k][1] - 0.5));
  }
  apriltag_detections_destroy(found);
  return points;
}
#endif

}  // namespace handsight::fixtures
