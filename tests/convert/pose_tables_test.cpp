// SPDX-License-Identifier: Apache-2.0
// Tables of poses in the words of every maker: what their turns are is read, found out or asked, never guessed.
#include "convert/hand_eye_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

using Numbers = std::function<std::vector<double>(const Rigid&)>;

std::string table(const std::string& header, const std::vector<Rigid>& poses, const Numbers& turn, double unit = 1,
                  const char* between = ",") {
  std::string text = header.empty() ? "" : header + "\n";
  for (const Rigid& p : poses) {
    const Vector3 t = unit * p.translation;
    text += fmt::format("{1:.9g}{0}{2:.9g}{0}{3:.9g}", between, t.x(), t.y(), t.z());
    for (const double n : turn(p)) text += fmt::format("{}{:.9g}", between, n);
    text += "\n";
  }
  return text;
}

TEST_F(HandEyeTables, MakersAnglesAreReadByTheirColumns) {
  const auto seen = write("target.csv", quaternions(target));
  const auto abc = [](const Rigid& p) { return euler(p, 2, 1, 0, degrees); };
  const auto wpr = [](const Rigid& p) { return fixed_xyz(p, degrees); };
  const auto oat = [](const Rigid& p) { return euler(p, 2, 1, 2, degrees); };
  const auto staubli = [](const Rigid& p) { return euler(p, 0, 1, 2, degrees); };
  const auto abb = [](const Rigid& p) { return quaternion(p, true); };
  for (const auto& [name, text] : {std::pair("KUKA", table("X;Y;Z;A;B;C", flange, abc, 1000, ";")),
                                   {"Mitsubishi", table("X,Y,Z,A,B,C", flange, wpr, 1000)},
                                   {"Fanuc", table("X,Y,Z,W,P,R", flange, wpr, 1000)},
                                   {"Kawasaki", table("X,Y,Z,O,A,T", flange, oat, 1000)},
                                   {"Staubli", table("x,y,z,rx,ry,rz", flange, staubli, 1000)},
                                   {"ABB", table("x,y,z,q1,q2,q3,q4", flange, abb, 1000)},
                                   {"UR", table("x,y,z,rx,ry,rz", flange, vector)}})
    expect_right(converted({write("flange.csv", text), seen}).session, name);
  std::string rows, columns;
  for (const Rigid& p : flange) {
    rows += joined(matrix(p), " ") + "\n";
    const std::vector<double> m = matrix(p);
    columns +=
        joined({m[0], m[4], m[8], 0, m[1], m[5], m[9], 0, m[2], m[6], m[10], 0, m[3], m[7], m[11], 1}, ",") + "\n";
  }
  expect_right(converted({write("flange.csv", rows), seen}).session, "matrices row by row");
  expect_right(converted({write("flange.csv", columns), seen}).session, "matrices column by column");
}

TEST_F(HandEyeTables, TurnsOfWhichNothingIsSaidAreFoundByTheMotionsOfBoth) {
  const auto radians = [](const Rigid& p) { return fixed_xyz(p, 1); };
  const Conversion vectors = converted({write("flange.csv", table("X,Y,Z,RX,RY,RZ", flange, vector, 1000)),
                                        write("target.csv", table("X,Y,Z,RX,RY,RZ", target, vector, 1000))});
  expect_right(vectors.session, "vectors");
  EXPECT_THAT(vectors.notes, Contains(AllOf(HasSubstr("rotation vectors"), HasSubstr("agree to"))));
  const Conversion angles = converted({write("flange.csv", table("x,y,z,rx,ry,rz", flange, radians)),
                                       write("target.csv", table("x,y,z,rx,ry,rz", target, radians))});
  expect_right(angles.session, "angles");
  EXPECT_THAT(angles.notes, Contains(HasSubstr("roll, pitch, yaw")));
  const Conversion unnamed = converted(
      {write("flange.txt", table("", flange, vector, 1, " ")), write("target.txt", table("", target, vector, 1, " "))});
  expect_right(unnamed.session, "without headers");
  const auto w_first = [](const Rigid& p) { return quaternion(p, true); };
  expect_right(
      converted({write("flange.txt", table("", flange, w_first, 1, " ")), write("target.csv", quaternions(target))})
          .session,
      "w first without a header");
  std::string script;
  for (const Rigid& p : flange) script += "p[" + place(p, 1, ", ") + ", " + joined(vector(p), ", ") + "]\n";
  expect_right(converted({write("flange.script", script), write("target.csv", quaternions(target))}).session, "script");
}

TEST_F(HandEyeTables, AnglesBeyondATurnAreDegrees) {
  const auto rpy = [](const Rigid& p) { return fixed_xyz(p, degrees); };
  const Conversion c = converted({write("flange.csv", table("x,y,z,roll,pitch,yaw", flange, rpy)),
                                  write("target.csv", table("x,y,z,roll,pitch,yaw", target, rpy))});
  expect_right(c.session, "degrees");
  EXPECT_THAT(c.notes, Contains(HasSubstr("can only be degrees")));
  const Conversion reported =
      converted({write("flange.csv", table("x,y,z,roll [deg],pitch [deg],yaw [deg]", flange, rpy)),
                 write("target.csv", quaternions(target))});
  expect_right(reported.session, "told in the header");
  EXPECT_THAT(reported.notes, Not(Contains(HasSubstr("can only be degrees"))));
}

TEST_F(HandEyeTables, DegreesAreForPosesToo) {
  std::vector<Rigid> slight, seen;  // within six degrees: the numbers could be rad
  for (const Rigid& p : flange) {
    slight.push_back({rotation_from_vector<double>(Vector3(0.02 * vector_from_rotation(p.rotation))), p.translation});
    seen.push_back(inverse(slight.back() * mount) * board);
  }
  const auto rpy = [](const Rigid& p) { return fixed_xyz(p, degrees); };
  options.degrees = true;
  options.angles = "rpy";
  const Conversion c =
      converted({write("flange.csv", table("x,y,z,rx,ry,rz", slight, rpy)), write("target.csv", quaternions(seen))});
  for (std::size_t i = 0; i < slight.size(); ++i)
    EXPECT_LT((base_from_flange(c.session.observations[i].position).rotation - slight[i].rotation).norm(), 1e-6);
}

TEST_F(HandEyeTables, WhereTwoReadingsServeItIsAsked) {
  std::vector<Rigid> spun, seen;  // a tool that only turns about its axis
  for (int i = 0; i < 12; ++i) {
    spun.push_back({rotation_from_rpy({3.141592653589793, 0, 0.2 * i}), {0.5, 0.1, 0.4}});
    seen.push_back(inverse(spun.back() * mount) * board);
  }
  const auto rpy = [](const Rigid& p) {
    return std::vector<double>{3.141592653589793, 0,
                               Eigen::AngleAxisd(p.rotation * Vector3(1, -1, -1).asDiagonal()).angle()};
  };
  const std::vector<std::filesystem::path> files{write("flange.csv", table("x,y,z,rx,ry,rz", spun, rpy)),
                                                 write("target.csv", quaternions(seen))};
  EXPECT_THAT(refusal(files), AllOf(HasSubstr("as well"), HasSubstr("--angles")));
  options.angles = "rpy";
  EXPECT_EQ(converted(files).session.observations.size(), 12u);
  options.angles = "degrees";
  EXPECT_THAT(refusal(files), HasSubstr("rotation_vector"));
}

TEST_F(HandEyeTables, AConventionThatSuitsNoTableIsRefused) {
  options.angles = "abc";
  EXPECT_THAT(refusal({write("flange.csv", quaternions(flange)), write("target.csv", quaternions(target))}),
              AllOf(HasSubstr("--angles abc"), HasSubstr("no table")));
}

TEST_F(HandEyeTables, WhereNothingCanBeTriedItIsAsked) {
  flange.resize(3), target.resize(3);
  EXPECT_THAT(
      refusal({write("flange.csv", table("x,y,z,rx,ry,rz", flange, vector)), write("target.csv", quaternions(target))}),
      AllOf(HasSubstr("nothing here can tell"), HasSubstr("--angles")));
}

TEST_F(HandEyeTables, RowsThatDoNotBelongTogetherAreNotReadToFit) {
  std::reverse(target.begin(), target.end());
  EXPECT_THAT(
      refusal({write("flange.csv", table("x,y,z,rx,ry,rz", flange, vector)), write("target.csv", quaternions(target))}),
      AllOf(HasSubstr("No reading"), HasSubstr("rows belong together")));
}

TEST_F(HandEyeTables, ARobotThatErrsByDegreesIsReadWhereNoOtherReadingComesNear) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto drawn = [&](double sigma) {
    return Vector3(sigma * normal(random), sigma * normal(random), sigma * normal(random));
  };
  for (Rigid& p : target) p = p * Rigid{rotation_from_vector<double>(drawn(0.05)), drawn(0.03)};
  const Conversion c = converted(
      {write("flange.csv", table("x,y,z,rx,ry,rz", flange, vector)), write("target.csv", quaternions(target))});
  EXPECT_THAT(c.notes, Contains(HasSubstr("read as rotation vectors")));
}

TEST_F(HandEyeTables, InvertedPosesDoNotLeadToAWrongReading) {
  for (Rigid& p : target) p = inverse(p);
  const Conversion c = converted(
      {write("flange.csv", table("x,y,z,rx,ry,rz", flange, vector)), write("target.csv", quaternions(target))});
  EXPECT_THAT(c.notes, Contains(HasSubstr("are inverted")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("read as rotation vectors")));
}

TEST_F(HandEyeTables, SigmasAreWrittenIntoTheSession) {
  options.sigma = 3e-4;
  options.sigma_angle = 1e-3;
  const Session s =
      converted({write("flange.csv", quaternions(flange)), write("target.csv", quaternions(target))}).session;
  EXPECT_DOUBLE_EQ(s.pose_sensor->sigma.value(), 3e-4);
  EXPECT_DOUBLE_EQ(s.pose_sensor->sigma_angle.value(), 1e-3);
}

}  // namespace
}  // namespace handsight
