// SPDX-License-Identifier: Apache-2.0
#include "effects/target_effects.h"

#include <gtest/gtest.h>

#include "effects/coupled_joint.h"
#include "effects/own_effect.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

std::vector<Vector3> shifts(const Session& s, const std::string& id, std::vector<double> values) {
  const Chain chain = make_chain(s);
  const OwnEffects own = list_own_effects(s, chain);
  const auto found = std::find_if(own.begin(), own.end(), [&](const auto& e) { return e->id == id; });
  if (found == own.end()) return {};
  EffectTerm term = term_of(**found, -1, *found);
  term.values = std::move(values);
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  return moved_sites(states_at(chain, Eigen::VectorXd::Constant(count, 0.3)), {term}).markers;
}

bool has_place(const Session& s, const std::string& id) {
  const Chain chain = make_chain(s);
  return !effect_places(*find_effect(id, list_own_effects(s, chain)), chain).empty();
}

TEST(TargetScale, TakesEveryPointAwayFromTheBodysOrigin) {
  const Session s = fixture::target_session();
  const std::vector<Vector3> in_body = described_in_body(*s.shape), shift = shifts(s, "target_scale", {0.02});
  ASSERT_EQ(shift.size(), s.shape->markers.size());
  Vector3 mean = Vector3::Zero();
  for (std::size_t m = 0; m < shift.size(); ++m) {
    EXPECT_LT((shift[m] - 0.02 * in_body[m]).norm(), 1e-15);
    mean += shift[m];
  }
  EXPECT_LT(mean.norm(), 1e-12) << "the body's origin must stay";
  EXPECT_NEAR((in_body[0] - in_body[23]).norm(), (s.shape->markers[0] - s.shape->markers[23]).norm(), 1e-12);
}

TEST(TargetScale, HasAPlaceOnlyWhereTheShapeIsKnown) {
  Session s = fixture::target_session();
  EXPECT_TRUE(has_place(s, "target_scale"));
  EXPECT_TRUE(has_place(s, "target_bend"));
  s.shape->sigma = 1e-4;
  EXPECT_TRUE(has_place(s, "target_scale"));
  s.shape->sigma.reset();
  EXPECT_FALSE(has_place(s, "target_scale")) << "free points have any size";
  EXPECT_FALSE(has_place(fixture::stand_session(), "target_scale"));
  EXPECT_FALSE(has_place(fixture::stand_session(), "target_bend"));
  std::vector<EffectTerm> terms;
  EXPECT_THROW(add_effect_value("target_scale:scale=0.02", s.robot, terms), InputError);
  EXPECT_THROW(effect_terms("target_scale", make_chain(s), list_own_effects(s, make_chain(s))), InputError);
}

TEST(TargetBend, LiftsTheEdgesAcrossTheTarget) {
  const Session s = fixture::target_session();
  const std::vector<Vector3> in_body = described_in_body(*s.shape), shift = shifts(s, "target_bend", {0.09, 0});
  ASSERT_EQ(shift.size(), in_body.size());
  const Vector3 across = (in_body[5] - in_body[0]).cross(in_body[18] - in_body[0]).normalized();
  double low = 1, high = -1, sum = 0;
  for (const Vector3& d : shift) {
    EXPECT_LT((d - across * across.dot(d)).norm(), 1e-15) << "across the board alone";
    low = std::min(low, across.dot(d)), high = std::max(high, across.dot(d)), sum += across.dot(d);
  }
  const double half = 0.5 * (in_body[5] - in_body[0]).norm(), inner = half / 5;
  EXPECT_NEAR(high - low, 0.5 * 0.09 * (half * half - inner * inner), 1e-12);
  EXPECT_NEAR(sum, 0, 1e-12);
}

TEST(JointCoupling, CountsJointsAlongTheChain) {
  const Session s = fixture::stand_session();
  const Chain chain = make_chain(s);
  const auto& j = chain.joints;
  EXPECT_EQ(coupled_joint(chain, j[2], 1), j[1]);
  EXPECT_EQ(coupled_joint(chain, j[2], 2), j[0]);
  EXPECT_EQ(coupled_joint(chain, j[2], 3), std::nullopt);
  EXPECT_EQ(coupled_joint(chain, j[2], -1), j[3]);
  EXPECT_EQ(coupled_joint(chain, j[5], -1), std::nullopt);
  EXPECT_EQ(coupled_joint(chain, j[2], 0), std::nullopt);
}

TEST(JointCoupling, TurnsTheJointByAShareOfTheOthersAngle) {
  const Session s = fixture::stand_session();
  const Chain chain = make_chain(s);
  Eigen::VectorXd position(6);
  position << 0.1, -0.5, 0.3, 0.7, 0.2, -0.4;
  std::vector<EffectTerm> terms;
  const std::string& name = s.robot.joints[static_cast<std::size_t>(chain.joints[2])].name;
  add_effect_value("joint_coupling:" + name + ".ratio=0.02", s.robot, terms);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_EQ(terms[0].values[1], 1) << "with the joint before it, where nothing is said";
  EXPECT_NEAR(moved_sites(states_at(chain, position), terms).robot.joints[2].angle, 0.02 * -0.5, 1e-15);
  add_effect_value("joint_coupling:" + name + ".from=-1", s.robot, terms);
  EXPECT_EQ(terms[0].values[1], -1) << "a choice is set, not added to";
  EXPECT_NEAR(moved_sites(states_at(chain, position), terms).robot.joints[2].angle, 0.02 * 0.7, 1e-15);
}

}  // namespace
}  // namespace handsight
