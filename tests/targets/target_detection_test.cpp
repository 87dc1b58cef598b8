// SPDX-License-Identifier: Apache-2.0
#include "targets/target_detection.h"

#include <gtest/gtest.h>

#include "board_targets.h"
#include "fixtures/target_images.h"

namespace handsight {
namespace {

using fixtures::TargetView;

Camera camera() {
  return {.width = 640, .height = 480, .fx = 620, .fy = 622, .cx = 322, .cy = 236, .k1 = -0.18, .k2 = 0.06};
}

const std::vector<Eigen::Vector2f>& rays() {
  static const auto all = fixtures::fine_rays(camera());
  return all;
}

/// The middle of the target in the middle of the image, turned about x and y.
TargetView find_detection_view(const Target& target, double distance, double turn_x, double turn_y) {
  const PrintedPattern pattern = pattern_of(target);
  const Vector2 centre = pattern.outline.top_left + 0.5 * pattern.outline.size;
  TargetView view;
  view.camera = camera();
  view.camera_from_target.rotation = rotation_from_vector<double>(Vector3(turn_x, turn_y, 0.2));
  view.camera_from_target.translation =
      Vector3(0, 0, distance) - view.camera_from_target.rotation * Vector3(centre.x(), centre.y(), 0);
  return view;
}

/// Every point of the target that is inside by 10 px is found, within 0.25 px (six sigmas of what blur and noise
/// leave).
void expect_found(const Target& target, const TargetView& view, const TargetSighting& sighting, std::size_t least) {
  EXPECT_GE(sighting.points.size(), least) << sighting.reason;
  const auto points = target_points(target);
  for (const TargetPixel& seen : sighting.points) {
    const Vector3 x = view.camera_from_target * points[static_cast<std::size_t>(seen.number)].position;
    EXPECT_LT((seen.pixel - project(view.camera, x)).norm(), 0.25) << "point " << seen.number;
    EXPECT_GT(seen.covariance.determinant(), 0);
  }
}

using fixture::charuco;
using fixture::chessboard;
using fixture::grid;

TEST(TargetDetection, FindsEveryPointOfWholeBoards) {
  for (const Target& target : {chessboard, charuco, grid}) {
    const PreparedTarget prepared = prepare(target);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.7, 0.2}, {-0.3, 0.6}}) {
      const TargetView view = find_detection_view(target, 0.42, x, y);
      expect_found(target, view, detect_target(make_image(target, view, rays()), prepared),
                   target_points(target).size());
    }
  }
}

/// Large images are looked through in small first; the points are those of the large one.
TEST(TargetDetection, LargeImagesAreFoundAsSmallOnesAre) {
  for (const Target& target : {charuco, grid}) {
    const TargetView view = find_detection_view(target, 0.42, 0.3, 0.2);
    const Image small = make_image(target, view, rays());
    Image large(3 * small.width, 3 * small.height);
    const cv::Mat from(small.height, small.width, CV_8U, const_cast<std::uint8_t*>(small.pixels.data()));
    cv::Mat into(large.height, large.width, CV_8U, large.pixels.data());
    cv::resize(from, into, into.size(), 0, 0, cv::INTER_CUBIC);
    ASSERT_GT(large.width * large.height, 2700000);
    const TargetSighting sighting = detect_target(large, prepare(target));
    ASSERT_EQ(sighting.points.size(), target_points(target).size()) << sighting.reason;
    for (const TargetPixel& seen : sighting.points) {
      const Vector3 x = view.camera_from_target * target_points(target)[static_cast<std::size_t>(seen.number)].position;
      const Vector2 there = 3 * (project(view.camera, x) + Vector2::Constant(0.5)) - Vector2::Constant(0.5);
      EXPECT_LT((seen.pixel - there).norm(), 0.75) << "point " << seen.number;
    }
  }
}

TEST(TargetDetection, OldCharucoIsToldFromTheNewOne) {
  Target old = charuco;
  old.old_layout = true;
  const TargetView view = find_detection_view(old, 0.42, 0.2, 0.1);
  const Image image = make_image(old, view, rays());
  expect_found(old, view, detect_target(image, prepare(old)), target_points(old).size());
  const TargetSighting wrong = detect_target(image, prepare(charuco));
  EXPECT_TRUE(wrong.points.empty()) << "rather nothing than wrong numbers";
  EXPECT_NE(wrong.reason.find("layout"), std::string::npos) << wrong.reason;
}

TEST(TargetDetection, PartlyOutsideAndCovered) {
  for (const Target& target : {charuco, grid}) {
    TargetView view = find_detection_view(target, 0.42, 0.3, -0.2);
    view.camera_from_target.translation.x() += 0.08;
    view.covers = {{{-100, 250}, {740, 250}, {740, 700}, {-100, 700}}};
    view.cover_greys = {90};
    const TargetSighting sighting = detect_target(make_image(target, view, rays()), prepare(target));
    expect_found(target, view, sighting, 12);
    EXPECT_LT(sighting.points.size(), target_points(target).size());
    EXPECT_TRUE(sighting.reason.empty());
  }
}

TEST(TargetDetection, ChessboardIsWholeOrNothing) {
  TargetView view = find_detection_view(chessboard, 0.42, 0.3, -0.2);
  view.covers = {{{-100, 330}, {740, 330}, {740, 700}, {-100, 700}}};
  view.cover_greys = {90};
  const TargetSighting sighting = detect_target(make_image(chessboard, view, rays()), prepare(chessboard));
  EXPECT_TRUE(sighting.points.empty());
  EXPECT_FALSE(sighting.reason.empty());
}

/// 9 x 6 corners have ends of different colours: the first corner is reported upside down too.
TEST(TargetDetection, ChessboardIsNumberedByItsColours) {
  TargetView view = find_detection_view(chessboard, 0.42, 0.2, 0.1);
  const Vector3 centre = view.camera_from_target * Vector3(0.1, 0.0625, 0);
  view.camera_from_target.rotation =
      rotation_from_vector<double>(Vector3(0, 0, 2.9)) * view.camera_from_target.rotation;
  view.camera_from_target.translation = centre - view.camera_from_target.rotation * Vector3(0.1, 0.0625, 0);
  expect_found(chessboard, view, detect_target(make_image(chessboard, view, rays()), prepare(chessboard)), 54);
}

TEST(TargetDetection, SingleTagsOfEitherKind) {
  for (const char* dictionary : {"DICT_5X5_100", "tag36h11", "DICT_APRILTAG_36h11"}) {
    const Target tags{.kind = TargetKind::tags, .tag = 0.05, .dictionary = dictionary, .ids = {3, 7, 9}};
    const TargetView view = find_detection_view(tags, 0.5, 0, 0);
    std::vector<Rigid> pieces;
    for (int i = 0; i < 3; ++i)
      pieces.push_back(
          {rotation_from_vector<double>(Vector3(0.4 * i, 0.3, 0.5 * i)), Vector3(-0.12 + 0.12 * i, 0.02 * i, 0.5)});
    const TargetSighting sighting = detect_target(make_image(tags, view, rays(), pieces), prepare(tags));
    ASSERT_EQ(sighting.points.size(), 12u) << dictionary;
    const auto points = target_points(tags);
    for (const TargetPixel& seen : sighting.points) {
      const TargetPoint& point = points[static_cast<std::size_t>(seen.number)];
      EXPECT_LT(
          (seen.pixel - project(view.camera, Vector3(pieces[static_cast<std::size_t>(point.piece)] * point.position)))
              .norm(),
          0.25);
    }
  }
}

/// A tag with an id of the set at two places: which is it? Neither.
TEST(TargetDetection, TheSameTagTwiceIsNone) {
  const Target tags{.kind = TargetKind::tags, .tag = 0.05, .dictionary = "DICT_5X5_100", .ids = {3, 7}};
  const TargetView view = find_detection_view(tags, 0.5, 0, 0);
  Image image =
      make_image(tags, view, rays(),
                 {Rigid{Matrix3::Identity(), Vector3(-0.1, 0, 0.5)}, Rigid{Matrix3::Identity(), Vector3(10, 0, 0.5)}});
  const Image other =
      make_image(tags, view, rays(),
                 {Rigid{Matrix3::Identity(), Vector3(0.1, 0, 0.5)}, Rigid{Matrix3::Identity(), Vector3(10, 0, 0.5)}});
  for (int v = 0; v < image.height; ++v) std::copy(other.row(v) + 320, other.row(v) + 640, image.row(v) + 320);
  const TargetSighting sighting = detect_target(image, prepare(tags));
  EXPECT_TRUE(sighting.points.empty());
  EXPECT_EQ(sighting.dropped_tags, 2);
}

TEST(TargetDetection, FindsNothingWhereNothingIs) {
  Image noise(640, 480);
  std::mt19937 random(3);
  for (auto& pixel : noise.pixels) pixel = static_cast<std::uint8_t>(random() % 256);
  for (const Target& target : {chessboard, charuco, grid})
    for (const Image& image : {noise, Image(640, 480, 128), Image(3, 2, 7)}) {
      const TargetSighting sighting = detect_target(image, prepare(target));
      EXPECT_TRUE(sighting.points.empty());
      EXPECT_FALSE(sighting.reason.empty());
    }
}

}  // namespace
}  // namespace handsight
