// SPDX-License-Identifier: Apache-2.0
// Points of robot programs, and folders that hold a recording whole.
#include "convert/program_points.h"

#include "convert/hand_eye_fixture.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double degrees = 57.295779513082323;

class Programs : public HandEyeTables {
 protected:
  std::string krl() const {
    std::string text = "&ACCESS RVP\r\nDEFDAT HANDEYE\r\n";
    int number = 0;
    for (const Rigid& p : flange) {
      const std::vector<double> xyz{1e3 * p.translation.x(), 1e3 * p.translation.y(), 1e3 * p.translation.z()},
          abc = euler(p, 2, 1, 0, degrees);
      text += fmt::format(
          "DECL E6POS XP{}={{X {:.6f},Y {:.6f},Z {:.6f},A {:.6f},B {:.6f},C {:.6f},S 2,T 35,E1 0.0}}\r\n"
          "DECL FDAT FP{}={{TOOL_NO 0,BASE_NO 0}}\r\n",
          ++number, xyz[0], xyz[1], xyz[2], abc[0], abc[1], abc[2], number);
    }
    return text + "ENDDAT\r\n";
  }
  std::string rapid() const {
    std::string text = "MODULE HandEye\n";
    for (const Rigid& p : flange)
      text += fmt::format("  CONST robtarget p{}:=[[{}],[{}],[0,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]];\n",
                          p.translation.x() > 0, place(p, 1e3, ","), joined(quaternion(p, true), ","));
    return text + "  PROC main()\n    MoveJ p1,v200,fine,tool0;\n  ENDPROC\nENDMODULE\n";
  }
  std::string tp() const {
    std::string text = "/PROG HANDEYE\n/MN\n   1:J P[1] 20% FINE ;\n/POS\n";
    for (const Rigid& p : flange) {
      const std::vector<double> wpr = fixed_xyz(p, degrees);
      text += fmt::format(
          "P[1]{{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n\tX = {:9.4f}  mm,\tY = {:9.4f}  mm,\tZ = "
          "{:9.4f}  mm,\n\tW = {:9.5f} deg,\tP = {:9.5f} deg,\tR = {:9.5f} deg\n}};\n",
          1e3 * p.translation.x(), 1e3 * p.translation.y(), 1e3 * p.translation.z(), wpr[0], wpr[1], wpr[2]);
    }
    return text + "/END\n";
  }
};

TEST_F(Programs, PointsOfThreeMakersAreTheFlange) {
  const auto seen = write("target.csv", quaternions(target));
  for (const auto& [name, text] : {std::pair{"handeye.dat", krl()}, {"handeye.mod", rapid()}, {"handeye.ls", tp()}}) {
    const Conversion c = converted({write(name, text), seen});
    expect_right(c.session, name);
    EXPECT_THAT(c.notes, Contains(HasSubstr("16 points of a program in"))) << name;
  }
}

TEST_F(Programs, WhatDeclaresNoPointIsNone) {
  EXPECT_FALSE(program_points("DEFDAT X\nDECL E6AXIS XH={A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\nENDDAT\n", "x.dat"));
  EXPECT_FALSE(program_points("VAR robtarget p1;\nPERS robtarget p2:=[[1,2,3],[9,9,9,9],[0,0,0,0]];\n", "x.mod"));
  EXPECT_FALSE(program_points("x,y,z,qx,qy,qz,qw\n1,2,3,0,0,0,1\n", "x.csv"));
  EXPECT_FALSE(program_points("robtarget p:=[[1,2,", "x.mod"));
}

/// A folder with a recording stands for its files; what is nothing that is read is left out and named.
TEST_F(Programs, AFolderStandsForItsFiles) {
  write("recording/flange.csv", quaternions(flange));
  write("recording/target.csv", quaternions(target));
  write("recording/README.txt", "Recorded in March, robot 3.\n");
  write("recording/run.py", "import handeye\n");
  write("recording/.hidden", "x\n");
  const Conversion c = converted({folder.path / "recording"});
  expect_right(c.session, "recording");
  EXPECT_THAT(c.notes, Contains("Left out, as nothing that is read: README.txt, run.py."));
  // What was named is not passed over.
  EXPECT_THAT(refusal({folder.path / "recording", write("notes.txt", "Recorded in April.\n")}),
              StartsWith(shown_path(folder.path / "notes.txt")));
  fs::create_directories(folder.path / "empty");
  EXPECT_THAT(refusal({folder.path / "empty"}), HasSubstr("is a folder without images"));
}

/// solvePnP's names say which table is the target's.
TEST_F(Programs, ColumnsOfSolvePnpAreTheTargets) {
  std::string seen = "tvec_x,tvec_y,tvec_z,rvec_x,rvec_y,rvec_z\n";
  for (const Rigid& p : target) {
    const Vector3 turn = vector_from_rotation(p.rotation);
    seen += place(p, 1, ",") + "," + joined({turn.x(), turn.y(), turn.z()}, ",") + "\n";
  }
  expect_right(converted({write("a.csv", quaternions(flange)), write("b.csv", seen)}).session, "rvec");
  EXPECT_THAT(refusal({write("a.csv", quaternions(flange)), write("b.csv", quaternions(target))}),
              StartsWith("a.csv and b.csv are both tables of poses"));
}

}  // namespace
}  // namespace handsight
