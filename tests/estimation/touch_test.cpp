// SPDX-License-Identifier: Apache-2.0
// A probe touches a plate, a ball's sockets, an edge, a dial gauge; a ball bar is read: the robot is found by them.
#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "diagnosis/selection/improvement.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/session_check.h"
#include "fixtures/two_arms.h"
#include "session/fixtures/list.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

using fixture::find_offset;

const Vector3 tip(0.01, -0.02, 0.15);  // m, in the TCP's frame
constexpr double sigma = 2e-5;         // m, of one reading

/// A robot and what it touches, with a truth of its own.
struct Bench {
  Session session;  // without observations
  std::vector<EffectTerm> truth;
  std::vector<Rigid> frames;  // of the fixtures, truly
};

void add(Bench& b, const FixtureKind* kind, const std::string& id, const Rigid& truly,
         const std::optional<Rigid>& said) {
  Mount mount;
  mount.link = "stand";
  mount.estimate = true;
  mount.known = said.has_value();
  if (said) mount.mount_from_sensor = *said;
  SessionPart part;
  part.title = id;
  part.tcp = "hand";
  part.mount = part.fixture = static_cast<int>(b.session.fixtures.size());
  part.marker_count = 1;
  if (b.session.fixtures.empty())
    b.session.mount = mount;
  else
    b.session.other_mounts.push_back(mount);
  b.session.parts.push_back(part);
  b.session.fixtures.push_back({id, kind, sigma});
  b.frames.push_back(truly);
}

Bench workbench() {
  Bench b;
  b.session = fixture::tracker_session(1);
  b.session.observations.clear();
  b.session.sigma_point = sigma;
  return b;
}

Rigid root_from_tcp(const Chain& chain, const Eigen::VectorXd& q, const std::vector<EffectTerm>& terms) {
  const ObservationState c = states_at(chain, q);
  return observed_ends(c, moved_sites(c, terms)).ends.root_from_tcp;
}

/// How far the tip is from where the fixture wants it, in as many numbers as the fixture holds; `value`: what a gauge
/// or a length is to read.
Eigen::VectorXd off(const FixtureKind* kind, const Vector3& in_frame, double value) {
  if (kind == &fixtures::point) return in_frame;
  if (kind == &fixtures::line) return in_frame.head<2>();
  if (kind == &fixtures::length) return Eigen::VectorXd::Constant(1, in_frame.norm() - value);
  return Eigen::VectorXd::Constant(1, in_frame.z() - value);
}

/// Touches of one fixture in postures that reach it, with the readings' noise.
void touch(Bench& b, std::size_t fixture, int count, std::uint64_t seed, double length = 0.4) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal;
  const Chain chain = make_chain(b.session);
  const FixtureKind* const kind = b.session.fixtures[fixture].kind;
  const Rigid frame_from_root = inverse(b.frames[fixture]);
  for (int made = 0; made < count;) {
    Eigen::VectorXd q(6);
    for (Eigen::Index j = 0; j < 6; ++j) q[j] = 1.2 * uniform(random);
    const double value = kind == &fixtures::length ? length : kind == &fixtures::gauge ? 5e-3 * uniform(random) : 0;
    const auto off_at = [&](const Eigen::VectorXd& at) {
      return off(kind, frame_from_root * (root_from_tcp(chain, at, b.truth) * tip), value);
    };
    bool reached = false;
    for (int step = 0; step < 60 && !reached; ++step) {
      const Eigen::VectorXd e = off_at(q);
      reached = e.norm() < 1e-12;
      Eigen::MatrixXd by(e.size(), 6);
      for (Eigen::Index j = 0; j < 6; ++j) {
        Eigen::VectorXd beside = q;
        beside[j] += 1e-6;
        by.col(j) = (off_at(beside) - e) / 1e-6;
      }
      const Eigen::VectorXd find_step =
          by.transpose() *
          Eigen::MatrixXd(by * by.transpose() + 1e-9 * Eigen::MatrixXd::Identity(e.size(), e.size())).ldlt().solve(-e);
      q += find_step.cwiseMin(0.3).cwiseMax(-0.3);
    }
    const Vector3 there = root_from_tcp(chain, q, b.truth) * tip;
    if (off_at(q).norm() > 1e-9 || q.cwiseAbs().maxCoeff() > 2.5 || there.z() < -0.5) continue;
    ++made;
    Observation o;
    o.id = static_cast<std::int64_t>(b.session.observations.size());
    o.time = static_cast<double>(o.id);
    o.position = q;
    o.part = static_cast<int>(fixture);
    Sighting s{.marker = 0, .point_sigma = sigma};
    s.point = Vector3::Zero();
    const auto noise = [&] { return sigma * normal(random); };
    if (kind == &fixtures::point) {
      const double x = noise(), y = noise(), z = noise();
      s.point = Vector3(x, y, z);
      o.sightings = {s};
    } else if (kind == &fixtures::length) {
      s.point = Vector3(value + noise(), 0, 0);
      s.reading = fixtures::length.numbers.front().reading;
      o.sightings = {s};
    } else if (kind == &fixtures::line) {
      Sighting across = s;
      s.point->x() = noise();
      s.along = Vector3(Vector3::UnitX());
      across.point->y() = noise();
      across.along = Vector3(Vector3::UnitY());
      o.sightings = {s, across};
    } else {
      s.point->z() = value + noise();
      s.along = Vector3(Vector3::UnitZ());
      o.sightings = {s};
    }
    b.session.observations.push_back(o);
  }
}

Rigid at(const Vector3& place, const Vector3& rpy = Vector3::Zero()) { return {rotation_from_rpy(rpy), place}; }

std::vector<EffectTerm> estimated(const Session& s, const std::string& text) {
  const Chain chain = make_chain(s);
  return effect_terms(text, chain, list_own_effects(s, chain));
}

TEST(Touch, APlateInThreePlacesTellsJointZeros) {
  Bench b = workbench();
  b.truth = {find_offset(b.session, "a2", 2e-3), find_offset(b.session, "a3", -1.5e-3)};
  const std::vector<Rigid> plates{at({0.45, 0, 0.25}), at({0.4, 0.3, 0.4}, {0.6, 0.2, 0}),
                                  at({0.6, -0.2, 0.5}, {0, -0.9, 0})};
  for (std::size_t f = 0; f < plates.size(); ++f) {
    add(b, &fixtures::plane, "plate_" + std::to_string(f), plates[f], std::nullopt);
    touch(b, f, 30, 10 + f);
  }
  FitOptions options;
  options.estimated = estimated(b.session, "joint_offset:a2+a3");
  const Fit found = fit(b.session, options);
  ASSERT_TRUE(found.converged());
  EXPECT_NEAR(found.effects[0].term.values[0], 2e-3, 4 * found.effects[0].sigmas[0]);
  EXPECT_NEAR(found.effects[1].term.values[0], -1.5e-3, 4 * found.effects[1].sigmas[0]);
  EXPECT_LT(found.effects[0].sigmas[0], 5e-4);
  ASSERT_TRUE(found.chi2_per_dof);
  EXPECT_NEAR(*found.chi2_per_dof, 1, 0.5);
}

TEST(Touch, EveryKindOfFixtureIsFittedToItsNoise) {
  Bench b = workbench();
  b.truth = {find_offset(b.session, "a2", 2e-3)};
  add(b, &fixtures::plane, "table", at({0.45, 0, 0.25}), std::nullopt);
  add(b, &fixtures::point, "socket", at({0.5, 0.2, 0.3}), std::nullopt);
  add(b, &fixtures::line, "edge", at({0.4, -0.3, 0.4}, {0.7, 0.5, 0}), at({0.41, -0.29, 0.41}, {0.72, 0.48, 0}));
  add(b, &fixtures::gauge, "dial", at({0.6, 0, 0.5}, {0, 1.2, 0}), at({0.6, 0, 0.51}, {0, 1.22, 0}));
  add(b, &fixtures::length, "bar", at({0.2, 0.1, 0.2}), at({0.21, 0.09, 0.2}));
  for (std::size_t f = 0; f < 5; ++f) touch(b, f, 25, 40 + f);
  FitOptions options;
  options.estimated = estimated(b.session, "joint_offset:a2");
  const Fit found = fit(b.session, options);
  ASSERT_TRUE(found.converged());
  EXPECT_NEAR(found.effects[0].term.values[0], 2e-3, 4 * found.effects[0].sigmas[0]);
  ASSERT_TRUE(found.chi2_per_dof);
  EXPECT_NEAR(*found.chi2_per_dof, 1, 0.4);
  EXPECT_NEAR((estimate(found).markers_in_tcp[0] - tip).norm(), 0, 3e-4);
  EXPECT_NEAR((estimate(found).mount(4).translation - b.frames[4].translation).norm(), 0, 3e-4) << "the bar's centre";
  const FitReport reported = report(b.session, found, options);
  EXPECT_NEAR(*reported.fitted.rms_m, sigma, sigma);
}

TEST(Touch, TwoSocketsOfKnownDistanceTellTheRobotsScale) {
  Bench b = workbench();
  EffectTerm longer = term_of(*find_effect("link_geometry"), find_joint(b.session.robot, "a4"));
  longer.values[0] = 1e-3;
  b.truth = {longer};
  add(b, &fixtures::point, "left", at({0.45, 0.15, 0.3}), std::nullopt);
  add(b, &fixtures::point, "right", at({0.45, -0.15, 0.3}), std::nullopt);
  for (std::size_t f = 0; f < 2; ++f) touch(b, f, 40, 70 + f);
  FitOptions options;
  options.estimated = estimated(b.session, "link_geometry:a4");
  const Fit without = fit(b.session, options);
  b.session.distances = {{0, 1, 0.3, 1e-5}};
  const Fit with = fit(b.session, options);
  const auto distance = [](const Fit& f) {
    return (estimate(f).mount(0).translation - estimate(f).mount(1).translation).norm();
  };
  EXPECT_NEAR(distance(with), 0.3, 3e-5);
  EXPECT_NEAR(with.effects[0].term.values[0], 1e-3, 4 * with.effects[0].sigmas[0]);
  const bool says_so = std::any_of(without.notes.begin(), without.notes.end(),
                                   [](const std::string& n) { return n.find("tells a length") != std::string::npos; });
  EXPECT_TRUE(says_so) << "one metre must come from somewhere";
}

/// A plate touched in many postures tells the tip: what means nothing, its turn about its own normal, must not pass
/// for something that is not known of the tip.
TEST(Touch, ATipThatIsDeterminedIsNotSaidNotToBe) {
  Bench b = workbench();
  const std::array<Rigid, 3> places{at({0.45, 0, 0.25}), at({0.4, 0.3, 0.4}, {0.6, 0.2, 0}),
                                    at({0.6, -0.2, 0.5}, {0, -0.9, 0})};
  for (std::size_t f = 0; f < 3; ++f) {
    add(b, &fixtures::plane, "plate_" + std::to_string(f), places[f], std::nullopt);
    touch(b, f, 8, 10 + f);
    const Fit found = fit(b.session, {});
    ASSERT_TRUE(found.converged());
    EXPECT_EQ(undetermined_tip(b.session, found), (std::array<bool, 3>{})) << f + 1 << " plates";
    for (const char untold : undetermined_fixtures(b.session, found)) EXPECT_FALSE(untold) << f + 1 << " plates";
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_LT(found.parameter_covariance(i, i), 1e-4);
  }
}

/// What nothing tells of a plate that is touched once must not pass for something that is not known of the tip.
TEST(Touch, AFixtureThatIsTouchedTooSeldomLeavesTheTipDetermined) {
  for (const int plates : {1, 2}) {
    Bench b = workbench();
    add(b, &fixtures::point, "socket", at({0.45, 0.15, 0.3}), std::nullopt);
    touch(b, 0, 10, 5);
    for (int p = 0; p < plates; ++p) {
      const Rigid plate = at({0.45, 0, 0.25 + 0.1 * p}, {0.3 * p, 0, 0});
      add(b, &fixtures::plane, "plate_" + std::to_string(p), plate, plate);
      touch(b, static_cast<std::size_t>(p) + 1, 1, 6);
    }
    const Fit found = fit(b.session, {});
    ASSERT_TRUE(found.converged());
    EXPECT_EQ(undetermined_tip(b.session, found), (std::array<bool, 3>{})) << plates << " plates";
    std::vector<char> untold(static_cast<std::size_t>(plates) + 1, 1);
    untold[0] = 0;
    EXPECT_EQ(undetermined_fixtures(b.session, found), untold) << plates << " plates";
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_LT(found.parameter_covariance(i, i), 1e-4);
  }
}

TEST(Touch, WhatNothingTellsHasAnUnknownSigma) {
  Bench b = workbench();
  add(b, &fixtures::point, "socket", at({0.45, 0.15, 0.3}), std::nullopt);
  touch(b, 0, 2, 5);  // the hand turned about one axis: along it the tip may be anywhere
  const Fit found = fit(b.session, {});
  const std::array<bool, 3> untold = undetermined_tip(b.session, found);
  EXPECT_TRUE(untold[0] || untold[1] || untold[2]);
  EXPECT_GT((found.parameter_covariance.topLeftCorner<3, 3>().trace()), 1);
  EXPECT_EQ(touches_lacking(b.session), (std::vector<int>{1}));
}

/// Its place would have to follow from a distance alone: three numbers from one.
TEST(Touch, WhatNothingTouchesIsRefusedByName) {
  Bench b = workbench();
  add(b, &fixtures::point, "socket", at({0.45, 0.15, 0.3}), std::nullopt);
  add(b, &fixtures::point, "far", at({0.45, 0.4, 0.3}), at({0.45, 0.4, 0.3}));
  touch(b, 0, 20, 5);
  EXPECT_FALSE(untouched_text(b.session)) << "its place is a guess that nobody asks for";
  b.session.distances = {{0, 1, 0.25, 1e-5}};
  const auto refused = [&](const char* what) {
    try {
      fit(b.session, {});
      ADD_FAILURE() << what;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    ASSERT_EQ(check_session(b.session).problems.size(), 1u);
    EXPECT_NE(check_session(b.session).problems.front().english().find(what), std::string::npos);
  };
  refused("as nothing touches far");
  b.session.distances.clear();
  b.session.other_mounts.front().known = false;
  refused("nothing says where the fixture far is");
}

TEST(Touch, WhatIsHiddenIsNamed) {
  Bench b = workbench();
  b.truth = {find_offset(b.session, "a3", 1.5e-3)};
  add(b, &fixtures::point, "socket_1", at({0.45, 0.2, 0.3}), std::nullopt);
  add(b, &fixtures::point, "socket_2", at({0.5, -0.2, 0.35}), std::nullopt);
  add(b, &fixtures::plane, "table", at({0.45, 0, 0.25}), std::nullopt);
  for (std::size_t f = 0; f < 3; ++f) touch(b, f, 30, 90 + f);
  b.session.distances = {{0, 1, (b.frames[0].translation - b.frames[1].translation).norm(), 1e-5}};
  const Improvement m = improve(b.session);
  ASSERT_FALSE(m.last.model.fit.effects.empty());
  EXPECT_EQ(m.last.model.fit.effects.front().term.id, "joint_offset");
  EXPECT_EQ(m.last.model.fit.effects.front().term.place, find_joint(b.session.robot, "a3"));
  EXPECT_EQ(m.last.model.fit.effects.size(), 1U);
}

}  // namespace
}  // namespace handsight
