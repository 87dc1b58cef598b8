// SPDX-License-Identifier: Apache-2.0
// A robot that errs by a millimetre before a camera that hardly does: what is wrong is weighed as it is.
#include "estimation/solvers/flange_error.h"

#include <gtest/gtest.h>

#include "estimation/fit/fit.h"
#include "estimation/fit/flange_error_size.h"
#include "estimation/solvers/normal_equations.h"
#include "fixtures/hand_eye.h"

namespace handsight {
namespace {

Vector6 error_of(const fixture::HandEye& h, const Fit& f) {
  return small_motion_between(h.flange_from_camera, estimate(f).mount_from_sensor);
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
    const Vector6 off = error_of(h, f);
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
  EXPECT_GT(inside, 0.88 * numbers);
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
  const Vector6 weights = flange_error_weights(problem.flange_error, problem.noise);
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  EXPECT_LT(eliminated.cost, plain.cost);
  for (int i = 0; i < 50; ++i) {
    Vector6 motion;
    motion << 1e-3 * fixture::drawn_3([&] { return normal(random); }),
        1e-3 * fixture::drawn_3([&] { return normal(random); });
    const Eigen::VectorXd step = markers_by_flange(problem, o, estimate(f)) * motion;
    const double cost = plain.cost - 2 * step.dot(plain.gradient.head(step.size())) +
                        step.dot(plain.information.topLeftCorner(step.size(), step.size()) * step) +
                        motion.dot(weights.cwiseProduct(motion));
    EXPECT_GE(cost, eliminated.cost * (1 - 1e-9));
  }
}

}  // namespace
}  // namespace handsight
