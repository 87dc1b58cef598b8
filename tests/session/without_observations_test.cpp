// SPDX-License-Identifier: Apache-2.0
// A copy of a session with everything but its observations.
#include "session/without_observations.h"

#include <gtest/gtest.h>

#include "session/session_xml.h"

namespace handsight {
namespace {

TEST(WithoutObservations, EverythingElseIsThere) {
  for (const char* name : {"probe_and_plate", "first_steps"}) {
    Session session = read_session(std::string(HANDSIGHT_SOURCE_DIR "/sample_sessions/") + name);
    ASSERT_FALSE(session.observations.empty());
    const Session bare = without_observations(session);
    EXPECT_TRUE(bare.observations.empty());
    session.observations.clear();
    EXPECT_EQ(session_text(bare), session_text(session)) << name;
    EXPECT_EQ(bare.file, session.file);
    EXPECT_EQ(bare.robot.joints.size(), session.robot.joints.size());
    EXPECT_EQ(bare.source, session.source);
  }
}

}  // namespace
}  // namespace handsight
