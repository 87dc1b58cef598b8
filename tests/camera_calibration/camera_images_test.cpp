// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/camera_images.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

class CameraImagesByName : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("handsight_groups_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void make(const std::string& name) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << "x";
  }
  fs::path folder_;
};

TEST_F(CameraImagesByName, FoldersOfTheSameNameAreCamerasByTheFolderAbove) {
  for (const char* n : {"cam0/data/1403636579.png", "cam0/data/1403636580.png", "cam1/data/1403636579.png"}) make(n);
  for (const auto& paths : {std::vector<fs::path>{folder_ / "cam0/data", folder_ / "cam1/data/"}, {folder_}}) {
    const GroupedImages grouped = group_images(paths);
    ASSERT_EQ(grouped.cameras.size(), 2u);
    EXPECT_EQ(grouped.cameras[0].name, "cam0");
    EXPECT_EQ(grouped.cameras[1].name, "cam1");
    EXPECT_EQ(grouped.frames.size(), 2u);
  }
}

TEST_F(CameraImagesByName, TimesThatDifferALittleAreOneMoment) {
  for (const char* n :
       {"cam0/data/1575683268010000000.png", "cam0/data/1575683268270000000.png", "cam0/data/1575683268530000000.png",
        "cam1/data/1575683268018000000.png", "cam1/data/1575683268278000000.png", "cam1/data/1575683268700000000.png"})
    make(n);
  const GroupedImages grouped = group_images({folder_});
  ASSERT_EQ(grouped.cameras.size(), 2u);
  EXPECT_EQ(grouped.frames.size(), 4u) << "two moments of both, one of each alone";
  EXPECT_EQ(grouped.cameras[1].keys[0], "1575683268010000000");
  EXPECT_NE(grouped.notes[0].find("nearest"), std::string::npos);
}

TEST_F(CameraImagesByName, NamesByDateAndTimeAreOneCamera) {
  for (const char* n : {"shot_2024-07-23_16-02-40.jpg", "shot_2024-07-23_16-03-01.jpg", "shot_2024-07-23_16-02-47.jpg"})
    make(n);
  const GroupedImages grouped = group_images({folder_});
  ASSERT_EQ(grouped.cameras.size(), 1u);
  EXPECT_EQ(grouped.cameras[0].name, "shot");
  EXPECT_EQ(grouped.cameras[0].files.back().filename(), "shot_2024-07-23_16-03-01.jpg");
}

TEST_F(CameraImagesByName, NumbersAfterTheCamera) {
  for (const char* n : {"right01.jpg", "left01.jpg", "left02.jpg", "left11.jpg", "right02.jpg", "intrinsics.yml"})
    make(n);
  const GroupedImages grouped = group_images({folder_});
  ASSERT_EQ(grouped.cameras.size(), 2u);
  EXPECT_EQ(grouped.cameras[0].name, "left");
  EXPECT_EQ(grouped.cameras[1].name, "right");
  EXPECT_EQ(grouped.frames, (std::vector<std::string>{"1", "2", "11"}));
  EXPECT_EQ(grouped.cameras[1].keys, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(grouped.notes.size(), 4u);  // two cameras, a moment without an image, a file that is none
}

TEST_F(CameraImagesByName, NumbersBeforeTheCameraAndInItsName) {
  for (const char* n : {"000_cam0.png", "000_cam1.png", "001_cam0.png", "001_cam1.png", "002_cam0.png", "002_cam1.png"})
    make(n);
  const GroupedImages grouped = group_images({folder_});
  ASSERT_EQ(grouped.cameras.size(), 2u);
  EXPECT_EQ(grouped.cameras[0].name, "cam0");
  EXPECT_EQ(grouped.frames.size(), 3u);
}

TEST_F(CameraImagesByName, AFolderForEachCamera) {
  for (const char* n : {"front/a_7.png", "front/a_8.png", "side/b_8.png", "side/b_9.png"}) make(n);
  for (const auto& paths : {std::vector<fs::path>{folder_}, {folder_ / "front", folder_ / "side/"}}) {
    const GroupedImages grouped = group_images(paths);
    ASSERT_EQ(grouped.cameras.size(), 2u);
    EXPECT_EQ(grouped.cameras[0].name, "front");
    EXPECT_EQ(grouped.frames, (std::vector<std::string>{"7", "8", "9"}));
  }
}

TEST_F(CameraImagesByName, OneCamera) {
  for (const char* n : {"image_0001.png", "image_0002.png"}) make(n);
  const GroupedImages grouped = group_images({folder_ / "image_0001.png", folder_ / "image_0002.png"});
  ASSERT_EQ(grouped.cameras.size(), 1u);
  EXPECT_EQ(grouped.cameras[0].files.size(), 2u);
}

TEST_F(CameraImagesByName, RefusesWhatIsNotThereOrTwice) {
  EXPECT_THROW(group_images({folder_ / "nothing"}), InputError);
  EXPECT_THROW(group_images({folder_}), InputError);
  for (const char* n : {"left1.png", "left01.png", "left2.png"}) make(n);
  EXPECT_THROW(group_images({folder_}), InputError);
}

}  // namespace
}  // namespace handsight
