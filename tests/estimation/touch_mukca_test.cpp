// SPDX-License-Identifier: Apache-2.0
// A ball at the hand of real robots, put into the two sockets of one fixture again and again: as touches. Against the
// figures that the authors of the measurements published of their own optimiser. Skipped where the sets are not there.
#include <gtest/gtest.h>

#include <filesystem>

#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/report/fit_report.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

const std::filesystem::path sets = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real";

/// The set's points are those of a tracker that the sockets stand for, 50 mm apart along x.
Session as_touches(const std::string& set) {
  Session s = read_session(sets / set);
  s.source.reset();
  const std::string link = s.mount.link;
  for (int f = 0; f < 2; ++f) {
    SessionPart part;
    part.title = f == 0 ? "socket_1" : "socket_2";
    part.tcp = s.tcp;
    part.mount = part.fixture = f;
    part.marker_count = 1;
    s.parts.push_back(part);
    s.fixtures.push_back({part.title, &fixtures::point, s.sigma_point});
  }
  const Mount mount{link, Rigid{}, true, false};
  s.mount = mount;
  s.other_mounts = {mount};
  s.distances = {{0, 1, 0.05, 1e-4}};
  for (Observation& o : s.observations) {
    o.part = o.sightings.front().point->x() > 0.025 ? 1 : 0;
    o.sightings = touch_sightings(s.fixtures[static_cast<std::size_t>(o.part)], 0, 0);
  }
  return s;
}

struct Set {
  const char* name;
  double published_mm;  // mean distance of the ball from its socket, in poses that were not trained on
};

class Mukca : public testing::TestWithParam<Set> {};

TEST_P(Mukca, HeldOutNoWorseThanTheAuthorsOptimiser) {
  if (!std::filesystem::exists(sets / GetParam().name)) GTEST_SKIP() << "the measurements are not here";
  const Session s = as_touches(GetParam().name);
  const Chain chain = make_chain(s);
  FitOptions o;
  o.estimated = effect_terms("link_geometry", chain, list_own_effects(s, chain));
  const Fit f = fit(s, o);
  ASSERT_TRUE(f.converged());
  const FitReport r = report(s, f, o);
  ASSERT_TRUE(r.held_out.mean_m && r.fitted.mean_m);
  RecordProperty("held_out_um", static_cast<int>(1e6 * *r.held_out.mean_m));
  std::printf("%s: fitted %.3f mm, held out %.3f mm (published %.3f)\n", GetParam().name, 1e3 * *r.fitted.mean_m,
              1e3 * *r.held_out.mean_m, GetParam().published_mm);
  EXPECT_LE(1e3 * *r.held_out.mean_m, GetParam().published_mm);
}

INSTANTIATE_TEST_SUITE_P(All, Mukca,
                         testing::Values(Set{"mukca_panda_6", 0.262}, Set{"mukca_kuka_14", 0.268},
                                         Set{"mukca_panda_2", 0.440}),
                         [](const auto& param) { return std::string(param.param.name); });

/// Where the fitted robot has the ball in the root's frame.
Vector3 ball(const Session& s, const Observation& o, const std::vector<EffectTerm>& terms, const Vector3& tip) {
  const Chain chain = make_chain(s);
  const ObservationState c = states_at(chain, o.position);
  const ObservedEnds seen = observed_ends(c, moved_sites(c, terms));
  return seen.ends.root_from_tcp * tip;
}

TEST(MukcaElsewhere, ARobotLearnedAtOneFixtureIsRightAtTheOthers) {
  if (!std::filesystem::exists(sets / "mukca_panda_2_sockets")) GTEST_SKIP() << "the measurements are not here";
  const Session s = as_touches("mukca_panda_2");
  const Chain chain = make_chain(s);
  FitOptions o;
  o.estimated = effect_terms("link_geometry", chain, list_own_effects(s, chain));
  const Fit f = fit(s, o);
  // There the sockets ride on the base as markers and the ball is the sensor.
  Session elsewhere = read_session(sets / "mukca_panda_2_sockets");
  std::vector<std::vector<Vector3>> at(static_cast<std::size_t>(elsewhere.marker_count));
  for (const Observation& from : elsewhere.observations) {
    Observation moved = from;
    ASSERT_EQ(elsewhere.joints, s.joints);
    at[static_cast<std::size_t>(from.sightings.front().marker)].push_back(
        ball(s, moved, list_terms(f), estimate(f).markers_in_tcp.front()));
  }
  double sum = 0;
  int count = 0;
  for (const auto& socket : at) {
    if (socket.size() < 2) continue;
    Vector3 mean = Vector3::Zero();
    for (const Vector3& x : socket) mean += x / static_cast<double>(socket.size());
    for (const Vector3& x : socket) {
      sum += (x - mean).norm();
      ++count;
    }
  }
  ASSERT_GT(count, 100);
  std::printf("panda_2 at all fixtures: mean %.3f mm from the socket's mean (published 0.440)\n", 1e3 * sum / count);
  EXPECT_LT(sum / count, 0.44e-3);
}

}  // namespace
}  // namespace handsight
