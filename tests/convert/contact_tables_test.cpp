// SPDX-License-Identifier: Apache-2.0
// Tables of contacts as the multirobot calibration toolbox has them: no header, a line for each marker and camera that
// saw the pose, NaN for what was not measured, both arms' joints in every line; planes and one hand against the other.
#include "chain/chain.h"
#include "chain/touching.h"
#include "convert/convert_fixture.h"
#include "fixtures/two_arms.h"
#include "session/fixtures/list.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Pose, face, arm, camera, u, v, external axis, six joints of the right and of the left arm, a tracker's point and its
/// uncertainties.
const std::vector<std::string> columns{"pose", "-",  "-",  "-",  "-",  "-",  "torso_1", "r1", "r2",
                                       "r3",   "r4", "r5", "r6", "l1", "l2", "l3",      "l4", "l5",
                                       "l6",   "-",  "-",  "-",  "-",  "-",  "-",       "-"};

class ContactTables : public Convert {
 protected:
  ContactTables() : robot_(fixture::two_armed_robot()), random_(3) {
    robot_.joints[static_cast<std::size_t>(find_joint(robot_, "torso_2"))].kind = JointKind::fixed;
    chain_.robot = robot_;
    chain_.tcp_link = find_link(robot_, "right_hand");
    chain_.mount_link = find_link(robot_, "left_hand");
    for (const std::string& name : columns)
      if (const int joint = find_joint(robot_, name); joint >= 0) chain_.joints.push_back(joint);
    write("robot.urdf", fixture::urdf_text(robot_));
    options_.tcp = "right_hand";
    options_.mount.clear();
    options_.columns = columns;
    options_.sigma = 2e-5;
  }

  double drawn(double size) { return std::uniform_real_distribution(-size, size)(random_); }

  /// Postures in which the probe's tip touches within the noise; `right_only`: the left arm hangs.
  std::vector<Eigen::VectorXd> touches(const TipInFixture& tip, const FixtureKind* kind, double value,
                                       bool right_only) {
    const Eigen::Index first_left = 7, count = 13;
    Eigen::VectorXd most = Eigen::VectorXd::Constant(count, 1.2);
    if (right_only) most.tail(count - first_left).setConstant(0);
    std::normal_distribution<double> noise(0, 2e-5);
    std::vector<Eigen::VectorXd> all;
    for (int tries = 0; tries < 4000 && all.size() < 40; ++tries) {
      Eigen::VectorXd start(count);
      for (Eigen::Index j = 0; j < count; ++j) start[j] = drawn(most[j]);
      const Eigen::VectorXd wanted = Eigen::VectorXd::Constant(1, value + noise(random_));
      if (const auto q = touching_posture(tip, *kind, wanted, start, -most, most)) all.push_back(*q);
    }
    return all;
  }

  std::string table(const std::vector<Eigen::VectorXd>& positions) {
    std::string text;
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (int line = 0; line < 3; ++line) {
        text +=
            fmt::format("{},{},1,{},{:.2f},{:.2f}", i + 1, 4 + line, 1 + line % 2, 400 + drawn(300), 300 + drawn(200));
        for (const double q : positions[i]) text += fmt::format(",{}", q);
        text += ",NaN,NaN,NaN,NaN,NaN,NaN,NaN\n";
      }
    return text;
  }

  void expect_fits(const Session& s) {
    const Fit f = fit(s);
    EXPECT_TRUE(f.converged());
    ASSERT_TRUE(f.chi2_per_dof);
    EXPECT_NEAR(*f.chi2_per_dof, 1, 0.5);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(estimate(f).markers_in_tcp.front()[i], probe_[i], 2e-3) << "the probe's tip, " << i;
  }

  Robot robot_;
  Chain chain_;
  std::mt19937_64 random_;
  const Vector3 probe_{0.02, -0.01, 0.12};
};

TEST_F(ContactTables, PlanesOpenByTheirColumns) {
  const Rigid wall{rotation_from_rpy({0, 1.5, 0.1}), {0.7, 0, 0.9}},
      board{rotation_from_rpy({0.1, 0, 0}), {0.5, -0.3, 0.6}}, side{rotation_from_rpy({1.4, 0.3, 0}), {0.4, -0.6, 0.9}};
  std::vector<std::filesystem::path> files;
  for (const auto& named : {std::pair{"wall", wall}, {"table", board}, {"side", side}}) {
    const Rigid& root_from_plane = named.second;
    const TipInFixture tip = [&](const Eigen::VectorXd& q) {
      return inverse(root_from_plane) * (chain_ends(chain_, q).root_from_tcp * probe_);
    };
    const auto positions = touches(tip, &fixtures::plane, 0, true);
    ASSERT_EQ(positions.size(), 40U);
    files.push_back(write(std::string(named.first) + ".csv", table(positions)));
  }
  options_.fixtures = {"plane wall", "plane table", "plane side"};
  const Conversion c = converted(files);
  ASSERT_EQ(c.session.observations.size(), 120U);
  EXPECT_THAT(c.notes, Contains(HasSubstr("80 lines are of a touch that the line before is of too")));
  expect_fits(c.session);
}

/// The probes of both hands are balls: their middles are 116 mm apart when they touch.
TEST_F(ContactTables, OneHandAgainstTheOther) {
  const Vector3 ball(0.06, 0.02, 0.05);  // on the left hand
  const TipInFixture tip = [&](const Eigen::VectorXd& q) {
    const ChainEnds ends = chain_ends(chain_, q);
    return Vector3(inverse(ends.root_from_mount) * (ends.root_from_tcp * probe_) - ball);
  };
  const auto positions = touches(tip, &fixtures::length, 0.116, false);
  ASSERT_EQ(positions.size(), 40U);
  options_.fixtures = {"length hands mount=left_hand to=0.05,0.02,0.06 value=0.116"};
  const Conversion c = converted({write("self.csv", table(positions))});
  ASSERT_EQ(c.session.observations.size(), 40U);
  expect_fits(c.session);
  EXPECT_LT((estimate(fit(c.session)).mount_from_sensor.translation - ball).norm(), 2e-3);
}

}  // namespace
}  // namespace handsight
