// SPDX-License-Identifier: Apache-2.0
// Sessions from images, and from what other programs know of cameras.
#include "ways/convert_fixture.h"

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
  EXPECT_THAT(refusal(with({write("l.yaml", with_base("0.0"))})), HasSubstr("one camera alone"));
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
  EXPECT_THAT(refusal(with({write("c.yaml", fisheye)})), HasSubstr("equidistant"));
}

}  // namespace
}  // namespace handsight
