// SPDX-License-Identifier: Apache-2.0
// One reading that slipped is said to be one, and nothing is added to the model for it.
#include "diagnosis/outliers/lone_observations.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>

#include "base/files.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<LoneObservation> lone_of(const Session& session) { return lone_observations(session, fit(session), {}); }

TEST(LoneObservations, AReadingThatSlippedIsNamedAndNothingIsAddedForIt) {
  Session session = simulated({}, 21, 20);
  session.observations[8].position[1] += 0.4;
  const Improvement m = improve(session, {});
  ASSERT_THAT(m.last.model.lone, SizeIs(1));
  EXPECT_EQ(m.last.model.lone[0].id, session.observations[8].id);
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  EXPECT_THAT(m.steps, SizeIs(1)) << "nothing was added";
  EXPECT_LT(*m.last.report.held_out.rms_pixel, 0.3);
  EXPECT_THAT(m.last.reason, HasSubstr("Look for a wrong reading"));
  EXPECT_EQ(m.last.model.fit.problem.observations.size(), 19u);
}

TEST(LoneObservations, BesideWhatIsMissingBothAreFound) {
  Session session = simulated({{"joint_elasticity", 1, {6e-5}}}, 22);
  session.observations[30].position[1] -= 0.5;
  const Diagnosis d = diagnose(session, {});
  ASSERT_THAT(d.model.lone, SizeIs(1));
  EXPECT_EQ(d.model.lone[0].index, 30);
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity");
}

TEST(LoneObservations, TwoOfVeryDifferentSizes) {
  Session session = simulated({}, 23);
  session.observations[12].position[0] += 0.8;
  session.observations[40].position[2] += 0.03;
  EXPECT_THAT(lone_of(session), SizeIs(2));
}

TEST(LoneObservations, WhatAnEffectDoesIsNoLoneObservation) {
  const std::vector<EffectTerm> hidden[] = {{},
                                            {{"joint_elasticity", 1, {2e-4}}},
                                            {{"backlash", 2, {4e-3}}},
                                            {{"friction_hysteresis", 3, {4e-3}}},
                                            {{"joint_offset", 2, {3e-2}}},
                                            {{"encoder_eccentricity", 4, {2e-2, 1e-2}}},
                                            {{"link_geometry", 2, {5e-3, 0, 2e-2, 0}}}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const std::vector<EffectTerm>& effects : hidden)
      for (const int observations : {14, 60})
        EXPECT_THAT(lone_of(simulated(effects, 100 + seed, observations)), IsEmpty())
            << (effects.empty() ? "nothing" : effects.front().id) << ", seed " << seed << ", " << observations;
}

TEST(LoneObservations, ASlipNearTheEndStaysASlip) {
  const Session session = simulated({{"body_slip", -1, {8e-3, -6e-3, 9e-3, 0.02, 0.03, -0.02, 57}}}, 24);
  EXPECT_THAT(lone_of(session), IsEmpty());
}

TEST(LoneObservations, OfATrackerInMillimetres) {
  Session session = simulated({}, 25, 30, fixture::tracker_session(4));
  session.observations[3].position[2] += 0.3;
  const CleanFit model = fit_without_outliers(session, {});
  ASSERT_THAT(model.lone, SizeIs(1));
  EXPECT_EQ(model.session.observations[3].decision, Decision::excluded);
  EXPECT_THAT(model.fit.notes.back(), HasSubstr("Observation 3 is left out: by what the others say it is off by"));
  EXPECT_THAT(model.fit.notes.back(), HasSubstr(" mm"));
}

/// A marker before a tracker on a flange that is only moved (it turns by a milliradian), and one of whose readings is
/// another point's. Turns of the flange times a body some metres away make up for much of it.
Session moved_and_never_turned(const std::filesystem::path& folder, std::uint64_t seed, int wrong) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Rigid tracker_from_base{rotation_from_rpy({2.6, -0.2, 0.1}), {0.1, -0.4, 0.4}};
  std::string observations;
  for (int i = 0; i < 13; ++i) {
    Rigid flange{rotation_from_rpy({3.0, 0.2, 1.0}), {}};
    for (double& x : flange.translation) x = 0.15 * uniform(random);
    Vector3 turn;
    for (double& x : turn) x = 1e-3 * normal(random);
    flange.rotation = flange.rotation * rotation_from_rpy(turn);
    Vector3 seen = tracker_from_base * (flange * Vector3(0.1, 0.05, 0.2));
    for (double& x : seen) x += 4e-4 * normal(random);
    if (i == wrong) seen += Vector3(0.09, -0.03, 0.12);
    const Eigen::Quaterniond q(flange.rotation);
    observations += fmt::format(
        "<observation id=\"{0}\" time=\"{0}\"><flange_pose xyz=\"{1} {2} {3}\" quaternion=\"{4} {5} {6} {7}\"/><marker "
        "index=\"0\" point=\"{8} {9} {10}\"/></observation>",
        i, flange.translation[0], flange.translation[1], flange.translation[2], q.x(), q.y(), q.z(), q.w(), seen[0],
        seen[1], seen[2]);
  }
  const auto file = folder / "session.xml";
  replace_file(file,
               "<handsight_session version=\"1\" title=\"Moved\"><robot kind=\"poses\" tcp=\"flange\"/><tracker "
               "mount=\"base\"><mount_from_tracker estimate=\"yes\"/></tracker><markers count=\"1\"/><observations>" +
                   observations + "</observations></handsight_session>");
  return read_session(file);
}

TEST(LoneObservations, PullAtAFitThatTheOthersHardlyHold) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const int wrong = static_cast<int>(seed) + 1;
    const std::vector<LoneObservation> lone = lone_of(moved_and_never_turned(folder.path, seed, wrong));
    ASSERT_THAT(lone, SizeIs(1)) << "seed " << seed;
    EXPECT_EQ(lone[0].index, wrong);
    EXPECT_THAT(lone_of(moved_and_never_turned(folder.path, seed, -1)), IsEmpty());
  }
}

}  // namespace
}  // namespace handsight
