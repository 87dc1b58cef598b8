// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/stand_in.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

Chain with_masses_times(double times) {
  Session session = fixture::stand_session();
  for (Link& link : session.robot.links) link.mass *= times;
  return make_chain(session);
}

/// A light arm with series springs and printed links bends as much as a heavy one of steel.
TEST(StandIn, ASpringIsBuiltAsSoftAsItsLoadAllows) {
  const EffectTerm soft{"link_elasticity", 3, {1.01e-3}};
  EXPECT_FALSE(is_too_large(soft, with_masses_times(0.3)));
  EXPECT_TRUE(is_too_large(soft, with_masses_times(10)));
  EXPECT_TRUE(is_too_large({"link_elasticity", 3, {1}}, with_masses_times(0.3)));
}

TEST(StandIn, WithoutMassesAndOfOtherNumbersWhatIsUsualDecides) {
  const Chain chain = with_masses_times(0);
  for (const char* id : {"link_elasticity", "joint_offset"}) {
    const double usual = find_effect(id)->parameters[0].sigma;
    EXPECT_FALSE(is_too_large({id, 3, {0.9 * largest_built * usual}}, chain)) << id;
    EXPECT_TRUE(is_too_large({id, 3, {1.1 * largest_built * usual}}, chain)) << id;
  }
}

/// What bends most is what hangs stretched out: no posture has more.
TEST(StandIn, NoPostureLoadsAJointMoreThanItsLimitAllowsFor) {
  const Chain chain = with_masses_times(0.3);
  for (int joint = 0; joint < 6; ++joint) {
    const EffectTerm term{"link_elasticity", joint, {0}};
    const double limit = find_largest_built(term, 0, chain);
    for (int i = 0; i < 40; ++i) {
      const Eigen::VectorXd q =
          Eigen::VectorXd::NullaryExpr(6, [&](Eigen::Index j) { return std::sin(3.7 * i + 2.1 * j); });
      const Posture p = solve_posture(chain.robot, q, chain.gravity);
      EXPECT_LE(
          limit * p.moment[static_cast<std::size_t>(joint)].norm(),
          std::max(1.0001 * 3 * M_PI / 180, largest_built * 3e-5 * p.moment[static_cast<std::size_t>(joint)].norm()));
    }
  }
}

}  // namespace
}  // namespace handsight
