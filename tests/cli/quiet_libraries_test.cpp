// SPDX-License-Identifier: Apache-2.0
// What the libraries below print of themselves never reaches a user: bad input is one sentence of ours.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <regex>

#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using test::run_cli;
using test::write_text;

/// What lines of libraries begin with.
const char* const library_lines[] = {"OpenCV(",  "[ WARN", "[ERROR",    "[ INFO",         "libpng", "libtiff",
                                     "TIFF",     "JPEG",   "Corrupt",   "Premature end",  "VP8",    "Ceres",
                                     "WARNING:", "WARN",   "terminate", "  what():",      "sqlite", "yaml-cpp",
                                     "BFGS",     "Eigen",  "***",       "Warning: linear"};

void expect_ours(const std::string& errors, const std::string& of) {
  static const std::regex glog_line("^[IWEF][0-9]{4,8} ");
  std::istringstream lines(errors);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(std::regex_search(line, glog_line)) << of << ": " << line;
    for (const char* begin : library_lines) EXPECT_FALSE(line.starts_with(begin)) << of << ": " << line;
  }
}

/// Refused with one sentence.
void expect_one_sentence(const test::CliResult& result, const std::string& of) {
  expect_ours(result.errors, of);
  EXPECT_EQ(result.exit_code, 2) << of << ": " << result.errors;
  std::size_t sentences = 0;
  std::istringstream lines(result.errors);
  for (std::string line; std::getline(lines, line);) sentences += !line.empty() && !line.starts_with("note:");
  EXPECT_EQ(sentences, 1u) << of << ": " << result.errors;
}

std::string encoded(const std::string& ending) {
  cv::Mat picture(120, 160, CV_8UC3);
  for (int v = 0; v < picture.rows; ++v)
    for (int u = 0; u < picture.cols; ++u)
      picture.at<cv::Vec3b>(v, u) = {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(u * v),
                                     static_cast<std::uint8_t>(v)};
  std::vector<std::uint8_t> bytes;
  cv::imencode(ending, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

class QuietLibraries : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(QuietLibraries, ImagesThatAreDamagedInside) {
  for (const std::string ending : {".png", ".jpg", ".tiff", ".bmp", ".webp"}) {
    fs::remove_all(folder_.path / "images");
    const std::string good = encoded(ending);
    for (int i = 0; i < 4; ++i) {
      std::string bad = good;
      for (std::size_t at = 60 + static_cast<std::size_t>(i); at + 30 < bad.size(); at += 37)
        bad[at] = static_cast<char>(bad[at] ^ 0x5A);
      write_text(folder_.path / "images" / ("image_" + std::to_string(i) + ending), bad);
    }
    const auto result =
        run_cli(folder_.path, {"cameras", (folder_.path / "images").string(), "--kind", "chessboard", "--columns", "9",
                               "--rows", "6", "--square", "0.02", "--out", (folder_.path / "c.yaml").string()});
    expect_ours(result.errors + result.output, ending);
    EXPECT_EQ(result.exit_code, 2) << ending << result.errors;
  }
}

TEST_F(QuietLibraries, FilesThatAreNoneOfTheirKind) {
  write_text(folder_.path / "robot.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>");
  const std::pair<const char*, std::string> files[] = {
      {"stereo.yml", "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1., 2.\n"},
      {"stereo.xml",
       "<?xml version=\"1.0\"?><opencv_storage><M1 type_id=\"opencv-matrix\"><rows>3</rows></opencv_storage>"},
      {"camera.yaml", "image_width: [640\ncamera_matrix: {\n"},
      {"bag.db3", "SQLite format 3\0 and then nothing that it is"},
      {"bag.mcap", "\x89MCAP0\r\n\x06\xFF\xFF\xFF"},
      {"bag.bag", "#ROSBAG V2.0\n\xFF\xFF\xFF\xFF"},
      {"bag.db3.zstd", "\x28\xB5\x2F\xFD and no frame"},
      {"model.xml", "<mujoco><worldbody><body pos=\"x\"/></worldbody></mujoco>"},
      {"camera.json", "{\"ppx\": 1, \"ppy\": \"two\", \"fx\": 3, \"fy\": 4}"},
      {"table.csv", "a,b\n1,two\n"},
      {"take.csv", "Format Version,1.23\nFrame,Time\n"}};
  for (const auto& [name, content] : files) {
    write_text(folder_.path / name, content);
    expect_one_sentence(run_cli(folder_.path, {"convert", (folder_.path / name).string(), "--robot",
                                               (folder_.path / "robot.urdf").string(), "--tcp", "a", "--out",
                                               (folder_.path / "made").string()}),
                        name);
    EXPECT_FALSE(fs::exists(folder_.path / "made")) << name;
  }
}

/// Poses that tell nothing of what is asked: the solver's own worries stay inside.
TEST_F(QuietLibraries, FitsThatCannotBeDone) {
  std::string flange = "x,y,z,qx,qy,qz,qw\n", target = flange;
  for (int i = 0; i < 12; ++i) {
    flange += "0.4,0.1,0.5,0,0,0,1\n";
    target += "0.1,0,0.6,0,0,0,1\n";
  }
  write_text(folder_.path / "flange.csv", flange);
  write_text(folder_.path / "target.csv", target);
  const std::string made = (folder_.path / "made").string();
  const auto converted = run_cli(folder_.path, {"convert", (folder_.path / "flange.csv").string(),
                                                (folder_.path / "target.csv").string(), "--out", made});
  expect_ours(converted.errors, "convert");
  if (converted.exit_code != 0) return;
  for (const char* command : {"check", "fit", "diagnose", "improve", "plan"}) {
    const auto result = run_cli(folder_.path, {command, made});
    expect_ours(result.errors, command);
    EXPECT_NE(result.exit_code, -1) << command << " ended by a signal";
  }
}

TEST_F(QuietLibraries, ACalibrationOfFourPairsOfWebcams) {
  const fs::path field = HANDSIGHT_SHARED_DIR "/field/cameras/webcam_pairs";
  if (!fs::exists(field)) GTEST_SKIP() << "no field sets on this machine";
  const auto result =
      run_cli(folder_.path, {"cameras", field.string(), "--kind", "chessboard", "--columns", "7", "--rows", "4",
                             "--square", "0.0319", "--out", (folder_.path / "c.yaml").string()});
  expect_ours(result.errors, "cameras");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

}  // namespace
}  // namespace handsight
