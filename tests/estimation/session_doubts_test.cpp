// SPDX-License-Identifier: Apache-2.0
#include "estimation/session_doubts.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

Session made() { return simulate_session(fixture::stand_session(), {.observations = 12, .seed = 5}).session; }

std::string only_doubt(const Session& session) {
  const auto doubts = session_doubts(session);
  EXPECT_EQ(doubts.size(), 1U);
  return doubts.empty() ? std::string() : doubts.front();
}

TEST(SessionDoubts, ThereAreNoneOfTheSampleSessions) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions")) {
    if (!std::filesystem::exists(entry.path() / "session.xml")) continue;
    for (const std::string& doubt : session_doubts(read_session(entry.path())))
      ADD_FAILURE() << entry.path().filename() << ": " << doubt;
  }
  EXPECT_TRUE(session_doubts(made()).empty());
}

TEST(SessionDoubts, SwappedWidthAndHeightAreNamed) {
  Session s = made();
  for (Camera* camera : {&s.rig->at(0).camera, &s.rig->at(1).camera}) std::swap(camera->width, camera->height);
  const std::string doubt = only_doubt(s);
  EXPECT_NE(doubt.find("swapped"), std::string::npos) << doubt;
}

TEST(SessionDoubts, APointFarOutsideIsNoSwap) {
  Session s = made();
  see(s.observations[3].sightings[1], 0, Vector2(5000, 100));
  const std::string doubt = only_doubt(s);
  EXPECT_EQ(doubt.find("swapped"), std::string::npos) << doubt;
  EXPECT_NE(doubt.find("observation 3"), std::string::npos) << doubt;
}

TEST(SessionDoubts, DegreesAreNotRadians) {
  Session s = made();
  for (Observation& o : s.observations) o.position *= 57.29578;
  EXPECT_NE(only_doubt(s).find("degrees"), std::string::npos);
}

TEST(SessionDoubts, AJointThatIsNotMeasuredIsNamed) {
  Session s = made();
  const std::string gone = s.joints[2];
  s.joints.erase(s.joints.begin() + 2);
  for (Observation& o : s.observations) {
    Eigen::VectorXd rest(o.position.size() - 1);
    rest << o.position.head(2), o.position.tail(o.position.size() - 3);
    o.position = rest;
  }
  EXPECT_NE(only_doubt(s).find(gone), std::string::npos);
}

TEST(SessionDoubts, MarkersThatAreNeverSeenAreNamed) {
  Session s = made();
  s.marker_count = 5;
  const std::string doubt = only_doubt(s);
  EXPECT_NE(doubt.find("3, 4 are never seen"), std::string::npos) << doubt;
}

TEST(SessionDoubts, ARobotWithoutMassesIsSaidToHaveNone) {
  Session s = made();
  for (Link& link : s.robot.links) link.mass = 0;
  EXPECT_NE(only_doubt(s).find("mass"), std::string::npos);
}

TEST(SessionDoubts, ABodyMetresFromTheHandIsDoubted) {
  EXPECT_EQ(body_doubt({Matrix3::Identity(), {0.1, 0.2, 0.3}}), "");
  EXPECT_NE(body_doubt({Matrix3::Identity(), {0, 0, 2.5}}).find("2.5 m"), std::string::npos);
}

}  // namespace
}  // namespace handsight
