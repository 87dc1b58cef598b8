// SPDX-License-Identifier: Apache-2.0
// A robot that errs by a millimetre before a camera that hardly does: what is wrong is weighed as it is.
#include "estimation/solvers/flange_error.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "estimation/body_error.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/flange_error_size.h"
#include "estimation/solvers/normal_equations.h"
#include "fixtures/erring_robot.h"
#include "fixtures/hand_eye.h"

namespace handsight {
namespace {

using fixture::ErringRig;

/// In the camera's own frame, as the covariance.
Vector6 compute_error(const fixture::HandEye& h, const Fit& f) {
  return small_motion_between(inverse(estimate(f).mount_from_sensor), inverse(h.flange_from_camera));
}

TEST(FlangeError, IsFoundAsLargeAsItIs) {
  const fixture::HandEye h = fixture::hand_eye({.poses = 40, .seed = 3});
  const Fit f = fit(h.session);
  ASSERT_TRUE(f.converged());
  EXPECT_NEAR(f.problem.flange_error.place, 1e-3, 3e-4);
  EXPECT_NEAR(f.problem.flange_error.turn, 3e-3, 8e-4);
}

TEST(FlangeError, IsNoneWhereTheRobotIsRight) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const fixture::HandEye h = fixture::hand_eye({.poses = 10, .place = 0, .turn = 0, .seed = seed});
    EXPECT_FALSE(fit(h.session).problem.flange_error.is_any()) << seed;
  }
}

/// Twenty robots of eight poses: nearer to the truth than where every pixel counts alike, and as sure as is said.
TEST(FlangeError, WeighsTheRobotAsItErrs) {
  double weighed = 0, plain = 0;
  int inside = 0, numbers = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const fixture::HandEye h = fixture::hand_eye({.seed = seed});
    const Fit f = fit(h.session);
    ASSERT_TRUE(f.converged());
    const Vector6 off = compute_error(h, f);
    weighed += off.head<3>().squaredNorm();
    const Eigen::Index mount = f.problem.mount_column();
    for (int i = 0; i < 6; ++i) {
      inside += std::abs(off[i]) < 1.96 * std::sqrt(f.parameter_covariance(mount + i, mount + i));
      ++numbers;
    }
    Problem alike = f.problem;
    alike.flange_error = {};
    plain += small_motion_between(h.flange_from_camera,
                                  solve(alike, estimate(f), {.fixed_body = true}).unknowns.mount_from_sensor)
                 .head<3>()
                 .squaredNorm();
  }
  EXPECT_LT(weighed, 0.5 * plain);
  EXPECT_GT(inside, 0.9 * numbers);
}

/// Where few poses are fitted best, pixel by pixel, far from where the robot's error leads, its size is found all the
/// same.
TEST(FlangeError, OfARobotThatErrsMuchIsFoundFromFewPoses) {
  for (const std::uint64_t seed : {109, 111, 112, 132, 146}) {
    const fixture::HandEye h = fixture::hand_eye({.poses = 4, .place = 3e-3, .turn = 9e-3, .seed = seed});
    const Fit f = fit(h.session);
    EXPECT_TRUE(f.problem.flange_error.is_any()) << seed;
    EXPECT_LT(compute_error(h, f).head<3>().norm(), 0.035) << seed;  // 0.04 to 0.12 m where pixels count alike
  }
}

/// Elimination against the same sum with the motions as unknowns.
TEST(FlangeError, EliminatedIsAsSolvedFor) {
  const fixture::HandEye h = fixture::hand_eye({.poses = 5, .seed = 2});
  Fit f = fit(h.session);
  Problem problem = f.problem;
  problem.flange_error = {2e-3, 1e-3};
  problem.noise = 0.15;
  const ProblemObservation& o = problem.observations[2];
  NormalEquations plain(problem.columns()), eliminated(problem.columns());
  add_observation(problem, o, estimate(f), plain);
  complete(plain);
  add_without_flange_error(problem, o, estimate(f), plain, eliminated);
  // The cost is the least of all motions: no motion that is tried lies below it.
  const Matrix6 covariance = make_covariance(flange_error_shares(problem, o), problem.flange_error);
  const Matrix6 weights = problem.noise * problem.noise * covariance.inverse();
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  EXPECT_LT(eliminated.cost, plain.cost);
  for (int i = 0; i < 50; ++i) {
    Vector6 motion;
    motion << 1e-3 * fixture::drawn_3([&] { return normal(random); }),
        1e-3 * fixture::drawn_3([&] { return normal(random); });
    const Eigen::VectorXd step = markers_by_motion(problem, o, estimate(f)) * motion;
    const double cost = plain.cost - 2 * step.dot(plain.gradient.head(step.size())) +
                        step.dot(plain.information.topLeftCorner(step.size(), step.size()) * step) +
                        motion.dot(weights * motion);
    EXPECT_GE(cost, eliminated.cost * (1 - 1e-9));
  }
}

/// A root of what is singular, too: few joints move a hand in few ways.
TEST(FlangeError, HasARootOfASingularCovariance) {
  Vector6 a, b;
  a << 1, 2, 3, 4, 5, 6;
  b << -1, 0.5, 0, 2, 0, 1;
  const Matrix6 covariance = 1e-6 * (a * a.transpose() + b * b.transpose());
  const Matrix6 root = root_of_covariance(covariance);
  EXPECT_LT((root * root.transpose() - covariance).cwiseAbs().maxCoeff(), 1e-12 * covariance.maxCoeff());
}

TEST(FlangeError, OfJointsIsFoundAsLargeAsItIs) {
  for (const ErringRig rig : {ErringRig::markers, ErringRig::board, ErringRig::camera_on_hand}) {
    const auto s = fixture::erring_robot(rig, {.poses = 40, .joints = 1e-3, .seed = 4});
    const Fit f = fit(s.session);
    ASSERT_TRUE(f.converged());
    EXPECT_NEAR(f.problem.flange_error.turn, 1e-3, 2.5e-4);
    EXPECT_LT(f.problem.flange_error.place, 2e-4);
  }
}

TEST(FlangeError, OfARobotWithJointsThatIsRightIsNone) {
  for (const ErringRig rig : {ErringRig::markers, ErringRig::board, ErringRig::camera_on_hand})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto s = fixture::erring_robot(rig, {.poses = 12, .seed = seed});
      const Fit f = fit(s.session), plain = fit(s.session, {.smallest_step = 1e-11});
      EXPECT_FALSE(f.problem.flange_error.is_any()) << seed;
      const Vector6 off = small_motion_between(plain.tcp_from_body, f.tcp_from_body);
      for (int i = 0; i < 6; ++i) EXPECT_LE(std::abs(off[i]), 1e-3 * std::sqrt(plain.covariance(i, i)));
    }
}

/// Robots with joints, of 8 poses to 25: nearer to the truth than where every pixel counts alike, and as sure as is
/// said.
TEST(FlangeError, OfJointsIsWeighed) {
  for (const ErringRig rig : {ErringRig::markers, ErringRig::board}) {
    double weighed = 0, plain = 0;
    int inside = 0, numbers = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const int poses = 8 + static_cast<int>(seed) % 3 * 8;
      const auto s = fixture::erring_robot(rig, {.poses = poses, .joints = 2e-3, .seed = seed});
      const Fit f = fit(s.session);
      ASSERT_TRUE(f.converged());
      const Vector6 off = body_error(s, f);
      weighed += off.head<3>().squaredNorm();
      plain += body_error(s, fit(s.session, {.smallest_step = 1e-11})).head<3>().squaredNorm();
      for (int i = 0; i < 6; ++i) inside += std::abs(off[i]) < 1.96 * std::sqrt(f.covariance(i, i));
      numbers += 6;
    }
    EXPECT_LT(weighed, 0.8 * plain);
    EXPECT_GT(inside, 0.9 * numbers);
  }
}

}  // namespace
}  // namespace handsight
