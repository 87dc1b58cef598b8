// SPDX-License-Identifier: Apache-2.0
// Which camera and which instant the names of files name.
#include "session/find_images.h"

#include <gmock/gmock.h>

#include <fstream>

#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FilesInAFolder : public testing::Test {
 protected:
  void put(const std::string& name) const { std::ofstream(folder.path / name) << "x"; }
  /// "12: cam1_0012.png b.png", an instant each; "-" where one is missing.
  std::vector<std::string> found(const std::vector<std::string>& cameras) {
    refusals.clear();
    std::vector<std::string> lines;
    const std::vector<std::filesystem::path> folders(cameras.size(), folder.path);
    for (const InstantImages& instant : find_camera_folders(cameras, folders, is_old, refusals)) {
      lines.push_back(std::to_string(instant.number) + ":");
      for (const auto& file : instant.files) lines.back() += " " + (file.empty() ? "-" : file.filename().string());
    }
    return lines;
  }
  TemporaryFolder folder;
  IsOldImage is_old = [](std::size_t, const std::filesystem::path&) { return false; };
  std::vector<Message> refusals;
};

TEST_F(FilesInAFolder, ACamerasNameMayEndInANumberAndBePartOfAnothers) {
  for (const char* name : {"0007_cam12.png", "cam1_0007.png", "Cam1 8.png", "notes.txt", ".0009_cam1.png"}) put(name);
  EXPECT_THAT(found({"cam1", "cam12"}), ElementsAre("7: cam1_0007.png 0007_cam12.png", "8: Cam1 8.png -"));
  EXPECT_THAT(refusals, IsEmpty());
}

TEST_F(FilesInAFolder, ANameOfDigitsIsNoPartOfALongerNumber) {
  for (const char* name : {"0017_1.png", "2_0017.png"}) put(name);
  EXPECT_THAT(found({"1", "2"}), ElementsAre("17: 0017_1.png 2_0017.png"));
}

TEST_F(FilesInAFolder, OfTwoCamerasTheSideWillDo) {
  for (const char* name : {"l0001.png", "r0001.png", "upright_left_2.png"}) put(name);
  EXPECT_THAT(found({"left", "right"}), ElementsAre("1: l0001.png r0001.png", "2: upright_left_2.png -"));
}

TEST_F(FilesInAFolder, ANumberThatIsThereTwiceIsToldAndLeavesOutNoOther) {
  for (const char* name : {"a_1.png", "b_01.png", "a_2.png"}) put(name);
  EXPECT_THAT(found({"camera"}), ElementsAre("2: a_2.png"));
  EXPECT_THAT(refusals, ElementsAre(HasSubstr("have the same number")));
}

TEST_F(FilesInAFolder, AnOldFileGivesWayToANewOneOfItsNumber) {
  for (const char* name : {"a_1.png", "b_1.png", "c_1.png", "a_2.png", "b_2.png"}) put(name);
  is_old = [](std::size_t, const std::filesystem::path& file) { return file.filename().string()[0] != 'b'; };
  EXPECT_THAT(found({"camera"}), ElementsAre("1: b_1.png", "2: b_2.png"));
  EXPECT_THAT(refusals, IsEmpty());
}

TEST_F(FilesInAFolder, WhereThereIsNothingThatIsTold) {
  EXPECT_THAT(found({"left", "right"}), IsEmpty());
  EXPECT_THAT(refusals, ElementsAre(HasSubstr("no left images"), HasSubstr("no right images")));
  std::filesystem::remove(folder.path);
  EXPECT_THAT(found({"left", "right"}), IsEmpty());
  EXPECT_THAT(refusals, ElementsAre(HasSubstr("cannot be read")));
}

}  // namespace
}  // namespace handsight
