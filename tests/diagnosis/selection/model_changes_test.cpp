// SPDX-License-Identifier: Apache-2.0
// What is larger than robots are built and costs the sensor's place is not taken.
#include "diagnosis/selection/model_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fixtures/arms.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

/// A tracker at an unknown place, an arm whose second joint sits 0.2 m higher than its drawing says. Along the first
/// joint's axis nothing shows that but the base, which bends about its foot by so much (rad/(N m)).
Session session_with(double compliance) {
  Session like = fixture::tracker_session();
  like.mount.estimate = true;
  SimulationOptions o;
  o.observations = 60;
  o.seed = 3;
  o.noise = 2e-5;
  o.effects = {{"link_elasticity", 0, {compliance}}, {"link_geometry", 1, {0, 0.2, 0, 0}}};
  return simulate_session(like, o).session;
}

ModelChange with_geometry(const Session& session) {
  ImprovementOptions o;
  o.estimated = {{"link_elasticity", 0, {0}}};
  const Diagnosis model = diagnosed(session, o);
  DiagnosisCandidate geometry;
  geometry.id = "link_geometry";
  geometry.terms = {{"link_geometry", 1, {0, 0, 0, 0}}};
  return add_candidate(session, o, model, geometry);
}

TEST(ModelChanges, ALinkThatOnlyMovesTheSensorIsNotTaken) {
  const ModelChange change = with_geometry(session_with(1e-5));
  EXPECT_FALSE(change.model);
  ASSERT_EQ(change.refused.size(), 1U);
  EXPECT_THAT(change.refused.front().reason.english(), testing::HasSubstr("plays against what never moves"));
}

TEST(ModelChanges, ALinkThatTheMeasurementsTellIsTakenHoweverLarge) {
  const ModelChange change = with_geometry(session_with(1e-4));
  ASSERT_TRUE(change.model);
  EXPECT_NEAR(list_terms(change.model->model.fit).back().values[1], 0.2, 2e-3);
}

}  // namespace
}  // namespace handsight
