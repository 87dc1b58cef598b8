// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/robot_check.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "diagnosis/verdict/diagnosis.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

Session with_hidden(const std::vector<EffectTerm>& effects, std::uint64_t seed = 7) {
  Session like = fixture::stand_session();
  like.robot.joints[1].stiffness = like.robot.joints[2].stiffness = 12000;
  SimulationOptions o;
  o.effects = effects;
  o.seed = seed;
  o.observations = 60;
  o.noise = 0.2;
  o.declare_noise = false;
  return simulate_session(like, o).session;
}

Diagnosis diagnosed(const std::vector<EffectTerm>& hidden) {
  DiagnosisOptions o;
  o.with_held_out = false;
  return diagnose(with_hidden(hidden), o);
}

const DiagnosisCandidate& found(const Diagnosis& d, const std::string& id) {
  return *std::find_if(d.candidates.begin(), d.candidates.end(),
                       [&](const DiagnosisCandidate& c) { return c.id == id; });
}

/// By statics: how far 1 kg at the hand's centre of mass turns a soft joint, and what that moves the hand down.
double drop_by_hand(const Session& session, std::int64_t id, int joint, double compliance) {
  const Chain chain = make_chain(session);
  const Observation& o = *std::find_if(session.observations.begin(), session.observations.end(),
                                       [&](const Observation& other) { return other.id == id; });
  const Posture p = solve_posture<double>(chain.robot, joint_values(chain.robot, chain.joints, o.position),
                                          RobotChange{}, chain.gravity, false);
  const Rigid& root_from_tcp = p.root_from_link[static_cast<std::size_t>(chain.tcp_link)];
  const Vector3 mass_at = root_from_tcp * chain.robot.links[static_cast<std::size_t>(chain.tcp_link)].center_of_mass;
  const Rigid& frame = p.root_from_joint[static_cast<std::size_t>(joint)];
  const Vector3 axis = frame.rotation * chain.robot.joints[static_cast<std::size_t>(joint)].axis;
  const double torque = axis.dot((mass_at - frame.translation).cross(chain.gravity));  // of 1 kg
  const Vector3 motion = compliance * torque * axis.cross(root_from_tcp.translation - frame.translation);
  return motion.dot(chain.gravity.normalized());
}

TEST(RobotCheck, PredictsByHowMuchTheHandDrops) {
  const std::vector<EffectTerm> hidden = {{"joint_elasticity", 2, {1e-4}}};
  const Session session = with_hidden(hidden);
  const Diagnosis d = diagnosed(hidden);
  const DiagnosisCandidate& c = found(d, "joint_elasticity");
  ASSERT_TRUE(c.check && c.check->observation);
  EXPECT_EQ(c.check->unit, "m");
  double of_estimate = 0;
  for (const EffectTerm& t : c.terms) of_estimate += drop_by_hand(session, *c.check->observation, t.place, t.values[0]);
  const double of_truth = drop_by_hand(session, *c.check->observation, 2, 1e-4);
  EXPECT_GT(of_truth, 1e-4);
  EXPECT_NEAR(c.check->value, of_estimate, 0.01 * of_truth);  // second order: springs that follow each other
  EXPECT_NEAR(c.check->value, of_truth, 4 * c.check->sigma);
  EXPECT_GT(c.check->sigma, 0);
  EXPECT_LT(c.check->sigma, 0.2 * of_truth);
  EXPECT_NE(prediction_text(*c.check).find("Hang 1 kg on the hand: it should sag"), std::string::npos);
  EXPECT_NE(c.explanation.find(prediction_text(*c.check)), std::string::npos) << c.explanation;
}

struct HiddenBeforeACheck {
  std::vector<EffectTerm> effects;
  const char* unit;
};

TEST(RobotCheck, EveryKindOfCheckPredictsWhatTheTruthWouldShow) {
  const std::vector<HiddenBeforeACheck> all = {
      {{{"joint_scale", 1, {3e-3}}}, "rad"},
      {{{"encoder_eccentricity", 1, {1.5e-3, -1e-3}}}, "rad"},
      {{{"joint_offset", 2, {4e-3}}}, "rad"},
      {{{"friction_hysteresis", 1, {1.5e-3}}}, "m"},
      {{{"mount_drift", -1, {1e-3, 0, -1e-3, 2e-3, 0, 1e-3, 0}}}, "m"},
      {{{"body_slip", -1, {1e-3, -1e-3, 2e-3, 0.01, 0, 0.01, 31}}}, "m"},
      {{{"stereo_rig", -1, {8e-4, -5e-4, 6e-4, 1e-3, 1.5e-3, -1e-3}}}, "px"},
      {{{"lens_distortion", -1, {0.02, -0.03, 5e-4, 8e-4, -0.02, 0.02, 0, 5e-4}}}, "px"},
      {{{"time_lag", -1, {0.015}}}, "m"}};
  for (const HiddenBeforeACheck& hidden : all) {
    const std::string& id = hidden.effects[0].id;
    const Diagnosis d = diagnosed(hidden.effects);
    const DiagnosisCandidate& c = found(d, id);
    ASSERT_TRUE(c.check) << id;
    EXPECT_EQ(c.check->unit, hidden.unit) << id;
    EXPECT_GT(c.check->sigma, 0) << id;
    EXPECT_GT(std::abs(c.check->value), 5 * c.check->sigma) << id;
    ASSERT_EQ(c.terms.size(), 1u) << id;
    DiagnosisCandidate truth = c;
    truth.terms = hidden.effects;
    const auto true_check = predicted_check(d, truth);
    ASSERT_TRUE(true_check) << id;
    if (true_check->observation == c.check->observation && true_check->before == c.check->before) {
      EXPECT_NEAR(c.check->value, true_check->value, 5 * c.check->sigma) << id << prediction_text(*c.check);
    }
  }
}

TEST(RobotCheck, ItsSigmaIsTheScatterOfThePredictions) {
  const Diagnosis d = diagnosed({{"mount_drift", -1, {1e-3, 0, -1e-3, 2e-3, 0, 1e-3, 0}}});
  const DiagnosisCandidate& c = found(d, "mount_drift");
  ASSERT_TRUE(c.check);
  const Eigen::MatrixXd half = c.covariance.llt().matrixL();
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  double sum = 0, squares = 0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    Eigen::VectorXd z(half.cols());
    for (double& x : z) x = normal(random);
    const Eigen::VectorXd off = half * z;
    DiagnosisCandidate other = c;
    for (Eigen::Index n = 0; n < 6; ++n) other.terms[0].values[static_cast<std::size_t>(n)] += off[n];
    const auto check = predicted_check(d, other);
    if (!check || check->observation != c.check->observation) continue;
    sum += check->value;
    squares += check->value * check->value;
    ++count;
  }
  ASSERT_GT(count, 300);
  const double repeatability = std::sqrt(squares / count - std::pow(sum / count, 2));
  EXPECT_NEAR(repeatability, c.check->sigma, 0.15 * c.check->sigma);  // three sigma of a scatter of 300
}

TEST(RobotCheck, NothingIsPredictedOfWhatDoesNotPass) {
  const Diagnosis d = diagnosed({});
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.ln_bayes_factor < d.threshold) {
      EXPECT_FALSE(c.check) << c.id;
    }
}

TEST(RobotCheck, SaysInsideOrOutsideAndWhatThatMeans) {
  const CheckPrediction p{"Hang 1 kg on the hand: it should sag", "further (pose 37)", 1.4e-3, 0.2e-3, "m", 37};
  EXPECT_EQ(prediction_text(p), "Hang 1 kg on the hand: it should sag 1.40 +- 0.20 mm further (pose 37).");
  const CheckAnswer good = answer_check(p, 1.3e-3, 0.05e-3);
  EXPECT_TRUE(good.is_inside);
  EXPECT_FALSE(good.could_be_nothing);
  EXPECT_NEAR(good.sigmas, 0.1 / std::hypot(0.2, 0.05), 1e-9);
  EXPECT_EQ(good.text, "Inside: 0.5 sigma from the prediction. That speaks for this cause.");
  const CheckAnswer none = answer_check(p, 0.02e-3, 0.05e-3);
  EXPECT_FALSE(none.is_inside);
  EXPECT_EQ(none.text, "Outside: 6.7 sigma from the prediction, and nothing shows. That speaks against this cause.");
  const CheckAnswer more = answer_check(p, 4e-3, 0.05e-3);
  EXPECT_FALSE(more.is_inside);
  EXPECT_EQ(more.text, "Outside: 13 sigma from the prediction. It is another cause, or not this one alone.");
  const CheckAnswer coarse = answer_check(p, 1e-3, 1e-3);
  EXPECT_TRUE(coarse.is_inside && coarse.could_be_nothing);
  EXPECT_NE(coarse.text.find("too coarse"), std::string::npos);
  // A drop of -1.4 mm is as far from 1.4 mm as it is.
  EXPECT_NEAR(answer_check(p, -1.4e-3, 0).sigmas, 14, 1e-9);
}

}  // namespace
}  // namespace handsight
