// SPDX-License-Identifier: Apache-2.0
// Images of a board beside a session: what they say of the cameras is part of the fit.
#include <gtest/gtest.h>

#include <random>

#include "camera_calibration/board_knowledge.h"
#include "chain/body_frame.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "fixtures/drawn.h"
#include "fixtures/rigs.h"

namespace handsight {
namespace {

/// What would be found in images of a board of 9 x 6 corners, held where the cameras look, by these cameras.
DetectedImages board_before(const Rig& rig, double distance, int frames, double sigma, std::uint64_t seed) {
  DetectedImages images;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 9; ++column)
      images.board.points.emplace_back(0.06 * (column - 4), 0.06 * (row - 2.5), 0);
  images.board.camera_count = rig.count();
  images.board.frame_count = frames;
  for (const RigCamera& c : rig.cameras) {
    images.sizes.emplace_back(c.camera.width, c.camera.height);
    images.names.push_back(c.name);
  }
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int frame = 0; frame < frames; ++frame) {
    const auto off = [&] { return fixture::drawn_3([&] { return uniform(random); }); };
    const Vector3 turn = off().cwiseProduct(Vector3(0.6, 0.6, 1)), shift = off().cwiseProduct(Vector3(0.25, 0.2, 0.3));
    const Rigid first_from_board{rotation_from_vector<double>(turn),
                                 {shift.x(), shift.y(), distance * (1 + shift.z())}};
    for (int c = 0; c < rig.count(); ++c) {
      BoardImage image{c, frame, {}};
      const Camera& camera = rig.at(c).camera;
      for (std::size_t i = 0; i < images.board.points.size(); ++i) {
        const Vector3 x = rig.at(c).camera_from_first * (first_from_board * images.board.points[i]);
        const Vector2 noise = fixture::drawn_2([&] { return normal(random); });
        if (x.z() < 0.1) continue;
        const Vector2 pixel = project(camera, x) + sigma * noise;
        if (pixel.x() > 0 && pixel.y() > 0 && pixel.x() < camera.width - 1 && pixel.y() < camera.height - 1)
          image.points.push_back({static_cast<int>(i), pixel, sigma * sigma * Eigen::Matrix2d::Identity()});
      }
      images.board.images.push_back(image);
    }
  }
  return images;
}

struct Case {
  SimulatedSession simulated;
  FitOptions options;
};

/// Few poses before cameras whose focal lengths and middles are not those of the session; the mount is but a guess.
Case few_poses(int cameras, std::uint64_t seed) {
  SimulationOptions o;
  o.observations = 8;
  o.seed = seed;
  Session like = fixture::rig_session(cameras);
  const Chain chain = make_chain(like);
  const OwnEffects own = list_own_effects(like, chain);
  const std::string of = cameras == 2 ? "cam_0_" : "cam_0.";
  for (const char* number : {"fx=3", "fy=3.4", "cx=-4", "cy=2"})
    add_effect_value("camera_intrinsics:" + of + number, like.robot, o.effects, own);
  Case c{simulate_session(like, o), {}};
  c.simulated.session.mount.estimate = true;
  c.options.estimated = effect_terms("camera_intrinsics", chain, own);
  return c;
}

std::vector<double> true_values(const SimulatedSession& s, const Session& session, const FittedEffect& fitted) {
  const Effect& effect = term_effect(fitted.term);
  std::vector<double> values;
  for (const EffectParameter& p : effect.parameters) {
    double value = 0;
    for (int c = 0; c < session.rig->count(); ++c)
      for (const CameraNumber& number : camera_numbers(session.rig->at(c).camera)) {
        const bool is_it = effect.scope == EffectScope::camera ? fitted.term.place == c && p.name == number.name
                                                               : p.name == session.rig->at(c).name + "_" + number.name;
        if (is_it) value = s.true_rig->at(c).camera.*number.value - session.rig->at(c).camera.*number.value;
      }
    values.push_back(value);
  }
  return values;
}

TEST(CameraImages, TheCamerasAreKnownBetterAndTheTruthIsCovered) {
  for (const int cameras : {1, 2}) {
    double squares = 0, body = 0, shares = 0;
    int numbers = 0;
    constexpr int seeds = 12;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Case c = few_poses(cameras, seed);
      const Session& session = c.simulated.session;
      const Fit alone = fit(session, c.options);
      c.options.camera_images = std::make_shared<CameraKnowledge>(
          board_knowledge(board_before(*c.simulated.true_rig, 1.3, 14, 0.2, 50 + seed), *session.rig));
      const Fit both = fit(session, c.options);
      EXPECT_TRUE(both.converged());
      for (std::size_t e = 0; e < both.effects.size(); ++e) {
        const std::vector<double> truth = true_values(c.simulated, session, both.effects[e]);
        for (std::size_t k = 0; k < truth.size(); ++k) {
          EXPECT_LT(both.effects[e].sigmas[k], alone.effects[e].sigmas[k]);
          const double off = (both.effects[e].term.values[k] - truth[k]) / both.effects[e].sigmas[k];
          squares += off * off;
          ++numbers;
        }
        shares += both.effects[e].sigmas[0] / alone.effects[e].sigmas[0];
      }
      const Matrix3 placed_both = both.covariance.topLeftCorner<3, 3>();
      const Matrix3 placed_alone = alone.covariance.topLeftCorner<3, 3>();
      EXPECT_LT(placed_both.trace(), placed_alone.trace());
      const Vector6 xi =
          small_motion_between(body_frame(both.sides, c.simulated.markers_in_tcp).tcp_from_body, both.tcp_from_body);
      body += xi.dot(both.covariance.ldlt().solve(xi));
      EXPECT_LT(disagreement(*c.options.camera_images, *both.problem.rig), 60) << "chi-squared of 8 or 22 numbers";
    }
    if (cameras == 1) {  // of two the poses alone tell the focal lengths better
      EXPECT_LT(shares / seeds, 0.6) << "the focal length";
    }
    // Chi-squared of 6 a seed; the cameras' numbers are correlated: twice the spread of independent ones is allowed.
    EXPECT_NEAR(body, 6 * seeds, 4.5 * std::sqrt(2.0 * 6 * seeds)) << cameras;
    EXPECT_NEAR(squares, numbers, 2 * 4.5 * std::sqrt(2.0 * numbers)) << cameras;
  }
}

/// Where the session says nothing the images do: their own minimum and covariance come out.
TEST(CameraImages, WhatTheySayIsTheirMinimumWithTheNumbersThatStay) {
  const Rig rig = *fixture::rig_session(2).rig;
  Rig truth = rig;
  truth.at(0).camera.fx += 5;
  truth.at(1).camera.cy -= 3;
  truth.at(1).camera_from_first =
      small_motion<double>((Vector6() << 1e-3, 0, -1e-3, 0, 2e-3, 0).finished()) * truth.at(1).camera_from_first;
  const CameraKnowledge k = board_knowledge(board_before(truth, 1.3, 20, 1e-6, 3), rig);
  EXPECT_LT(change_of_rig(truth, k.rig).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_EQ(k.numbers, 6 + 2 * 8);
  EXPECT_GT(disagreement(k, rig), 1e6);
  // A number that is no effect's stays as the session has it: the others make up for it as well as they can.
  Rig other = truth;
  for (RigCamera& c : other.cameras) c.camera.k3 += 0.01;
  const CameraKnowledge bent = board_knowledge(board_before(other, 1.3, 20, 0.1, 3), rig);
  EXPECT_GT(bent.residual, 0);
  const Eigen::VectorXd best = -bent.information.ldlt().solve(bent.pull);
  const double least = bent.residual + bent.pull.dot(best);
  EXPECT_GE(least, -1e-6);
  EXPECT_LT(least, bent.residual);
}

template <class Do>
std::string refusal(const Do& act) {
  try {
    act();
  } catch (const InputError& error) {
    EXPECT_GE(std::string(error.what()).size(), 20U);
    EXPECT_LE(std::string(error.what()).size(), 600U);
    return error.what();
  }
  return {};
}

TEST(CameraImages, OfAnotherCameraAreRefused) {
  const Session session = few_poses(2, 1).simulated.session;
  DetectedImages images = board_before(*session.rig, 1.3, 14, 0.2, 1);
  images.sizes[1] = {1280, 1024};
  EXPECT_NE(refusal([&] { board_knowledge(images, *session.rig); }).find("1280 x 1024"), std::string::npos);
  images = board_before(*session.rig, 1.3, 14, 0.2, 1);
  images.board.images.resize(2);  // one pose
  for (BoardImage& image : images.board.images)
    std::erase_if(image.points, [](const TargetPixel& p) {
      return p.number != 0 && p.number != 8 && p.number != 45 && p.number != 53;  // the board's own corners stay
    });
  const std::string too_few = refusal([&] { board_knowledge(images, *session.rig); });
  EXPECT_NE(too_few.find("do not determine"), std::string::npos) << too_few;
  images.board.images.clear();
  EXPECT_NE(refusal([&] { board_knowledge(images, *session.rig); }).find("in none of the board images"),
            std::string::npos);
  GroupedImages three;
  for (const char* name : {"a", "b", "c"}) three.cameras.push_back({name, {}, {}});
  EXPECT_NE(refusal([&] { group_by_cameras(three, *session.rig); }).find("3 cameras (a, b, c)"), std::string::npos);
  three.cameras.pop_back();
  EXPECT_EQ(group_by_cameras(three, *session.rig).notes.size(), 2U) << "by their order, which is said";
  three.cameras[0].name = "cam_1", three.cameras[1].name = "cam_0";
  EXPECT_EQ(group_by_cameras(three, *session.rig).cameras[0].name, "cam_0");
  FitOptions nothing_moves;
  nothing_moves.camera_images =
      std::make_shared<CameraKnowledge>(board_knowledge(board_before(*session.rig, 1.3, 14, 0.2, 1), *session.rig));
  EXPECT_NE(refusal([&] { fit(session, nothing_moves); }).find("--effects camera_intrinsics"), std::string::npos);
}

}  // namespace
}  // namespace handsight
