// SPDX-License-Identifier: Apache-2.0
// Tables in the manner of recordings that were found in public repositories: rows of two things in one table, tabs and
// blanks mixed, results below the rows, turns before places, rows that do not go with the others.
#include "convert/hand_eye_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

class StrangerTables : public HandEyeTables {
 protected:
  static std::string xyz_rpy(const Rigid& p) { return place(p, 1, ", ") + ", " + joined(fixed_xyz(p, degrees), ", "); }
  static std::string row(const std::vector<double>& first, const std::vector<double>& second) {
    return joined(first, ",") + "," + joined(second, ",") + "\n";
  }
  static std::vector<double> xyz(const Rigid& p) { return {p.translation.x(), p.translation.y(), p.translation.z()}; }
  std::string hand_and_eye() const {
    std::string text;
    for (std::size_t i = 0; i < flange.size(); ++i)
      text += "hand," + xyz_rpy(flange[i]) + "\neye," + xyz_rpy(target[i]) + "\n";
    return text;
  }
};

TEST_F(StrangerTables, AWordSaysWhoseRowItIs) {
  const Conversion c = converted({write("calibration.csv", hand_and_eye())});
  expect_right(c.session, "without a header");
  EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("\"hand\""), HasSubstr("flange"), HasSubstr("\"eye\""))));
  expect_right(converted({write("named.csv", "what,x,y,z,roll[deg],pitch[deg],yaw[deg]\n" + hand_and_eye())}).session,
               "with one");
}

TEST_F(StrangerTables, NamesOfPointsAreStillNoTables) {
  std::string text;
  for (std::size_t i = 0; i < flange.size(); ++i) text += fmt::format("P{},", i) + xyz_rpy(flange[i]) + "\n";
  EXPECT_THAT(refusal({write("flange.csv", text)}), HasSubstr("the only poses"));
}

TEST_F(StrangerTables, ResultsBelowTheRowsAreLeftOut) {
  const std::string result = "\n[[-0.007 -0.99 -0.005 -0.024]\n [ 0.999 -0.007 -0.005  0.012]\n [ 0. 0. 0. 1.]]\n";
  const Conversion c = converted({write("calibration.csv", hand_and_eye() + result)});
  expect_right(c.session, "with a result below");
  EXPECT_THAT(c.notes, Contains(HasSubstr("behind an empty line")));
  // What is as wide as the table is a row of it that is not whole.
  const std::string broken = quaternions(flange) + "\n1,2,3\n";
  EXPECT_THAT(refusal({write("flange.csv", broken), write("target.csv", quaternions(target))}),
              HasSubstr("3 columns, expected 7"));
}

TEST_F(StrangerTables, TabsAndBlanksMayBeMixed) {
  std::string text;
  for (std::size_t i = 0; i < flange.size(); ++i)
    text += place(flange[i], 1, "\t") + (i % 3 == 1 ? " " : "\t") + joined(quaternion(flange[i], false), "\t") + "\n";
  expect_right(converted({write("flange.txt", text), write("target.csv", quaternions(target))}).session, "mixed");
}

TEST_F(StrangerTables, PairsOfMatricesUnderAKeyOfTheirOwn) {
  const auto nested = [](const Rigid& p) {
    const std::vector<double> m = matrix(p);
    std::string text;
    for (std::size_t r = 0; r < 4; ++r)
      text += fmt::format("{}[{:.9g}, {:.9g}, {:.9g}, {:.9g}]", r ? ", " : "", m[4 * r], m[4 * r + 1], m[4 * r + 2],
                          m[4 * r + 3]);
    return "[" + text + "]";
  };
  std::string pairs, joints;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    pairs += (i ? ", [" : "[") + nested(flange[i]) + ", " + nested(target[i]) + "]";
    joints += i ? ", [1, 2, 3, 4, 5, 6]" : "[1, 2, 3, 4, 5, 6]";
  }
  const std::string text = "{\"Title\": \"a log\", \"Result\": " + nested(mount) + ", \"Joint Dataset\": [" + joints +
                           "], \"Transform Dataset\": [" + pairs + "]}";
  expect_right(converted({write("log.json", text)}).session, "a log");
}

TEST_F(StrangerTables, TurnsMayStandBeforePlaces) {
  std::string robot, camera;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    robot += fmt::format("{},", i) + row(vector(flange[i]), xyz(flange[i]));
    camera += fmt::format("{},", i) + row(vector(target[i]), xyz(target[i]));
  }
  const Conversion c = converted({write("gripper2base.csv", robot), write("target2cam.csv", camera)});
  expect_right(c.session, "turns first");
  EXPECT_THAT(c.notes, Contains(HasSubstr("the three columns before the last three are read as rotation vectors")));
}

TEST_F(StrangerTables, RowsThatDoNotGoWithTheOthersAreSaid) {
  const Rigid other{rotation_from_rpy({0.4, 0.9, -0.2}), {0.1, 0.02, 0.15}};  // the tracker takes the body for turned
  for (std::size_t i = 5; i < 12; ++i)
    flange[i] = flange[i] * Rigid{rotation_from_rpy({0.1 * double(i), 0, 0}), Vector3::Zero()} * other;
  std::string robot, camera;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    robot += row(vector(flange[i]), xyz(flange[i]));
    camera += row(vector(target[i]), xyz(target[i]));
  }
  const Conversion c = converted({write("gripper2base.csv", robot), write("target2cam.csv", camera)});
  EXPECT_THAT(c.notes,
              Contains(AllOf(HasSubstr("9 of 16 rows go together"), HasSubstr("observations 5, 6, 7, 8, 9, 10, 11"))));
}

}  // namespace
}  // namespace handsight
