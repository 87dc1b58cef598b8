// SPDX-License-Identifier: Apache-2.0
// One story: which cause leads, when a model may be said to agree, what stands in for what, and that the command's
// words name the same.
#include "diagnosis/story/story.h"

#include <gtest/gtest.h>

#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {
namespace {

DiagnosisCandidate named(const std::string& id, double ln_bayes_factor) {
  DiagnosisCandidate c;
  c.id = id;
  c.where = {"a2"};
  c.terms = {term_of(*find_effect(id), 1)};
  c.sigmas = {std::vector<double>(c.terms[0].values.size(), 1e-6)};
  c.ln_bayes_factor = ln_bayes_factor;
  c.held_out = ErrorSummary{.rms_pixel = 0.3};
  return c;
}

class StoryOf : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    session_ = new Session(simulated({}, 2, 20));
    fit_ = new Fit(fit(*session_));
  }
  static void TearDownTestSuite() {
    delete session_;
    delete fit_;
  }

  /// A diagnosis with these candidates where noise alone reaches 4; the error is so many times the noise.
  static Diagnosis diagnosed(Verdict verdict, double times, std::vector<DiagnosisCandidate> candidates = {}) {
    Diagnosis d;
    d.verdict = verdict;
    d.reason = "The reason that was given.";
    d.threshold = 4;
    d.model.session = *session_;
    d.model.fit = *fit_;
    d.noise = fit_->noise;
    d.report = report(*session_, *fit_);
    d.report.held_out.rms_pixel = times * *fit_->noise;
    d.candidates = std::move(candidates);
    return d;
  }

  static Session* session_;
  static Fit* fit_;
};
Session* StoryOf::session_ = nullptr;
Fit* StoryOf::fit_ = nullptr;

TEST_F(StoryOf, WhatIsOfferedFirstLeadsAndIsNamedInTheWords) {
  DiagnosisCandidate large = named("link_geometry", 90);
  large.plausible = false;
  large.too_large = true;
  const Diagnosis d = diagnosed(Verdict::missing_effect, 8,
                                {large, named("backlash", 60), named("joint_scale", 50), named("payload", 3)});
  const Story s = find_story(d);
  EXPECT_EQ(s.state, StoryState::missing);
  ASSERT_EQ(s.causes.size(), 3u) << "what does not pass is not offered";
  EXPECT_EQ(s.causes[0].id, "backlash");
  EXPECT_EQ(s.causes[1].id, "joint_scale");
  EXPECT_EQ(s.causes[2].id, "link_geometry") << "what no robot is built like comes last, however much speaks for it";
  ASSERT_NE(s.lead(), nullptr);
  EXPECT_EQ(s.lead()->id, finding_of(d)->id);
  EXPECT_EQ(s.next, StoryNext::add);
  const std::string text = story_text(s, d);
  EXPECT_NE(text.find("Backlash"), std::string::npos) << text;
  EXPECT_EQ(text.find("Link geometry"), std::string::npos) << text;
}

TEST_F(StoryOf, TheFirstOfMoreThanFourIsStillTheOneThatLeads) {
  std::vector<DiagnosisCandidate> many;
  for (const char* id : {"link_geometry", "joint_offset", "base_tilt", "camera_mount"}) {
    many.push_back(named(id, 90));
    many.back().plausible = false;
    many.back().too_large = true;
  }
  many.push_back(named("body_slip", 60));
  const Story s = find_story(diagnosed(Verdict::missing_effect, 8, many));
  ASSERT_EQ(s.causes.size(), 4u);
  EXPECT_EQ(s.causes.front().id, "body_slip") << "a cause that is named has its card";
}

TEST_F(StoryOf, NothingAgreesBeyondOneAndAHalfTimesTheNoise) {
  for (const double times : {1.0, 1.4, 1.6, 3.8}) {
    const Diagnosis d = diagnosed(Verdict::adequate, times);
    const Story s = find_story(d);
    EXPECT_EQ(s.state, times < 1.5 ? StoryState::at_the_noise : StoryState::repeatability) << times;
    EXPECT_EQ(story_text(s, d).find("Nothing is missing"), std::string::npos) << times;
    if (times > 1.5) EXPECT_NE(story_text(s, d).find("follows nothing"), std::string::npos) << story_text(s, d);
  }
  Diagnosis scattered = diagnosed(Verdict::adequate, 1.4);
  scattered.repeatability.joints = 1e-3;
  EXPECT_EQ(find_story(scattered).state, StoryState::repeatability) << "where joints scatter sooner";
}

TEST_F(StoryOf, WhatWasRefusedDoesNotLead) {
  const Diagnosis d = diagnosed(Verdict::missing_effect, 8, {named("backlash", 60), named("joint_scale", 50)});
  const auto reported = [&](std::set<std::string> refused) {
    return find_story(
        {.fit = d.model.fit, .report = d.report, .attribution = {}, .diagnosis = &d, .refused = std::move(refused)});
  };
  EXPECT_EQ(reported({"backlash"}).lead()->id, "joint_scale");
  const Story none = reported({"backlash", "joint_scale"});
  EXPECT_EQ(none.state, StoryState::refused);
  EXPECT_EQ(none.lead(), nullptr);
}

TEST_F(StoryOf, ASpringThatPushesBackIsNotBelieved) {
  DiagnosisCandidate spring = named("joint_elasticity", 90);
  spring.terms[0].values = {-8.6e-5};
  EXPECT_FALSE(is_believable(spring));
  const Story s = find_story(diagnosed(Verdict::missing_effect, 8, {spring, named("backlash", 60)}));
  EXPECT_EQ(s.lead()->id, "backlash");
  EXPECT_EQ(find_story(diagnosed(Verdict::missing_effect, 8, {spring})).state, StoryState::implausible);
  spring.terms[0].values = {8.6e-5};
  EXPECT_TRUE(is_believable(spring));
  spring.terms[0].values = {-1e-6};
  EXPECT_TRUE(is_believable(spring)) << "one sigma below nothing is nothing";
}

/// Zeros of degrees are in robots: where they leave much the words are not that no robot is built so, and beside small
/// deviations, which explain the rest, nothing is said against them.
TEST_F(StoryOf, WhatIsLargeAndLeavesMuchIsDoubtedInOtherWords) {
  DiagnosisCandidate zero = named("joint_offset", 90);
  zero.plausible = false;
  zero.explained = 0.7;
  const auto said = [&] {
    const Diagnosis d = diagnosed(Verdict::missing_effect, 8, {zero});
    return story_text(find_story(d), d).english();
  };
  EXPECT_EQ(find_disbelief(zero), Disbelief::leaves_much);
  EXPECT_NE(said().find("more than three times what is usual, and it leaves much"), std::string::npos) << said();
  zero.ln_of_small = 12;
  EXPECT_TRUE(is_believable(zero));
  EXPECT_EQ(said().find("stands in"), std::string::npos) << said();
  zero.too_large = true;
  EXPECT_NE(said().find("larger than robots are built"), std::string::npos) << said();
}

TEST_F(StoryOf, WhatStandsInIsSaidWhereverItIsInTheModel) {
  Diagnosis d = diagnosed(Verdict::adequate, 1.0);
  FittedEffect spring;
  spring.term = term_of(*find_effect("joint_elasticity"), 1);
  spring.term.values = {-8.6e-5};
  spring.sigmas = {1e-6};
  d.model.fit.effects = {spring};
  Story s = find_story(d);
  ASSERT_EQ(s.stands_in.size(), 1u);
  EXPECT_TRUE(s.stands_in[0].pushes_back);
  EXPECT_NE(story_text(s, d).find("stands in for another cause"), std::string::npos) << story_text(s, d);
  d.model.fit.effects[0].term.values = {8.6e-5};
  EXPECT_TRUE(find_story(d).stands_in.empty());
  d.model.fit.effects[0].term.values = {0.9 * largest_built * find_effect("joint_elasticity")->parameters[0].sigma};
  EXPECT_TRUE(find_story(d).stands_in.empty()) << "as large as the widest prior has it";
  d.model.fit.effects[0].term.values = {1.1 * largest_built * find_effect("joint_elasticity")->parameters[0].sigma};
  EXPECT_EQ(find_story(d).stands_in.size(), 1u) << "larger than robots are built";
  d.model.fit.effects[0].sigmas = {0};
  EXPECT_TRUE(find_story(d).stands_in.empty()) << "what the user holds is the user's";
}

TEST_F(StoryOf, WhereNothingHasAMassTheMassesAreAskedFor) {
  Diagnosis d = diagnosed(Verdict::unexplained, 3);
  EXPECT_EQ(find_story(d).next, StoryNext::look) << "these links have masses";
  for (Link& link : d.model.session.robot.links) link.mass = 0;
  const Story s = find_story(d);
  EXPECT_EQ(s.next, StoryNext::give_masses);
  EXPECT_NE(std::string(story_text(s, d)).find("give the masses"), std::string::npos) << std::string(story_text(s, d));
  d.verdict = Verdict::adequate;
  d.report.held_out.rms_pixel = *d.noise;
  EXPECT_EQ(find_story(d).next, StoryNext::use_it) << "where nothing is left, nothing is asked for";
}

TEST_F(StoryOf, FewObservationsAndUnknownNoiseHaveNoCause) {
  EXPECT_EQ(find_story(diagnosed(Verdict::too_few_observations, 8, {named("backlash", 60)})).lead(), nullptr);
  Diagnosis d = diagnosed(Verdict::unexplained, 8);
  d.model.fit.noise.reset();
  d.noise.reset();
  const Story s = find_story(d);
  EXPECT_FALSE(s.error.ratio());
  EXPECT_EQ(s.beyond, 0);
}

TEST_F(StoryOf, ManyBeyondTheNoiseAreCounted) {
  Diagnosis d = diagnosed(Verdict::missing_effect, 8, {named("backlash", 60)});
  EXPECT_FALSE(find_story(d).many_beyond());
  for (ObservationReport& o : d.report.per_observation) o.rms_pixel = 4 * *fit_->noise;
  const Story s = find_story(d);
  EXPECT_EQ(s.beyond, s.used);
  EXPECT_TRUE(s.many_beyond());
}

TEST_F(StoryOf, ACauseOfTheCamerasIsToBlameWhateverTheResidualsSay) {
  DiagnosisCandidate drift = named("mount_drift", 60);
  drift.terms = {term_of(*find_effect("mount_drift"), -1)};
  drift.terms[0].values.assign(drift.terms[0].values.size(), 1e-3);
  drift.explained = 0.9;
  const Diagnosis d = diagnosed(Verdict::missing_effect, 8, {drift});
  const Story s = find_story(
      {.fit = d.model.fit, .report = d.report, .attribution = {0, 0.04, 0.96, ErrorCause::robot}, .diagnosis = &d});
  EXPECT_EQ(s.attribution.cause, ErrorCause::cameras);
  EXPECT_NEAR(s.attribution.cameras, 0.9, 1e-9);
}

/// Zeros that were set by eye are far larger than usual, and true.
TEST(StoryOfLargeZeros, DoesNotDisownThem) {
  const Session s = simulated({{"joint_offset", 2, {0.073}}, {"joint_offset", 3, {-0.054}}}, 6);
  const Diagnosis d = diagnose(s, {});
  const Story found = find_story(d);
  ASSERT_TRUE(found.lead());
  EXPECT_EQ(found.lead()->id, "joint_offset");
  EXPECT_TRUE(found.lead()->believable);
  EXPECT_NE(found.state, StoryState::implausible);
  EXPECT_EQ(story_text(found, d).find("stands in"), std::string::npos) << story_text(found, d);
  FitOptions o;
  o.estimated = {term_of(*find_effect("joint_offset"), 2), term_of(*find_effect("joint_offset"), 3)};
  EXPECT_TRUE(stand_ins(fit(s, o)).empty());
}

TEST(StorySize, HasTwoDigits) {
  EXPECT_EQ(story_size_text(0.1951, true), "0.20 px");
  EXPECT_EQ(story_size_text(3.413, true), "3.4 px");
  EXPECT_EQ(story_size_text(0.0233, false), "23 mm");
  EXPECT_EQ(story_size_text(0.0996, true), "0.10 px");
  EXPECT_EQ(story_size_text(0, true), "0 px");
}

/// The hand in mm, all markers of an observation together: noise alone makes of it what is said.
TEST(HandInMillimetres, OfNoiseAloneIsWhatNoiseMakesOfIt) {
  const Session s = simulated({}, 5, 120);
  const Fit f = fit(s);
  const FitReport r = report(s, f);
  ASSERT_TRUE(r.fitted.hand_m && r.held_out.hand_m && r.noise_of_hand_m);
  EXPECT_NEAR(*r.held_out.hand_m / *r.noise_of_hand_m, 1.0, 0.25);
  EXPECT_LT(*r.held_out.hand_m, *r.held_out.rms_m) << "single corners have more of the depth's noise";
  const Session tracker = simulated({}, 5, 40, fixture::tracker_session());
  const FitReport t = report(tracker, fit(tracker));
  EXPECT_FALSE(t.fitted.hand_m) << "a tracker tells places by itself";
}

}  // namespace
}  // namespace handsight
