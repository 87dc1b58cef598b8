// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/session_warnings.h"

#include <gmock/gmock.h>

#include "fixtures/arms.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

Session made() { return simulate_session(fixture::stand_session(), {.observations = 12, .seed = 5}).session; }

std::string only_model_uncertainty(const Session& session) {
  const auto warnings = session_warnings(session);
  EXPECT_EQ(warnings.size(), 1U);
  return warnings.empty() ? std::string() : warnings.front();
}

TEST(SessionWarnings, ThereAreNoneOfTheSampleSessions) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions")) {
    if (!std::filesystem::exists(entry.path() / "session.xml")) continue;
    for (const Message& model_uncertainty : session_warnings(read_session(entry.path())))
      ADD_FAILURE() << entry.path().filename() << ": " << model_uncertainty;
  }
  EXPECT_TRUE(session_warnings(made()).empty());
}

TEST(SessionWarnings, SwappedWidthAndHeightAreNamed) {
  Session s = made();
  for (Camera* camera : {&s.rig->at(0).camera, &s.rig->at(1).camera}) std::swap(camera->width, camera->height);
  const std::string model_uncertainty = only_model_uncertainty(s);
  EXPECT_NE(model_uncertainty.find("swapped"), std::string::npos) << model_uncertainty;
}

TEST(SessionWarnings, APointFarOutsideIsNoSwap) {
  Session s = made();
  see(s.observations[3].sightings[1], 0, Vector2(5000, 100));
  const std::string model_uncertainty = only_model_uncertainty(s);
  EXPECT_EQ(model_uncertainty.find("swapped"), std::string::npos) << model_uncertainty;
  EXPECT_NE(model_uncertainty.find("observation 3"), std::string::npos) << model_uncertainty;
}

TEST(SessionWarnings, DegreesAreNotRadians) {
  Session s = made();
  for (Observation& o : s.observations) o.position *= 57.29578;
  EXPECT_NE(only_model_uncertainty(s).find("degrees"), std::string::npos);
}

TEST(SessionWarnings, AJointThatIsNotMeasuredIsNamed) {
  Session s = made();
  const std::string gone = s.joints[2];
  s.joints.erase(s.joints.begin() + 2);
  for (Observation& o : s.observations) {
    Eigen::VectorXd rest(o.position.size() - 1);
    rest << o.position.head(2), o.position.tail(o.position.size() - 3);
    o.position = rest;
  }
  EXPECT_NE(only_model_uncertainty(s).find(gone), std::string::npos);
}

TEST(SessionWarnings, MarkersThatAreNeverSeenAreNamed) {
  Session s = made();
  s.marker_count = 5;
  const std::string model_uncertainty = only_model_uncertainty(s);
  EXPECT_NE(model_uncertainty.find("3, 4 are never seen"), std::string::npos) << model_uncertainty;
}

TEST(SessionWarnings, ARobotWithoutMassesIsSaidToHaveNone) {
  Session s = made();
  for (Link& link : s.robot.links) link.mass = 0;
  EXPECT_NE(only_model_uncertainty(s).find("mass"), std::string::npos);
}

TEST(SessionWarnings, ABodyMetresFromTheHandIsDoubted) {
  EXPECT_EQ(body_warning({Matrix3::Identity(), {0.1, 0.2, 0.3}}), "");
  EXPECT_NE(body_warning({Matrix3::Identity(), {0, 0, 2.5}}).find("2.5 m"), std::string::npos);
}

TEST(SessionWarnings, DegreesAreSuspected) {
  Session s = made();
  for (Observation& o : s.observations) o.position *= 5.9;  // less than two turns each
  EXPECT_THAT(session_warnings(s), Contains(HasSubstr("are they in degrees?")));
}

TEST(SessionWarnings, CamerasThatSeeNothingAreTold) {
  Session s = made();
  s.rig->at(0).camera.fx = 1;
  s.rig->at(1).camera.cx = -5;
  s.rig->at(1).camera_from_first.translation *= 1000;
  const auto said = session_warnings(s);
  EXPECT_THAT(said, Contains(HasSubstr("left camera sees 180 degrees")));
  EXPECT_THAT(said, Contains(HasSubstr("left camera's fx 1 and fy")));
  EXPECT_THAT(said, Contains(HasSubstr("right camera's principal point")));
  EXPECT_THAT(said, Contains(HasSubstr("is right_from_left in m?")));
}

TEST(SessionWarnings, CopiesAreTold) {
  Session s = made();
  for (Observation& o : s.observations) {
    o.position = s.observations.front().position;
    o.images[0] = o.images[1] = "a.png";
    for (Sighting& sighting : o.sightings) see(sighting, 1, seen_by(sighting, 0)->pixel);
  }
  const auto said = session_warnings(s);
  EXPECT_THAT(said, Contains(HasSubstr("the left point is the right one")));
  EXPECT_THAT(said, Contains(HasSubstr("the left image is the right one")));
  EXPECT_THAT(said, Contains(HasSubstr("same joint positions")));
}

TEST(SessionWarnings, ReadingsThatWereNotMadeAnewAreTold) {
  Session stood = made();
  stood.observations[5].position = stood.observations[4].position;
  const std::string of_robot = only_model_uncertainty(stood);
  EXPECT_THAT(of_robot, HasSubstr("joint readings are the same in observations 4 and 5"));
  Session seen = made();
  seen.observations[8].sightings = seen.observations[7].sightings;
  EXPECT_THAT(only_model_uncertainty(seen), HasSubstr("What was seen is the same in observations 7 and 8"));
  Session both = stood;
  both.observations[5].sightings = both.observations[4].sightings;
  EXPECT_TRUE(session_warnings(both).empty()) << "a pose that was measured again";
}

TEST(SessionWarnings, GravityOfAnotherPlanetIsTold) {
  Session s = made();
  s.gravity *= 1000;
  EXPECT_THAT(session_warnings(s), Contains(HasSubstr("Gravity is 9810")));
}

}  // namespace
}  // namespace handsight
