// SPDX-License-Identifier: Apache-2.0
// A sensor on the hand before a target on the table: what is predicted, corrected and written is where the hand is.
#include <gtest/gtest.h>

#include "correct/correction.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/hand_end.h"
#include "export/exported.h"
#include "export/rigid/urdf_file.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "fixtures/targets.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

struct Calibrated {
  SimulatedSession simulated;
  CalibratedRobot robot, hand;  // as fitted, and with the end that moves as its hand
};

const EffectTerm wrong_zero{"joint_offset", 1, {8e-3}};

Calibrated calibrated_wrist_camera() {
  SimulationOptions o;
  o.seed = 4;
  o.observations = 40;
  o.noise = 0.2;
  o.effects = {wrong_zero};
  Calibrated c;
  c.simulated = simulate_session(fixture::with_unknown_mount(fixture::eye_in_hand_session()), o);
  FitOptions options;
  for (int j = 1; j < 6; ++j) options.estimated.push_back({"joint_offset", j, {0}});
  const Fit f = fit(c.simulated.session, options);
  c.robot = calibrated_robot(c.simulated.session, f, report(c.simulated.session, f, options), options, "test");
  c.hand = with_moved_hand(c.robot);
  return c;
}

/// Where the hand really is.
Rigid true_hand(const Chain& of_hand, const Eigen::VectorXd& position) {
  const ObservationState c = states_at(of_hand, position);
  return observed_ends(c, moved_sites(c, {wrong_zero})).ends.root_from_tcp;
}

TEST(MovedHand, IsTheLinkThatCarriesTheSensor) {
  const Chain wrist = make_chain(fixture::eye_in_hand_session()), stand = make_chain(fixture::target_session());
  EXPECT_TRUE(hand_carries_sensor(wrist));
  EXPECT_FALSE(hand_carries_sensor(stand));
  EXPECT_EQ(chain_of_hand(wrist).tcp_link, wrist.mount_link);
  EXPECT_EQ(with_moved_hand(CalibratedRobot{.chain = stand, .tcp = "hand", .mount = "stand"}).tcp, "hand");
}

TEST(MovedHand, IsPredictedWhereItIsWithinItsSigma) {
  const Calibrated c = calibrated_wrist_camera();
  EXPECT_EQ(c.hand.tcp, "hand");
  double moved = 0, squares = 0;
  for (const Observation& o : c.simulated.session.observations) {
    const TcpPrediction p = predict_tcp(c.hand.chain, o.position, c.hand.model);
    const Vector3 error = p.root_from_tcp_est.translation - true_hand(c.hand.chain, o.position).translation;
    moved = std::max(moved, (p.root_from_tcp_est.translation - p.root_from_tcp.translation).norm());
    EXPECT_LT(error.norm(), 1e-3);
    EXPECT_LT(p.sigma().head<3>().maxCoeff(), 2e-3);
    squares += error.dot(Matrix3(p.covariance.topLeftCorner<3, 3>()).ldlt().solve(error));
  }
  EXPECT_GT(moved, 2e-3) << "as far as 8 mrad bring it";
  EXPECT_LT(squares / (3.0 * static_cast<double>(c.simulated.session.observations.size())), 4);
}

TEST(MovedHand, IsCorrectedByWhatIsKnown) {
  const Calibrated c = calibrated_wrist_camera();
  const Eigen::VectorXd pose = c.simulated.session.observations[3].position;
  const Rigid wanted = predict_tcp(c.hand.chain, pose, c.hand.model).root_from_tcp;
  const Correction corrected_pose = corrected(states_at(c.hand.chain, pose), c.hand.model);
  ASSERT_TRUE(corrected_pose.reached);
  const double before = (true_hand(c.hand.chain, pose).translation - wanted.translation).norm();
  const double after = (true_hand(c.hand.chain, corrected_pose.position).translation - wanted.translation).norm();
  EXPECT_GT(before, 1e-3);
  EXPECT_LT(after, 0.2 * before);
}

TEST(MovedHand, IsTheSameFromTheWrittenCalibration) {
  const Calibrated c = calibrated_wrist_camera();
  const Calibration read = parse_calibration(readable_text(c.robot.calibration), "wrist.xml");
  const CalibratedRobot there =
      with_moved_hand(calibrated_robot(read, c.simulated.session.robot, "arm.urdf", "wrist.xml"));
  for (int i = 0; i < 5; ++i) {
    const Eigen::VectorXd& pose = c.simulated.session.observations[static_cast<std::size_t>(i)].position;
    const TcpPrediction a = predict_tcp(c.hand.chain, pose, c.hand.model),
                        b = predict_tcp(there.chain, pose, there.model);
    EXPECT_LT(small_motion_between(a.root_from_tcp_est, b.root_from_tcp_est).norm(), 1e-12);
    EXPECT_LT((a.covariance - b.covariance).cwiseAbs().maxCoeff(), 1e-9 * a.covariance.trace());
  }
}

TEST(MovedHand, IsWhatAProgramMoves) {
  const Calibrated c = calibrated_wrist_camera();
  const ExportedFile file = exported_file(c.robot, "python");
  for (const Message& note : file.notes) EXPECT_EQ(note.find("does not move the hand"), std::string::npos) << note;
}

TEST(MovedHand, IsTheHandOfTheUrdf) {
  Calibrated c = calibrated_wrist_camera();
  c.robot.urdf_text = fixture::urdf_text(c.simulated.session.robot);
  c.robot.urdf_file = "arm.urdf";
  const UrdfFile file = urdf_file(c.robot);
  Session calibrated = c.simulated.session;
  calibrated.robot = parse_urdf(file.text, "calibrated.urdf", nullptr);
  calibrated.mount.link = file.hand_link;
  const Chain chain = chain_of_hand(make_chain(calibrated));
  for (int i = 0; i < 5; ++i) {
    const Eigen::VectorXd& pose = c.simulated.session.observations[static_cast<std::size_t>(i)].position;
    const Rigid reported = predict_tcp(c.hand.chain, pose, c.hand.model).root_from_tcp_est;
    const Rigid there = observed_ends(states_at(chain, pose), {}).ends.root_from_tcp;
    EXPECT_LT(small_motion_between(reported, there).norm(), 1e-9)
        << "an offset of a joint's zero is all that was found";
  }
}

}  // namespace
}  // namespace handsight
