// SPDX-License-Identifier: Apache-2.0
#include "estimation/session_oddities.h"

#include <gmock/gmock.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Session good_session() {
  SimulationOptions options;
  options.observations = 12;
  return simulate_session(fixture::stand_session(), options).session;
}

TEST(SessionOddities, AGoodSessionHasNone) { EXPECT_THAT(session_oddities(good_session()), IsEmpty()); }

TEST(SessionOddities, DegreesAreSuspected) {
  Session s = good_session();
  for (Observation& o : s.observations) o.position *= 57.29577951308232;
  EXPECT_THAT(session_oddities(s), Contains(HasSubstr("are they in degrees?")));
}

TEST(SessionOddities, CamerasThatSeeNothingAreTold) {
  Session s = good_session();
  s.rig->at(0).camera.fx = 1;
  s.rig->at(1).camera.cx = -5;
  s.rig->at(1).camera_from_first.translation *= 1000;
  const auto said = session_oddities(s);
  EXPECT_THAT(said, Contains(HasSubstr("left camera sees 180 degrees")));
  EXPECT_THAT(said, Contains(HasSubstr("left camera's fx 1 and fy")));
  EXPECT_THAT(said, Contains(HasSubstr("right camera's principal point")));
  EXPECT_THAT(said, Contains(HasSubstr("is right_from_left in m?")));
}

TEST(SessionOddities, CopiesAreTold) {
  Session s = good_session();
  for (Observation& o : s.observations) {
    o.position = s.observations.front().position;
    o.images[0] = o.images[1] = "a.png";
    for (Sighting& sighting : o.sightings) see(sighting, 1, seen_by(sighting, 0)->pixel);
  }
  const auto said = session_oddities(s);
  EXPECT_THAT(said, Contains(HasSubstr("the left point is the right one")));
  EXPECT_THAT(said, Contains(HasSubstr("the left image is the right one")));
  EXPECT_THAT(said, Contains(HasSubstr("same joint positions")));
}

TEST(SessionOddities, GravityOfAnotherPlanetIsTold) {
  Session s = good_session();
  s.gravity *= 1000;
  EXPECT_THAT(session_oddities(s), Contains(HasSubstr("Gravity is 9810")));
}

}  // namespace
}  // namespace handsight
