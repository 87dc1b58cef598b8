// SPDX-License-Identifier: Apache-2.0
// What planned poses bring when they are measured, against random ones and against what the plan expects.
#include <gtest/gtest.h>

#include "diagnosis/planning/planning_sessions.h"
#include "diagnosis/ranking/refitting.h"

namespace handsight {
namespace {

using namespace fixture;

TEST(Planning, PlannedPosesGiveABetterBodyThanRandomOnes) {
  constexpr std::size_t taken = 8, added = 6;
  constexpr int draws = 40;
  const std::vector<EffectTerm> offsets = effect_terms("joint_offset", make_chain(stand_session()));
  double planned_squares = 0, random_squares = 0, expected_squares = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const SimulatedSession s = simulated(stand_session(), static_cast<int>(taken + added), 100 + draw);
    const std::vector<std::optional<Vector3>> known(s.markers_in_tcp.begin(), s.markers_in_tcp.end());
    const Session start = first_of(s, taken);
    PlanOptions o;
    o.count = added;
    o.estimated = offsets;
    o.pool = 600;
    const Plan p = plan(start, o);
    FitOptions fitting;
    fitting.estimated = offsets;
    const auto error = [&](const std::vector<Eigen::VectorXd>& poses) {
      const Fit f = fit(measured(s, start, poses, Random(500 + static_cast<std::uint64_t>(draw))), fitting);
      const Rigid truth = body_frame(f.sides, s.markers_in_tcp).tcp_from_body;
      return small_motion_between(truth, f.tcp_from_body).head<3>().squaredNorm();
    };
    planned_squares += error(positions(p));
    random_squares += error(random_poses(s, taken, added));
    expected_squares += p.poses.back().sigma.head<3>().squaredNorm();
  }
  RecordProperty("planned_rms_um", static_cast<int>(1e6 * std::sqrt(planned_squares / draws)));
  RecordProperty("random_rms_um", static_cast<int>(1e6 * std::sqrt(random_squares / draws)));
  EXPECT_LT(std::sqrt(planned_squares), 0.9 * std::sqrt(random_squares));
  // The priors' offsets are wider than the truth's (none), so what is expected is no less than what is found.
  EXPECT_LT(planned_squares, 1.5 * expected_squares);
}

/// ln of the Bayes factor of the first against the second term in a session.
double ln_bayes_factor(const Session& session, const std::vector<EffectTerm>& first,
                       const std::vector<EffectTerm>& second) {
  FitOptions a, b;
  a.estimated = first;
  b.estimated = second;
  const double noise = session.is_tracker() ? *session.sigma_point : *session.sigma_pixel;
  return fit_evidence(fit(session, a), 0, NoiseModel{{}, noise}).ln_evidence -
         fit_evidence(fit(session, b), 0, NoiseModel{{}, noise}).ln_evidence;
}

TEST(Planning, PlannedPosesTellEffectsApartBetterThanRandomOnes) {
  constexpr std::size_t taken = 10, added = 5;
  constexpr int draws = 40;
  const Chain chain = make_chain(stand_session());
  const auto first = effect_terms("joint_scale:a2", chain), second = effect_terms("encoder_eccentricity:a2", chain);
  double planned = 0, random = 0, before = 0, expected = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Random size(static_cast<std::uint64_t>(900 + draw));
    std::vector<EffectTerm> truth = first;
    truth[0].values[0] = 4e-4 * size.gaussian();  // a fifth of the prior sigma
    const SimulatedSession s = simulated(stand_session(), static_cast<int>(taken + added), 200 + draw, truth);
    const Session start = first_of(s, taken);
    PlanOptions o;
    o.count = added;
    o.pool = 600;
    o.between = {"scale", "eccentricity", first, second};
    const Plan p = plan(start, o);
    const Random noise(static_cast<std::uint64_t>(700 + draw));
    before += ln_bayes_factor(start, first, second);
    planned += ln_bayes_factor(measured(s, start, positions(p), noise), first, second);
    random += ln_bayes_factor(measured(s, start, random_poses(s, taken, added), noise), first, second);
    expected += (*p.poses.back().ln_bayes_factor)[0];
  }
  RecordProperty("before_milli", static_cast<int>(1e3 * before / draws));
  RecordProperty("planned_milli", static_cast<int>(1e3 * planned / draws));
  RecordProperty("random_milli", static_cast<int>(1e3 * random / draws));
  RecordProperty("expected_milli", static_cast<int>(1e3 * expected / draws));
  EXPECT_GT(planned, before);
  EXPECT_GT(planned - before, 1.2 * (random - before));
}

/// The linear theory: what a plan expects is what comes, in the mean, where the truth is drawn as the theory has it.
TEST(Planning, TheExpectedBayesFactorComesInTheMean) {
  constexpr int draws = 150;
  const Chain chain = make_chain(stand_session());
  const auto first = effect_terms("joint_scale:a2", chain), second = effect_terms("encoder_eccentricity:a2", chain);
  // One scale of the priors and joints that repeat, as the theory has it.
  const auto ln_evidence = [&](const Session& session, const std::vector<EffectTerm>& terms) {
    FitOptions o;
    o.estimated = terms;
    const Fit f = fit(session, o);
    return whiten(linear_model(f.problem, estimate(f), f.problem.effect_count(), *session.sigma_pixel), {}, {})
        .ln_evidence;
  };
  double found = 0, expected = 0, squares = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Random size(static_cast<std::uint64_t>(4000 + draw));
    std::vector<EffectTerm> truth = first;
    truth[0].values[0] = 2e-3 * size.gaussian();
    const SimulatedSession s = simulated(stand_session(), 10, 5000 + draw, truth);
    PlanOptions o;
    o.count = 3;
    o.pool = 200;
    o.between = {"scale", "eccentricity", first, second};
    const Plan p = plan(s.session, o);
    const Session more = measured(s, s.session, positions(p), Random(static_cast<std::uint64_t>(6000 + draw)));
    const double gained = (ln_evidence(more, first) - ln_evidence(more, second)) -
                          (ln_evidence(s.session, first) - ln_evidence(s.session, second));
    const double difference = gained - (*p.poses.back().ln_bayes_factor)[0];
    found += gained / draws;
    expected += (*p.poses.back().ln_bayes_factor)[0] / draws;
    squares += difference * difference;
  }
  const double error = std::sqrt(squares) / draws;
  RecordProperty("found_milli", static_cast<int>(1e3 * found));
  RecordProperty("expected_milli", static_cast<int>(1e3 * expected));
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(found, expected, 4 * error + 0.02 * expected);
}

}  // namespace
}  // namespace handsight
