// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/judging.h"

#include <gtest/gtest.h>

#include <random>

#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

DiagnosisCandidate named(const std::string& id, double ln_bayes_factor) {
  DiagnosisCandidate c;
  c.id = id;
  c.where = {"a2"};
  c.terms = {term_of(*find_effect(id), 1)};
  c.sigmas = {std::vector<double>(c.terms[0].values.size(), 1.0)};
  c.ln_bayes_factor = ln_bayes_factor;
  return c;
}

DiagnosisCandidate curve_of_angle(double ln_bayes_factor) {
  DiagnosisCandidate c;
  c.ln_bayes_factor = ln_bayes_factor;
  c.unnamed.emplace();
  c.unnamed->empirical_error.variable =
      std::make_shared<Variable>(Variable{VariableKind::angle, 1, "angle of a2", "rad", {}});
  return c;
}

class Judge : public testing::Test {
 protected:
  static void SetUpTestSuite() { session_ = new Session(simulated({}, 2, 20)); }
  static void TearDownTestSuite() { delete session_; }

  /// What is said of these candidates where noise alone reaches 4.
  Diagnosis judged(std::vector<DiagnosisCandidate> candidates, bool knows_noise = true) const {
    Diagnosis d;
    d.threshold = 4;
    d.noise = 0.2;
    d.lack_of_fit_p = 0.5;
    d.model.session = *session_;
    d.report.held_out.rms_pixel = 0.3;
    d.candidates = std::move(candidates);
    judge(*session_, knows_noise, {}, d);
    EXPECT_GE(d.reason.english().size(), 20u);
    return d;
  }

  static Session* session_;
};
Session* Judge::session_ = nullptr;

TEST_F(Judge, NamesWhatPassesAlone) {
  const Diagnosis d = judged({named("joint_scale", 30), named("backlash", 26)});
  EXPECT_EQ(d.verdict, Verdict::missing_effect);
  EXPECT_NE(d.reason.find("Joint scale"), std::string::npos) << d.reason;
}

TEST_F(Judge, IsAmbiguousWithinOddsOfTwenty) {
  EXPECT_EQ(judged({named("joint_scale", 30), named("backlash", 27.1)}).verdict, Verdict::ambiguous);
  EXPECT_EQ(judged({named("joint_scale", 30), named("backlash", 26.9)}).verdict, Verdict::missing_effect);
}

TEST_F(Judge, AnUnnamedCurveOnTopIsUnexplainedAndItsVariableNamed) {
  const Diagnosis d = judged({curve_of_angle(31), named("joint_scale", 30)});
  EXPECT_EQ(d.verdict, Verdict::unexplained);
  EXPECT_NE(d.reason.find("angle of a2"), std::string::npos) << d.reason;
  EXPECT_EQ(judged({named("joint_scale", 30), curve_of_angle(29.9)}).verdict, Verdict::missing_effect)
      << "a curve below a name is no rival of it";
}

TEST_F(Judge, ANameThatExplainsMostOfTheSameComesBeforeACurveWithinOddsOfTwenty) {
  DiagnosisCandidate curve = curve_of_angle(31), name = named("joint_offset", 28.5);
  curve.explained = 1.0;
  name.refitted = true;
  name.explained = 0.86;
  EXPECT_EQ(judged({curve, name}).verdict, Verdict::missing_effect);
  EXPECT_TRUE(comes_before(name, curve));
  name.explained = 0.7;
  EXPECT_EQ(judged({curve, name}).verdict, Verdict::unexplained) << "the curve explains clearly more";
  name.explained = 0.86;
  name.ln_bayes_factor = 27;
  EXPECT_EQ(judged({curve, name}).verdict, Verdict::unexplained) << "the odds are above 20";
}

TEST_F(Judge, NothingThatPassesIsAdequateOnlyWhereTheNoiseIsKnown) {
  EXPECT_EQ(judged({named("joint_scale", 3.9), curve_of_angle(3.9)}).verdict, Verdict::adequate);
  EXPECT_EQ(judged({named("joint_scale", 3.9)}, false).verdict, Verdict::unexplained);
  EXPECT_EQ(judged({}).verdict, Verdict::adequate);
}

/// A robot whose joints repeat to so much, in rad, and the second one to another figure.
Diagnosis with_repeatability(double joints, std::optional<double> declared = std::nullopt,
                             std::optional<double> second = std::nullopt, int observations = 60) {
  SimulatedSession s = simulate_session(fixture::stand_session(4), {.observations = observations, .seed = 4});
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (Observation& o : s.session.observations)
    for (Eigen::Index j = 0; j < o.position.size(); ++j)
      o.position[j] += (j == 1 ? second.value_or(joints) : joints) * normal(random);
  s.session.repeatability = declared;
  return diagnose(s.session);
}

/// What follows nothing may be scatter only as far as robots scatter.
TEST(Judging, ScatterBeyondThatOfRobotsIsUnexplained) {
  const Diagnosis little = with_repeatability(2e-4), much = with_repeatability(2e-3),
                  declared = with_repeatability(2e-3, 3e-3);
  EXPECT_EQ(little.verdict, Verdict::adequate) << little.reason;
  EXPECT_EQ(much.verdict, Verdict::unexplained) << much.reason;
  EXPECT_NE(much.reason.find("times the noise"), std::string::npos) << much.reason;
  EXPECT_NE(much.reason.find("joints that repeat to"), std::string::npos) << much.reason;
  EXPECT_EQ(declared.verdict, Verdict::adequate) << declared.reason;
}

/// What the hand's whole usual scatter could make as large is told from it where the poses do: joints that repeat to
/// 0.9 mrad move the hand otherwise than a hand that is put down anew.
TEST(Judging, JointsThatScatterAsMuchAsAHandMayAreTold) {
  const Diagnosis d = with_repeatability(9e-4);
  ASSERT_TRUE(d.beyond_repeatability);
  EXPECT_LT(*d.beyond_repeatability, 1.1) << "no more than noise and all usual scatter together";
  EXPECT_GT(d.ln_against_usual_repeatability, ln_20);
  EXPECT_EQ(d.verdict, Verdict::unexplained) << d.reason;
}

/// The mean of all joints hides none: it is each joint that may scatter as much as robots do.
TEST(Judging, OneJointThatScattersMoreThanRobotsDoIsNamed) {
  const Diagnosis one = with_repeatability(2e-5, std::nullopt, 6e-4, 200),
                  usual = with_repeatability(2e-5, std::nullopt, 3e-4, 200);
  EXPECT_LT(one.repeatability.joints, usual_repeatability.joints);
  EXPECT_EQ(one.verdict, Verdict::unexplained) << one.reason;
  EXPECT_NE(one.reason.find("(a2 to 0."), std::string::npos) << one.reason;
  EXPECT_EQ(usual.verdict, Verdict::adequate) << usual.reason;
  EXPECT_NE(usual.reason.find("(a2 to 0."), std::string::npos) << usual.reason;
}

}  // namespace
}  // namespace handsight
