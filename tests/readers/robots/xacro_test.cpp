// SPDX-License-Identifier: Apache-2.0
// xacro: expanded where the program is installed.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "readers/robots/program_output.h"
#include "readers/robots/robot_file.h"
#include "session/session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// PATH as a test wants it.
class Path {
 public:
  explicit Path(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

class Xacro : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text, bool runs = false) {
    std::ofstream(folder_.path / name) << text;
    if (runs) std::filesystem::permissions(folder_.path / name, std::filesystem::perms::owner_all);
    return folder_.path / name;
  }
  const std::string robot_ =
      "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><xacro:property name=\"n\" value=\"2\"/>"
      "<link name=\"l${n}\"/></robot>";
  TemporaryFolder folder_;
};

TEST_F(Xacro, WhereTheProgramIsThereItIsAsked) {
  write("xacro", "#!/bin/sh\nsed -e 's/<xacro:property[^>]*>//' -e 's/${n}/2/' \"$1\"\n", true);
  const Path path(folder_.path.string() + ":/usr/bin:/bin");
  const FieldUrdf field = robot_of_file(write("arm.urdf.xacro", robot_));
  EXPECT_EQ(link_names(field.robot), std::vector<std::string>{"l2"});
  EXPECT_THAT(field.notes, Contains(HasSubstr("was expanded by xacro")));
}

TEST_F(Xacro, WhereItFailsItsReasonIsTold) {
  write("xacro", "#!/bin/sh\necho long story >&2\necho \"No such argument: prefix\" >&2\nexit 2\n", true);
  const Path path(folder_.path.string() + ":/usr/bin:/bin");
  const std::string sentence = find_refusal([&] { robot_of_file(write("arm.urdf.xacro", robot_)); });
  EXPECT_THAT(sentence, HasSubstr("No such argument: prefix"));
  EXPECT_THAT(sentence, HasSubstr("NAME:=VALUE"));
}

TEST_F(Xacro, WhereItIsNotThereTheCommandIsTold) {
  const Path path(folder_.path.string());
  EXPECT_THAT(find_refusal([&] { robot_of_file(write("arm.urdf.xacro", robot_)); }),
              HasSubstr("`xacro arm.urdf.xacro >"));
}

TEST_F(Xacro, AProgramThatDoesNotEndIsEnded) {
  const auto output = run_for_output({"/bin/sh", "-c", "echo begun; echo odd >&2; exec sleep 30"}, 1);
  ASSERT_TRUE(output);
  EXPECT_EQ(output->out, "begun\n");
  EXPECT_EQ(output->err, "odd\n");
  EXPECT_EQ(output->status, 128 + 9);
}

}  // namespace
}  // namespace handsight
