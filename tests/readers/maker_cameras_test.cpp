// SPDX-License-Identifier: Apache-2.0
// Cameras in the words of several programs.
#include "readers/maker_cameras.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "readers/kalibr_target.h"
#include "readers/yaml_text.h"
#include "session/session_texts.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string stereo_ost = R"(# oST version 5.0 parameters


[image]

width
640

height
480

[narrow_stereo/left]

camera matrix
500.5 0.0 320.25
0.0 501.5 240.75
0.0 0.0 1.0

distortion
-0.2 0.05 0.001 -0.002 0.0

rectification
1.0 0.0 0.0
0.0 1.0 0.0
0.0 0.0 1.0

projection
490.0 0.0 321.0 0.0
0.0 490.0 241.0 0.0
0.0 0.0 1.0 0.0

[narrow_stereo/right]

camera matrix
502.5 0.0 319.25
0.0 503.5 239.75
0.0 0.0 1.0

distortion
-0.21 0.06 0.0 0.0 0.0

rectification
1.0 0.0 0.0
0.0 1.0 0.0
0.0 0.0 1.0

projection
490.0 0.0 321.0 -58.8
0.0 490.0 241.0 0.0
0.0 0.0 1.0 0.0
)";

TEST(MakerCameras, OstHoldsOneCameraOrTwo) {
  ASSERT_TRUE(is_ost(stereo_ost));
  const auto cameras = read_ost(stereo_ost, "ost.txt");
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].name, "left");
  EXPECT_EQ(cameras[0].camera.fy, 501.5);
  EXPECT_EQ(cameras[0].camera.k1, -0.2);
  EXPECT_EQ(cameras[0].camera.p2, -0.002);
  EXPECT_EQ(cameras[1].camera.width, 640);
  const StereoRig rig = make_rig(cameras[0], cameras[1]);
  EXPECT_NEAR(rig.right_from_left.translation.x(), -0.12, 1e-12);
  const auto one = read_ost(stereo_ost.substr(0, stereo_ost.find("[narrow_stereo/right]")), "ost.ini");
  EXPECT_EQ(one.size(), 1u);
  EXPECT_THAT(find_refusal([&] { read_ost("[image]\nwidth\n640\n[a]\ncamera matrix\n1 2 3\n", "ost.ini"); }),
              HasSubstr("3 numbers; expected 9"));
  EXPECT_THAT(find_refusal([&] { read_ost("[image]\nwidth\n640x\n", "ost.ini"); }), HasSubstr("line 3"));
}

TEST(MakerCameras, TheFirstEchoedMessageCounts) {
  const std::string one =
      "header:\n  stamp:\n    sec: 1\nheight: 480\nwidth: 640\ndistortion_model: rational_polynomial\n"
      "d:\n- 0.1\n- 0.2\n- 0.01\n- 0.02\n- 0.3\n- 0.4\n- 0.5\n- 0.6\nk: [500, 0, 320, 0, 501, 240, 0, 0, 1]\n---\n";
  const YAML::Node yaml = parse_yaml(one + "height: 1\n---\n", "echo.yaml");
  ASSERT_TRUE(is_echoed_camera_info(yaml));
  const RosCamera camera = read_echoed_camera_info(yaml, "echo.yaml");
  EXPECT_EQ(camera.camera.width, 640);
  EXPECT_EQ(camera.camera.k6, 0.6);
  const std::string shortened_text =
      "height: 480\nwidth: 640\ndistortion_model: plumb_bob\nd: '<sequence type: double, length: 5>'\nk: [500, 0, "
      "320]\n";
  EXPECT_THAT(find_refusal([&] { read_echoed_camera_info(parse_yaml(shortened_text, "e"), "echo.yaml"); }),
              HasSubstr("--full-length"));
}

TEST(MakerCameras, RealSenseAsJsonAndAsListed) {
  std::vector<Message> notes;
  const auto json = [&](const std::string& model, const std::string& coefficients) {
    return read_realsense(parse_yaml("{\"width\": 640, \"height\": 480, \"ppx\": 321.5, \"ppy\": 238.25, \"fx\": 600, "
                                     "\"fy\": 601, \"model\": \"" +
                                         model + "\", \"coeffs\": [" + coefficients + "]}",
                                     "rs.json"),
                          "rs.json", notes);
  };
  EXPECT_EQ(json("distortion.inverse_brown_conrady", "0,0,0,0,0").camera.cy, 238.25);
  EXPECT_THAT(notes, IsEmpty());
  EXPECT_EQ(json("distortion.inverse_brown_conrady", "-0.05,0.06,0.001,0.002,-0.02").camera.p1, 0.001);
  EXPECT_THAT(notes, Contains(HasSubstr("as librealsense projects with them")));
  EXPECT_TRUE(json("distortion.kannala_brandt4", "0.1,0.2,0.3,0.4,0").camera.is_fisheye);
  EXPECT_THAT(find_refusal([&] { json("distortion.ftheta", "0.1,0,0,0,0"); }), HasSubstr("ftheta"));
  const std::string listed =
      "Device info:\n Name : Intel RealSense D435\n\n Intrinsic of \"Color\" / 640x480 / {YUYV/RGB8}\n"
      "  Width:      \t640\n  Height:     \t480\n  PPX:        \t321.5\n  PPY:        \t238.25\n  Fx:         \t600\n"
      "  Fy:         \t601\n  Distortion: \tBrown Conrady\n  Coeffs:     \t0.1  \t0.2  \t0.003  \t0.004  \t0.5  \n"
      "  FOV (deg):  \t56.1 x 43.6\n\n";
  ASSERT_TRUE(is_realsense_listing(listed));
  const RosCamera camera = read_realsense_listing(listed, "rs.txt", notes);
  EXPECT_EQ(camera.camera.fx, 600);
  EXPECT_EQ(camera.camera.k3, 0.5);
  EXPECT_THAT(find_refusal([&] { read_realsense_listing(listed + listed, "rs.txt", notes); }),
              HasSubstr("lists 2 streams"));
}

TEST(MakerCameras, CamodocalsPinholeAndFisheye) {
  const std::string head = "%YAML:1.0\n---\nmodel_type: ",
                    size = "\ncamera_name: front\nimage_width: 640\nimage_height: 480\n";
  const RosCamera plain = read_camodocal(head + "PINHOLE" + size +
                                             "distortion_parameters:\n  k1: -0.2\n  k2: 0.1\n  p1: 0.001\n  p2: 0.002\n"
                                             "projection_parameters:\n  fx: 500\n  fy: 501\n  cx: 320\n  cy: 240\n",
                                         "camera.yaml");
  EXPECT_EQ(plain.name, "front");
  EXPECT_EQ(plain.camera.p2, 0.002);
  EXPECT_EQ(plain.camera.fy, 501);
  const RosCamera wide = read_camodocal(head + "KANNALA_BRANDT" + size +
                                            "projection_parameters:\n  k2: 0.01\n  k3: 0.02\n  k4: 0.03\n  k5: 0.04\n"
                                            "  mu: 300\n  mv: 301\n  u0: 320\n  v0: 240\n",
                                        "camera.yaml");
  EXPECT_TRUE(wide.camera.is_fisheye);
  EXPECT_EQ(wide.camera.k4, 0.04);
  EXPECT_EQ(wide.camera.fy, 301);
  EXPECT_THAT(
      find_refusal([&] { read_camodocal(head + "MEI" + size + "projection_parameters:\n  u0: 1\n", "camera.yaml"); }),
      HasSubstr("KANNALA_BRANDT"));
}

TEST(MakerCameras, KalibrsTargets) {
  const Target grid = read_kalibr_target(
      parse_yaml("target_type: 'aprilgrid'\ntagCols: 6\ntagRows: 5\ntagSize: 0.088\ntagSpacing: 0.3\n", "t"),
      "april.yaml");
  EXPECT_EQ(grid.kind, TargetKind::aprilgrid);
  EXPECT_EQ(grid.columns, 6);
  EXPECT_EQ(grid.rows, 5);
  EXPECT_EQ(grid.tag, 0.088);
  EXPECT_EQ(grid.spacing, 0.3);
  const std::string board =
      "target_type: checkerboard\ntargetCols: 6\ntargetRows: 7\nrowSpacingMeters: 0.06\ncolSpacingMeters: ";
  const Target chess = read_kalibr_target(parse_yaml(board + "0.06\n", "t"), "checker.yaml");
  EXPECT_EQ(chess.kind, TargetKind::chessboard);
  EXPECT_EQ(point_count(chess), 42);
  EXPECT_THAT(find_refusal([&] { read_kalibr_target(parse_yaml(board + "0.05\n", "t"), "checker.yaml"); }),
              HasSubstr("expected squares"));
  const std::string circles =
      "target_type: circlegrid\ntargetCols: 6\ntargetRows: 7\nspacingMeters: 0.02\nasymmetricGrid: true\n";
  EXPECT_THAT(find_refusal([&] { read_kalibr_target(parse_yaml(circles, "t"), "circles.yaml"); }),
              HasSubstr("--target circles columns=6 rows=7 spacing=0.02 diameter=METRES layout=asymmetric"));
  EXPECT_THAT(find_refusal([&] { read_kalibr_target(parse_yaml("target_type: balls\n", "t"), "balls.yaml"); }),
              HasSubstr("handsight-cli target"));
}

}  // namespace
}  // namespace handsight
