// SPDX-License-Identifier: Apache-2.0
// Chessboards through lenses that bend them.
#include <gtest/gtest.h>

#include <filesystem>

#include "board_targets.h"
#include "fixtures/wide_views.h"
#include "targets/corner_lattice.h"
#include "targets/corner_links.h"
#include "targets/target_detection.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using namespace fixtures;

class WideChessboards : public testing::TestWithParam<double> {};

/// Five boards in view of a lens: every point of every board, within 0.3 px.
TEST_P(WideChessboards, EveryPointIsFound) {
  const Target& board = fixture::chessboard;
  const PreparedTarget target = prepare(board);
  const WideLens lens = wide_lens(GetParam(), GetParam() <= 75 ? 1.0 / 3 : 0.02);
  const auto rays = wide_rays(lens);
  std::mt19937_64 random(20);
  for (int boards = 0; boards < 5;) {
    const WideView view = placed_wide(board, lens, random);
    const auto truth = wide_truth(board, view, 8);
    if (!truth) continue;
    ++boards;
    const TargetSighting sighting = detect_target(wide_image(board, view, rays), target);
    ASSERT_EQ(sighting.points.size(), truth->size()) << "board " << boards << ": " << sighting.reason;
    for (const TargetPixel& p : sighting.points)
      EXPECT_LT((p.pixel - (*truth)[static_cast<std::size_t>(p.number)]).norm(), 0.3) << "point " << p.number;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, WideChessboards, testing::Values(60, 120, 160, 190));

/// A board of one row more, of which half a row is lost: rather nothing than wrong numbers.
TEST(WideChessboards, AnotherBoardIsNoneOfTheseCorners) {
  const WideLens lens = wide_lens(120, 0.02);
  Target larger = fixture::chessboard;
  larger.rows = 7;
  WideView view;
  view.lens = lens;
  view.camera_from_target.translation = {-0.1, -0.075, 0.15};
  const Image image = wide_image(larger, view, wide_rays(lens));
  EXPECT_EQ(detect_target(image, prepare(larger)).points.size(), 63U);
  EXPECT_TRUE(detect_target(image, prepare(fixture::chessboard)).points.empty());
}

TEST(CornerLattice, PlacesAreGuessedOnABentSurface) {
  LatticePixels pixels;
  const auto bent = [](int column, int row) {
    return Vector2(30 * column + 0.8 * column * column - row, 25 * row + 0.5 * column * row);
  };
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) pixels[{column, row}] = bent(column, row);
  pixels.erase({2, 1});
  const auto inside = guess_pixel(pixels, {2, 1}), outside = guess_pixel(pixels, {5, 2});
  ASSERT_TRUE(inside && outside);
  EXPECT_LT((inside->pixel - bent(2, 1)).norm(), 1e-9);
  EXPECT_LT((outside->pixel - bent(5, 2)).norm(), 1e-9);
  EXPECT_TRUE(inside->is_between);
  EXPECT_FALSE(outside->is_between);
  EXPECT_NEAR(inside->slope(0, 0), 30 + 2 * 0.8 * 2, 1e-9);
  EXPECT_FALSE(guess_pixel({{{0, 0}, {1, 2}}, {{1, 0}, {3, 4}}}, {2, 0}));
}

/// Two edges that leave to the same side make an arc; to different sides they are none.
TEST(CornerLinks, FollowArcsButNoZigzags) {
  const auto corner = [](double x, double turn, bool dark) {
    return RayCorner{{x, 0}, {0.3 + turn, 1.8 + turn, 0.3 + turn + M_PI, 1.8 + turn + M_PI}, dark};
  };
  const auto arc = link_corners({corner(0, 0, true), corner(30, -0.6, false)});
  EXPECT_EQ(arc[0][0].corner, 1);
  EXPECT_EQ(arc[0][0].ray, 2U);
  EXPECT_EQ(arc[1][2].corner, 0);
  EXPECT_EQ(link_corners({corner(0, 0, true), corner(30, -0.6, true)})[0][0].corner, -1) << "the same colours";
  EXPECT_EQ(link_corners({corner(0, 0, true), corner(30, 0, false)})[0][0].corner, -1) << "a zigzag";
}

/// Images of two lenses as people have them: a fisheye of 180 degrees and an action camera.
TEST(WideChessboards, FieldImagesAreFound) {
  const fs::path cameras = fs::path(HANDSIGHT_SHARED_DIR) / "field/cameras";
  if (!fs::exists(cameras)) GTEST_SKIP() << "no field sets on this machine";
  const PreparedTarget target = prepare(fixture::chessboard);
  for (const char* set : {"fisheye_chessboard", "wide_angle_chessboard"})
    for (const auto& file : fs::directory_iterator(cameras / set / "images")) {
      const TargetSighting sighting = detect_target(read_image(file.path()), target);
      EXPECT_EQ(sighting.points.size(), 54U) << file.path() << ": " << sighting.reason;
    }
}

}  // namespace
}  // namespace handsight
