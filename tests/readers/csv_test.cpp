// SPDX-License-Identifier: Apache-2.0
#include "readers/csv.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "session/session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> joints{"j1", "j2"};

std::string refusal(const std::string& text) {
  return find_refusal([&] { parse_poses(text, "poses.csv", joints); });
}

TEST(Csv, EverySeparator) {
  for (const char* text : {"1,2\n3,4\n", "1;2\n3;4", "1 2\n3\t4", " 1 , 2 \r\n3,4\r\n",
                           "\xEF\xBB\xBF"
                           "1,2\n\n3,4\n",
                           "# a remark\n1,2 # the first\n3,4,\n"}) {
    const auto poses = parse_poses(text, "poses.csv", joints);
    ASSERT_EQ(poses.size(), 2u) << text;
    EXPECT_THAT(poses[0], ElementsAre(1, 2)) << text;
    EXPECT_THAT(poses[1], ElementsAre(3, 4)) << text;
  }
}

TEST(Csv, HeadersGiveTheOrder) {
  std::vector<Message> notes;
  const auto poses = parse_poses("time, \"j2\", j1\n0.1, 2, 1\n", "poses.csv", joints, &notes);
  EXPECT_THAT(poses.at(0), ElementsAre(1, 2));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("1 columns are no joints")));
  notes.clear();
  EXPECT_THAT(parse_poses("j1 j2\n1 2", "poses.csv", joints, &notes).at(0), ElementsAre(1, 2));
  EXPECT_THAT(notes, IsEmpty());
}

TEST(Csv, BadLinesAreRefusedWithTheirNumber) {
  EXPECT_EQ(refusal("1,2\n\n1,2,3\n"), "poses.csv, line 3: the line has 3 columns, expected 2.");
  EXPECT_EQ(refusal("1,2\n1,x\n"),
            "poses.csv, line 2: \"x\" stands in column 2, expected a finite number such as 0.5.");
  EXPECT_THAT(refusal("1,nan"), HasSubstr("\"nan\""));
  EXPECT_THAT(refusal("1;2\n0,5;2"), HasSubstr("line 2: \"0,5\""));
  EXPECT_THAT(refusal("1,,2"), HasSubstr("3 columns"));
  EXPECT_THAT(refusal("1,\n"), HasSubstr("1 columns"));
  EXPECT_THAT(refusal("j1,other\n1,2"), HasSubstr("line 1: the header has no column \"j2\""));
  EXPECT_THAT(refusal("j1,j2,j1\n1,2,3"), HasSubstr("names \"j1\" twice"));
  EXPECT_THAT(refusal(""), HasSubstr("no pose"));
  EXPECT_THAT(refusal("j1,j2\n# nothing\n"), HasSubstr("no pose"));
  EXPECT_THAT(refusal("1," + std::string(100000, 'x')), HasSubstr("..."));
}

TEST(Csv, FilesAreRead) {
  const TemporaryFolder temporary;
  replace_file(temporary.path / "poses.csv", "1,2");
  EXPECT_EQ(read_poses(temporary.path / "poses.csv", joints).size(), 1u);
  EXPECT_THAT(find_refusal([&] { read_poses(temporary.path / "none.csv", joints); }), HasSubstr("cannot be opened"));
}

TEST(Csv, TimesAndVelocitiesAreReadWhereTheyHaveColumns) {
  const std::vector<std::string> names = {"a", "b"};
  std::vector<Message> notes;
  const PoseTable table =
      parse_pose_table("time,b,velocity_b,a,force\n1,0.2,-0.1,0.1,7\n2,0.4,0,0.3,8\n", "p.csv", names, &notes);
  ASSERT_EQ(table.positions.size(), 2u);
  EXPECT_THAT(table.positions[1], ElementsAre(0.3, 0.4));
  ASSERT_EQ(table.velocities.size(), 2u);
  EXPECT_THAT(table.velocities[0], ElementsAre(0, -0.1));
  EXPECT_THAT(table.times, ElementsAre(1, 2));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("1 columns are no joints")));
  const PoseTable plain = parse_pose_table("a,b\n1,2\n", "p.csv", names);
  EXPECT_TRUE(plain.velocities.empty() && plain.times.empty());
  EXPECT_THAT(find_refusal([&] { parse_pose_table("a,b,time,time\n1,2,3,4\n", "p.csv", names); }), HasSubstr("twice"));
  EXPECT_THAT(find_refusal([&] { parse_pose_table("a,b\n1,1e160\n", "p.csv", names); }),
              HasSubstr("p.csv, line 2: \"1e160\" stands in column 2, expected a number from"));
}

TEST(Csv, ALineIsCutAsATableIs) {
  EXPECT_THAT(cells_of_line("\"elbow, left\",q2 # the second one"), ElementsAre("\"elbow, left\"", "q2"));
  EXPECT_THAT(cells_of_line("\"a;b\", c"), ElementsAre("\"a;b\"", "c"));
  EXPECT_THAT(cells_of_line(" 1.0,\t2.0,\r"), ElementsAre("1.0", "2.0", ""));
  EXPECT_THAT(cells_of_line("\t1.0\t2.0 3.0\r"), ElementsAre("1.0", "2.0", "3.0"));
  EXPECT_THAT(cells_of_line("1;;2"), ElementsAre("1", "", "2"));
  EXPECT_THAT(cells_of_line(" \t # nothing"), IsEmpty());
  const PoseTable named = parse_pose_table("\"elbow, left\",b\n1,2\n", "p.csv", {"b", "elbow, left"});
  EXPECT_THAT(named.positions.front(), ElementsAre(2, 1));
}

}  // namespace
}  // namespace handsight
