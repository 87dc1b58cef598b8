// SPDX-License-Identifier: Apache-2.0
// Boards that are not as described: found, told, and not taken for another lens.
#include <gtest/gtest.h>

#include <random>

#include "camera_calibration/bent_board.h"
#include "camera_calibration/board_images.h"
#include "camera_calibration/board_report.h"
#include "camera_calibration/board_views.h"

namespace handsight {
namespace {

using fixture::board_views;
using fixture::make_rig;

const Target board{.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.03};

std::vector<Vector3> described() { return board_views(make_rig(brown_lens, 1), 1, 0, 1).points; }

std::vector<Vector3> bent(const Vector3& bend) {
  std::vector<Vector3> points = described();
  const Vector3 middle = find_middle(points);
  for (Vector3& point : points) point = bent_point(point, middle, bend);
  return points;
}

std::vector<Vector3> badly_printed(double sigma) {
  std::vector<Vector3> points = described();
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal(0, sigma);
  for (Vector3& point : points) point += fixture::drawn_3([&] { return normal(random); });
  return points;
}

CameraCalibration calibrated(const BoardImages& images, const std::string& model = "best") {
  return calibrate_cameras(images, {{640, 480}}, {"camera"}, {model});
}

/// Squared error of the lens's numbers over their covariance.
double chi_squared(const CameraCalibration& c, const CameraRig& truth) {
  const auto& numbers = c.bundle.rig.lenses[0].numbers;
  const auto count = static_cast<Eigen::Index>(numbers.size());
  const Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(numbers.data(), count) -
                            Eigen::Map<const Eigen::VectorXd>(truth.lenses[0].numbers.data(), count);
  return e.dot(c.bundle.lens_covariances[0]->ldlt().solve(e));
}

bool says(const std::vector<Message>& lines, const std::string& what) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(what) != std::string::npos; });
}

TEST(BoardShape, ABendKeepsLengthsAndItsDerivativesAreRight) {
  const Vector3 middle(0.1, 0.05, 0), bend(0.4, 0.1, -0.2), point(0.2, -0.03, 0);
  Matrix3 by_bend;
  const Vector3 at = bent_point(point, middle, bend, &by_bend);
  for (int k = 0; k < 3; ++k) {
    const Vector3 step = 1e-6 * Vector3::Unit(k);
    const Vector3 numeric = (bent_point(point, middle, bend + step) - bent_point(point, middle, bend - step)) / 2e-6;
    EXPECT_LT((numeric - by_bend.col(k)).norm(), 1e-9);
  }
  EXPECT_GT(at.z(), 0);
  // Along a cylinder the way from the middle to the edge stays as long as it was.
  double length = 0;
  for (int i = 0; i < 100; ++i) {
    const auto on_it = [&](int k) { return bent_point(Vector3(0.1 + 0.001 * k, 0.05, 0), middle, Vector3(1, 0, 0)); };
    length += (on_it(i + 1) - on_it(i)).norm();
  }
  EXPECT_NEAR(length, 0.1, 5e-7) << "0.17 mm without";
}

TEST(BoardShape, ABentBoardIsNoFisheye) {
  for (const Vector3& bend : {Vector3(0.25, 0, 0), Vector3(0.1, -0.15, 0.08), Vector3(0, 0.6, 0)})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const CameraRig truth = make_rig(brown_lens, 1);
      const BoardImages images = board_views(truth, 12, 0.05, seed, 0, 1, bent(bend));
      const CameraCalibration c = calibrated(images);
      EXPECT_EQ(c.bundle.rig.lenses[0].model, &brown_lens) << bend.transpose();
      ASSERT_EQ(c.bundle.shape, BoardShape::bent) << bend.transpose();
      EXPECT_LT(chi_squared(c, truth), 27.9) << "of nine, once in a thousand";
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(c.bundle.bend[k], bend[k], 4 * std::sqrt((*c.bundle.bend_covariance)(k, k)) + 0.002);
      const BoardReport report = board_report(images, c, board);
      EXPECT_TRUE(says(report.warnings, "not flat")) << bend.transpose();
      EXPECT_TRUE(says(report.sentences, "How large it is images cannot tell"));
    }
}

TEST(BoardShape, AFlatBoardStaysAsDescribed) {
  for (std::uint64_t seed = 10; seed < 14; ++seed)
    for (const LensModel* lens : {&brown_lens, &fisheye_lens}) {
      const BoardImages images = board_views(make_rig(*lens, 1), 12, 0.1, seed, 0, lens == &fisheye_lens ? 0.35 : 1);
      const CameraCalibration c = calibrated(images);
      EXPECT_EQ(c.bundle.rig.lenses[0].model, lens) << seed;
      EXPECT_EQ(c.bundle.shape, BoardShape::held) << seed;
      const BoardReport report = board_report(images, c, board);
      EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
      EXPECT_TRUE(says(report.sentences, "bent by less than"));
    }
}

TEST(BoardShape, PointsElsewhereThanDescribedAreFoundWithTheLens) {
  const std::vector<Vector3> real = badly_printed(3e-4);
  const CameraRig truth = make_rig(brown_lens, 1);
  BoardImages images = board_views(truth, 16, 0.05, 4, 0, 1, real);
  for (const std::optional<double> sigma : {std::optional<double>(0), std::optional<double>(), std::optional(3e-4)}) {
    images.sigma = sigma;
    const CameraCalibration c = calibrated(images);
    EXPECT_EQ(c.bundle.rig.lenses[0].model, &brown_lens);
    EXPECT_EQ(c.bundle.shape, sigma == std::optional(3e-4) ? BoardShape::within : BoardShape::free);
    EXPECT_LT(chi_squared(c, truth), 27.9);
    const BoardReport report = board_report(images, c, board);
    EXPECT_NEAR(report.off_rms, 3e-4 * std::sqrt(3.0), 1e-4);
    std::vector<Vector3> found = c.bundle.target_points;
    double most = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i % 9 == 8) continue;
      const std::size_t k = i + 1;  // sides in a row: they do not depend on where the whole is laid
      most = std::max(most, std::abs((found[i] - found[k]).norm() - (real[i] - real[k]).norm()));
    }
    EXPECT_LT(most, 1.5e-4) << "of sides that are off by 0.4 mm and more";
  }
}

/// The scatter of 40 draws over the covariance: 9 for nine numbers, its standard error sqrt(2 * 9 / 40) = 0.67.
TEST(BoardShape, CovariancesCountWhatTheShapeLeavesOpen) {
  const CameraRig truth = make_rig(brown_lens, 1);
  double of_bent = 0, of_free = 0;
  constexpr int draws = 40;
  for (int draw = 0; draw < draws; ++draw) {
    const std::uint64_t seed = 200 + static_cast<std::uint64_t>(draw);
    BoardImages images = board_views(truth, 12, 0.1, seed, 0, 1, bent(Vector3(0.3, 0, 0)));
    const BundleResult start = start_bundle(images, brown_lens, {{640, 480}}, {"a"});
    for (const BoardShape shape : {BoardShape::bent, BoardShape::free}) {
      CameraCalibration c;
      c.bundle = adjust_bundle(images, start.rig, start.first_from_target, {.shape = shape}, true);
      ASSERT_TRUE(c.bundle.lens_covariances[0].has_value());
      (shape == BoardShape::bent ? of_bent : of_free) += chi_squared(c, truth) / draws;
    }
  }
  EXPECT_NEAR(of_bent, 9, 2.7);
  EXPECT_NEAR(of_free, 9, 2.7);
}

TEST(BoardShape, OfFourViewsNothingMoreIsAsked) {
  const CameraCalibration c =
      calibrated(board_views(make_rig(brown_lens, 1), 4, 0.1, 3, 0, 1, bent(Vector3(0.1, 0, 0))));
  EXPECT_EQ(c.bundle.rig.lenses[0].model, &brown_lens);
}

TEST(BoardShape, OfASheetWithUnevenFeed) {
  std::vector<Vector3> real = described();
  for (Vector3& point : real) point.x() *= 1.006;
  const BoardImages images = board_views(make_rig(brown_lens, 1), 14, 0.05, 8, 0, 1, real);
  const CameraCalibration c = calibrated(images);
  const BoardReport report = board_report(images, c, board);
  EXPECT_TRUE(says(report.warnings, "0.6")) << fmt::format("{}", fmt::join(report.warnings, "\n"));
}

struct Detected {
  DetectedImages images;
  CameraCalibration calibration;
  BoardReport report;
};

std::optional<Detected> of_field(const std::string& name, const Target& target) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras" / name;
  if (!std::filesystem::exists(folder)) return std::nullopt;
  Detected d{detect_in_images(group_images({folder / "images"}), target), {}, {}};
  d.calibration = calibrate_cameras(d.images.board, d.images.sizes, d.images.names, {});
  d.report = board_report(d.images.board, d.calibration, target);
  return d;
}

TEST(BoardShape, OfARenderedBentBoard) {
  for (const std::optional<double> sigma : {std::optional<double>(0), std::optional<double>()}) {
    const auto d = of_field("bent_board", {.kind = TargetKind::charuco,
                                           .columns = 7,
                                           .rows = 5,
                                           .square = 0.03,
                                           .tag = 0.021,
                                           .dictionary = "DICT_4X4_50",
                                           .sigma = sigma});
    if (!d) GTEST_SKIP() << "not here";
    const Lens& lens = d->calibration.bundle.rig.lenses[0];
    EXPECT_EQ(lens.model, &brown_lens);
    EXPECT_NEAR(lens.numbers[0], 620, 0.5);
    EXPECT_NEAR(lens.numbers[2], 402.3, 0.5);
    EXPECT_NEAR(lens.numbers[3], 296.7, 0.5);
    EXPECT_TRUE(says(d->report.warnings, "not flat"));
  }
}

TEST(BoardShape, OfTagsWithAnotherGap) {
  const auto d = of_field("aprilgrid_spacing", {.kind = TargetKind::aprilgrid,
                                                .columns = 6,
                                                .rows = 5,
                                                .tag = 0.04,
                                                .spacing = 0.25,
                                                .dictionary = "tag36h11",
                                                .border = 2});
  if (!d) GTEST_SKIP() << "not here";
  EXPECT_NEAR(d->calibration.bundle.rig.lenses[0].numbers[0], 620, 0.5);
  EXPECT_TRUE(says(d->report.warnings, "spacing=0.3 ")) << d->report.warnings.front();
}

}  // namespace
}  // namespace handsight
