// SPDX-License-Identifier: Apache-2.0
// Poses in lists, folders and single tables, and which of them belong together.
#include "convert/hand_eye_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// Rows of a table: what stands before each pose.
std::string rows(const std::string& header, const std::vector<std::string>& before,
                 const std::vector<std::string>& poses) {
  std::string text = header + "\n";
  for (std::size_t i = 0; i < poses.size(); ++i) text += before[i] + poses[i] + "\n";
  return text;
}

class PoseLists : public HandEyeTables {
 protected:
  static std::string cells(const Rigid& p) { return place(p, 1, ",") + "," + joined(quaternion(p, false), ","); }
  static std::vector<std::string> cells(const std::vector<Rigid>& poses) {
    std::vector<std::string> all;
    for (const Rigid& p : poses) all.push_back(cells(p));
    return all;
  }
};

TEST_F(PoseLists, MoveItsSamplesInYamlAndJson) {
  std::string yaml, json = "[";
  const auto item = [](const Rigid& p) {
    std::string text;
    for (const double n : matrix(p)) text += fmt::format("  - {:.9g}\n", n);
    return text;
  };
  const auto nested = [](const Rigid& p) {
    const std::vector<double> m = matrix(p);
    std::string text = "[";
    for (int r = 0; r < 4; ++r)
      text += fmt::format("{}[{:.9g}, {:.9g}, {:.9g}, {:.9g}]", r ? ", " : "", m[static_cast<std::size_t>(4 * r)],
                          m[static_cast<std::size_t>(4 * r + 1)], m[static_cast<std::size_t>(4 * r + 2)],
                          m[static_cast<std::size_t>(4 * r + 3)]);
    return text + "]";
  };
  for (std::size_t i = 0; i < flange.size(); ++i) {
    yaml += "- effector_wrt_world:\n" + item(flange[i]) + "  object_wrt_sensor:\n" + item(target[i]);
    json += (i ? ", [" : "[") + nested(flange[i]) + ", " + nested(target[i]) + "]";
  }
  expect_right(converted({write("samples.yaml", yaml)}).session, "YAML");
  expect_right(converted({write("pairs.json", json + "]")}).session, "JSON");
}

/// Each message of the detector holds the one target; of two nobody could say which is meant.
TEST_F(PoseLists, ArraysOfOnePoseEach) {
  const auto echoed = [](const std::vector<Rigid>& poses, int of_each) {
    std::string text;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Eigen::Quaterniond q(poses[i].rotation);
      const Vector3& t = poses[i].translation;
      text += fmt::format("header:\n  stamp:\n    sec: {}\n    nanosec: 0\n  frame_id: camera\nposes:\n", i);
      for (int k = 0; k < of_each; ++k)
        text += fmt::format(
            "- position:\n    x: {}\n    y: {}\n    z: {}\n  orientation:\n    x: {}\n    y: {}\n    z: {}\n    w: "
            "{}\n",
            t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
      text += "---\n";
    }
    return text;
  };
  const auto hand = write("flange.yaml", echoed(flange, 1));
  options.target_frame = "seen.yaml";
  expect_right(converted({hand, write("seen.yaml", echoed(target, 1))}).session, "PoseArray");
  EXPECT_THAT(refusal({hand, write("seen.yaml", echoed(target, 2))}), HasSubstr("--field poses[0]"));
}

TEST_F(PoseLists, BothPosesInOneTable) {
  std::string named =
                  "time,tool_x,tool_y,tool_z,tool_qx,tool_qy,tool_qz,tool_qw,tag_x,tag_y,tag_z,tag_qx,tag_qy,tag_qz,"
                  "tag_qw\n",
              twice = "x,y,z,qx,qy,qz,qw,x,y,z,qx,qy,qz,qw\n", unnamed;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    named += fmt::format("{},", i) + cells(flange[i]) + "," + cells(target[i]) + "\n";
    twice += cells(flange[i]) + "," + cells(target[i]) + "\n";
    unnamed += joined(matrix(flange[i]), " ") + " " + joined(matrix(target[i]), " ") + "\n";
  }
  expect_right(converted({write("both.csv", named)}).session, "named");
  expect_right(converted({write("both.csv", twice)}).session, "the same names twice");
  twice.replace(0, 17, "X,Y,Z,QX,QY,QZ,QW");
  expect_right(converted({write("both.csv", twice)}).session, "the same names, once in capitals");
  expect_right(converted({write("both.txt", unnamed)}).session, "matrices side by side");
}

TEST_F(PoseLists, AFileForEachPose) {
  std::string storage = "%YAML:1.0\n---\n";
  for (std::size_t i = 0; i < flange.size(); ++i) {
    std::string rows_of_four;
    const std::vector<double> m = matrix(flange[i], 1000);
    for (std::size_t r = 0; r < 4; ++r)
      rows_of_four += joined({m[4 * r], m[4 * r + 1], m[4 * r + 2], m[4 * r + 3]}, " ") + "\n";
    write(fmt::format("robot/pose_{}.txt", i), rows_of_four);
    for (const auto& [of, p] : {std::pair("fPe", flange[i]), std::pair("cPo", target[i])}) {
      std::string text = "rows: 6\ncols: 1\ndata: \n";
      std::vector<double> six = vector(p);
      six.insert(six.begin(), p.translation.data(), p.translation.data() + 3);
      for (const double n : six) text += fmt::format("  - [{:.9g}]\n", n);
      write(fmt::format("visp/pose_{}_{}.yaml", of, i + 1), text);
    }
    for (const auto& [of, p] : {std::pair("gripper2base", flange[i]), std::pair("target2cam", target[i])})
      storage += fmt::format("{}{:02d}: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ {} ]\n", of, i,
                             joined(matrix(p), ", "));
  }
  expect_right(converted({folder.path / "visp"}).session, "ViSP");
  expect_right(converted({write("poses.yml", storage)}).session, "OpenCV");
  std::string numbered = "number,x,y,z,qx,qy,qz,qw\n";
  for (std::size_t i = target.size(); i-- > 0;) numbered += fmt::format("{},", i) + cells(target[i]) + "\n";
  const Conversion c = converted({folder.path / "robot", write("target.csv", numbered)});
  expect_right(c.session, "a folder of matrices in mm beside a numbered table");
  EXPECT_THAT(c.notes, Contains(HasSubstr("paired by their numbers")));
}

/// As programs with OpenCV keep what a robot shows and what solvePnP finds: a rotation vector and a place each.
TEST_F(PoseLists, StoragesOfVectors) {
  std::string robot = "%YAML:1.0\n---\ndistance_unit: mm\n", turns, places;
  const auto matrix_of = [](const Vector3& v) {
    return fmt::format(
        "   - !!opencv-matrix\n      rows: 3\n      cols: 1\n      dt: d\n      data: [ {:.9g},\n          {:.9g}, "
        "{:.9g} ]\n",
        v.x(), v.y(), v.z());
  };
  for (std::size_t i = 0; i < flange.size(); ++i) {
    const Vector3 mm = 1000 * flange[i].translation;
    robot += fmt::format("pose{}: [ {:.9g}, {:.9g}, {:.9g},\n    {} ]\n", i + 1, mm.x(), mm.y(), mm.z(),
                         joined(vector(flange[i]), ", "));
    turns += matrix_of(vector_from_rotation(target[i].rotation));
    places += matrix_of(1000 * target[i].translation);
  }
  const std::string board =
      "%YAML:1.0\n---\nWhen: \"Tue May 10\"\nRotation_Vec:\n" + turns + "Translation_Vec:\n" + places;
  expect_right(converted({write("robot_poses.yaml", robot), write("board_pose.yml", board)}).session, "vectors");
  const std::string camera =
      board + "M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 900, 0, 640, 0, 900, 360, 0, 0, 1 ]\n";
  EXPECT_THAT(refusal({write("camera.yml", camera)}), HasSubstr("There is no robot"))
      << "a camera and where it saw the board";
}

TEST_F(PoseLists, RowsArePairedByWhatBothHave) {
  std::vector<std::string> numbers, names, times, late;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    numbers.push_back(fmt::format("{},", i + 1));
    names.push_back(fmt::format("images/IMG_{:02d}.png,", i + 1));
    times.push_back(fmt::format("{},", 10.0 * static_cast<double>(i)));
    late.push_back(fmt::format("{},", 10.0 * static_cast<double>(i) + 0.03));
  }
  const std::string pose = "x,y,z,qx,qy,qz,qw";
  auto seen = cells(target);
  const auto without_two = [](std::vector<std::string> list) {
    list.erase(list.begin() + 9);
    list.erase(list.begin() + 4);
    std::reverse(list.begin(), list.end());
    return list;
  };
  for (const auto& [column, of_flange, of_target] :
       {std::tuple("number", numbers, numbers), std::tuple("image", names, names), std::tuple("time", times, late)}) {
    const Conversion c = converted(
        {write("flange.csv", rows(std::string(column) + "," + pose, of_flange, cells(flange))),
         write("target.csv", rows(std::string(column) + "," + pose, without_two(of_target), without_two(seen)))});
    expect_right(c.session, column, 14);
    EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("paired by"), HasSubstr("14 of 16"))));
  }
  seen.pop_back();
  EXPECT_THAT(refusal({write("flange.csv", quaternions(flange)),
                       write("target.csv", rows(pose, std::vector<std::string>(15), seen))}),
              HasSubstr("number, image or time"));
}

TEST_F(PoseLists, MissingAndRepeatedRowsAreNoMeasurements) {
  auto of_flange = cells(flange), seen = cells(target);
  seen[3] = "nan,nan,nan,nan,nan,nan,nan";
  seen[7] = ",,,,,,";
  of_flange.push_back(of_flange[10]);
  seen.push_back(seen[10]);
  const std::vector<std::string> nothing(17);
  const Conversion c = converted({write("flange.csv", rows("x,y,z,qx,qy,qz,qw", nothing, of_flange)),
                                  write("target.csv", rows("x,y,z,qx,qy,qz,qw", nothing, seen))});
  expect_right(c.session, "14 are left", 14);
  EXPECT_THAT(c.notes, Contains(HasSubstr("2 of 17 rows hold no whole pose")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("1 rows repeat")));
}

TEST_F(PoseLists, APoseThatStoodStillWhileTheOtherMovedIsSaid) {
  flange[6] = flange[5];
  const Conversion c = converted({write("flange.csv", quaternions(flange)), write("target.csv", quaternions(target))});
  EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("pose of the flange is the same"), HasSubstr("5 and 6"))));
  std::vector<Rigid> seen = target;
  seen[9] = seen[8];
  flange[6].translation.z() += 0.01;
  const Conversion other =
      converted({write("flange.csv", quaternions(flange)), write("target.csv", quaternions(seen))});
  EXPECT_THAT(other.notes, Contains(AllOf(HasSubstr("What was seen is the same"), HasSubstr("8 and 9"))));
}

}  // namespace
}  // namespace handsight
