// SPDX-License-Identifier: Apache-2.0
// A target that is described wrongly, as the command line tells it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/cli_runner.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using test::CliResult;

class WrongTarget : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("handsight_wrong_target_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    images_ = fs::path(HANDSIGHT_SHARED_DIR) / "field/cameras/charuco_described_wrongly";
    if (!fs::exists(images_)) GTEST_SKIP() << images_ << " is not here";
  }
  void TearDown() override { fs::remove_all(folder_); }

  CliResult cameras(const std::string& which, const std::string& columns = "8", const std::string& rows = "6") {
    return test::run_cli(
        folder_, {"cameras", (images_ / which).string(), "--kind", "charuco", "--columns", columns, "--rows", rows,
                  "--square", "0.035", "--marker", "0.024", "--dictionary", "DICT_4X4_50"});
  }

  /// A camera on a robot's hand before the board, with images of which the session says `layout`.
  CliResult checked(const std::string& which, const std::string& layout) {
    const fs::path session = folder_ / "session";
    fs::create_directories(session / "images");
    std::string observations;
    for (int i = 0; i < 4; ++i) {
      const std::string file = fmt::format("00{}.jpg", i);
      fs::copy_file(images_ / which / file, session / "images" / file, fs::copy_options::overwrite_existing);
      observations += fmt::format(
          "<observation id=\"{0}\" time=\"{0}\"><flange_pose xyz=\"0.{0} 0 0.5\" rpy=\"0.{0} 0 0\"/>"
          "<images eye=\"images/{1}\"/></observation>",
          i, file);
    }
    test::write_text(session / "session.xml",
                     "<handsight_session version=\"1\" title=\"Board\"><robot kind=\"poses\" tcp=\"base\"/>"
                     "<cameras mount=\"flange\"><mount_from_first estimate=\"yes\"/><camera name=\"eye\" width=\"800\" "
                     "height=\"600\" fx=\"620\" fy=\"620\" cx=\"400\" cy=\"300\"/></cameras>"
                     "<target kind=\"charuco\" columns=\"8\" rows=\"6\" square=\"0.035\" marker=\"0.024\" "
                     "dictionary=\"DICT_4X4_50\"" +
                         layout + "/><observations>" + observations + "</observations></handsight_session>");
    return test::run_cli(folder_, {"check", session.string()});
  }

  fs::path folder_, images_;
};

TEST_F(WrongTarget, CamerasSaysWhatFitsAndWhyOfEveryImage) {
  const CliResult legacy = cameras("legacy");
  EXPECT_EQ(legacy.exit_code, 2);
  EXPECT_NE(legacy.errors.find("`--layout old`"), std::string::npos) << legacy.errors;
  EXPECT_NE(legacy.errors.find("not used: 000.jpg, 001.jpg"), std::string::npos) << legacy.errors;
  EXPECT_NE(cameras("ids24").errors.find("`--first-id 24`"), std::string::npos);
  EXPECT_NE(cameras("mirrored").errors.find("mirror"), std::string::npos);
  EXPECT_NE(cameras("inverted").errors.find("white for black"), std::string::npos);
  EXPECT_NE(cameras("plain", "6", "8").errors.find("`--columns 8 --rows 6`"), std::string::npos);
}

TEST_F(WrongTarget, ABoardFoundNowhereIsAProblem) {
  const CliResult lost = checked("legacy", "");
  EXPECT_EQ(lost.exit_code, 2) << lost.output;
  EXPECT_EQ(lost.output.find("Everything"), std::string::npos) << lost.output;
  EXPECT_NE(lost.output.find("layout=\"old\""), std::string::npos) << lost.output;
  const CliResult found = checked("legacy", " layout=\"old\"");
  EXPECT_EQ(found.exit_code, 0) << found.output << found.errors;
}

/// What is to be typed is what the images show, its lengths left to be measured.
TEST_F(WrongTarget, WhereNoneIsNamedConvertSaysWhatTheImagesShow) {
  const fs::path hand_eye = fs::path(HANDSIGHT_SHARED_DIR) / "field/cameras/hand_eye";
  const CliResult refused =
      test::run_cli(folder_, {"convert", (hand_eye / "images").string(), (hand_eye / "flange_quaternion.csv").string(),
                              (hand_eye / "camera.yaml").string(), "--out", (folder_ / "made").string()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(refused.errors.find("--target \"chessboard columns=9 rows=6 square=?mm\"") != std::string::npos ||
              refused.errors.find("--target \"chessboard columns=6 rows=9 square=?mm\"") != std::string::npos)
      << refused.errors;
}

TEST_F(WrongTarget, WhereNoneIsNamedCamerasSaysWhatTheImagesShow) {
  const CliResult board = test::run_cli(folder_, {"cameras", (images_ / "plain").string()});
  EXPECT_EQ(board.exit_code, 2);
  EXPECT_NE(board.errors.find("--target \"charuco columns=8 rows=6 square=?mm marker=?mm"), std::string::npos)
      << board.errors;
  const CliResult grid =
      test::run_cli(folder_, {"cameras", (images_.parent_path() / "aruco_gridboard" / "images").string()});
  EXPECT_NE(grid.errors.find("--target \"grid columns=4 rows=5 marker=?mm"), std::string::npos) << grid.errors;
}

/// The numbers alone would be found on any grid: where they lie is looked at, too.
TEST_F(WrongTarget, AGridOfOtherColumnsIsFoundOut) {
  const auto seen = [&](const std::string& columns, const std::string& rows, const std::string& dictionary) {
    return test::run_cli(folder_, {"cameras", (images_.parent_path() / "aruco_gridboard" / "images").string(), "--kind",
                                   "grid", "--columns", columns, "--rows", rows, "--marker", "0.035", "--separation",
                                   "0.015", "--dictionary", dictionary});
  };
  EXPECT_EQ(seen("4", "5", "DICT_6X6_250").exit_code, 0);
  const CliResult exchanged = seen("5", "4", "DICT_6X6_250");
  EXPECT_EQ(exchanged.exit_code, 2) << exchanged.output;
  EXPECT_NE(exchanged.errors.find("`--columns 4 --rows 5`"), std::string::npos) << exchanged.errors;
  EXPECT_NE(seen("4", "5", "DICT_4X4_50").errors.find("`--dictionary DICT_6X6_50`"), std::string::npos);
}

}  // namespace
}  // namespace handsight
