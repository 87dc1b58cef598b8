// SPDX-License-Identifier: Apache-2.0
// Simulated touches: the tip truly stands where the fixture holds it, but for the readings' noise.
#include <gmock/gmock.h>

#include "base/error.h"
#include "chain/touching.h"
#include "fixtures/touch_session.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

Session workbench() {
  Session s = fixture::probe_session();
  fixture::add_plates(s);
  fixture::add_sockets(s);
  fixture::add_fixture(s, &fixtures::line, "edge", {0.4, -0.3, 0.4}, {0.7, 0.5, 0});
  fixture::add_fixture(s, &fixtures::gauge, "dial", {0.6, 0, 0.5}, {0, 1.2, 0});
  fixture::add_fixture(s, &fixtures::length, "bar", {0.2, 0.1, 0.2});
  return s;
}

/// How far what is held is off what was read, of every number, in sigmas.
std::vector<double> off_readings(const SimulatedSession& made) {
  std::vector<double> off;
  const Session& s = made.session;
  for (std::size_t k = 0; k < s.observations.size(); ++k) {
    const Observation& o = s.observations[k];
    const Fixture& fixture = s.fixtures[static_cast<std::size_t>(o.part)];
    const Rigid root_from_fixture = find_mount(s, o.part).mount_from_sensor;  // the stand is the root
    const Vector3 tip = inverse(root_from_fixture) * (made.root_from_tcp[k] * made.markers[k][0]);
    const Sighting& read = o.sightings.front();
    Eigen::VectorXd held = held_by(*fixture.kind, tip);
    held.array() -= touch_value(read);
    for (const double h : held) off.push_back(h / *fixture.sigma);
  }
  return off;
}

TEST(SimulatedTouches, TheTipStandsWhereItIsHeldWithinTheNoise) {
  const Session like = workbench();
  EffectTerm zero = term_of(*find_effect("joint_offset"), find_joint(like.robot, "a2"));
  EffectTerm slack = term_of(*find_effect("backlash"), find_joint(like.robot, "a3"));
  zero.values[0] = 3e-3;
  slack.values[0] = 2e-3;
  const SimulatedSession made = fixture::simulated_touches(like, 160, 3, {zero, slack});
  const std::vector<double> off = off_readings(made);
  ASSERT_EQ(off.size(), 160u + 2 * 40 + 20) << "three numbers a socket, two an edge";
  double squares = 0;
  for (const double o : off) squares += o * o;
  EXPECT_NEAR(squares / static_cast<double>(off.size()), 1, 0.25);
}

TEST(SimulatedTouches, WithoutNoiseNothingIsOff) {
  SimulationOptions options;
  options.observations = 32;
  options.noise = 0;
  Session like = workbench();
  const SimulatedSession made = simulate_session(like, options);
  for (std::size_t k = 0; k < made.session.observations.size(); ++k) {
    const Observation& o = made.session.observations[k];
    const Vector3 tip =
        inverse(find_mount(made.session, o.part).mount_from_sensor) * (made.root_from_tcp[k] * made.markers[k][0]);
    Eigen::VectorXd held = held_by(*made.session.fixtures[static_cast<std::size_t>(o.part)].kind, tip);
    held.array() -= touch_value(o.sightings.front());
    EXPECT_LT(held.norm(), 1e-9);
  }
  EXPECT_FALSE(made.session.fixtures.front().sigma) << "nothing is declared";
}

TEST(SimulatedTouches, EveryFixtureIsTouchedAsOften) {
  const SimulatedSession made = fixture::simulated_touches(workbench(), 80, 4);
  std::vector<int> counts(8, 0);
  for (const Observation& o : made.session.observations) ++counts[static_cast<std::size_t>(o.part)];
  EXPECT_THAT(counts, testing::Each(10));
  EXPECT_NEAR(made.session.distances.front().by, 0.3, 6e-5);
  EXPECT_NE(made.session.distances.front().by, 0.3) << "measured, not known";
}

TEST(SimulatedTouches, WrittenTheyAreASessionThatReadsBack) {
  const SimulatedSession made = fixture::simulated_touches(workbench(), 40, 5);
  const Session back = parse_session(session_text(made.session), "session.xml");
  ASSERT_EQ(back.observations.size(), 40u);
  for (std::size_t k = 0; k < back.observations.size(); ++k) {
    EXPECT_EQ(back.observations[k].position, made.session.observations[k].position);
    EXPECT_EQ(*back.observations[k].sightings.front().point, *made.session.observations[k].sightings.front().point);
  }
}

TEST(SimulatedTouches, AFixtureOutOfReachIsNamed) {
  Session far = fixture::probe_session();
  fixture::add_fixture(far, &fixtures::point, "socket", {4, 0, 0.3});
  EXPECT_THAT([&] { fixture::simulated_touches(far, 4, 1); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("touches the fixture socket")));
}

}  // namespace
}  // namespace handsight
