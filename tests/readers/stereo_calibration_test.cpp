// SPDX-License-Identifier: Apache-2.0
#include "readers/stereo_calibration.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

constexpr const char* yaml = R"(%YAML:1.0
---
imageSize: [ 640, 480 ]
M1: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 520., 0.5, 320., 0., 521., 240., 0., 0., 1. ]
D1: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ -0.1, 0.06, 4.0e-04, -3.0e-04, 0.01 ]
M2: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 522., 0., 318., 0., 523., 238., 0., 0., 1. ]
D2: !!opencv-matrix
   rows: 4
   cols: 1
   dt: d
   data: [ -0.2, 0.05, 0., 0. ]
)";

constexpr const char* extrinsics = R"(%YAML:1.0
---
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 1., 0., 0., 0., 0.8, -0.6, 0., 0.6, 0.8 ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ %s ]
)";

class StereoCalibration : public testing::Test {
 protected:
  std::filesystem::path write(const char* name, std::string text, const std::string& t = {}) {
    if (const auto place = text.find("%s"); place != std::string::npos) text.replace(place, 2, t);
    replace_file(folder.path / name, text);
    return folder.path / name;
  }
  void expect_refusal(const std::vector<std::filesystem::path>& files, const std::string& words) {
    try {
      read_stereo_calibration(files);
      FAIL() << "not refused: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
  TemporaryFolder folder;
};

TEST_F(StereoCalibration, IntrinsicsAndExtrinsicsFromTwoFiles) {
  const auto rig =
      read_stereo_calibration({write("intrinsics.yml", yaml), write("extrinsics.yml", extrinsics, "-0.12, 0., 0.001")});
  EXPECT_EQ(rig.left.width, 640);
  EXPECT_EQ(rig.right.height, 480);
  EXPECT_EQ(rig.left.fx, 520);
  EXPECT_EQ(rig.left.skew, 0.5);
  EXPECT_EQ(rig.left.p2, -3e-4);
  EXPECT_EQ(rig.left.k3, 0.01);
  EXPECT_EQ(rig.right.cy, 238);
  EXPECT_EQ(rig.right.k1, -0.2);
  EXPECT_EQ(rig.right.k3, 0);
  EXPECT_EQ(rig.right_from_left.translation, Vector3(-0.12, 0, 0.001));
  EXPECT_NEAR(rig.right_from_left.rotation(1, 2), -0.6, 1e-12);
}

TEST_F(StereoCalibration, MillimetresAreNoticed) {
  std::vector<Message> notes;
  const auto rig = read_stereo_calibration(
      {write("intrinsics.yml", yaml), write("extrinsics.yml", extrinsics, "-120., 0., 1.")}, &notes);
  EXPECT_NEAR(rig.right_from_left.translation.x(), -0.12, 1e-15);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("millimetres"), std::string::npos);
}

TEST_F(StereoCalibration, OpenCVsOwnSampleFileIsReadAsFarAsItGoes) {
  const std::filesystem::path sample = HANDSIGHT_SHARED_DIR "/real/opencv_stereo/intrinsics.yml";
  if (!std::filesystem::exists(sample)) GTEST_SKIP() << "not there: " << sample;
  const auto rig = read_stereo_calibration({sample, write("extrinsics.yml", extrinsics, "-0.0835, 0., 0.")});
  EXPECT_NEAR(rig.left.fx, 534.80326845051309, 1e-12);
  EXPECT_EQ(rig.left.width, 0) << "it does not name the size";
}

TEST_F(StereoCalibration, WhatIsMissingOrWrongIsNamed) {
  const auto intrinsics = write("intrinsics.yml", yaml);
  expect_refusal({intrinsics}, "rotation R");
  expect_refusal({write("extrinsics.yml", extrinsics, "-0.1, 0., 0.")}, "left camera matrix");
  expect_refusal({write("poses.yml", "%YAML:1.0\npose1: [ 722., 38., 372., 0.1, 3., -0.1 ]\n")}, "nor numbered poses");
  expect_refusal({write("notes.txt", "these are my notes\n")}, "FileStorage");
  expect_refusal({folder.path / "nowhere.yml"}, "nowhere.yml");
  std::string sheared = extrinsics;
  sheared.replace(sheared.find("0.8, -0.6"), 9, "0.9, -0.6");
  expect_refusal({intrinsics, write("extrinsics.yml", sheared, "-0.1, 0., 0.")}, "no rotation");
}

TEST_F(StereoCalibration, WhatOpenCvCannotReadIsOneSentence) {
  for (const char* text :
       {"%YAML:1.", "%YAML:1.0\n---\n s:3", " :", "", "{", "<?xml version=\"1.0\"?>\n<opencv_storage>",
        "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: q\n   data: [ 1 ]\n"})
    expect_refusal({write("broken.yaml", text)}, "broken.yaml");
  expect_refusal({write("zero.yaml", std::string("%YAML:1.0\n\0", 11))}, "zero byte");
}

TEST_F(StereoCalibration, NestingWithoutEndIsRefusedBeforeItIsParsed) {
  std::string indented = "%YAML:1.0\n---\n", elements = "<?xml version=\"1.0\"?><opencv_storage>";
  for (int depth = 0; depth < 3000; ++depth) indented += std::string(static_cast<std::size_t>(depth), ' ') + "a:\n";
  for (int depth = 0; depth < 100000; ++depth) elements += "<a>";
  for (const std::string& text : {"{\"a\":" + std::string(1'000'000, '['), indented, elements})
    expect_refusal({write("deep.yaml", text)}, "nested too deeply");
}

TEST_F(StereoCalibration, MatricesThatAreNoCamerasAreRefused) {
  std::string text = yaml;
  text.replace(text.find("rows: 3"), 7, "rows: 2000000000");
  expect_refusal({write("large.yaml", text)}, "large.yaml");
  text = yaml;
  text.replace(text.find("520."), 4, "1e160");
  expect_refusal({write("huge.yaml", text)}, "huge.yaml");
  text = yaml;
  text.replace(text.find("520."), 4, ".Nan");
  expect_refusal({write("nan.yaml", text)}, "nan.yaml");
  text = yaml;
  text.replace(text.find("520."), 4, "1e-9");
  expect_refusal({write("tiny.yaml", text), write("extrinsics.yaml", extrinsics, "-0.1, 0., 0.")}, "focal length");
}

}  // namespace
}  // namespace handsight
