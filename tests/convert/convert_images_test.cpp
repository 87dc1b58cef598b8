// SPDX-License-Identifier: Apache-2.0
// Sessions from images, and from what other programs know of cameras.
#include "convert/convert_fixture.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST_F(Convert, ImagesWithSwappedSidesOfTheCalibration) {
  const std::string storage =
      "%YAML:1.0\n---\nimage_width: 6\nimage_height: 8\n"
      "M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 10., 0., 3.9, 0., 10., 2.9, 0., 0., 1. ]\n"
      "M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 10., 0., 4.1, 0., 10., 3.1, 0., 0., 1. ]\n"
      "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n"
      "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ -120., 0., 0. ]\n";
  for (int i = 0; i < 3; ++i)
    for (const char* side : {"left", "right"})
      write(fmt::format("{}/{:03}.pgm", side, i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  std::string joints = "a1,a2,a3,a4,a5,a6\n";
  for (int i = 0; i < 3; ++i) joints += fmt::format("{},0.1,0.2,0.3,0.4,0.5\n", 0.1 * i);
  const auto table = write("j.csv", joints), calibration = write("stereo.yml", storage);
  const Conversion c = converted({folder.path / "right", folder.path / "left", table, calibration});
  EXPECT_THAT(c.notes, Contains(HasSubstr("width and height swapped")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("millimetres")));
  EXPECT_EQ(c.session.rig->at(0).camera.width, 8);
  EXPECT_THAT(c.session.observations[0].images[0], HasSubstr("left"));
  const auto turned = write(
      "turned.yml",
      std::string(storage).replace(storage.find("3.9"), 3, "2.9").replace(storage.find("0., 10., 2.9") + 9, 3, "3.9"));
  EXPECT_THAT(refusal({folder.path / "right", folder.path / "left", table, turned}), HasSubstr("turned by a quarter"));
  EXPECT_THAT(
      refusal({folder.path / "right", folder.path / "left", write("j.csv", joints + "0,0,0,0,0,0\n"), calibration}),
      HasSubstr("3 pairs of images and 4 lines"));
}

TEST_F(Convert, CamerasOfRosAndKalibr) {
  const std::string info = R"(image_width: 8
image_height: 6
camera_name: narrow/left
camera_matrix:
  rows: 3
  cols: 3
  data: [10.0, 0.0, 4.0, 0.0, 11.0, 3.0, 0.0, 0.0, 1.0]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.1, 0.02, 0.001, 0.002, 0.0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
projection_matrix:
  rows: 3
  cols: 4
  data: [10.0, 0.0, 4.0, BASE, 0.0, 10.0, 3.0, 0.0, 0.0, 0.0, 1.0, 0.0]
)";
  const auto with_base = [&](const std::string& base) {
    std::string text = info;
    return text.replace(text.find("BASE"), 4, base);
  };
  for (int i = 0; i < 2; ++i)
    for (const char* side : {"left", "right"})
      write(fmt::format("{}/{:03}.pgm", side, i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  const auto table = write("j.csv", "a1,a2,a3,a4,a5,a6\n0,0.1,0.2,0.3,0.4,0.5\n1,0.1,0.2,0.3,0.4,0.5\n");
  const std::vector<std::filesystem::path> images{folder.path / "left", folder.path / "right", table};
  const auto with = [&](std::initializer_list<std::filesystem::path> more) {
    std::vector<std::filesystem::path> all = images;
    all.insert(all.end(), more);
    return all;
  };
  const Conversion ros = converted(with({write("r.yaml", with_base("-1.5")), write("l.yaml", with_base("0.0"))}));
  EXPECT_NEAR(ros.session.rig->at(1).camera_from_first.translation.x(), -0.15, 1e-12);
  EXPECT_EQ(ros.session.rig->at(0).camera.p2, 0.002);
  EXPECT_THAT(refusal(with({write("r.yaml", with_base("0.0")), write("l.yaml", with_base("0.0"))})),
              HasSubstr("neither names the distance"));
  EXPECT_THAT(refusal(with({write("l.yaml", with_base("0.0"))})), HasSubstr("--target"));
  const std::string chain = R"(cam0:
  camera_model: pinhole
  intrinsics: [10.0, 11.0, 4.0, 3.0]
  distortion_model: radtan
  distortion_coeffs: [-0.1, 0.02, 0.001, 0.002]
  resolution: [8, 6]
  rostopic: /cam0/image_raw
cam1:
  camera_model: pinhole
  intrinsics: [10.5, 11.5, 4.0, 3.0]
  distortion_model: MODEL
  distortion_coeffs: [-0.1, 0.02, 0.001, 0.002]
  resolution: [8, 6]
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";
  std::string radtan = chain, fisheye = chain;
  radtan.replace(radtan.find("MODEL"), 5, "radtan");
  fisheye.replace(fisheye.find("MODEL"), 5, "equidistant");
  EXPECT_EQ(converted(with({write("c.yaml", radtan)})).session.rig->at(1).camera_from_first.translation.x(), -0.11);
  const Conversion round = converted(with({write("c.yaml", fisheye)}));
  const Camera& c = round.session.rig->at(1).camera;
  EXPECT_FALSE(round.session.rig->at(0).camera.is_fisheye);
  EXPECT_TRUE(c.is_fisheye);
  EXPECT_EQ(c.k3, 0.001);
  EXPECT_EQ(c.k4, 0.002);
  std::string omni = chain;
  omni.replace(omni.find("MODEL"), 5, "fov");
  EXPECT_THAT(refusal(with({write("c.yaml", omni)})), HasSubstr("model \"fov\""));
}

/// Boards name their points: one camera will do, or three.
TEST_F(Convert, ABoardBeforeOneCameraOrThree) {
  const auto camera_text = [](const std::string& motion) {
    return "  camera_model: pinhole\n  intrinsics: [10.0, 11.0, 4.0, 3.0]\n  distortion_model: radtan\n"
           "  distortion_coeffs: [0, 0, 0, 0]\n  resolution: [8, 6]\n" +
           motion;
  };
  const std::string aside =
      "  T_cn_cnm1:\n  - [1, 0, 0, -0.1]\n  - [0, 1, 0, 0]\n  - [0, 0, 1, 0.02]\n  - [0, 0, 0, 1]\n";
  for (int i = 0; i < 2; ++i)
    for (const char* camera : {"cam0", "cam1", "cam2"})
      write(fmt::format("{}/{:03}.pgm", camera, i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  const auto table = write("j.csv", "a1,a2,a3,a4,a5,a6\n0,0.1,0.2,0.3,0.4,0.5\n1,0.1,0.2,0.3,0.4,0.5\n");
  const auto one = write("one.yaml", "cam0:\n" + camera_text("")),
             three = write("three.yaml", "cam0:\n" + camera_text("") + "cam1:\n" + camera_text(aside) + "cam2:\n" +
                                             camera_text(aside));
  EXPECT_THAT(refusal({folder.path / "cam0", table, one}), HasSubstr("--target"));
  options_.target = fixture::charuco();
  const Conversion single = converted({folder.path / "cam0", table, one});
  EXPECT_EQ(single.session.rig->count(), 1);
  ASSERT_TRUE(single.session.target);
  EXPECT_FALSE(needs_label(single.session));
  EXPECT_EQ(single.session.observations[1].images[0], "images/001.pgm");
  // Folders go to the cameras that they are named after, whatever their order.
  const Conversion many = converted({folder.path / "cam2", folder.path / "cam0", folder.path / "cam1", table, three});
  ASSERT_EQ(many.session.rig->count(), 3);
  EXPECT_EQ(many.session.observations[0].images[1], "images/cam1/000.pgm");
  EXPECT_EQ(many.session.observations[0].images[2], "images/cam2/000.pgm");
  // Of Kalibr each camera's motion is from the one before.
  EXPECT_NEAR(many.session.rig->at(2).camera_from_first.translation.x(), -0.2, 1e-12);
  EXPECT_NEAR(many.session.rig->at(2).camera_from_first.translation.z(), 0.04, 1e-12);
  EXPECT_THAT(refusal({folder.path / "cam0", folder.path / "cam1", table, three}),
              HasSubstr("2 folders of images and a calibration of 3 cameras (cam0, cam1 and cam2)"));
}

/// What the robot's controller says of its flange will do where there is no URDF: the camera on it, or on a stand.
TEST_F(Convert, ABoardBesidePosesOfTheFlange) {
  for (int i = 0; i < 2; ++i) write(fmt::format("photos/{:03}.pgm", i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  const auto flange =
      write("robot_poses.csv", "x,y,z,qx,qy,qz,qw\n0.4,0.1,0.5,0.6,0,0.8,0\n0.5,-0.1,0.4,0,0.6,0,0.8\n");
  const auto camera = write("one.yaml",
                            "cam0:\n  camera_model: pinhole\n  intrinsics: [10.0, 11.0, 4.0, 3.0]\n  distortion_model: "
                            "radtan\n  distortion_coeffs: [0, 0, 0, 0]\n  resolution: [8, 6]\n");
  options_.target = fixture::charuco();
  const auto of_flange = [&](const std::filesystem::path& poses) {
    std::filesystem::remove_all(options_.out);
    return convert({folder.path / "photos", poses, camera}, options_);
  };
  const Conversion hand = of_flange(flange);
  EXPECT_TRUE(hand.session.robot.is_of_poses);
  EXPECT_EQ(hand.session.mount.link, "flange");
  EXPECT_EQ(hand.session.tcp, "base");
  EXPECT_THAT(hand.notes, Contains(HasSubstr("--eye-on-base")));
  EXPECT_EQ(hand.session.observations[1].images[0], "images/001.pgm");
  const Rigid second = base_from_flange(hand.session.observations[1].position);
  EXPECT_LT((second.translation - Vector3(0.5, -0.1, 0.4)).norm(), 1e-15);
  EXPECT_LT((second.rotation - Eigen::Quaterniond(0.8, 0, 0.6, 0).toRotationMatrix()).norm(), 1e-14);
  options_.eye_on_base = true;
  const Conversion stand = of_flange(flange);
  EXPECT_EQ(stand.session.mount.link, "base");
  EXPECT_EQ(stand.session.tcp, "flange");
  EXPECT_THROW(of_flange(write("robot_poses.csv", "x,y,z,qx,qy,qz,qw\n0.4,0.1,0.5,0.6,0,0.8,0\n")), InputError);
  // With a robot its joints are wanted, and the other way is named.
  EXPECT_THAT(refusal({folder.path / "photos", flange, camera}), HasSubstr("leave the robot out"));
}

}  // namespace
}  // namespace handsight
