// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/threshold.h"

#include <gtest/gtest.h>

#include <random>

#include "diagnosis/ranking.h"
#include "estimation/fit.h"
#include "simulated_stand.h"

namespace handsight {
namespace {

/// A tracker that sees one marker: every row is external, so that noise can be drawn anew into the model.
struct NoiseAlone {
  Candidates candidates;
  LinearModel model;

  NoiseAlone() {
    const Session session = simulated({}, 11, 40, fixture::tracker_session(1));
    const Fit f = fit(session, {});
    candidates = all_candidates(f.problem);
    model = linear_model(candidates.problem, estimate(f), candidates.base_effects, 2e-4);
  }
};

TEST(Threshold, IsReachedByNoiseAloneInOneSessionOfTwoHundred) {
  NoiseAlone n;
  const double threshold = simulated_threshold(n.model, n.candidates, {}, {});
  EXPECT_GE(threshold, 4);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr int draws = 400;
  int reached = 0, halfway = 0;
  for (int i = 0; i < draws; ++i) {
    for (Eigen::Index r = 0; r < n.model.external_error.size(); ++r) n.model.external_error[r] = normal(random);
    const Ranking ranking = rank(n.model, {}, n.candidates, {});
    reached += ranking.effects.front().ln_bayes_factor >= threshold;
    halfway += ranking.effects.front().ln_bayes_factor >= 0;
  }
  // 2 expected; a hundredth of a hundredth of such trials have more than 9.
  EXPECT_LE(reached, 9);
  EXPECT_GT(halfway, reached) << "the draws are no constant";
}

TEST(Threshold, AsksForMoreWhereRepeatabilityIsEstimatedToo) {
  const NoiseAlone n;
  EXPECT_GT(simulated_threshold(n.model, n.candidates, {1e-4, 0}, {}), simulated_threshold(n.model, n.candidates, {}, {}));
}

}  // namespace
}  // namespace handsight
