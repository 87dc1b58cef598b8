// SPDX-License-Identifier: Apache-2.0
// What several sessions together show: effects that none of them shows, and what has changed between them.
#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "estimation/report/export.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/prediction.h"
#include "fixtures/touch_session.h"
#include "fixtures/two_arms.h"

namespace handsight {
namespace {

using fixture::find_offset;

SimulationOptions simulation(std::uint64_t seed) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = 40;
  o.noise = 2e-4;
  o.nearest = 0.2;
  o.farthest = 4;
  o.most_turned = 1.5;
  return o;
}

std::vector<std::string> list_names(const Improvement& m) {
  std::vector<std::string> names;
  for (const FittedEffect& e : m.last.model.fit.effects)
    names.push_back(e.term.id + " " + place_name(term_effect(e.term), e.term.place, m.last.model.session.robot));
  return names;
}

std::vector<JoinedMember> two_days(const std::vector<EffectTerm>& august) {
  return fixture::two_days(fixture::hand_session('l'), simulation(31), {}, august);
}

TEST(ImproveCollection, AJointZeroThatChangedBetweenSessionsIsToldAsThat) {
  const Session like = fixture::hand_session('l');
  const Improvement m = improve(joined(two_days({find_offset(like, "l3", 1.5e-3)}), "days"));
  EXPECT_EQ(list_names(m), (std::vector<std::string>{"joint_offset_changed august l3"}));
  EXPECT_EQ(m.last.verdict, Verdict::adequate);
}

/// All fixtures of one day are touched by the same joints.
TEST(ImproveCollection, AJointZeroThatChangedBetweenTouchesIsThatOfTheDay) {
  Session like = fixture::probe_session();
  fixture::add_plates(like);
  fixture::add_sockets(like);
  std::vector<EffectTerm> truth;
  add_effect_value("joint_offset:a3.offset=0.001", like.robot, truth);
  std::vector<JoinedMember> days(2);
  days[0].session = fixture::simulated_touches(like, 80, 6).session, days[0].title = "june";
  days[1].session = fixture::simulated_touches(like, 80, 6, truth).session, days[1].title = "august";
  const Session both = joined(days, "days");
  EXPECT_EQ(list_names(improve(both)), (std::vector<std::string>{"joint_offset_changed august a3"}));
}

TEST(ImproveCollection, NothingIsFoundWhereNothingIsHidden) {
  const Improvement m = improve(joined(two_days({}), "days"));
  EXPECT_TRUE(list_names(m).empty());
  EXPECT_EQ(m.last.verdict, Verdict::adequate);
}

TEST(ImproveCollection, ASlipIsThatOfItsSession) {
  EffectTerm slip = term_of(*find_effect("mount_slip"), -1);
  slip.values = {2e-3, -1e-3, 1e-3, 1e-3, 0, 2e-3, 58};  // of the 80, of which august has the last 40
  const Improvement m = improve(joined(two_days({slip}), "days"));
  EXPECT_EQ(list_names(m), (std::vector<std::string>{"mount_slip august"}));
}

/// What the choice of the effects leaves open stands in the calibration of each session.
TEST(ImproveCollection, EachSessionHasTheDoubtOfAll) {
  const Session like = fixture::hand_session('l');
  EffectTerm scale = term_of(*find_effect("joint_scale"), find_joint(like.robot, "l3"));
  scale.values[0] = 4e-4;
  std::vector<JoinedMember> members = fixture::two_days(like, simulation(32), {scale}, {scale});
  members[1].body = "glued anew";
  const Session s = joined(members, "days");
  const Improvement m = improve(s);
  const ModelUncertainty& model_uncertainty = m.inclusion_probabilities.model_uncertainty;
  const Fit& fit = m.last.model.fit;
  ASSERT_TRUE(model_uncertainty.is_any());
  ASSERT_FALSE(model_uncertainty.others.empty());
  const FitReport reported = report(m.last.model.session, fit, m.last.model_options);
  const Calibration all =
      make_calibration(m.last.model.session, fit, reported, m.last.model_options, "test", model_uncertainty);
  ASSERT_EQ(all.sessions.size(), 2u);
  for (const Calibration& c : all.sessions) {
    ASSERT_TRUE(c.model_uncertainty) << c.session;
    EXPECT_TRUE(c.model_uncertainty->covariance.allFinite());
    EXPECT_GE(c.model_uncertainty->covariance.diagonal().minCoeff(), 0);
    EXPECT_GT(c.model_uncertainty->covariance.diagonal().head(3).maxCoeff(), 0) << "of where the body is on the hand";
  }
  // The doubt of all is reported about the body of the first session.
  const Matrix6 first = all.sessions[0].model_uncertainty->covariance.topLeftCorner(6, 6);
  const Matrix6 of_all = model_uncertainty.covariance.topLeftCorner(6, 6);
  EXPECT_LT((first - of_all).cwiseAbs().maxCoeff(), 1e-9 * of_all.cwiseAbs().maxCoeff());
  const Calibration alone = make_calibration(m.last.model.session, fit, reported, m.last.model_options, "test");
  EXPECT_FALSE(alone.sessions[0].model_uncertainty);
  // Predictions count with it.
  const Chain chain = make_chain(members[1].session);
  const Eigen::VectorXd pose = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(chain.joints.size()), 0.5);
  const auto variance = [&](const Calibration& c) {
    return predict_tcp(chain, pose, prediction_model(c, s.robot)).covariance.diagonal().head<3>().sum();
  };
  EXPECT_GT(variance(all.sessions[1]), variance(alone.sessions[1]));
}

}  // namespace
}  // namespace handsight
