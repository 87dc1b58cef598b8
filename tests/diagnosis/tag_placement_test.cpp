// SPDX-License-Identifier: Apache-2.0
// One tag of a body of five was put on askew: it is named with its number; where all are right nothing is named.
#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "effects/own_effect.h"
#include "estimation/report/fit_report.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

using fixture::tag_cube;
using fixture::target_session;

DiagnosisOptions quick() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

/// What cameras see of a cube of which one tag lies elsewhere than described: exactly moved, not to first order.
SimulatedSession askew(int tag, const Vector3& by, const Vector3& turn, std::uint64_t seed = 5, int observations = 40,
                       Target described = tag_cube()) {
  Target real = described;
  TagPlace& place = real.places[static_cast<std::size_t>(tag)];
  const Rigid moved = target_from_tag(place) * Rigid{rotation_from_vector<double>(turn), by};
  place.xyz = moved.translation;
  place.rpy = rpy_from_rotation(moved.rotation);
  for (TagPlace& p : real.places) p.sigma = p.sigma_angle = 0;
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  SimulatedSession s = simulate_session(target_session(real), o);
  set_target(s.session, described);
  return s;
}

Fit fitted(const Session& session, const std::string& effects) {
  const Chain chain = chain_of(session);
  return fit(session, {.estimated = effect_terms(effects, chain, own_effects_of(session, chain))});
}

constexpr double two_degrees = 2 * std::numbers::pi / 180;

TEST(TagPlacement, IsFoundWithTheBodyInItsPlace) {
  const Vector3 by(1e-3, -1.5e-3, 0.5e-3), turn(0, 0.02, 0.01);
  const SimulatedSession s = askew(2, by, turn);
  const Fit f = fitted(s.session, "tag_placement:2");
  EXPECT_TRUE(f.converged());
  ASSERT_EQ(f.effects.size(), 1u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(f.effects[0].term.values[i], by[static_cast<Eigen::Index>(i)], 4 * f.effects[0].sigmas[i]);
    EXPECT_NEAR(f.effects[0].term.values[i + 3], turn[static_cast<Eigen::Index>(i)], 4 * f.effects[0].sigmas[i + 3]);
  }
  const auto frame = tcp_from_target(s.session, f);
  ASSERT_TRUE(frame);
  for (std::size_t m = 0; m < 4; ++m)  // of the tag on top, which lies where it is described
    EXPECT_LT((*frame * s.session.shape->markers[m] - s.markers_in_tcp[m]).norm(), 5e-4);
}

TEST(TagPlacement, IsNamedWithItsTag) {
  for (const auto& [tag, by, turn] : {std::tuple{1, Vector3(2e-3, 0, 0), Vector3(0, 0, 0)},
                                      std::tuple{3, Vector3(0, 0, 0), Vector3(two_degrees, 0, 0)},
                                      std::tuple{0, Vector3(0, -2e-3, 0), Vector3(0, 0, two_degrees)}}) {
    const Diagnosis d = diagnose(askew(tag, by, turn).session, quick());
    ASSERT_FALSE(d.candidates.empty());
    EXPECT_EQ(d.verdict, Verdict::missing_effect) << d.reason;
    EXPECT_EQ(d.candidates.front().id, "tag_placement") << d.reason;
    EXPECT_EQ(d.candidates.front().where, (std::vector<std::string>{fmt::format("tag {}", tag)})) << d.reason;
    EXPECT_TRUE(d.candidates.front().plausible);
  }
}

TEST(TagPlacement, IsNotNamedWhereAllTagsAreRight) {
  for (const std::uint64_t seed : {5, 6, 7})
    EXPECT_EQ(diagnose(askew(0, Vector3::Zero(), Vector3::Zero(), seed).session, quick()).verdict, Verdict::adequate);
}

TEST(TagPlacement, IsNotNamedWhereTheSigmasAllowForIt) {
  Target loose = tag_cube();
  for (TagPlace& place : loose.places) place.sigma = 2e-3, place.sigma_angle = 0.03;
  const SimulatedSession s = askew(1, Vector3(2e-3, 0, 0), Vector3(0, two_degrees, 0), 5, 40, loose);
  const Diagnosis d = diagnose(s.session, quick());
  EXPECT_EQ(d.verdict, Verdict::adequate) << d.reason;
}

TEST(TagPlacement, IsTakenFirstAndEnoughToImproveTheModel) {
  const SimulatedSession s = askew(4, Vector3(1e-3, 2e-3, 0), Vector3(0, 0, two_degrees));
  const Improvement m = improve(s.session, {});
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "tag_placement");
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
}

TEST(TagPlacement, ASpringOfTheRobotIsNotBlamedOnATag) {
  SimulationOptions o;
  o.observations = 50;
  o.seed = 5;
  o.effects = {{"joint_elasticity", 2, {1.5e-4}}};
  const Diagnosis d = diagnose(simulate_session(target_session(tag_cube()), o).session, quick());
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity") << d.reason;
}

TEST(TagPlacement, HasAPlaceForEveryTagOfABody) {
  const Session s = target_session(tag_cube());
  const Chain chain = chain_of(s);
  const OwnEffects own = own_effects_of(s, chain);
  EXPECT_EQ(effect_terms("tag_placement", chain, own).size(), 5u);
  EXPECT_EQ(effect_terms("tag_placement:3+4", chain, own).size(), 2u);
  EXPECT_THROW(effect_terms("tag_placement:9", chain, own), InputError);
  const Session board = target_session();
  EXPECT_THROW(effect_terms("tag_placement", chain_of(board), own_effects_of(board, chain_of(board))), InputError);
}

}  // namespace
}  // namespace handsight
