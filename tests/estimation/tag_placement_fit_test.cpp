// SPDX-License-Identifier: Apache-2.0
// tag_placement in a fit: the six numbers of the tag that was put on askew, and the body where the others have it.
#include <gtest/gtest.h>

#include "base/error.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/report/fit_report.h"
#include "fixtures/askew_tags.h"

namespace handsight {
namespace {

using fixture::askew;
using fixture::tag_cube;
using fixture::target_session;

Fit fitted(const Session& session, const std::string& effects) {
  const Chain chain = make_chain(session);
  return fit(session, {.estimated = effect_terms(effects, chain, list_own_effects(session, chain))});
}

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

TEST(TagPlacement, HasAPlaceForEveryTagOfABody) {
  const Session s = target_session(tag_cube());
  const Chain chain = make_chain(s);
  const OwnEffects own = list_own_effects(s, chain);
  EXPECT_EQ(effect_terms("tag_placement", chain, own).size(), 5u);
  EXPECT_EQ(effect_terms("tag_placement:3+4", chain, own).size(), 2u);
  EXPECT_THROW(effect_terms("tag_placement:9", chain, own), InputError);
  const Session board = target_session();
  EXPECT_THROW(effect_terms("tag_placement", make_chain(board), list_own_effects(board, make_chain(board))),
               InputError);
}

TEST(TagPlacement, WithoutItNothingFits) {
  const SimulatedSession s = askew(2, Vector3(1e-3, -1.5e-3, 0.5e-3), Vector3(0, 0.02, 0.01));
  EXPECT_GT(*fit(s.session).chi2_per_dof, 2);
  EXPECT_LT(*fitted(s.session, "tag_placement:2").chi2_per_dof, 1.3);
  EXPECT_GT(*fitted(s.session, "tag_placement:3").chi2_per_dof, 1.5) << "another tag does not serve";
}

}  // namespace
}  // namespace handsight
