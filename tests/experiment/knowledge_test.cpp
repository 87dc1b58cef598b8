// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/knowledge.h"

#include <gtest/gtest.h>

#include "session/session_xml.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

Session seen_in(int observations) {
  const Session like =
      read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "one_camera" / "session.xml");
  SimulationOptions options;
  options.observations = observations;
  options.seed = 3;
  return simulate_session(like, options).session;
}

/// A camera whose mount is not known, a board whose place on the hand is not: one look determines neither.
TEST(Knowledge, TheHandHasNoLimitWhileItIsNotDetermined) {
  const Session many = seen_in(12);
  const std::vector<Eigen::VectorXd> poses{many.observations[0].position};
  EXPECT_FALSE(assess_knowledge(seen_in(1), {}, false, poses).hand_limit);
  const Knowledge known = assess_knowledge(many, {}, false, poses);
  ASSERT_TRUE(known.hand_limit);
  EXPECT_GT(*known.hand_limit, 1e-6);
}

}  // namespace
}  // namespace handsight
