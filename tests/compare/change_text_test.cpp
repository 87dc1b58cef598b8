// SPDX-License-Identifier: Apache-2.0
// What has changed, in words: each number in a unit that a person reads.
#include <gtest/gtest.h>

#include "chain/chain.h"
#include "compare/change_candidates.h"
#include "fixtures/random_robot.h"

namespace handsight {
namespace {

std::string text_of(const std::string& group, double value, double sigma) {
  const Session session = fixture::seen_random_session(31);
  const Chain chain = make_chain(session);
  for (ChangeUnit unit : change_units(make_problem(session, chain, {}, {}))) {
    if (unit.group != group) continue;
    for (double& v : unit.terms.front().values) v = value;
    return change_text(unit, unit.terms,
                       Eigen::VectorXd::Constant(static_cast<Eigen::Index>(unit.terms.front().values.size()), sigma),
                       chain)
        .english();
  }
  ADD_FAILURE() << "no " << group;
  return {};
}

TEST(ChangeText, ASpringIsInMicroradiansAndALoadToTheSamePlaceAsItsSigma) {
  EXPECT_NE(text_of("joint_elasticity", 1.234e-4, 5.6e-6).find("gives way by 123.4 +- 5.6 urad/(N m) more"),
            std::string::npos)
      << text_of("joint_elasticity", 1.234e-4, 5.6e-6);
  EXPECT_NE(text_of("payload", 0.51234, 0.021).find("carries 0.512 +- 0.021 kg more"), std::string::npos)
      << text_of("payload", 0.51234, 0.021);
}

TEST(ChangeText, NoNumberIsTimesAPowerOfTen) {
  for (const char* group : {"camera_mount", "body_slip", "joint_offset", "payload", "joint_elasticity"})
    for (const double size : {1e-5, 1e-3}) {
      const std::string text = text_of(group, size, size / 30);
      EXPECT_EQ(text.find("e-0"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace handsight
