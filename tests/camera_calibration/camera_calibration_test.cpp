// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/camera_calibration.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "camera_calibration/board_images.h"
#include "camera_calibration/board_views.h"
#include "fixtures/drawn.h"
#include "readers/stereo_calibration.h"

namespace handsight {
namespace {

using fixture::board_views;
using fixture::make_rig;

CameraCalibration calibrated_camera(const BoardImages& images, const std::string& model) {
  const auto count = static_cast<std::size_t>(images.camera_count);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("camera" + std::to_string(i));
  return calibrate_cameras(images, std::vector<std::pair<int, int>>(count, {640, 480}), names, {model});
}

TEST(CameraCalibration, RecoversWithoutNoise) {
  for (const LensModel* model : {&brown_lens, &fisheye_lens}) {
    const CameraRig truth = make_rig(*model, 3);
    const CameraCalibration c = calibrated_camera(board_views(truth, 14, 0, 1), std::string(model->name));
    EXPECT_LT(c.bundle.rms_pixel, 1e-5) << model->name;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(c.bundle.rig.lenses[i].numbers[k], truth.lenses[i].numbers[k], 1e-3) << model->name;
      EXPECT_LT(small_motion_between(c.bundle.rig.from_first[i], truth.from_first[i]).norm(), 1e-6);
    }
  }
}

/// The reported covariance against the scatter of 60 draws: the mean squared error over it is 9 for nine numbers; its
/// standard error is sqrt(2 * 9 / 60) = 0.55.
TEST(CameraCalibration, CovariancesAreRight) {
  const CameraRig truth = make_rig(brown_lens, 2);
  double lens = 0, placement = 0;
  constexpr int draws = 60;
  for (int draw = 0; draw < draws; ++draw) {
    const BoardImages images = board_views(truth, 12, 0.1, 100 + static_cast<std::uint64_t>(draw));
    const BundleResult start = start_bundle(images, brown_lens, {{640, 480}, {640, 480}}, {"a", "b"});
    const BundleResult result = adjust_bundle(images, start.rig, start.first_from_target, {}, true);
    ASSERT_TRUE(result.lens_covariances[0] && result.placement_covariances[1]);
    const Eigen::Map<const Eigen::VectorXd> found(result.rig.lenses[0].numbers.data(), 9),
        real(truth.lenses[0].numbers.data(), 9);
    const Eigen::VectorXd e = found - real;
    lens += e.dot(result.lens_covariances[0]->ldlt().solve(e)) / draws;
    const Vector6 v = small_motion_between(truth.from_first[1], result.rig.from_first[1]);
    placement += v.dot(result.placement_covariances[1]->ldlt().solve(v)) / draws;
  }
  EXPECT_NEAR(lens, 9, 2.2);
  EXPECT_NEAR(placement, 6, 1.8);
}

TEST(CameraCalibration, WrongCornersDoNotMatterMuch) {
  const CameraRig truth = make_rig(brown_lens, 2);
  const CameraCalibration c = calibrated_camera(board_views(truth, 14, 0.1, 3, 50), "brown");
  // Six of the clean sigmas (0.15 px at this noise, by the test above); plain least squares are off by 3 px and more.
  EXPECT_NEAR(c.bundle.rig.lenses[0].numbers[0], truth.lenses[0].numbers[0], 1.0);
}

TEST(CameraCalibration, ChoosesTheModelThatPredicts) {
  const CameraCalibration fisheye =
      calibrated_camera(board_views(make_rig(fisheye_lens, 1), 14, 0.1, 4, 0, 0.35), "best");
  EXPECT_EQ(fisheye.bundle.rig.lenses[0].model, &fisheye_lens)
      << fisheye.tried[0].held_out_rms_pixel << " " << fisheye.tried[1].held_out_rms_pixel << " "
      << fisheye.tried[2].held_out_rms_pixel << fisheye.tried[2].failure;
  const CameraCalibration brown = calibrated_camera(board_views(make_rig(brown_lens, 1), 14, 0.1, 5), "best");
  EXPECT_EQ(brown.bundle.rig.lenses[0].model, &brown_lens);
  EXPECT_EQ(brown.tried.size(), 3u);
  EXPECT_NEAR(brown.held_out.rms_pixel, 0.1 * std::sqrt(2.0), 0.02);
}

TEST(CameraCalibration, SaysWherePosesDoNotSuffice) {
  BoardImages images = board_views(make_rig(brown_lens, 1), 14, 0.1, 6);
  EXPECT_TRUE(calibrated_camera(images, "brown").warnings.empty());
  // Only poses that face the camera.
  const CameraRig rig = make_rig(brown_lens, 1);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (BoardImage& image : images.images) {
    image.points.clear();
    for (std::size_t i = 0; i < images.points.size(); ++i) {
      const Rigid pose{rotation_from_vector<double>(Vector3(0.01 * image.frame, 0, 0.02)),
                       Vector3(-0.11, -0.07, 0.4 + 0.01 * image.frame)};
      image.points.push_back({static_cast<int>(i),
                              project(rig.lenses[0], Vector3(pose * images.points[i])) +
                                  0.1 * fixture::drawn_2([&] { return normal(random); }),
                              Eigen::Matrix2d::Identity()});
    }
  }
  std::string all;
  for (const Message& warning : calibrated_camera(images, "brown").warnings) all += warning + "\n";
  EXPECT_NE(all.find("degrees"), std::string::npos) << all;
  images.images.resize(2);
  EXPECT_THROW(calibrated_camera(images, "brown"), InputError);
}

TEST(CameraCalibration, CamerasThatShareNoMomentAreRefused) {
  BoardImages images = board_views(make_rig(brown_lens, 2), 12, 0.1, 7);
  std::erase_if(images.images, [](const BoardImage& image) { return (image.camera == 0) != (image.frame < 6); });
  EXPECT_THROW(calibrated_camera(images, "brown"), InputError);
}

TEST(CameraCalibration, YamlReadsBackBitForBit) {
  const CameraRig rig = make_rig(brown_lens, 2);
  const StereoRig read = parse_stereo_calibration({{rig_yaml(rig, {"left", "right"}), "rig.yaml"}});
  EXPECT_EQ(read.left.width, 640);
  EXPECT_EQ(make_lens(read.left).numbers, rig.lenses[0].numbers);
  EXPECT_EQ(make_lens(read.right).numbers, rig.lenses[1].numbers);
  EXPECT_EQ(read.right_from_left.translation, rig.from_first[1].translation);
  EXPECT_LT((read.right_from_left.rotation - rig.from_first[1].rotation).norm(), 1e-12);
}

TEST(CameraCalibration, RigsOfOneToThreeCamerasOfAnyLensReadBack) {
  const std::vector<std::string> names{"front", "side", "rear"};
  for (const LensModel* model : lens_models())
    for (int count = 1; count <= 3; ++count) {
      CameraRig rig = make_rig(*model, count);
      for (Lens& lens : rig.lenses)
        for (std::size_t k = 9; k < lens.numbers.size(); ++k) lens.numbers[k] = 0.01 * static_cast<double>(k);
      const Rig read = parse_rig_calibration({{rig_yaml(rig, names), "rig.yaml"}});
      ASSERT_EQ(read.count(), count) << model->name;
      for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        EXPECT_EQ(read.at(i).camera.width, 640);
        EXPECT_EQ(read.at(i).name, count == 2 ? (i == 0 ? "left" : "right") : names[k]);
        const Vector3 x(0.1, -0.2, 0.9);
        EXPECT_LT((project(read.at(i).camera, x) - project(rig.lenses[k], x)).norm(), 1e-9) << model->name;
        EXPECT_EQ(read.at(i).camera_from_first.translation, rig.from_first[k].translation);
      }
    }
}

TEST(CameraCalibration, ARigWithoutTheWayToACameraIsRefused) {
  std::string text = rig_yaml(make_rig(brown_lens, 3), {"a", "b", "c"});
  text.replace(text.find("T_3"), 3, "U_3");
  EXPECT_THROW(parse_rig_calibration({{text, "rig.yaml"}}), InputError);
}

/// OpenCV's own 13 stereo pairs: 0.217 px with OpenCV 4.6; to be at most 0.175.
TEST(CameraCalibration, OpenCVsStereoPairs) {
  const std::filesystem::path folder = HANDSIGHT_SHARED_DIR "/real/opencv_stereo";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const Target board{.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025};
  const DetectedImages detected = detect_in_images(group_images({folder}), board);
  ASSERT_EQ(detected.images.size(), 26u);
  for (const ReadImage& image : detected.images) EXPECT_EQ(image.points, 54) << image.file << " " << image.reason;
  const CameraCalibration c = calibrate_cameras(detected.board, detected.sizes, detected.names, {});
  EXPECT_LE(c.bundle.rms_pixel, 0.175);
  EXPECT_GT(c.held_out.rms_pixel, c.bundle.rms_pixel);
  EXPECT_NEAR(c.bundle.rig.from_first[1].translation.norm(), 0.0838, 0.002);  // OpenCV's own answer: 83.8 mm
}

}  // namespace
}  // namespace handsight
