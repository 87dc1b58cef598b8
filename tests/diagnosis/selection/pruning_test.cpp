// SPDX-License-Identifier: Apache-2.0
// What a model is kept up to once a name has come in: what only made up for the name goes.
#include "diagnosis/selection/pruning.h"

#include <gtest/gtest.h>

#include "diagnosis/selection/model_changes.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

/// A mount of the cameras that is off, and a little geometry of one joint.
const std::vector<EffectTerm> hidden_mount = {{"camera_mount", -1, {-2e-3, -6e-3, -3e-3, -11e-3, -3e-3, -6e-3}},
                                              {"link_geometry", 2, {9e-4, -6e-4, 3e-3, -2.5e-3}}};

/// The geometry of all joints as the first name in the model: that of the first one moves the arm as the mount would.
Improvement begun(const Session& session) {
  ImprovementOptions o;
  o.with_held_out = false;
  Improvement m;
  DiagnosisOptions all;
  all.estimated = effect_terms("link_geometry", make_chain(session));
  all.with_held_out = false;
  m.last = diagnose(session, all);
  return m;
}

TEST(Pruning, ANameThatExplainsAsMuchMorePlausiblyComesInAndWhatStoodInForItGoes) {
  const Session session = simulated(hidden_mount, 5);
  const Improvement m = begun(session);
  const auto mount = std::find_if(m.last.candidates.begin(), m.last.candidates.end(),
                                  [](const DiagnosisCandidate& c) { return c.id == "camera_mount"; });
  ASSERT_NE(mount, m.last.candidates.end());
  ASSERT_GT(mount->ln_bayes_factor, m.last.threshold) << "the first joint is off by more than any robot's";
  ImprovementOptions o;
  o.with_held_out = false;
  const ModelChange change = add_candidate(session, o, m.last, *mount);
  ASSERT_TRUE(change.model) << (change.refused.empty() ? "" : change.refused.front().reason);
  const std::vector<EffectTerm> terms = list_terms(change.model->model.fit);
  std::vector<int> geometry;
  for (const EffectTerm& t : terms)
    if (t.id == "link_geometry") geometry.push_back(t.place);
  EXPECT_EQ(geometry, std::vector<int>{2}) << "the other joints have nothing left to say";
  const EffectTerm& found = terms.back();
  ASSERT_EQ(found.id, "camera_mount");
  for (std::size_t p = 0; p < 6; ++p) EXPECT_NEAR(found.values[p], hidden_mount[0].values[p], 6e-4) << p;
  EXPECT_LE(held_out_error(*change.model), (1 + 1e-4) * held_out_error(m.last));
}

}  // namespace
}  // namespace handsight
