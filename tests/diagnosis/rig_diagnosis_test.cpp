// SPDX-License-Identifier: Apache-2.0
// What is missing is named with one camera and with three as it is with two.
#include <gtest/gtest.h>

#include "diagnosis/attribution/error_attribution.h"
#include "diagnosis/outliers/snooping.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "fixtures/rigs.h"

namespace handsight {
namespace {

Session seen_by(int cameras, const std::vector<std::string>& values, std::uint64_t seed, int observations = 60) {
  const Session like = fixture::rig_session(cameras);
  const Chain chain = make_chain(like);
  SimulationOptions o;
  for (const std::string& text : values) add_effect_value(text, like.robot, o.effects, list_own_effects(like, chain));
  o.seed = seed;
  o.observations = observations;
  o.declare_noise = false;
  return simulate_session(like, o).session;
}

DiagnosisOptions quick() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

struct HiddenInARig {
  int cameras;
  std::vector<std::string> values;
  std::string id, where;
};

TEST(RigDiagnosis, NamesWhatIsHiddenAndAtWhichCamera) {
  const std::vector<HiddenInARig> all = {
      {1, {"joint_elasticity:a3.compliance=1e-4"}, "joint_elasticity", "a3"},
      {1,
       {"encoder_eccentricity:a2.sine=2e-3", "encoder_eccentricity:a2.cosine=-1.5e-3"},
       "encoder_eccentricity",
       "a2"},
      {1, {"lens_distortion:cam_0.k1=0.04", "lens_distortion:cam_0.k2=-0.05"}, "lens_distortion", "cam_0"},
      {3, {"rig:cam_2.ry=3e-3", "rig:cam_2.x=1e-3"}, "rig", "cam_2"},
      {3, {"camera_intrinsics:cam_1.fx=5", "camera_intrinsics:cam_1.cx=4"}, "camera_intrinsics", "cam_1"},
      {3, {"joint_elasticity:a3.compliance=1e-4"}, "joint_elasticity", "a3"}};
  for (const HiddenInARig& hidden : all) {
    const Diagnosis d = diagnose(seen_by(hidden.cameras, hidden.values, 7), quick());
    ASSERT_FALSE(d.candidates.empty());
    const DiagnosisCandidate& best = d.candidates.front();
    EXPECT_EQ(best.id, hidden.id) << hidden.cameras << " cameras: " << d.reason;
    EXPECT_NE(d.verdict, Verdict::adequate) << hidden.id;
    EXPECT_EQ(std::count(best.where.begin(), best.where.end(), hidden.where), 1) << hidden.id;
    EXPECT_FALSE(best.explanation.empty());
  }
}

TEST(RigDiagnosis, IsHonestWhenNothingIsMissing) {
  for (const int cameras : {1, 3, 5})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Diagnosis d = diagnose(seen_by(cameras, {}, seed), quick());
      EXPECT_EQ(d.verdict, Verdict::adequate) << cameras << " cameras: " << d.reason;
      for (const std::string& id : d.invisible) EXPECT_NE(id, "stereo_rig");
      for (const DiagnosisCandidate& c : d.candidates) EXPECT_NE(c.id, "stereo_rig");
    }
}

TEST(RigDiagnosis, ImprovesAModelOfThreeCamerasToTheNoise) {
  const Session s = seen_by(3, {"rig:cam_1.ry=4e-3", "joint_elasticity:a3.compliance=1e-4"}, 9, 80);
  const Improvement m = improve(s);
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  std::vector<std::string> added;
  for (const ImprovementStep& step : m.steps) added.push_back(step.added);
  EXPECT_EQ(std::count(added.begin(), added.end(), "rig"), 1);
  EXPECT_EQ(std::count(added.begin(), added.end(), "joint_elasticity"), 1);
}

TEST(RigDiagnosis, AWrongPointIsThatCameras) {
  Session s = seen_by(3, {}, 4);
  Observation& o = s.observations[7];
  CameraPoint* const wrong = seen_by(o.sightings[1], o.sightings[1].in_cameras.back().camera);
  wrong->pixel += Vector2(9, -8);
  const CleanFit clean = clean_fit(s, {});
  ASSERT_EQ(clean.wrong.size(), 1u);
  EXPECT_EQ(clean.wrong[0].id, o.id);
  EXPECT_EQ(clean.wrong[0].marker, o.sightings[1].marker);
  EXPECT_EQ(clean.wrong[0].camera, wrong->camera);
  const std::vector<ObservationAttribution> all = attribute_observations(s, clean.fit);
  for (const ObservationAttribution& b : all)
    if (b.id == o.id) {
      EXPECT_EQ(b.attribution.cause, ErrorCause::cameras);
      EXPECT_EQ(b.change.camera, wrong->camera);
      EXPECT_NE(change_text(b.change, &*s.rig).find(s.rig->at(wrong->camera).name + " image"), std::string::npos);
    }
}

}  // namespace
}  // namespace handsight
