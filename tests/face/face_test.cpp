// SPDX-License-Identifier: Apache-2.0
// What other programs call gives what the rooms behind it give.
#include <gmock/gmock.h>

#include "base/files.h"
#include "handsight/handsight.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

Session sample(const char* name) {
  return read_session(std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/" + name);
}

TEST(Face, FitsByAModelAsByItsTerms) {
  const Session session = sample("hidden_1");
  const Model model = named_model(session, {"joint_offset", "joint_elasticity:" + session.joints[1],
                                            "joint_offset:" + session.joints[2] + ".offset=0.001"});
  const ModelTerms terms = list_terms(model, session);
  ASSERT_EQ(terms.held.size(), 1U);
  EXPECT_EQ(terms.held[0].values[0], 0.001);
  FitOptions options;
  options.effects = terms.held;
  options.estimated = terms.estimated;
  const Fit by_terms = fit(session, options), by_model = fit(session, model);
  EXPECT_EQ((by_terms.tcp_from_body.translation - by_model.tcp_from_body.translation).norm(), 0);
  EXPECT_EQ(by_terms.covariance, by_model.covariance);
  EXPECT_EQ(report(session, by_terms, options).held_out.rms_pixel, report(session, by_model, model).held_out.rms_pixel);

  const Model found = make_model(by_model);
  ASSERT_EQ(found.effects.size(), model.effects.size());
  EXPECT_FALSE(found.effects[0].is_estimated);
  for (std::size_t i = 1; i < found.effects.size(); ++i) {
    EXPECT_TRUE(found.effects[i].is_estimated);
    EXPECT_EQ(found.effects[i].id, model.effects[i].id);
    EXPECT_NE(found.effects[i].values[0], 0) << found.effects[i].id << " " << found.effects[i].place;
  }
}

TEST(Face, FindsWhatIsMissingAndPutsItIntoTheModel) {
  const Session session = sample("hidden_1");
  const Diagnosis found = diagnose(session, Model{});
  ASSERT_EQ(found.verdict, Verdict::missing_effect);
  const Model with = with_candidate({}, found.candidates.front(), session);
  EXPECT_EQ(with.effects.front().id, found.candidates.front().id);
  const FitReport before = report(session, fit(session, Model{}), Model{}),
                  after = report(session, fit(session, with), with);
  EXPECT_LT(*after.held_out.rms_pixel, 0.8 * *before.held_out.rms_pixel);
}

TEST(Face, PredictsAndCorrectsFromAFileAsFromTheSession) {
  const TemporaryFolder folder;
  const Session session = sample("hidden_1");
  const Model model = named_model(session, {"joint_elasticity"});
  const CalibratedRobot robot = calibrated_robot(session, fit(session, model), model);
  save_calibration(folder.path / "c.xml", robot);
  const CalibratedRobot read =
      read_calibrated_robot(folder.path / "c.xml", session.file.parent_path() / session.robot_file);
  const Eigen::VectorXd& position = session.observations[5].position;
  const TcpPrediction a = predict(robot, position), b = predict(read, position);
  EXPECT_LT((a.root_from_tcp_est.translation - b.root_from_tcp_est.translation).norm(), 1e-12);
  EXPECT_GT((a.root_from_tcp_est.translation - a.root_from_tcp.translation).norm(), 1e-4);
  EXPECT_GT(a.sigma().head<3>().minCoeff(), 0);

  const Correction command = correct(read, position);
  EXPECT_TRUE(command.reached);
  EXPECT_GT(command.error_before_m, 1e-4);
  const TcpPrediction there = predict(read, command.position);
  EXPECT_LT((there.root_from_tcp_est.translation - a.root_from_tcp.translation).norm(), 1e-6);
  const Correction to_target = correct(read, position, b.root_from_tcp_est);
  EXPECT_LT((to_target.position - position).norm(), 1e-6);  // it is there already
}

TEST(Face, PredictsManyPosesAsEach) {
  const Session session = sample("hidden_1");
  const CalibratedRobot robot = calibrated_robot(session, fit(session, Model{}), Model{});
  const std::vector<Eigen::VectorXd> positions{session.observations[1].position, session.observations[4].position};
  const std::vector<TcpPrediction> all = predict(robot, positions);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].root_from_tcp_est.translation, predict(robot, positions[1]).root_from_tcp_est.translation);
  EXPECT_EQ(all[1].covariance, predict(robot, positions[1]).covariance);
}

TEST(Face, TakesTheCalibrationToTheRobot) {
  const TemporaryFolder folder;
  const Session session = sample("hidden_1");
  const Model model = named_model(session, {"joint_offset"});
  const CalibratedRobot robot = calibrated_robot(session, fit(session, model), model);
  const ExportedFile urdf = save_robot(folder.path / "calibrated.urdf", robot, "urdf");
  EXPECT_EQ(read_file(folder.path / "calibrated.urdf"), urdf.text);
  ASSERT_TRUE(urdf.left && urdf.nominal);
  EXPECT_LT(*urdf.left, 0.5 * *urdf.nominal);  // the rest is what declared springs bend, which a URDF cannot say
  EXPECT_THAT(export_robot(robot, "cpp").text, HasSubstr("hand_pose"));
  EXPECT_THROW((void)export_robot(robot, "stone tablet"), InputError);
}

TEST(Face, ComparesACalibrationWithALaterSession) {
  const Session session = sample("hidden_1");
  const Model model = named_model(session, {"joint_elasticity"});
  const CalibratedRobot robot = calibrated_robot(session, fit(session, model), model);
  Session later = session;
  for (Observation& o : later.observations) o.position[2] += 0.004;  // the joint's zero is another
  EXPECT_EQ(compare(robot, session).verdict, ComparisonVerdict::unchanged);
  const Comparison found = compare(robot, later);
  EXPECT_NE(found.verdict, ComparisonVerdict::unchanged);
  ASSERT_FALSE(found.changes.empty());
  EXPECT_EQ(found.changes.front().id, "joint_offset");
}

/// The hand is the link that carries the camera, not the board's on the table.
TEST(Face, TellsOfTheHandThatCarriesTheCamera) {
  const Session like = sample("rigs/camera_on_hand");
  SimulationOptions options;
  options.observations = 25;
  Session session = simulate(like, Model{}, options).session;
  session.mount.estimate = true;  // where the camera sits on the hand is what is sought
  const CalibratedRobot robot = calibrated_robot(session, fit(session, Model{}), Model{});
  ASSERT_TRUE(robot.of_hand);
  const TcpPrediction here = predict(robot, session.observations[0].position);
  const TcpPrediction there = predict(robot, session.observations[1].position);
  EXPECT_GT((here.root_from_tcp.translation - there.root_from_tcp.translation).norm(), 1e-3);
  EXPECT_TRUE(correct(robot, session.observations[0].position, here.root_from_tcp_est).reached);
}

TEST(Face, SimulatesTheTruthThatAModelSays) {
  const Session like = sample("hidden_1");
  const Model truth{{{"joint_offset", like.joints[2], {0.004}}}};
  const SimulatedSession simulated = simulate(like, truth);
  const Model model = named_model(simulated.session, {"joint_offset:" + like.joints[2]});
  const Fit found = fit(simulated.session, model);
  EXPECT_NEAR(make_model(found).effects[0].values[0], 0.004, 5 * found.effects[0].sigmas[0]);
  EXPECT_EQ(compare(simulated.session, simulated.session, model).verdict, ComparisonVerdict::unchanged);
}

TEST(Face, RefusesAPositionOfAnotherRobot) {
  const Session session = sample("hidden_1");
  const CalibratedRobot robot = calibrated_robot(session, fit(session, Model{}), Model{});
  const auto refusal = [&](const Eigen::VectorXd& position) -> std::string {
    try {
      (void)predict(robot, position);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(Eigen::VectorXd::Zero(3)), HasSubstr("has 3 numbers; expected 6"));
  EXPECT_THAT(refusal(Eigen::VectorXd::Constant(6, std::nan(""))), HasSubstr("not finite"));
  EXPECT_THROW((void)named_model(session, {"no_such_effect"}), InputError);
}

}  // namespace
}  // namespace handsight
