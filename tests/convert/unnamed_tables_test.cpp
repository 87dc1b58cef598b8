// SPDX-License-Identifier: Apache-2.0
// Tables as laboratories save them: joints and places in one, without a header or with numbered axes, and turns that a
// device writes and does not measure.
#include "convert/convert_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class UnnamedTables : public Convert {
 protected:
  /// A row an observation: the joints' angles, the points of the first markers, then `more`.
  std::string rows(int markers, double angle_unit, double length_unit, const std::string& separator,
                   const std::string& more) const {
    std::string text;
    for (const Observation& o : truth.session.observations) {
      std::string row;
      for (Eigen::Index j = 0; j < 6; ++j) row += fmt::format("{:.12g}{}", o.position[j] * angle_unit, separator);
      for (int m = 0; m < markers; ++m)
        for (int axis = 0; axis < 3; ++axis)
          row += fmt::format("{:.12g}{}", (*o.sightings[static_cast<std::size_t>(m)].point)[axis] * length_unit,
                             separator);
      row += more;
      text += row.substr(0, row.find_last_not_of(separator) + 1) + "\n";
    }
    return text;
  }

  static constexpr double degrees = 180 / std::numbers::pi;
  const std::string joints = "a1,a2,a3,a4,a5,a6,";
};

TEST_F(UnnamedTables, ColumnsWithoutAHeaderAreAskedForAndTaken) {
  const auto table = write("data.csv", rows(4, degrees, 1000, " ", "0 0 0"));
  EXPECT_THAT(refusal({table}), AllOf(HasSubstr("data.csv"), HasSubstr("21 columns"), HasSubstr("no header"),
                                      HasSubstr("--table-columns"), HasSubstr("a1 a2 a3")));
  for (int j = 1; j <= 6; ++j) options_.columns.push_back(fmt::format("a{}[deg]", j));
  for (int m = 1; m <= 4; ++m)
    for (const char axis : {'x', 'y', 'z'}) options_.columns.push_back(fmt::format("m{}_{}[mm]", m, axis));
  for (int i = 0; i < 3; ++i) options_.columns.emplace_back("-");
  const Conversion c = converted({table});
  expect_good(c.session);
  EXPECT_THAT(c.notes, Each(Not(HasSubstr("left out")))) << "all columns are read, or were given up";
}

TEST_F(UnnamedTables, AxesThatAreNumberedArePointsOfMarkers) {
  const auto header = [&](const char* form) {
    std::string text = joints;
    for (int m = 1; m <= 4; ++m)
      for (const char axis : {'x', 'y', 'z'}) text += fmt::format(fmt::runtime(form), axis, m) + ",";
    return text.substr(0, text.size() - 1) + "\n";
  };
  for (const char* form : {"{}{}", "{}_{}", "{}[{}]"}) {
    const Conversion c = converted({write("data.csv", header(form) + rows(4, 1, 1, ",", ""))});
    EXPECT_EQ(c.session.marker_count, 4) << form;
    expect_good(c.session);
    EXPECT_THAT(c.notes, Each(Not(HasSubstr("left out")))) << form;
  }
}

TEST_F(UnnamedTables, PosesOfNumberedAxesAreReadByTheMotionsOfTheRobot) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  std::string text = joints + "x1,y1,z1,phix1,phiy1,phiz1\n";
  const std::vector<Rigid> poses = target_poses(truth, tcp_from_target);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (const double q : truth.session.observations[i].position) text += fmt::format("{:.12g},", q);
    const Vector3 &t = poses[i].translation, rpy = rpy_from_rotation(poses[i].rotation);
    text += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n", t.x(), t.y(), t.z(), rpy.x(), rpy.y(),
                        rpy.z());
  }
  const Conversion c = converted({write("samples.csv", text)});
  EXPECT_THAT(c.notes, Contains(HasSubstr("phix1 phiy1 phiz1 are read as roll, pitch, yaw")));
  EXPECT_LT(small_motion_between(tcp_from_target, fit(c.session).tcp_from_body).norm(), 1e-6);
}

TEST_F(UnnamedTables, TurnsThatNeverChangeAreNone) {
  for (const char* turn : {"0,0,0", "-0.2139,50.02256,27.7369"}) {
    const Conversion c = converted({write("data.csv", joints + "x,y,z,rx,ry,rz\n" + rows(1, 1, 1, ",", turn))});
    EXPECT_FALSE(c.session.pose_sensor.has_value()) << turn;
    EXPECT_EQ(c.session.marker_count, 1) << turn;
    EXPECT_THAT(c.notes, Contains(HasSubstr("the device measures places alone"))) << turn;
    expect_good(c.session);
  }
}

}  // namespace
}  // namespace handsight
