// SPDX-License-Identifier: Apache-2.0
// What follows the place of the hand before the sensor has a formula, and a curve of it is a member of the model.
#include "diagnosis/curves/place_formulas.h"

#include <gtest/gtest.h>

#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/report/prediction.h"

namespace handsight {
namespace {

/// Where the sensor has the nominal TCP, an observation a column.
Eigen::Matrix3Xd seen_places(const Problem& problem, const Rigid& mount_from_sensor) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(problem.observations.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    places.col(i) =
        sensor_from_tcp_at(problem.observations[static_cast<std::size_t>(i)], mount_from_sensor).translation;
  return places;
}

TEST(PlaceFormulas, AreTheCamerasDistanceAndImage) {
  Session session = simulated({}, 11, 30);
  for (RigCamera* camera : {&session.rig->at(0), &session.rig->at(1)}) camera->camera.k1 = camera->camera.k2 = 0;
  const Problem problem = make_problem(session, make_chain(session), {}, {});
  const Rigid mount = session.mount.mount_from_sensor;
  const Eigen::Matrix3Xd seen = seen_places(problem, mount);
  const PlaceFormula distance = distance_formula(problem, tcp_places(problem), mount);
  const PlaceFormula column = image_formula(problem, tcp_places(problem), mount, 0),
                     row = image_formula(problem, tcp_places(problem), mount, 1);
  for (Eigen::Index i = 0; i < seen.cols(); ++i) {
    const Vector2 pixel = project(session.rig->at(0).camera, Vector3(seen.col(i)));
    EXPECT_NEAR(distance.values[i], seen(2, i), 5e-4);
    EXPECT_NEAR(column.values[i], pixel.x(), 1);
    EXPECT_NEAR(row.values[i], pixel.y(), 1);
  }
  EXPECT_NE(distance.text.find("tcp_x"), std::string::npos) << distance.text;
}

TEST(PlaceFormulas, AreReadBackFromTheCurvesThatFollowThem) {
  const Session session = simulated({}, 11, 30);
  const Problem problem = make_problem(session, make_chain(session), {}, {});
  const Rigid mount = session.mount.mount_from_sensor;
  for (const PlaceFormula& place :
       {distance_formula(problem, tcp_places(problem), mount), image_formula(problem, tcp_places(problem), mount, 0)}) {
    const std::string u = centred_text(place.text, -0.4, 2);
    EffectDefinition curve;
    curve.moves = {{"hand_x", "x_slope*" + u + " + x_bow*" + u + "^2", 0}};
    EXPECT_EQ(centred_part(curve.moves.front().formula), u);
    const auto followed = followed_place(problem, curve);
    ASSERT_TRUE(followed) << u;
    EXPECT_EQ(followed->text, place.text);
    EXPECT_EQ(followed->values, place.values);
    EXPECT_EQ(formula_text(curve), "hand_x: x_slope*u + x_bow*u^2; u = " + u.substr(1, u.size() - 2));
  }
  EXPECT_EQ(centred_part("sine*sin(((3*q_a1)))"), "");
}

TEST(PlaceFormulas, AreTheWayFromATrackersOrigin) {
  const Session session = simulated({}, 12, 30, fixture::tracker_session(3));
  const Problem problem = make_problem(session, make_chain(session), {}, {});
  const Rigid mount = session.mount.mount_from_sensor;
  const PlaceFormula distance = distance_formula(problem, tcp_places(problem), mount);
  const Eigen::Matrix3Xd seen = seen_places(problem, mount);
  for (Eigen::Index i = 0; i < seen.cols(); ++i) EXPECT_NEAR(distance.values[i], seen.col(i).norm(), 1e-3);
}

/// A shift of the hand that grows with the square of the distance from the middle of the poses.
EffectTerm hidden_bow(const Session& like) {
  const Session poses = simulated({}, 31, 60, like);
  const Problem problem = make_problem(poses, make_chain(poses), {}, {});
  const PlaceFormula distance = distance_formula(problem, tcp_places(problem), poses.mount.mount_from_sensor);
  EffectDefinition d;
  d.id = "hidden_bow";
  d.scope = "session";
  d.parameters = {{"size", "m", 1e-3}};
  d.moves = {{"hand_x", fmt::format("size*(({} - {:.3f})/0.3)^2", distance.text, distance.values.mean()), 0}};
  const auto effect = own_effect(d, like.robot);
  EffectTerm term = term_of(*effect, -1, effect);
  term.values[0] = 2e-3;
  return term;
}

TEST(PlaceFormulas, ACurveOfTheDistanceIsFoundAddedAndPredictedWith) {
  const EffectTerm truth = hidden_bow(like_stand());
  const Session session = simulated({truth}, 32, 80);
  const Improvement m = improve(session, {});
  const std::vector<EffectTerm> terms = list_terms(m.last.model.fit);
  ASSERT_EQ(terms.size(), 1u);
  ASSERT_TRUE(is_curve(terms.front())) << terms.front().id;
  EXPECT_EQ(term_effect(terms.front()).title, "Curve of the distance from the sensor");
  EXPECT_EQ(m.last.verdict, Verdict::unexplained);

  const PredictionModel with = prediction_model(m.last.model.fit);
  PredictionModel of_truth = with;
  of_truth.effects = {truth};
  const Chain chain = make_chain(session);
  double square = 0, moved = 0;
  for (const Observation& o : session.observations) {
    const TcpPrediction found = predict_tcp(chain, o.position, with),
                        true_one = predict_tcp(chain, o.position, of_truth);
    // Of a shift along its own axes a part that is the same everywhere passes for TCP->Body: only what differs counts.
    square += (found.root_from_tcp_est.translation - true_one.root_from_tcp_est.translation).squaredNorm();
    moved += (true_one.root_from_tcp.translation - true_one.root_from_tcp_est.translation).squaredNorm();
  }
  EXPECT_LT(square, 0.25 * moved) << terms.front().own->definition->moves.front().formula;
}

}  // namespace
}  // namespace handsight
