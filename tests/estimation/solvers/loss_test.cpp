// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/loss.h"

#include <gtest/gtest.h>

#include "estimation/body_error.h"
#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

TEST(Loss, WeightAndCurvatureAreItsSlopes) {
  for (const Loss loss : {Loss::none, Loss::huber, Loss::cauchy})
    for (const int rows : {2, 3, 4, 6})
      for (const double s : {0.1, 3.0, 20.0, 500.0}) {
        const double h = 1e-5 * s;
        const LossValue at = loss_at(loss, s, rows, 0.7);
        const LossValue more = loss_at(loss, s + h, rows, 0.7), less = loss_at(loss, s - h, rows, 0.7);
        EXPECT_NEAR(at.weight, (more.cost - less.cost) / (2 * h), 1e-8);
        EXPECT_NEAR(at.curvature, (more.weight - less.weight) / (2 * h), 1e-8);
        EXPECT_LE(at.cost, s * (1 + 1e-15));
      }
}

SimulatedSession with_wrong_corners(std::uint64_t seed) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = 40;
  SimulatedSession s = simulate_session(fixture::stand_session(), options);
  for (const std::size_t k : {3, 11, 20, 31}) seen_by(s.session.observations[k].sightings[1], 0)->pixel.x() += 25;
  return s;
}

SimulatedSession with_wrong_poses(std::uint64_t seed) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = 40;
  SimulatedSession s = simulate_session(fixture::stand_session(), options);
  for (const std::size_t k : {3, 11, 20, 31})
    for (Sighting& sighting : s.session.observations[k].sightings) {
      seen_by(sighting, 0)->pixel.y() += 25;
      seen_by(sighting, 1)->pixel.y() += 25;
    }
  return s;
}

TEST(RobustFit, StandsWhatIsWrongByEveryObjectiveWhateverIsDeclared) {
  SimulationOptions same;
  same.seed = 10;
  same.observations = 40;
  const Session clean = simulate_session(fixture::stand_session(), same).session;
  for (const bool declares : {true, false})
    for (const Objective objective : {Objective::image, Objective::camera, Objective::angle_axis}) {
      // The angle-axis objective weighs whole poses: there whole poses are wrong.
      Session session = (objective == Objective::angle_axis ? with_wrong_poses(10) : with_wrong_corners(10)).session;
      if (!declares) session.sigma_pixel.reset();
      const auto drawn_off = [&](Loss loss) {
        const Fit f = fit(session, {.objective = objective, .loss = loss});
        EXPECT_TRUE(f.converged());
        const Fit without = fit(clean, {.objective = objective, .loss = loss});
        return small_motion_between(without.tcp_from_body, f.tcp_from_body).norm();
      };
      const double plain = drawn_off(Loss::none);
      // The wrong poses bend the average shape a little, which no loss on poses mends.
      const double most = objective == Objective::angle_axis ? 0.75 : 0.6;
      for (const Loss loss : {Loss::huber, Loss::cauchy})
        EXPECT_LT(drawn_off(loss), most * plain)
            << declares << " objective " << static_cast<int>(objective) << " loss " << static_cast<int>(loss);
    }
}

TEST(RobustFit, ItsNoiseIsInTheUnitOfItsResiduals) {
  const SimulatedSession s = with_wrong_corners(10);
  EXPECT_NEAR(fit(s.session, {.loss = Loss::huber}).loss_noise, 0.2, 1e-12) << "px";
  const double metres = fit(s.session, {.objective = Objective::camera, .loss = Loss::huber}).loss_noise;
  EXPECT_GT(metres, 5e-5);
  EXPECT_LT(metres, 5e-3) << "0.2 px at a metre, a baseline of 0.18 m and a focal length of 820 px";
}

/// Over many draws of the noise and of where corners are wrong, the errors scatter as the covariance says.
TEST(RobustFit, ItsCovarianceIsThatOfItsErrors) {
  constexpr int draws = 150;
  for (const Loss loss : {Loss::huber, Loss::cauchy}) {
    double squares = 0;
    for (int i = 0; i < draws; ++i) {
      SimulationOptions options;
      options.seed = static_cast<std::uint64_t>(100 + i);
      options.observations = 40;
      options.wrong_corners = 0.05;
      const SimulatedSession s = simulate_session(fixture::stand_session(), options);
      const Fit f = fit(s.session, {.loss = loss});
      const Vector3 off = body_error(s, f).head<3>();
      squares += off.dot(Matrix3(f.covariance.topLeftCorner<3, 3>()).inverse() * off) / 3 / draws;
    }
    // A sandwich of 40 observations is itself uncertain, which lengthens the mean by some 10 %.
    EXPECT_GT(squares, 0.75) << static_cast<int>(loss);
    EXPECT_LT(squares, 1.4) << static_cast<int>(loss);
  }
}

}  // namespace
}  // namespace handsight
