// SPDX-License-Identifier: Apache-2.0
// Touches in a collection, beside sessions of other sensors; what is known of where a fixture stands; what is not
// known.
#include <gmock/gmock.h>

#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/part_fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/part_report.h"
#include "fixtures/touch_session.h"
#include "session/fixtures/list.h"
#include "session/joined.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

EffectTerm find_zero(const Session& s, const std::string& joint, double value) {
  EffectTerm term = term_of(*find_effect("joint_offset"), find_joint(s.robot, joint));
  term.values[0] = value;
  return term;
}

JoinedMember touched(Session like, int count, std::uint64_t seed, const std::string& title, const std::string& body) {
  JoinedMember m;
  m.session = fixture::simulated_touches(like, count, seed, {find_zero(like, "a2", 2e-3), find_zero(like, "a3", -1e-3)})
                  .session;
  m.session.title = m.title = title;
  m.body = body;
  return m;
}

Session plate_session(const Vector3& place, const Vector3& rpy) {
  Session s = fixture::probe_session();
  fixture::add_fixture(s, &fixtures::plane, "plate", place, rpy);
  return s;
}

Fit fit_zeros(const Session& s) {
  const Chain chain = make_chain(s);
  FitOptions o;
  o.estimated = effect_terms("joint_offset:a2+a3", chain, list_own_effects(s, chain));
  return fit(s, o);
}

void expect_truth(const Fit& f) {
  ASSERT_TRUE(f.converged());
  EXPECT_NEAR(f.effects[0].term.values[0], 2e-3, 4 * f.effects[0].sigmas[0]);
  EXPECT_NEAR(f.effects[1].term.values[0], -1e-3, 4 * f.effects[1].sigmas[0]);
  ASSERT_TRUE(f.chi2_per_dof);
  EXPECT_NEAR(*f.chi2_per_dof, 1, 0.5);
}

TEST(TouchTogether, BesideATrackerOfTheSameRobot) {
  Session like = fixture::probe_session();
  fixture::add_plates(like);
  const JoinedMember touches = touched(like, 60, 3, "touches", "");
  JoinedMember tracked;
  SimulationOptions o;
  o.observations = 30;
  o.seed = 4;
  o.noise = 1e-4;
  o.effects = {find_zero(like, "a2", 2e-3), find_zero(like, "a3", -1e-3)};
  tracked.session = simulate_session(fixture::tracker_session(3), o).session;
  tracked.title = "tracker";
  const Session all = joined({tracked, touches}, "both");
  EXPECT_FALSE(all.is_touch());
  ASSERT_EQ(all.parts.size(), 4u);
  EXPECT_EQ(all.parts[2].title, "touches plate_left");
  const Fit together = fit_zeros(all), alone = fit_zeros(touches.session), by_tracker = fit_zeros(tracked.session);
  expect_truth(together);
  EXPECT_LT(together.effects[0].sigmas[0], alone.effects[0].sigmas[0]);
  EXPECT_LT(together.effects[0].sigmas[0], by_tracker.effects[0].sigmas[0]);
  const auto parts = part_reports(all, together, report(all, together, {}));
  EXPECT_NEAR(*parts[1].fitted.rms_m, 2e-5, 1e-5) << "in the probe's own unit";
}

TEST(TouchTogether, APlateHereAndAPlateThere) {
  const JoinedMember here = touched(plate_session({0.45, 0, 0.25}, {}), 40, 5, "here", "probe"),
                     there = touched(plate_session({0.4, 0.3, 0.4}, {0.6, 0.2, 0}), 40, 6, "there", "probe");
  // Two probes are the same only where their tips are: the second is put in the first's place.
  SimulationOptions o;
  o.observations = 40;
  o.seed = 6;
  o.effects = {find_zero(here.session, "a2", 2e-3), find_zero(here.session, "a3", -1e-3)};
  o.markers_in_tcp = fixture::simulated_touches(plate_session({0.45, 0, 0.25}, {}), 40, 5).markers_in_tcp;
  JoinedMember again = there;
  again.session = simulate_session(plate_session({0.4, 0.3, 0.4}, {0.6, 0.2, 0}), o).session;
  const Session all = joined({here, again}, "plates");
  EXPECT_TRUE(all.is_touch()) << "one hand, two places";
  const Fit together = fit_zeros(all);
  expect_truth(together);
  EXPECT_LT(together.effects[0].sigmas[0], 0.85 * fit_zeros(here.session).effects[0].sigmas[0]);
  JoinedMember other_probe = there;
  other_probe.body = "another";
  const Session two = joined({here, other_probe}, "plates");
  EXPECT_FALSE(two.is_touch());
  EXPECT_EQ(two.marker_count, 2);
  expect_truth(fit_zeros(two));
}

TEST(TouchTogether, APartOfACollectionIsFittedByTheRobotOfAll) {
  Session like = fixture::probe_session();
  fixture::add_sockets(like);
  const JoinedMember sockets = touched(like, 40, 8, "sockets", "probe");
  JoinedMember plate = touched(plate_session({0.45, 0, 0.25}, {}), 40, 9, "plate", "other");
  const Session all = joined({sockets, plate}, "both");
  ASSERT_EQ(all.distances.size(), 1u);
  const Fit together = fit_zeros(all);
  expect_truth(together);
  EXPECT_NEAR((estimate(together).mount(all.parts[0].mount).translation -
               estimate(together).mount(all.parts[1].mount).translation)
                  .norm(),
              sockets.session.distances.front().by, 4e-5);
}

TEST(TouchTogether, APlaceThatIsKnownIsKept) {
  Session like = fixture::probe_session();
  fixture::add_fixture(like, &fixtures::point, "socket", {0.48, 0.15, 0.3});
  Session s = fixture::simulated_touches(like, 12, 12).session;
  const Vector3 truly = s.mount.mount_from_sensor.translation;
  s.mount.mount_from_sensor.translation += Vector3(8e-5, -6e-5, 5e-5);
  const Vector3 said = s.mount.mount_from_sensor.translation;
  const auto off = [&](const Fit& f) { return (estimate(f).mount(0).translation - truly).norm(); };
  const auto from_said = [&](const Fit& f) { return (estimate(f).mount(0).translation - said).norm(); };
  const Fit guessed = fit_zeros(s);
  s.fixtures.front().place_sigma = 1e-6;
  const Fit held = fit_zeros(s);
  EXPECT_LT(from_said(held), 1e-5);
  s.fixtures.front().place_sigma = 1e-4;
  const Fit known = fit_zeros(s);
  ASSERT_TRUE(guessed.converged() && held.converged() && known.converged());
  const auto sigma = [](const Fit& f) {
    return std::sqrt(f.parameter_covariance.block<3, 3>(f.problem.mount_column(), f.problem.mount_column()).trace());
  };
  EXPECT_LT(sigma(known), 2e-4);
  EXPECT_LT(sigma(known), sigma(guessed));
  EXPECT_LT(off(known), 4 * sigma(known));
}

TEST(TouchTogether, AKnownPlateIsALengthToo) {
  Session like = fixture::probe_session();
  fixture::add_plates(like);
  Session s = fixture::simulated_touches(like, 60, 14).session;
  const auto says_no_length = [](const Fit& f) {
    return std::any_of(f.notes.begin(), f.notes.end(),
                       [](const std::string& n) { return n.find("tells a length") != std::string::npos; });
  };
  FitOptions o;
  o.estimated = {term_of(*find_effect("link_geometry"), find_joint(s.robot, "a3"))};
  EXPECT_TRUE(says_no_length(fit(s, o)));
  s.fixtures[0].place_sigma = 2e-5;
  EXPECT_FALSE(says_no_length(fit(s, o)));
}

}  // namespace
}  // namespace handsight
