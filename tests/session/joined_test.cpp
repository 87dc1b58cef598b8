// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot as one, and each of them back again.
#include "session/joined.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

JoinedMember member(const std::string& title, int markers, int observations) {
  JoinedMember m;
  m.session = fixture::stand_session(markers);
  m.session.file = title + "/session.xml";
  m.session.sigma_pixel = 0.3;
  m.title = title;
  m.session.observations.clear();
  for (int i = 0; i < observations; ++i) {
    Observation o;
    o.id = 10 + i;
    o.time = 5 * i;
    o.position = Eigen::VectorXd::Constant(6, 0.1 * i);
    o.images[0] = "images/" + std::to_string(i) + ".png";
    for (int k = 0; k < markers; ++k) o.sightings.push_back(seen_at(k, {100.0 + k, 200.0 + i}, Vector2(90, 210)));
    m.session.observations.push_back(o);
  }
  return m;
}

std::string refusal(const std::vector<JoinedMember>& members) {
  try {
    joined(members, "both");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Joined, NumbersEverythingThroughAndTellsEachItsPlace) {
  const Session s = joined({member("june", 3, 4), member("august", 4, 5)}, "both");
  ASSERT_EQ(s.parts.size(), 2U);
  EXPECT_EQ(s.marker_count, 7);
  EXPECT_EQ(s.rig->count(), 4);
  EXPECT_EQ(s.other_mounts.size(), 1U);
  const Observation& o = s.observations[5];  // the second of august
  EXPECT_EQ(o.part, 1);
  EXPECT_EQ(o.sightings.front().marker, 3);
  EXPECT_EQ(o.sightings.front().in_cameras.front().camera, 2);
  EXPECT_EQ(o.whole->order, 5);
  EXPECT_EQ(o.whole->end - o.whole->start, 20);
  EXPECT_EQ(o.images[2], "../august/images/1.png");
  EXPECT_EQ(s.observations[4].whole->position_before.size(), 0) << "the first of a session comes from nowhere";
  std::set<std::int64_t> ids;
  for (const Observation& one : s.observations) ids.insert(one.id);
  EXPECT_EQ(ids.size(), 9U);
}

TEST(Joined, EachPartComesBackAsItWas) {
  const std::vector<JoinedMember> members{member("june", 3, 4), member("august", 4, 5)};
  const Session s = joined(members, "both");
  for (int p = 0; p < 2; ++p) {
    const Session &was = members[static_cast<std::size_t>(p)].session, is = part_session(s, p);
    ASSERT_EQ(is.observations.size(), was.observations.size());
    for (std::size_t i = 0; i < was.observations.size(); ++i) {
      EXPECT_EQ(is.observations[i].id, was.observations[i].id);
      EXPECT_EQ(is.observations[i].time, was.observations[i].time);
      EXPECT_TRUE(is.observations[i].position == was.observations[i].position);
      EXPECT_EQ(is.observations[i].sightings.back().marker, was.observations[i].sightings.back().marker);
      EXPECT_EQ(is.observations[i].sightings.back().in_cameras[1].pixel,
                was.observations[i].sightings.back().in_cameras[1].pixel);
    }
    EXPECT_EQ(is.sigma_pixel, was.sigma_pixel);
    EXPECT_EQ(is.rig->count(), 2);
    EXPECT_EQ(is.marker_count, was.marker_count);
  }
}

TEST(Joined, WhatIsSharedIsThereOnce) {
  std::vector<JoinedMember> members{member("june", 3, 4), member("august", 3, 5)};
  for (JoinedMember& m : members) m.rig = "head", m.body = "hand";
  const Session s = joined(members, "both");
  EXPECT_EQ(s.marker_count, 3);
  EXPECT_EQ(s.rig->count(), 2);
  EXPECT_TRUE(s.other_mounts.empty());
  EXPECT_EQ(s.parts[1].first_marker, 0);
}

TEST(Joined, SensorsOfDifferentNoiseCountByTheirOwn) {
  std::vector<JoinedMember> members{member("june", 3, 4), member("august", 3, 5)};
  members[1].session.sigma_pixel = 0.6;
  const Session s = joined(members, "both");
  EXPECT_EQ(s.parts[1].residual_unit, 2);
  EXPECT_EQ(s.observations.back().sightings.front().in_cameras.front().sigma->u, 0.6);
  EXPECT_EQ(s.observations.front().sightings.front().in_cameras.front().sigma->u, 0.3);
  EXPECT_EQ(usual_sigma(s), 0.3);
}

TEST(Joined, OneSessionIsItself) {
  const JoinedMember m = member("june", 3, 4);
  const Session s = joined({m}, "alone");
  EXPECT_TRUE(s.parts.empty());
  EXPECT_EQ(s.observations.front().id, m.session.observations.front().id);
}

TEST(Joined, SaysWhatSessionsCannotHaveInCommon) {
  std::vector<JoinedMember> members{member("june", 3, 4), member("august", 4, 5)};
  members[1].session.robot.joints[2].parent_from_joint.translation.z() += 0.001;
  EXPECT_NE(refusal(members).find("joint a3 has its place at 0 0 0.4 in one and 0 0 0.401 in the other"),
            std::string::npos)
      << refusal(members);
  members[1] = member("august", 4, 5);
  members[0].body = members[1].body = "hand";
  EXPECT_NE(refusal(members).find("another number of markers"), std::string::npos) << refusal(members);
  members[1] = member("august", 3, 5);
  members[1].session.rig->cameras[1].camera.fx += 1;
  members[0].rig = members[1].rig = "head";
  EXPECT_NE(refusal(members).find("has other cameras"), std::string::npos) << refusal(members);
  members[1] = member("august", 3, 5);
  members[1].session.sigma_pixel.reset();
  members[0].rig.clear();
  EXPECT_NE(refusal(members).find("nothing tells the noise"), std::string::npos) << refusal(members);
  members = {member("a", 3, 2), member("b", 3, 2), member("c", 3, 2), member("d", 3, 2), member("e", 3, 2)};
  EXPECT_NE(refusal(members).find("more than 8 cameras"), std::string::npos) << refusal(members);
}

}  // namespace
}  // namespace handsight
