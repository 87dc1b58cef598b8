// SPDX-License-Identifier: Apache-2.0
// Effects by formula keep the contract of the catalogue's, and formulas that would not are refused in a sentence.
#include "effects/own_effect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/selection/improvement.h"
#include "estimation/report/export.h"
#include "estimation/report/prediction.h"
#include "estimation/solvers/normal_equations.h"
#include "fixtures/arms.h"
#include "session/calibration_xml.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

constexpr const char* samples = R"xml(<handsight_effects version="1">
  <effect id="belt_wave" title="Belt wave" scope="joint">
    <cause>The belt's teeth.</cause>
    <parameter name="sine" unit="rad" sigma="1e-3"/>
    <parameter name="cosine" unit="rad" sigma="1e-3"/>
    <moves site="angle" by="sine*sin(7*q) + cosine*cos(7*q)"/>
  </effect>
  <effect id="soft_when_loaded" title="Spring that softens" scope="joint">
    <parameter name="size" unit="rad" sigma="1e-3"/>
    <moves site="angle" by="size*tanh(tau/20)"/>
  </effect>
  <effect id="bearing" title="Bearing that tumbles" scope="joint">
    <parameter name="tilt" unit="rad" sigma="1e-3"/>
    <parameter name="play" unit="m" sigma="1e-3"/>
    <moves site="after_rx" by="tilt*cos(q)"/>
    <moves site="before_z" by="play*sin(q)"/>
  </effect>
  <effect id="spring" title="Spring of one's own" scope="joint">
    <parameter name="compliance" unit="rad/(N m)" sigma="1e-4"/>
    <moves site="compliance" by="compliance"/>
  </effect>
  <effect id="cable" title="Cable pull" scope="session">
    <parameter name="x" unit="m" sigma="1e-3"/>
    <parameter name="turn" unit="rad" sigma="1e-3"/>
    <moves site="hand_x" by="x*sin(2*q_a3)*exp(-time)"/>
    <moves site="hand_rz" by="turn*q_a2*q_a3"/>
    <moves site="mount_y" by="x*(seconds > 30 ? 1 : 0)"/>
  </effect>
  <effect id="far_away" title="Far away" scope="session">
    <parameter name="z" unit="m" sigma="1e-3"/>
    <moves site="hand_z" by="z*(tcp_x^2 + tcp_y^2 + (tcp_z - 0.5)^2)"/>
  </effect>
  <effect id="gum" title="Gum under a marker" scope="marker">
    <parameter name="height" unit="m" sigma="1e-3"/>
    <moves site="z" by="height*time"/>
  </effect>
  <effect id="zoom" title="Zoom" scope="session">
    <parameter name="f" unit="px" sigma="3"/>
    <moves site="left_fx" by="f"/>
    <moves site="left_fy" by="f"/>
  </effect>
</handsight_effects>)xml";

Session stand() {
  Session session = fixture::stand_session(3);
  for (Joint& joint : session.robot.joints) joint.stiffness = 8000;
  return session;
}

EffectTerm sample_term(const Session& session, const std::string& id, int place, double size) {
  for (const EffectDefinition& d : parse_effect_definitions(samples, "effects.xml"))
    if (d.id == id) {
      const auto effect = own_effect(d, session.robot);
      EffectTerm term = term_of(*effect, place, effect);
      for (std::size_t p = 0; p < term.values.size(); ++p) term.values[p] = size * effect->parameters[p].sigma;
      return term;
    }
  throw BrokenPromise("no such sample: " + id);
}

std::vector<EffectTerm> all_samples(const Session& session, double size) {
  return {sample_term(session, "belt_wave", 1, size), sample_term(session, "soft_when_loaded", 1, size),
          sample_term(session, "bearing", 2, size),   sample_term(session, "spring", 2, size),
          sample_term(session, "cable", -1, size),    sample_term(session, "far_away", -1, size),
          sample_term(session, "gum", 1, size),       sample_term(session, "zoom", -1, size)};
}

SimulationOptions sixty(std::vector<EffectTerm> effects) {
  SimulationOptions o;
  o.observations = 60;
  o.seed = 5;
  o.noise = 0.2;
  o.effects = std::move(effects);
  return o;
}

TEST(OwnEffect, IsAbsentWhereItsNumbersAreZeroAndAddsInThem) {
  const Session session = simulate_session(stand(), sixty({})).session;
  const Chain chain = make_chain(session);
  const ObservationState here = observation_states(session, chain)[20];
  for (const EffectTerm& term : all_samples(session, 1)) {
    EffectTerm none = term, twice = term;
    for (double& v : none.values) v = 0;
    for (double& v : twice.values) v *= 2;
    const auto numbers = [&](const std::vector<EffectTerm>& terms) {
      const Sites s = moved_sites(here, terms);
      Eigen::VectorXd all(6 * 4 + 16 + 9);
      all << s.hand, s.drift, s.body, s.cameras[1].motion, s.cameras[0].numbers, s.cameras[1].numbers, s.markers[0],
          s.markers[1], s.markers[2];
      double joints = 0;
      for (const JointChange& j : s.robot.joints)
        joints += j.angle + 3 * j.compliance + j.frame.sum() + 7 * j.after.sum();
      return Eigen::VectorXd((Eigen::VectorXd(all.size() + 1) << all, joints).finished());
    };
    EXPECT_EQ(numbers({none}).norm(), 0) << term.id;
    EXPECT_GT(numbers({term}).norm(), 0) << term.id;
    EXPECT_LT((numbers({term, term}) - numbers({twice})).norm(), 1e-15) << term.id;
  }
}

/// The fit's derivative of the measurements by each number against central differences.
TEST(OwnEffect, HasExactDerivatives) {
  const Session session = simulate_session(stand(), sixty(all_samples(stand(), 0.5))).session;
  for (const EffectTerm& term : all_samples(session, 0.7)) {
    Problem problem = make_problem(session, make_chain(session), {}, {term});
    Unknowns u;
    u.markers_in_tcp = {{0.03, 0.01, 0.05}, {-0.02, 0.03, 0.05}, {0, -0.03, 0.04}};
    u.mount_from_sensor = session.mount.mount_from_sensor;
    u.effects = effect_values(problem);
    const NormalEquations at = normal_equations(problem, u);
    for (Eigen::Index c = 0; c < problem.effect_count(); ++c) {
      const double step = 1e-3 * problem.columns_of_effects[static_cast<std::size_t>(c)].sigma;
      double cost[2];
      for (const int side : {0, 1}) {
        Unknowns other = u;
        other.effects[c] += side ? step : -step;
        Problem moved = problem;
        set_effects(moved, other.effects);
        cost[side] = normal_equations(moved, other).cost;
      }
      const double slope = (cost[1] - cost[0]) / (2 * step), expected = -2 * at.gradient[problem.effect_column() + c];
      EXPECT_NEAR(slope, expected, 1e-4 * std::abs(expected) + 1e-3 * at.cost) << term.id << " " << c;
    }
  }
}

TEST(OwnEffect, IsRecoveredFromASimulatedSession) {
  for (const EffectTerm& truth : all_samples(stand(), 1)) {
    const Session session = simulate_session(stand(), sixty({truth})).session;
    FitOptions o;
    o.estimated = {truth};
    for (double& v : o.estimated[0].values) v = 0;
    const Fit f = fit(session, o);
    ASSERT_TRUE(f.converged()) << truth.id;
    for (std::size_t p = 0; p < truth.values.size(); ++p)
      EXPECT_NEAR(f.effects[0].term.values[p], truth.values[p], 3.5 * f.effects[0].sigmas[p]) << truth.id << " " << p;
  }
}

TEST(OwnEffect, OfTheSessionIsRankedAndNamedLikeTheCatalogue) {
  Session like = stand();
  const EffectTerm truth = sample_term(like, "belt_wave", 1, 1.5);
  Session session = simulate_session(like, sixty({truth})).session;
  session.effect_definitions = parse_effect_definitions(samples, "effects.xml");
  const Improvement m = improve(session);
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "belt_wave");
  EXPECT_EQ(m.steps[1].where, std::vector<std::string>{session.robot.joints[1].name});
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
}

TEST(OwnEffect, TravelsWithTheCalibration) {
  const Session like = stand();
  const Session session = simulate_session(like, sixty({sample_term(like, "cable", -1, 1)})).session;
  FitOptions o;
  o.estimated = {sample_term(like, "cable", -1, 0), sample_term(like, "soft_when_loaded", 1, 0)};
  const Fit f = fit(session, o);
  const std::string text = calibration_text(make_calibration(session, f, report(session, f, o), o, "test"));
  const Calibration read = parse_calibration(text, "calibration.xml");
  ASSERT_EQ(read.definitions.size(), 2u);
  const PredictionModel here = prediction_model(f), there = prediction_model(read, session.robot);
  const Chain chain = make_chain(session);
  for (const Observation& observation : session.observations) {
    const TcpPrediction a = predict_tcp(chain, observation.position, here),
                        b = predict_tcp(chain, observation.position, there);
    EXPECT_LT(small_motion_between(a.root_from_tcp_est, b.root_from_tcp_est).norm(), 1e-12);
  }
}

std::string refusal(const std::string& scope, const std::string& site, const std::string& formula,
                    const std::string& parameter = "a") {
  const std::string text = "<handsight_effects version=\"1\"><effect id=\"own\" scope=\"" + scope +
                           "\"><parameter name=\"" + parameter + "\" unit=\"rad\" sigma=\"1e-3\"/>\n<moves site=\"" +
                           site + "\" by=\"" + formula + "\"/></effect></handsight_effects>";
  try {
    own_effect(parse_effect_definitions(text, "effects.xml").front(), stand().robot);
  } catch (const InputError& error) {
    EXPECT_LE(std::string(error.what()).size(), 600u);
    return error.what();
  }
  return "accepted";
}

TEST(OwnEffect, IsRefusedWithFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal("joint", "angle", "a*sin(q)"), "accepted");
  EXPECT_EQ(refusal("joint", "angle", "q &gt; 0.6 ? a : -a"), "accepted");
  const std::string typo = refusal("joint", "angle", "a*sin(3*p)");
  EXPECT_NE(typo.find("effects.xml, line 2"), std::string::npos) << typo;
  EXPECT_NE(typo.find("\"p\", column 9"), std::string::npos) << typo;
  EXPECT_NE(refusal("joint", "angle", "a*sin(q").find("is not understood"), std::string::npos);
  EXPECT_NE(refusal("joint", "angle", "sin(a*q)").find("not linear in the parameter \"a\""), std::string::npos);
  EXPECT_NE(refusal("joint", "angle", "a*a*q").find("not linear"), std::string::npos);
  EXPECT_NE(refusal("joint", "angle", "a*q + 1e-3").find("without any parameter"), std::string::npos);
  EXPECT_NE(refusal("joint", "elbow", "a").find("expected one of angle compliance"), std::string::npos);
  EXPECT_NE(refusal("session", "hand_x", "a*q").find("write q_NAME"), std::string::npos);
  EXPECT_NE(refusal("session", "left_fx", "a*time").find("same in all observations"), std::string::npos);
  EXPECT_NE(refusal("joint", "angle", "tau*q", "tau").find("name of a variable"), std::string::npos);
  EXPECT_NE(refusal("joint", "angle", "q_a2*0*a, a").find("is not understood"), std::string::npos);
}

TEST(OwnEffect, MustBeFiniteAtEveryObservationAndNotInTheCatalogue) {
  Session session = simulate_session(stand(), sixty({})).session;
  const auto find_refusal = [&](const std::string& id, const std::string& formula) -> std::string {
    session.effect_definitions =
        parse_effect_definitions("<handsight_effects version=\"1\"><effect id=\"" + id +
                                     "\"><parameter name=\"a\" sigma=\"1e-3\"/><moves site=\"angle\" by=\"" + formula +
                                     "\"/></effect></handsight_effects>",
                                 "effects.xml");
    try {
      list_own_effects(session, make_chain(session));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(find_refusal("root", "a*log(q)").find("not a finite number at observation"), std::string::npos);
  EXPECT_NE(find_refusal("backlash", "a*q").find("the catalogue has an effect \"backlash\""), std::string::npos);
  EXPECT_EQ(find_refusal("fine", "a*q^3"), "accepted");
}

TEST(EffectDefinitions, AreWrittenAsTheyAreRead) {
  for (const EffectDefinition& d : parse_effect_definitions(samples, "effects.xml")) {
    const std::string text = effect_definition_text(d);
    const EffectDefinition again =
        parse_effect_definitions("<handsight_effects version=\"1\">" + text + "</handsight_effects>", "again.xml")
            .front();
    EXPECT_EQ(effect_definition_text(again), text);
    EXPECT_EQ(again.moves.size(), d.moves.size());
    EXPECT_EQ(again.parameters.back().sigma, d.parameters.back().sigma);
  }
}

}  // namespace
}  // namespace handsight
