// SPDX-License-Identifier: Apache-2.0
// Poses of a flange beside points that a sensor measured without a turn: a marker before a depth camera or a tracker.
#include "convert/hand_eye_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

class FlangePoints : public HandEyeTables {
 protected:
  std::string points(double unit = 1) const {
    std::string text = "x,y,z\n";
    for (const Rigid& p : target) text += place(p, unit, ",") + "\n";
    return text;
  }
  void expect_mount(const Session& session) const {
    const Rigid found = estimate(fit(session)).mount_from_sensor;
    EXPECT_LT((found.translation - mount.translation).norm(), 3e-3);
    EXPECT_LT((found.rotation - mount.rotation).norm(), 1e-2);
  }
};

TEST_F(FlangePoints, AreASessionOfATracker) {
  const Conversion c = converted({write("flange.csv", quaternions(flange)), write("points.csv", points())});
  EXPECT_EQ(c.session.observations.size(), 16u);
  EXPECT_TRUE(c.session.robot.is_of_poses);
  EXPECT_EQ(c.session.marker_count, 1);
  expect_mount(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("--eye-on-base")));
}

TEST_F(FlangePoints, OfAMarkerOnTheFlange) {
  const Vector3 marker(0.08, 0.02, 0.11);
  std::string text = "x,y,z\n";
  for (const Rigid& pose : flange)
    text += place(Rigid{Matrix3::Identity(), inverse(mount) * (pose * marker)}, 1, ",") + "\n";
  options.eye_on_base = true;
  const Session session = converted({write("flange.csv", quaternions(flange)), write("points.csv", text)}).session;
  const Unknowns answer = estimate(fit(session));
  EXPECT_LT((answer.markers_in_tcp[0] - marker).norm(), 1e-6);
  EXPECT_LT((answer.mount_from_sensor.translation - mount.translation).norm(), 1e-6);
}

TEST_F(FlangePoints, TellHowAnglesAreToBeRead) {
  std::string text;
  for (const Rigid& p : flange) text += place(p, 1000, " ") + " " + joined(vector(p), " ") + "\n";
  const Conversion c = converted({write("robot.txt", text), write("points.csv", points(1000))});
  expect_mount(c.session);
  EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("rotation vectors"), HasSubstr("left of the points"))));
}

TEST_F(FlangePoints, ThatGoWithTwoReadingsAskWhichItIs) {
  // A marker in the flange's middle moves as it does, however it turns.
  std::string robot, text = "x,y,z\n";
  for (const Rigid& p : flange) {
    robot += place(p, 1000, " ") + " " + joined(vector(p), " ") + "\n";
    text += place(Rigid{Matrix3::Identity(), inverse(mount) * p.translation}, 1000, ",") + "\n";
  }
  options.eye_on_base = true;
  EXPECT_THAT(refusal({write("robot.txt", robot), write("points.csv", text)}),
              AllOf(HasSubstr("the points go with both"), HasSubstr("--angles")));
}

TEST_F(FlangePoints, AreRefusedWhereTheyDoNotPairOrAreOfSeveralMarkers) {
  std::string fewer = points();
  fewer.resize(fewer.rfind('\n', fewer.size() - 2) + 1);
  EXPECT_THAT(refusal({write("flange.csv", quaternions(flange)), write("points.csv", fewer)}),
              AllOf(HasSubstr("16 poses of the flange"), HasSubstr("15")));
  std::string two = "x1,y1,z1,x2,y2,z2\n";
  for (const Rigid& p : target) two += place(p, 1, ",") + "," + place(p, 1, ",") + "\n";
  EXPECT_THAT(refusal({write("flange.csv", quaternions(flange)), write("points.csv", two)}),
              HasSubstr("points of 2 markers"));
}

}  // namespace
}  // namespace handsight
