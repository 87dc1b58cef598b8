// SPDX-License-Identifier: Apache-2.0
#include "session/collection.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

class CollectionFile : public ::testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    replace_file(file(), text);
    try {
      read_collection(file());
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
  std::filesystem::path file() const { return folder_.path / "cell" / "collection.xml"; }
  void SetUp() override { std::filesystem::create_directories(file().parent_path()); }

  TemporaryFolder folder_;
};

TEST_F(CollectionFile, SaysWhatIsSharedAndWhatIsOwn) {
  replace_file(file(), R"(<handsight_collection version="1" title="Both hands">
  <session folder="right_june" rig="head" body="right_hand"/>
  <session folder="../left" rig="head" title="left hand" own="joint_offset:arm_3 joint_scale"/>
</handsight_collection>)");
  const Collection c = read_collection(file().parent_path());
  EXPECT_EQ(c.title, "Both hands");
  ASSERT_EQ(c.entries.size(), 2U);
  EXPECT_EQ(c.entries[0].title, "right_june");
  EXPECT_EQ(c.entries[0].body, "right_hand");
  EXPECT_EQ(c.entries[1].title, "left hand");
  EXPECT_EQ(c.entries[1].own, (std::vector<std::string>{"joint_offset:arm_3", "joint_scale"}));
  EXPECT_EQ(find_folder(c, c.entries[1]), folder_.path / "left");
  replace_file(file(), collection_text(c));
  EXPECT_EQ(collection_text(read_collection(file())), collection_text(c));
}

TEST_F(CollectionFile, IsToldFromASession) {
  EXPECT_FALSE(is_collection(file().parent_path()));
  replace_file(file(), "<handsight_collection version=\"1\"><session folder=\"a\"/></handsight_collection>");
  EXPECT_TRUE(is_collection(file().parent_path()));
  EXPECT_TRUE(is_collection(file()));
  replace_file(file().parent_path() / "session.xml", "<handsight_session version=\"1\"/>");
  EXPECT_FALSE(is_collection(file().parent_path())) << "a folder with a session is that session";
}

TEST_F(CollectionFile, SaysWhatIsWrongWithIt) {
  const auto file_with = [](const std::string& inside) {
    return "<handsight_collection version=\"1\">" + inside + "</handsight_collection>";
  };
  EXPECT_NE(refusal(file_with("")).find("has no <session>"), std::string::npos);
  EXPECT_NE(refusal(file_with("<session folder=\"/etc\"/>")).find("inside the collection's folder or beside it"),
            std::string::npos);
  EXPECT_NE(refusal(file_with("<session folder=\"../../x\"/>")).find("inside the collection's folder or beside it"),
            std::string::npos);
  EXPECT_NE(refusal(file_with("<session folder=\"a\"/><session folder=\"b/a\"/>")).find("second session called \"a\""),
            std::string::npos);
}

}  // namespace
}  // namespace handsight
