// SPDX-License-Identifier: Apache-2.0
// What is held out together: poses that were measured again, and regions of poses.
#include "estimation/report/regions.h"

#include <gtest/gtest.h>

#include <set>

#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

SimulatedSession simulated(const std::vector<EffectTerm>& effects = {}) {
  SimulationOptions options;
  options.observations = 60;
  options.seed = 5;
  options.effects = effects;
  return simulate_session(fixture::stand_session(4), options);
}

Problem problem_of(const Session& session) { return make_problem(session, make_chain(session)); }

TEST(Regions, AreFiveAndTheSameEachTime) {
  const Session s = simulated().session;
  const std::vector<int> regions = list_regions(problem_of(s));
  EXPECT_EQ(std::set<int>(regions.begin(), regions.end()).size(), 5u);
  EXPECT_EQ(regions, list_regions(problem_of(s)));
}

/// Poses near each other in the joints lie together: neighbours' mean distance is far below that of all.
TEST(Regions, LieApart) {
  const Session s = simulated().session;
  const std::vector<int> regions = list_regions(problem_of(s));
  double within = 0, across = 0;
  int n_within = 0, n_across = 0;
  for (std::size_t a = 0; a < regions.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double d = (s.observations[a].position - s.observations[b].position).squaredNorm();
      (regions[a] == regions[b] ? within : across) += d;
      ++(regions[a] == regions[b] ? n_within : n_across);
    }
  EXPECT_LT(within / n_within, 0.8 * across / n_across);
}

TEST(Regions, PosesMeasuredAgainAreOnePose) {
  Session s = simulated().session;
  for (std::size_t i = 30; i < 60; ++i) s.observations[i].position = s.observations[i - 30].position;
  s.observations[40].position.array() += 4e-3;  // not quite there
  s.observations[41].position.array() += 0.1;   // another pose
  const Problem problem = problem_of(s);
  const std::vector<int> first = first_of_same_pose(problem), regions = list_regions(problem);
  for (int i = 30; i < 60; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(first[at], i == 41 ? 41 : i - 30) << i;
    if (i != 40 && i != 41) EXPECT_EQ(regions[at], regions[at - 30]) << i;
  }
}

/// A model that bends to the poses at hand for want of the right one is worse where it has seen none.
TEST(Regions, TheErrorElsewhereIsLarger) {
  const SimulatedSession s =
      simulated({{"encoder_eccentricity", 1, {8e-3, 4e-3}}, {"encoder_eccentricity", 2, {-6e-3, 7e-3}}});
  FitOptions options;
  options.estimated = effect_terms("link_geometry", make_chain(s.session));
  const Fit f = fit(s.session, options);
  const ErrorSummary usual = report(s.session, f, options).held_out,
                     elsewhere = held_out_by_region(s.session, f, options);
  ASSERT_TRUE(elsewhere.rms_pixel);
  EXPECT_GT(*elsewhere.rms_pixel, 1.1 * *usual.rms_pixel);
}

}  // namespace
}  // namespace handsight
