// SPDX-License-Identifier: Apache-2.0
// Robots whose joints err from pose to pose: what is missing is asked as ever, and the answer weighs the error as a fit
// does.
#include "fixtures/erring_robot.h"

#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"

namespace handsight {
namespace {

TEST(ErringRobot, ImprovementAnswersAsTheFitDoes) {
  const SimulatedSession s = fixture::erring_robot(fixture::ErringRig::board, {.poses = 40, .joints = 1e-3, .seed = 2});
  const Fit plain = fit(s.session, {});
  ASSERT_TRUE(plain.problem.flange_error.is_any());
  const Improvement m = improve(s.session);
  ASSERT_EQ(m.steps.size(), 1u);  // nothing is missing
  const Fit& f = m.last.model.fit;
  EXPECT_NEAR(f.problem.flange_error.turn, plain.problem.flange_error.turn, 1e-5);
  EXPECT_LT(small_motion_between(f.tcp_from_body, plain.tcp_from_body).norm(), 1e-6);
  EXPECT_LT((f.covariance - plain.covariance).norm(), 1e-3 * plain.covariance.norm());
  ASSERT_TRUE(m.last.report.held_out.rms_pixel);
  EXPECT_EQ(m.steps.back().held_out.rms_pixel, m.last.report.held_out.rms_pixel);
  ASSERT_TRUE(m.unweighed);  // pixels alone leave less in the images
  EXPECT_LT(*m.unweighed->fitted.rms_pixel, *m.steps.back().fitted.rms_pixel);
}

TEST(ErringRobot, OneThatRepeatsIsNotWeighed) {
  const SimulatedSession s = fixture::erring_robot(fixture::ErringRig::board, {.poses = 40, .joints = 0, .seed = 2});
  EXPECT_FALSE(improve(s.session).unweighed);
}

}  // namespace
}  // namespace handsight
