// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/diagnosis.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "base/threads.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "effects/own_effect.h"
#include "effects/target_effects.h"

namespace handsight {
namespace {

DiagnosisOptions quick() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

struct Hidden {
  const char* where;
  std::vector<EffectTerm> effects;
};

TEST(Diagnosis, NamesWhatIsHiddenAndWhere) {
  const std::vector<Hidden> all = {
      {"a2", {{"encoder_eccentricity", 1, {1.5e-3, -1e-3}}}},
      {"a3", {{"joint_elasticity", 2, {1e-4}}}},
      {"a2", {{"link_geometry", 1, {8e-4, 5e-4, 2e-3, -2e-3}}}},
      {"", {{"stereo_rig", -1, {8e-4, -5e-4, 6e-4, 1e-3, 1.5e-3, -1e-3}}}},
      {"", {{"lens_distortion", -1, {0.02, -0.03, 5e-4, 8e-4, -0.02, 0.02, 0, 5e-4}}}},
      {"from observation 31 on", {{"body_slip", -1, {1e-3, -1e-3, 1e-3, 0.01, 0, 0.01, 31}}}},
      {"marker 1", {{"marker_slip", 1, {1.5e-3, 1e-3, -1e-3, 22}}}},
      {"", {{"mount_drift", -1, {1e-3, 0, -1e-3, 2e-3, 0, 1e-3, 0}}}},
      {"", {{"time_lag", -1, {0.015}}}}};
  for (const Hidden& hidden : all) {
    const Diagnosis d = diagnose(simulated(hidden.effects, 7), quick());
    ASSERT_FALSE(d.candidates.empty());
    const DiagnosisCandidate& best = d.candidates.front();
    EXPECT_EQ(best.id, hidden.effects[0].id);
    EXPECT_EQ(d.verdict, Verdict::missing_effect) << hidden.effects[0].id << ": " << d.reason;
    const std::string where = hidden.where;
    if (!where.empty()) {
      EXPECT_EQ(std::count(best.where.begin(), best.where.end(), where), 1) << hidden.effects[0].id;
    }
    EXPECT_FALSE(best.explanation.empty());
    EXPECT_TRUE(best.plausible);
  }
}

TEST(Diagnosis, EveryEffectOfTheCatalogueComesFirst) {
  const Session like = fixture::torso_session(4);
  for (const Effect& e : catalogue()) {
    if (e.scope == EffectScope::camera) continue;  // of rigs of three cameras and more: rig_diagnosis_test.cpp
    if (has_no_target(e)) continue;                // of targets: target_size_test.cpp
    const std::vector<int> places = effect_places(e, make_chain(like));
    ASSERT_FALSE(places.empty()) << e.id;
    EffectTerm hidden = term_of(e, places[std::min<std::size_t>(1, places.size() - 1)]);
    double sign = 2;
    for (std::size_t p = 0; p < e.parameters.size(); ++p) {
      const EffectParameter& parameter = e.parameters[p];
      hidden.values[p] = !parameter.is_choice        ? sign * prior_sigma(parameter, make_chain(like))
                         : parameter.choices.empty() ? 37
                                                     : parameter.choices.front();
      sign = -sign;
    }
    const Diagnosis d = diagnose(simulated({hidden}, 31, 90, like), quick());
    ASSERT_FALSE(d.candidates.empty());
    EXPECT_EQ(d.candidates.front().id, e.id) << d.reason;
    EXPECT_GT(d.candidates.front().ln_bayes_factor, 20) << e.id << " hardly shows";
  }
}

TEST(Diagnosis, TheBestCandidatesFitCanBeFollowed) {
  const Diagnosis d = diagnose(simulated({{"joint_elasticity", 2, {1e-4}}}, 7), quick());
  const DiagnosisCandidate& best = d.candidates.front();
  ASSERT_TRUE(best.refitted);
  ASSERT_GE(best.path.size(), 1u);
  EXPECT_LT(best.path.back().cost, d.model.fit.solution.normal.data_cost());
  for (std::size_t i = 1; i < best.path.size(); ++i) EXPECT_LE(best.path[i].cost, best.path[i - 1].cost);
  // It ends at the candidate's numbers.
  Eigen::Index number = best.path.back().unknowns.effects.size() - static_cast<Eigen::Index>(best.covariance.rows());
  for (const EffectTerm& term : best.terms)
    EXPECT_EQ(term.values[0], best.path.back().unknowns.effects[number++]) << "joint " << term.place;
  EXPECT_EQ(number, best.path.back().unknowns.effects.size());
}

/// What fits far worse is told from the best, whatever they have in common, and the best from it.
TEST(Diagnosis, WhatTheEvidenceTellsApartIsNotSaidToLookTheSame) {
  constexpr double ln_20 = 2.995732273553991, ln_million = 13.815510557964274;
  const Diagnosis d =
      diagnose(simulated({{"joint_elasticity", 1, {1.5e-4}}, {"joint_elasticity", 2, {1e-4}}}, 7), quick());
  std::map<std::string, double> evidence;
  for (const DiagnosisCandidate& c : d.candidates)
    if (!c.unnamed) evidence[c.id] = c.ln_bayes_factor;
  int worse = 0;
  for (const DiagnosisCandidate& c : d.candidates) {
    worse += !c.unnamed && c.ln_bayes_factor > 1 && c.ln_bayes_factor < d.candidates.front().ln_bayes_factor - ln_20;
    for (const std::string& other : c.indistinguishable_from) {
      EXPECT_LE(evidence.at(other), c.ln_bayes_factor + ln_20) << c.id << " and " << other;
      EXPECT_GE(evidence.at(other), c.ln_bayes_factor - ln_million) << c.id << " and " << other;
    }
  }
  EXPECT_GT(worse, 1) << "else nothing is looked at";
}

TEST(Diagnosis, IsHonestWhenNothingIsMissing) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Diagnosis d = diagnose(simulated({}, seed), quick());
    EXPECT_EQ(d.verdict, Verdict::adequate) << d.reason;
    EXPECT_LT(d.candidates.front().ln_bayes_factor, d.threshold);
  }
}

TEST(Diagnosis, SaysWhatThesePosesCannotShow) {
  const Session rigid = simulated({}, 3, 40, fixture::stand_session());
  const Diagnosis d = diagnose(rigid, quick());
  for (const char* id : {"payload", "base_tilt", "mimic_error", "mimic_linkage"})
    EXPECT_EQ(std::count(d.invisible.begin(), d.invisible.end(), id), 1) << id;
  EXPECT_EQ(std::count(d.invisible.begin(), d.invisible.end(), "camera_intrinsics"), 0);
}

/// An effect that is in the model was seen, though the places that are left for it cannot show it; so was one that the
/// same answer speaks for.
TEST(Diagnosis, WhatWasSeenIsNotAmongWhatThesePosesCannotShow) {
  const Session session = simulated({{"joint_offset", 1, {3e-3}}}, 3, 40, fixture::stand_session());
  DiagnosisOptions options = quick();
  for (int j = 1; j < 5; ++j) options.estimated.push_back({"joint_offset", j, {0}});
  for (const Diagnosis& d : {diagnose(session, quick()), diagnose(session, options)}) {
    for (const FittedEffect& e : d.model.fit.effects)
      EXPECT_EQ(std::count(d.invisible.begin(), d.invisible.end(), e.term.id), 0) << e.term.id;
    for (const DiagnosisCandidate& c : d.candidates)
      if (!c.unnamed && c.ln_bayes_factor >= d.threshold)
        EXPECT_EQ(std::count(d.invisible.begin(), d.invisible.end(), c.id), 0) << c.id;
    EXPECT_EQ(std::count(d.invisible.begin(), d.invisible.end(), "payload"), 1);
  }
}

TEST(Diagnosis, NamesTheVariableOfWhatTheCatalogueDoesNotHave) {
  // A deviation with sin 3q at a joint.
  Session session = simulated({}, 5, 80);
  for (Observation& o : session.observations) o.position[1] -= 1.5e-3 * std::sin(3 * o.position[1]);
  const Diagnosis d = diagnose(session, quick());
  EXPECT_EQ(d.verdict, Verdict::unexplained) << d.reason;
  EXPECT_NE(d.reason.find("angle of a2"), std::string::npos) << d.reason;
  ASSERT_FALSE(d.patterns.empty());
  EXPECT_EQ(d.patterns.front().against.joint, 1);
}

TEST(Diagnosis, RefusesToJudgeTooFewObservations) {
  const Diagnosis d = diagnose(simulated({}, 2, 8), quick());
  EXPECT_EQ(d.verdict, Verdict::too_few_observations);
}

TEST(Diagnosis, NeverCallsAModelAdequateWhoseNoiseIsNotKnown) {
  Session like = fixture::tracker_session(1);
  const Diagnosis d = diagnose(simulated({}, 2, 40, like), quick());
  EXPECT_FALSE(d.noise);
  EXPECT_EQ(d.verdict, Verdict::unexplained);
}

TEST(Diagnosis, WorksOnTrackerSessions) {
  const Session session = simulated({{"joint_elasticity", 1, {1e-4}}}, 4, 60, [] {
    Session s = fixture::tracker_session(3);
    s.robot.joints[1].stiffness = 12000;
    return s;
  }());
  const Diagnosis d = diagnose(session, quick());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity") << d.reason;
}

TEST(Snooping, FindsWrongPointsAndNoOthers) {
  Session session = simulated({{"joint_elasticity", 1, {1e-4}}}, 6, 60);
  std::mt19937_64 random(1);
  int displaced = 0;
  for (Observation& o : session.observations)
    if (o.id % 6 == 1) {
      seen_by(o.sightings[o.id % 3], 0)->pixel += Vector2(7, -6);
      ++displaced;
    }
  const CleanFit clean = clean_fit(session, {});
  int right = 0;
  for (const WrongPoint& w : clean.wrong) right += w.id % 6 == 1 && w.marker == w.id % 3 && w.camera == 0;
  EXPECT_GE(right, displaced - 1);
  EXPECT_LE(static_cast<int>(clean.wrong.size()), right + 1);
  EXPECT_NEAR(clean.fit.noise_estimate->sigma, 0.2, 0.02);
}

TEST(Snooping, LeavesASlippedMarkerIn) {
  const Session session = simulated({{"marker_slip", 2, {3e-3, 2e-3, -2e-3, 52}}}, 9);
  const Diagnosis d = diagnose(session, quick());
  EXPECT_EQ(d.candidates.front().id, "marker_slip") << d.reason;
  EXPECT_LT(d.model.wrong.size(), 3u);
}

TEST(Patterns, OfNoiseAreNone) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    found += diagnose(simulated({}, seed), quick()).patterns.empty() ? 0 : 1;
  EXPECT_LE(found, 1);
}

TEST(Patterns, ShowTheTorqueThatAJointGivesWayTo) {
  const Diagnosis d = diagnose(simulated({{"joint_elasticity", 1, {1e-4}}}, 8), quick());
  ASSERT_FALSE(d.patterns.empty());
  EXPECT_LT(d.patterns.front().p_value, 1e-4);
  const bool torque = std::any_of(
      d.patterns.begin(),
      d.patterns.begin() + std::min<std::ptrdiff_t>(5, static_cast<std::ptrdiff_t>(d.patterns.size())),
      [](const DiagnosisPattern& p) { return p.against.kind == VariableKind::torque && p.against.joint == 1; });
  EXPECT_TRUE(torque) << d.patterns.front().residual.name << " against " << d.patterns.front().against.name;
}

TEST(Improvement, FindsTwoEffectsAndStopsAtTheNoise) {
  const Session session = simulated(
      {{"joint_elasticity", 1, {1e-4}}, {"joint_elasticity", 2, {1e-4}}, {"encoder_eccentricity", 0, {1.5e-3, 1e-3}}},
      12, 80);
  const Improvement m = improve(session);
  std::vector<std::string> added;
  for (const ImprovementStep& s : m.steps)
    if (!s.added.empty()) added.push_back(s.added);
  std::sort(added.begin(), added.end());
  EXPECT_EQ(added, (std::vector<std::string>{"encoder_eccentricity", "joint_elasticity"}));
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  EXPECT_LT(*m.steps.back().held_out.rms_pixel, 0.22);
  for (std::size_t i = 1; i < m.steps.size(); ++i)
    EXPECT_LT(*m.steps[i].held_out.rms_pixel, *m.steps[i - 1].held_out.rms_pixel);
}

TEST(Improvement, EndsWhereItsBudgetIsSpentAndSaysSo) {
  const Session session =
      simulated({{"joint_elasticity", 1, {1e-4}}, {"encoder_eccentricity", 0, {1.5e-3, 1e-3}}}, 12, 60);
  ImprovementOptions options;
  options.most_models = 2;
  const Improvement m = improve(session, options), whole = improve(session);
  EXPECT_TRUE(m.is_budget_spent);
  EXPECT_EQ(m.most_models, 2);
  EXPECT_EQ(m.steps.size(), 2u);
  EXPECT_FALSE(whole.is_budget_spent);
  EXPECT_GT(whole.models, m.models);
  EXPECT_LT(whole.models, whole.most_models);
}

TEST(Improvement, IsTheSameBitByBitHoweverManyThreadsThereAre) {
  const Session session =
      simulated({{"joint_elasticity", 1, {1e-4}}, {"encoder_eccentricity", 0, {1.5e-3, 1e-3}}}, 12, 60);
  std::vector<Improvement> all;
  for (const int threads : {1, 2, 5}) {
    most_threads() = threads;
    all.push_back(improve(session));
  }
  most_threads() = 0;
  const Improvement& alone = all.front();
  for (const Improvement& m : all) {
    ASSERT_EQ(m.steps.size(), alone.steps.size());
    EXPECT_EQ(m.last.report.held_out.rms_pixel, alone.last.report.held_out.rms_pixel);
    ASSERT_EQ(m.last.candidates.size(), alone.last.candidates.size());
    for (std::size_t c = 0; c < m.last.candidates.size(); ++c)
      EXPECT_EQ(m.last.candidates[c].ln_bayes_factor, alone.last.candidates[c].ln_bayes_factor);
    const Eigen::VectorXd effects = estimate(m.last.model.fit).effects;
    EXPECT_TRUE((effects.array() == estimate(alone.last.model.fit).effects.array()).all());
  }
}

TEST(Improvement, AddsNothingWhereNothingIsMissing) {
  const Improvement m = improve(simulated({}, 3));
  EXPECT_EQ(m.steps.size(), 1u);
  EXPECT_EQ(m.last.verdict, Verdict::adequate);
}

TEST(Improvement, DoesNotTakeAWrongNameForAnUnnamedCurve) {
  Session session = simulated({}, 5, 80);
  for (Observation& o : session.observations) o.position[2] -= 1.5e-3 * std::sin(4 * o.position[2]);
  const Improvement m = improve(session);
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "curve_1");
  EXPECT_NE(m.steps[1].formula.find("*q"), std::string::npos) << m.steps[1].formula;
  EXPECT_EQ(m.last.verdict, Verdict::unexplained);
  EXPECT_NE(m.last.reason.find(session.robot.joints[2].name), std::string::npos) << m.last.reason;
  EXPECT_GT(m.unnamed_share.value_or(0), 0.9);
  EXPECT_LT(*m.steps[1].held_out.rms_pixel, 0.22);
}

TEST(Improvement, ACurveFarLargerThanUsualStaysOneAndIsSaidToBeOdd) {
  EffectDefinition wave;
  wave.id = "wave", wave.scope = "joint";
  wave.parameters = {{"sine", "rad", 1e-3}};
  wave.moves = {{"angle", "sine*sin(3*q)", 0}};
  const auto own = own_effect(wave, like_stand().robot);
  EffectTerm truth = term_of(*own, 2, own);
  truth.values = {0.03};
  const Session session = simulated({truth}, 5, 80);
  const Improvement m = improve(session);
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "curve_1");
  ASSERT_EQ(m.steps[1].stands.size(), 1u);
  EXPECT_NE(m.steps[1].stands.front().find("sine"), std::string::npos) << m.steps[1].stands.front();
  EXPECT_LT(*m.steps[1].held_out.rms_pixel, 0.22);
}

TEST(Improvement, TakesNothingWhereNoFitIsAnAnswer) {
  // Every pose with the image of another: effects bend to that, and what they are then means nothing.
  Session session = simulated({}, 7, 30);
  const auto half = static_cast<std::ptrdiff_t>(session.observations.size() / 2);
  std::vector<std::vector<Sighting>> seen;
  for (const Observation& o : session.observations) seen.push_back(o.sightings);
  std::rotate(seen.begin(), seen.begin() + half, seen.end());
  for (std::size_t i = 0; i < seen.size(); ++i) session.observations[i].sightings = seen[i];
  const Improvement m = improve(session);
  EXPECT_EQ(m.steps.size(), 1u);
  EXPECT_EQ(m.last.verdict, Verdict::unexplained);
  EXPECT_NE(m.last.reason.find("finds no answer"), std::string::npos) << m.last.reason;
}

TEST(Improvement, StopsWhenAsked) {
  ImprovementOptions o;
  int calls = 0;
  o.on_progress = [&](double) { return ++calls < 2; };
  const Improvement m = improve(simulated({{"joint_elasticity", 1, {1e-4}}}, 3), o);
  EXPECT_TRUE(m.stopped);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace handsight
