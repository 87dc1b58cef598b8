// SPDX-License-Identifier: Apache-2.0
// Poses as they came from the field, each to its right value.
#include "base/files.h"
#include "convert/hand_eye_fixture.h"
#include "detection/target_finding.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

const fs::path shared = HANDSIGHT_SHARED_DIR;
constexpr double degree = 0.017453292519943295;

struct Place {
  Vector3 mm, rpy_degrees;
};

void expect_at(const Rigid& found, const Place& right, double mm, double degrees, const std::string& what) {
  EXPECT_LT((1e3 * found.translation - right.mm).norm(), mm) << what;
  const Matrix3 rotation = rotation_from_rpy(Vector3(right.rpy_degrees * degree));
  EXPECT_LT(vector_from_rotation(Matrix3(rotation.transpose() * found.rotation)).norm(), degrees * degree) << what;
}

Conversion converted(const std::vector<fs::path>& files, const std::optional<Target>& target = {}) {
  const TemporaryFolder folder;
  ConvertOptions options;
  options.out = folder.path / "made";
  options.target = target;
  Conversion c = convert(files, options);
  find_targets(c.session);
  return c;
}

TEST(FieldPoses, OfTwoTablesComeToTheirRightValue) {
  const fs::path robots = shared / "field/robots";
  if (!fs::exists(robots)) GTEST_SKIP() << "no field sets on this machine";
  const Place camera{{62, -34, 47}, {2, -3, 88}}, board{{550, 80, 10}, {1, 2, 30}};
  for (const std::string name :
       {"degrees_without_unit", "rotation_vectors", "hand_eye_export", "makers_angles/abb", "makers_angles/fanuc",
        "makers_angles/kawasaki", "makers_angles/kuka", "makers_angles/matrices"}) {
    const Fit f = fit(converted({robots / name / "flange.csv", robots / name / "target.csv"}).session);
    expect_at(estimate(f).mount_from_sensor, camera, 1, 0.3, name);
    expect_at(f.tcp_from_body, board, 1.5, 0.3, name);
  }
  for (const std::string name : {"samples.yaml", "pairs.json"}) {
    const Fit f = fit(converted({robots / "moveit_samples" / name}).session);
    expect_at(estimate(f).mount_from_sensor, camera, 1, 0.3, name);
  }
}

TEST(FieldPoses, BesideImagesComeToTheirRightValue) {
  const fs::path set = shared / "field/cameras/hand_eye";
  if (!fs::exists(set)) GTEST_SKIP() << "no field sets on this machine";
  Target target;
  target.kind = TargetKind::chessboard;
  target.columns = 9;
  target.rows = 6;
  target.square = 0.022;
  const Place camera{{11, 9, 75}, {1, -2, 136}};
  for (const auto& [images, poses] :
       std::vector<std::pair<std::string, std::string>>{{"images", "flange_rx_ry_rz.csv"},
                                                        {"images", "flange_roll_pitch_yaw_degrees.csv"},
                                                        {"images", "poses_no_header.txt"},
                                                        {"images", "flange_matrix_rows.csv"},
                                                        {"images", "flange_with_image_names.csv"},
                                                        {"images", "matrix_files"},
                                                        {"images", "visp_poses"},
                                                        {"images", "opencv_poses.yml"},
                                                        {"images_by_time", "flange_quaternion.csv"},
                                                        {"images_digit_first", "flange_quaternion.csv"}}) {
    const Fit f = fit(converted({set / images, set / poses, set / "camera.yaml"}, target).session);
    expect_at(estimate(f).mount_from_sensor, camera, 0.5, 0.1, images + " " + poses);
  }
}

}  // namespace
}  // namespace handsight
