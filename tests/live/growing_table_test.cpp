// SPDX-License-Identifier: Apache-2.0
// Lines of a table as they come to their end, each once, and all again where the writer begins again.
#include "live/growing_table.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Lines = std::vector<GrowingTable::Cells>;

class ATableThatGrows : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
  void append(const std::string& text) const { std::ofstream(file, std::ios::binary | std::ios::app) << text; }
  /// A clock that is too coarse to tell two writings apart is no part of what is tested.
  void rewrite(const std::string& text) const {
    const auto before = std::filesystem::last_write_time(file);
    write(text);
    std::filesystem::last_write_time(file, before + std::chrono::seconds(1));
  }
  TemporaryFolder folder;
  std::filesystem::path file = folder.path / "table.csv";
  GrowingTable table{file, {"a", "b"}};
};

TEST_F(ATableThatGrows, ALineComesOnceItHasComeToItsEnd) {
  EXPECT_FALSE(table.is_there());
  EXPECT_THAT(table.read().lines, IsEmpty());
  write("b,a\n1,2\n3");
  EXPECT_EQ(table.read().lines, (Lines{{"1", "2"}}));
  EXPECT_THAT(table.read().lines, IsEmpty());
  append("3,4\n");
  const GrowingTable::News news = table.read();
  EXPECT_FALSE(news.is_anew);
  ASSERT_EQ(news.lines, (Lines{{"33", "4"}}));
  EXPECT_EQ(table.cell(news.lines[0], "a"), "4");
  EXPECT_EQ(table.cell(news.lines[0], "c"), "");
}

TEST_F(ATableThatGrows, WhoeverBeginsAgainIsReadAnew) {
  write("a,b\n1,2\n3,4\n");
  table.read();
  for (const char* text : {"a,b\n5,6\n", "a,b\n7,8\n", "a,b\n9,10\n11,12\n"}) {  // shorter, as long, longer
    rewrite(text);
    const GrowingTable::News news = table.read();
    EXPECT_TRUE(news.is_anew) << text;
    EXPECT_EQ(news.lines.size(), text[4] == '9' ? 2U : 1U) << text;
  }
}

TEST_F(ATableThatGrows, ALineOfAnotherLengthKeepsItsPlaceAndIsSaid) {
  write("a,b\n1,2,3\n4,5\n");
  EXPECT_EQ(table.read().lines, (Lines{{}, {"4", "5"}}));
  EXPECT_THAT(table.newly_set_aside(), ElementsAre(HasSubstr("3 columns")));
  EXPECT_THAT(table.newly_set_aside(), IsEmpty()) << "once";
  EXPECT_THAT(table.all_set_aside(), ElementsAre(HasSubstr("3 columns"))) << "as long as it is so";
  rewrite("a,b\n1,2\n4,5\n");
  table.read();
  EXPECT_THAT(table.all_set_aside(), IsEmpty());
}

TEST_F(ATableThatGrows, IsWrittenAsManyProgramsDo) {
  for (const char* text :
       {"\xEF\xBB\xBF\"a\";\"b\"\r\n1; 2\r\n", "# a remark\na,b,\n\n1,2,\n", "1 2\n", "a,b\n1,2,\n"}) {
    GrowingTable other(file, {"a", "b"});
    write(text);
    EXPECT_EQ(other.read().lines, (Lines{{"1", "2"}})) << text;
    EXPECT_TRUE(other.has("a")) << text;
  }
  write("a,b,c\n1,,\n");  // what was not seen
  GrowingTable points(file, {});
  EXPECT_EQ(points.read().lines, (Lines{{"1", "", ""}}));
}

TEST_F(ATableThatGrows, APipeIsSaidAndNotWaitedAt) {
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_THAT(table.read().lines, IsEmpty());
  EXPECT_THAT(table.newly_set_aside(), ElementsAre(HasSubstr("pipe")));
  std::filesystem::remove(file);
  write("a,b\n1,2\n");
  EXPECT_EQ(table.read().lines, (Lines{{"1", "2"}}));
  EXPECT_THAT(table.all_set_aside(), IsEmpty());
}

}  // namespace
}  // namespace handsight
