// SPDX-License-Identifier: Apache-2.0
// What laboratories bring: robots that scatter before a board, many zeros that are degrees off, a board of another size
// over a robot with small deviations everywhere.
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/judging.h"
#include "fixtures/arms.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

/// Joints that repeat to so much (rad): all of them, or one.
void scatter(double repeatability, std::uint64_t seed, Session& s, std::optional<Eigen::Index> joint = {}) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (Observation& observation : s.observations)
    for (Eigen::Index j = 0; j < observation.position.size(); ++j)
      if (!joint || j == *joint) observation.position[j] += repeatability * normal(random);
}

Session scattering(const Session& like, double repeatability, std::uint64_t seed) {
  SimulationOptions o;
  o.observations = 40;
  o.seed = seed;
  Session s = simulate_session(like, o).session;
  scatter(repeatability, seed, s);
  return s;
}

DiagnosisOptions quick_verdicts() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

TEST(FieldVerdicts, ABoardsManyRowsDoNotHideARobotsScatter) {
  for (const std::uint64_t seed : {3, 4, 5}) {
    const Session like = fixture::target_session();
    const Diagnosis wild = diagnose(scattering(like, 1.5e-3, seed), quick_verdicts());
    EXPECT_TRUE(repeats_too_badly(wild)) << *wild.beyond_repeatability;
    EXPECT_NE(wild.verdict, Verdict::adequate) << wild.reason;
    const Diagnosis usual = diagnose(scattering(like, 1e-4, seed), quick_verdicts());
    EXPECT_FALSE(repeats_too_badly(usual)) << *usual.beyond_repeatability;
    EXPECT_EQ(usual.verdict, Verdict::adequate) << usual.reason;
  }
}

/// The shape of a tracker's body is bent to what the robot leaves; that is no noise that its scatter could hide behind.
TEST(FieldVerdicts, AFineTrackersBodyDoesNotHideARobotsScatter) {
  for (const std::uint64_t seed : {3, 4, 5}) {
    SimulationOptions o;
    o.observations = 17;
    o.noise = 5e-6;
    o.seed = seed;
    o.effects = {{"link_geometry", 2, {3e-3, 2e-3, 0.01, -0.01}}};
    Session s = simulate_session(fixture::tracker_session(4), o).session;
    scatter(3e-3, seed, s);
    DiagnosisOptions with_geometry = quick_verdicts();
    with_geometry.estimated = {{"link_geometry", 2, {0, 0, 0, 0}}};
    const Diagnosis wild = diagnose(s, with_geometry);
    ASSERT_TRUE(wild.beyond_repeatability) << seed;
    EXPECT_GT(*wild.beyond_repeatability, 3) << seed;
    EXPECT_NE(wild.verdict, Verdict::adequate) << wild.reason;
  }
}

/// A tenth of what is usual, everywhere.
void add_small_deviations(const Chain& chain, std::mt19937_64& random, std::vector<EffectTerm>& terms) {
  std::normal_distribution<double> normal;
  for (const char* id : {"link_geometry", "encoder_eccentricity"}) {
    const Effect& e = *find_effect(id);
    for (const int place : effect_places(e, chain)) {
      EffectTerm t = term_of(e, place);
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!e.parameters[p].is_choice) t.values[p] = 0.1 * prior_sigma(e.parameters[p], chain) * normal(random);
      terms.push_back(t);
    }
  }
}

std::vector<EffectTerm> zeros_degrees_off(const Chain& chain, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.02, 0.1);
  std::vector<EffectTerm> terms;
  const Effect& e = *find_effect("joint_offset");
  for (const int place : effect_places(e, chain)) {
    EffectTerm t = term_of(e, place);
    const double size = uniform(random);
    t.values = {random() % 2 ? size : -size};
    terms.push_back(t);
  }
  return terms;
}

/// The last joint repeats to 0.25 mrad and the others exactly. Were all taken to repeat alike, the first one's share,
/// 0.1 mm at the hand, would be more than its encoder does.
TEST(FieldVerdicts, AWristThatRepeatsBadlyHidesNothingOfTheFirstJoint) {
  for (const std::uint64_t seed : {3, 4, 5}) {
    SimulationOptions o;
    o.observations = 150;
    o.noise = 5e-6;
    o.seed = seed;
    o.effects = {{"encoder_eccentricity", 0, {2e-5, -1e-5}}};
    Session s = simulate_session(fixture::tracker_session(3), o).session;
    scatter(2.5e-4, seed, s, 5);
    const Diagnosis d = diagnose(s, quick_verdicts());
    ASSERT_FALSE(d.candidates.empty());
    EXPECT_EQ(d.candidates.front().id, "encoder_eccentricity") << d.reason;
    EXPECT_EQ(d.candidates.front().where, std::vector<std::string>{"a1"});
    EXPECT_GT(d.candidates.front().ln_bayes_factor, d.threshold);
  }
}

TEST(FieldVerdicts, ZerosComeBeforeAGeometryThatStandsInForThem) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Session like = fixture::stand_session(4);
    const Chain chain = make_chain(like);
    std::mt19937_64 random(seed);
    SimulationOptions o;
    o.observations = 80;
    o.seed = seed;
    o.effects = zeros_degrees_off(chain, random);
    add_small_deviations(chain, random, o.effects);
    const Diagnosis d = diagnose(simulate_session(like, o).session, quick_verdicts());
    const DiagnosisCandidate* finding = finding_of(d);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->id, "joint_offset") << d.reason;
  }
}

TEST(FieldVerdicts, ABoardsSizeComesBeforeARobotThatIsBentByIt) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Session like = fixture::target_session(fixture::charuco(), 2);
    std::mt19937_64 random(seed);
    SimulationOptions o;
    o.observations = 80;
    o.seed = seed;
    add_small_deviations(make_chain(like), random, o.effects);
    Session s = simulate_session(like, o).session;
    for (Vector3& x : s.shape->markers) x /= 1.008;
    s.target->square /= 1.008;
    s.target->tag /= 1.008;
    const Improvement m = improve(s, {});
    ASSERT_GT(m.steps.size(), 1u);
    EXPECT_EQ(m.steps[1].added, "target_scale");
    // The board's shape is held, and yet it is said how sure the names are.
    const auto scale = std::find_if(m.inclusion_probabilities.names.begin(), m.inclusion_probabilities.names.end(),
                                    [](const InclusionProbability& n) { return n.id == "target_scale"; });
    ASSERT_NE(scale, m.inclusion_probabilities.names.end());
    EXPECT_GT(scale->probability, 0.99);
    EXPECT_GT(m.inclusion_probabilities.model_uncertainty.covariance.norm(), 0);
  }
}

}  // namespace
}  // namespace handsight
