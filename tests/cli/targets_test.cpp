// SPDX-License-Identifier: Apache-2.0
// `target` and `cameras` as a user runs them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "cli/cli_runner.h"
#include "readers/stereo_calibration.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using test::CliResult;

class TargetCommands : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("handsight_targets_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  CliResult run(const std::vector<std::string>& arguments) { return test::run_cli(folder_, arguments); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& named) {
    const CliResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.output;
    EXPECT_NE(result.errors.find(named), std::string::npos) << result.errors;
    EXPECT_GE(result.errors.size(), 20u);
    EXPECT_LE(result.errors.size(), 601u);
  }
  fs::path folder_;
};

const std::vector<std::string> charuco{"--kind",   "charuco", "--columns", "8",     "--rows",       "6",
                                       "--square", "0.02",    "--marker",  "0.015", "--dictionary", "DICT_5X5_100"};

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST_F(TargetCommands, PrintsInThreeFormats) {
  for (const auto& [name, begin] :
       {std::pair{"board.pdf", "%PDF-1."}, {"board.svg", "<?xml"}, {"board.png", "\x89PNG"}}) {
    const CliResult result = run(joined({"target", "--out", path(name)}, charuco));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.output.find("A4"), std::string::npos) << result.output;
    EXPECT_TRUE(test::read_text(path(name)).starts_with(begin)) << name;
  }
}

TEST_F(TargetCommands, RefusesInOneSentence) {
  expect_refused(joined({"target", "--out", path("board.doc")}, charuco), ".pdf");
  expect_refused({"target", "--out", path("board.pdf"), "--kind", "charuco", "--columns", "8"}, "rows");
  expect_refused({"target", "--out", path("board.pdf"), "--kind", "rings"}, "rings");
  expect_refused(joined({"target", "--out", path("no/such/board.pdf")}, charuco), "no/such");
  EXPECT_FALSE(fs::exists(path("board.pdf")));
  const std::vector<std::string> board{"--target", "chessboard", "columns=9", "rows=6", "square=0.025"};
  expect_refused(joined({"cameras", path("nothing")}, board), "nothing");
  expect_refused(joined({"cameras", folder_.string()}, board), "No images");
  test::write_text(path("a1.png"), "no image");
  expect_refused(joined({"cameras", folder_.string()}, board), "a1.png");
  expect_refused({"cameras", folder_.string(), "--target", "chessboard", "9x6"}, "9x6");
}

TEST_F(TargetCommands, CamerasFromRealPairs) {
  const fs::path images = HANDSIGHT_SHARED_DIR "/real/opencv_stereo";
  if (!fs::exists(images)) GTEST_SKIP() << images << " is not there";
  const CliResult result = run({"cameras", images.string(), "--target",
                                "<target kind=\"chessboard\" columns=\"9\" rows=\"6\" square=\"0.025\"/>", "--out",
                                path("rig.yaml"), "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.errors.find("camera left: 13 images"), std::string::npos) << result.errors;
  const nlohmann::json json = result.json();
  EXPECT_LE(json["rms_pixel"].get<double>(), 0.175);
  EXPECT_GT(json["held_out_rms_pixel"].get<double>(), 0);
  ASSERT_EQ(json["cameras"].size(), 2u);
  EXPECT_EQ(json["cameras"][1]["name"], "right");
  EXPECT_EQ(json["cameras"][0]["residual_map"]["cells"].size(), 48u);
  EXPECT_EQ(json["images"].size(), 26u);
  const StereoRig rig = read_stereo_calibration({path("rig.yaml")});
  EXPECT_EQ(rig.left.fx, json["cameras"][0]["parameters"][0]["value"].get<double>());
  EXPECT_EQ(rig.right_from_left.translation.x(), json["cameras"][1]["from_first"][0][3].get<double>());
}

/// Images of the board beside a session: its camera's numbers are known better than by the session's poses alone.
TEST_F(TargetCommands, BoardImagesBesideASessionTellOfItsCameras) {
  const fs::path samples = fs::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions";
  const std::string rig = (samples / "rigs/one_camera_board").string();
  ASSERT_EQ(run({"simulate", "--like", rig, "--out", path("few"), "--observations", "6", "--seed", "7", "--effect",
                 "camera_intrinsics:front.fx=3"})
                .exit_code,
            0);
  Session few = read_session(path("few"));
  few.mount.estimate = true;  // six poses, and only a guess where the camera stands
  few.source.reset();
  save_session(few);
  ASSERT_EQ(run({"simulate", "--like", rig, "--out", path("board"), "--observations", "16", "--seed", "8", "--images",
                 "all", "--effect", "camera_intrinsics:front.fx=3"})
                .exit_code,
            0);
  const auto sigma_of_fx = [&](const std::vector<std::string>& more, bool with_images) {
    const CliResult r =
        run(joined({"fit", path("few"), "--effects", "camera_intrinsics", "--json", path("fit.json")}, more));
    EXPECT_EQ(r.exit_code, 0) << r.errors;
    EXPECT_EQ(r.output.find("Camera images: ") != std::string::npos, with_images) << r.output;
    const auto json = nlohmann::json::parse(test::read_text(path("fit.json")));
    EXPECT_EQ(json.contains("camera_images"), with_images);
    EXPECT_NE(r.output.find("mount_from_first, on stand (where the camera sits)\n"), std::string::npos)
        << "where the camera stands is told too";
    if (with_images) {
      EXPECT_TRUE(json["camera_images"]["agree"].get<bool>()) << json["camera_images"];
    }
    const auto fx = json["effects"][0]["parameters"][0];
    EXPECT_NEAR(fx["value"].get<double>(), 3, 4 * fx["sigma"].get<double>());
    return fx["sigma"].get<double>();
  };
  const double alone = sigma_of_fx({}, false), both = sigma_of_fx({"--camera-images", path("board/images")}, true);
  EXPECT_LT(both, 0.8 * alone);
  const std::vector<std::string> intrinsics{"--effects", "camera_intrinsics"};
  expect_refused(joined({"fit", path("few"), "--camera-images", (samples / "first_steps/images").string()}, intrinsics),
                 "2 cameras (left, right)");
  expect_refused(joined({"fit", path("few"), "--camera-images", (samples / "first_steps/images/000_left.png").string()},
                        intrinsics),
                 "640 x 480");
  expect_refused({"fit", path("few"), "--camera-images", path("board/images")}, "--effects camera_intrinsics");
  expect_refused(joined({"fit", path("few")}, {"--target", "chessboard", "columns=9", "rows=6", "square=0.02"}),
                 "--camera-images");
}

}  // namespace
}  // namespace handsight
