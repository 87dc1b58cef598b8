// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/proof/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/selection/model_changes.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

Session simulated_with(const std::vector<EffectTerm>& effects, std::uint64_t seed) {
  SimulationOptions o;
  o.effects = effects;
  o.seed = seed;
  o.observations = 60;
  o.noise = 0.2;
  return simulate_session(fixture::stand_session(), o).session;
}

Diagnosis without_curves(const Session& session) {
  DiagnosisOptions options;
  options.with_curves = false;
  return diagnose(session, options);
}

const DiagnosisCandidate* candidate(const Diagnosis& d, const std::string& id) {
  const auto found = std::find_if(d.candidates.begin(), d.candidates.end(),
                                  [&](const DiagnosisCandidate& c) { return c.id == id && !c.unnamed; });
  return found == d.candidates.end() ? nullptr : &*found;
}

/// Weighed slope of y by x through the origin.
template <class Value>
double slope(const ProofPlot& plot, const Value& y) {
  double xy = 0, xx = 0;
  for (const ProofPoint& p : plot.points) {
    const double weight = 1 / (p.sigma * p.sigma);
    xy += weight * p.x * y(p);
    xx += weight * p.x * p.x;
  }
  return xy / xx;
}

double chi_per_point(const ProofPlot& plot) {
  double sum = 0;
  for (const ProofPoint& p : plot.points) sum += std::pow((p.y - p.curve) / p.sigma, 2);
  return sum / static_cast<double>(plot.points.size());
}

TEST(Proof, TheSlopeOfASpringAgainstItsOwnTorqueIsItsCompliance) {
  const double a2 = 1.5e-4, a3 = 0.9e-4;
  const Session session = simulated_with({{"joint_elasticity", 1, {a2}}, {"joint_elasticity", 2, {a3}}}, 3);
  const Diagnosis d = without_curves(session);
  const DiagnosisCandidate* c = candidate(d, "joint_elasticity");
  ASSERT_NE(c, nullptr);
  const std::vector<ProofPlot> plots = make_proof(d, *c);
  ASSERT_EQ(plots.size(), 2U);
  std::set<std::string> against;
  for (const ProofPlot& plot : plots) {
    against.insert(plot.against);
    EXPECT_EQ(plot.against, "gravity torque at " + plot.of);
    EXPECT_EQ(plot.against_unit, "N m");
    EXPECT_EQ(plot.quantity, "error of " + plot.of);
    EXPECT_EQ(plot.unit, "rad");
    ASSERT_EQ(plot.numbers.size(), 1U);
    const ProofNumber& n = plot.numbers.front();
    const double truth = plot.of == "a2" ? a2 : a3;
    EXPECT_NEAR(n.value, truth, 4 * n.sigma);
    EXPECT_NEAR(n.slope, n.value, 0.1 * n.sigma) << "but for the prior's pull";
    EXPECT_NEAR(slope(plot, [](const ProofPoint& p) { return p.y; }), n.value, 0.1 * n.sigma);
    EXPECT_EQ(plot.points.size() + static_cast<std::size_t>(plot.left_out), 60U);
    EXPECT_LT(chi_per_point(plot), 1.3) << "the points lie on the line as closely as the noise lets them";
    EXPECT_GT(plot.largest, 4 * plot.noise) << "and far from the level";
  }
  EXPECT_EQ(against.size(), 2U);
}

TEST(Proof, AfterTheAdditionTheSamePointsAreLevel) {
  const Session session = simulated_with({{"joint_elasticity", 1, {1.5e-4}}}, 4);
  const Diagnosis before = without_curves(session);
  const DiagnosisCandidate* c = candidate(before, "joint_elasticity");
  ASSERT_NE(c, nullptr);
  const std::vector<ProofPlot> offered = make_proof(before, *c);
  ImprovementOptions options;
  options.with_curves = false;
  const ModelChange change = add_candidate(session, options, before, *c);
  ASSERT_TRUE(change.model);
  const std::vector<ProofPlot> taken =
      make_proof(session, change.model->model.fit, change.model->model_options.estimated);
  ASSERT_EQ(taken.size(), offered.size());
  ASSERT_EQ(taken.front().points.size(), offered.front().points.size());
  for (std::size_t i = 0; i < taken.front().points.size(); ++i) {
    const ProofPoint &a = offered.front().points[i], &b = taken.front().points[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_NEAR(a.x, b.x, 1e-6 * std::abs(a.x));
    EXPECT_NEAR(a.y, b.y, 0.1 * a.sigma) << "the same points on the same axes";
    EXPECT_NEAR(a.sigma, b.sigma, 0.01 * a.sigma);
  }
  const double sigma = taken.front().numbers.front().sigma;
  EXPECT_NEAR(slope(taken.front(), [](const ProofPoint& p) { return p.y - p.curve; }), 0, 0.1 * sigma);
}

TEST(Proof, OfACandidateThatWasNotFittedItIsLinearAndSaysTheSame) {
  const Session session = simulated_with({{"joint_elasticity", 1, {2e-5}}}, 5);
  const Diagnosis d = without_curves(session);
  const DiagnosisCandidate* fitted = candidate(d, "joint_elasticity");
  ASSERT_NE(fitted, nullptr);
  ASSERT_TRUE(fitted->full_fit);
  DiagnosisCandidate linear = *fitted;
  linear.full_fit.reset();
  const std::vector<ProofPlot> a = make_proof(d, *fitted), b = make_proof(d, linear);
  ASSERT_FALSE(a.empty());
  ASSERT_EQ(a.size(), b.size());
  ASSERT_EQ(a.front().points.size(), b.front().points.size());
  for (std::size_t i = 0; i < a.front().points.size(); ++i)
    EXPECT_NEAR(a.front().points[i].y, b.front().points[i].y, 0.5 * a.front().points[i].sigma);
}

/// Eccentricity: sine and cosine are one curve over the angle; both numbers are slopes by their share.
TEST(Proof, SineAndCosineOfOneEncoderStandInOnePlotAgainstItsAngle) {
  const Session session = simulated_with({{"encoder_eccentricity", 1, {2e-3, -1e-3}}}, 6);
  const Diagnosis d = without_curves(session);
  const DiagnosisCandidate* c = candidate(d, "encoder_eccentricity");
  ASSERT_NE(c, nullptr);
  const std::vector<ProofPlot> plots = make_proof(d, *c);
  const auto at = std::find_if(plots.begin(), plots.end(), [](const ProofPlot& p) { return p.of == "a2"; });
  ASSERT_NE(at, plots.end());
  EXPECT_EQ(at->against, "angle of a2");
  ASSERT_EQ(at->numbers.size(), 2U);
  EXPECT_EQ(at->numbers[0].name, "sine");
  for (const ProofNumber& n : at->numbers) EXPECT_NEAR(n.slope, n.value, 0.1 * n.sigma);
  for (const ProofPoint& p : at->points) {
    EXPECT_NEAR(p.share[0], std::sin(p.x), 1e-12);
    EXPECT_NEAR(p.share[1], std::cos(p.x), 1e-12);
  }
}

struct Expected {
  EffectTerm term;
  std::string against;
};
class ProofAgainst : public testing::TestWithParam<Expected> {};

/// Every kind of effect is shown against what it follows.
TEST_P(ProofAgainst, WhatItFollows) {
  const Session session = simulated_with({}, 7);
  const Diagnosis d = without_curves(session);
  DiagnosisCandidate c;
  c.id = GetParam().term.id;
  c.terms = {GetParam().term};
  const std::vector<ProofPlot> plots = make_proof(d, c);
  ASSERT_FALSE(plots.empty());
  EXPECT_EQ(plots.front().against, GetParam().against);
  EXPECT_GT(plots.front().noise, 0);
  for (const ProofPlot& plot : plots)
    for (const ProofPoint& p : plot.points) EXPECT_TRUE(std::isfinite(p.y) && p.sigma > 0);
}

INSTANTIATE_TEST_SUITE_P(
    Effects, ProofAgainst,
    testing::Values(Expected{{"joint_offset", 1, {1e-3}}, "angle of a2"},
                    Expected{{"joint_scale", 2, {1e-3}}, "angle of a3"},
                    Expected{{"friction_hysteresis", 1, {1e-3}}, "direction in which a2 last moved"},
                    Expected{{"backlash", 1, {1e-3}}, "gravity torque at a2"},
                    Expected{{"link_elasticity", 1, {3e-5}}, "gravity's moment across the axis of a2"},
                    Expected{{"mount_drift", -1, {1e-3, 0, 0, 0, 0, 0, 0}}, "time"},
                    Expected{{"body_slip", -1, {1e-3, 0, 0, 0, 0, 0, 20}}, "order of the observations"},
                    Expected{{"camera_mount", -1, {1e-3, 0, 0, 0, 0, 0}}, "time"},
                    Expected{{"lens_distortion", -1, {1e-3, 0, 0, 0, 0, 0, 0, 0}}, "time"}),
    [](const auto& one) { return one.param.term.id; });

/// Before a slip its number has no share, and yet the observations say where the body was.
TEST(Proof, BeforeASlipThePointsAreLevel) {
  const Session session = simulated_with({{"body_slip", -1, {4e-3, 0, 0, 0, 0, 0, 30}}}, 8);
  const Diagnosis d = without_curves(session);
  const DiagnosisCandidate* c = candidate(d, "body_slip");
  ASSERT_NE(c, nullptr);
  ASSERT_TRUE(c->full_fit);
  const std::vector<ProofPlot> plots = make_proof(d, *c);
  const auto x =
      std::find_if(plots.begin(), plots.end(), [](const ProofPlot& p) { return p.numbers.front().name == "x"; });
  ASSERT_NE(x, plots.end());
  ASSERT_EQ(x->points.size(), 60U);
  EXPECT_NEAR(x->numbers.front().value, 4e-3, 4 * x->numbers.front().sigma);
  double before = 0, after = 0;
  for (const ProofPoint& p : x->points) (p.x < 30 ? before : after) += p.y / 30;
  EXPECT_NEAR(after - before, 4e-3, 4e-4);
}

TEST(Proof, SaysTheSlopeInWordsAndUnits) {
  ProofPlot plot;
  plot.of = "arm_2", plot.quantity = "error of arm_2", plot.unit = "rad";
  plot.against = "gravity torque at arm_2", plot.against_unit = "N m";
  plot.numbers = {{0, 0, "compliance", "rad/(N m)", 1.5e-4, 6e-7, 1.5e-4}};
  plot.points.resize(2);
  plot.points[0].share = Eigen::VectorXd::Constant(1, 12);
  plot.points[1].share = Eigen::VectorXd::Constant(1, 3);
  plot.largest_x = 12, plot.largest = 1.8e-3, plot.hand_m = 1.4e-3;
  EXPECT_EQ(
      proof_text(plot),
      "arm_2 gives way by 150.00 +- 0.60 urad for each N m: 12 N m at most here, so 1.8 mrad, 1.4 mm at the hand.");
}

/// A curve without a name is proved like anything else.
TEST(Proof, OfAnEffectByFormulaIsAgainstTheVariableThatTheFormulaNames) {
  const Session session = simulated_with({}, 9);
  const Diagnosis d = without_curves(session);
  EffectDefinition definition;
  definition.id = "curve_1", definition.scope = "session", definition.unnamed = true;
  definition.parameters = {{"sine", "m", 1e-3}};
  definition.moves = {{"hand_y", "sine*sin(3.3*q_a4)", 0}};
  const auto own = own_effect(definition, session.robot);
  DiagnosisCandidate c;
  c.terms = {term_of(*own, -1, own)};
  c.terms.front().values = {5e-4};
  const std::vector<ProofPlot> plots = make_proof(d, c);
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots.front().against, "angle of a4");
  EXPECT_EQ(plots.front().quantity, "shift along y of the hand");
  for (const ProofPoint& p : plots.front().points) EXPECT_NEAR(p.share[0], std::sin(3.3 * p.x), 1e-12);
}

}  // namespace
}  // namespace handsight
