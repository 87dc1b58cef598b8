// SPDX-License-Identifier: Apache-2.0
// One labelled observation, images of the others, nothing known of the mount.
#include "estimation/start/mount_search.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "chain/sighting.h"
#include "estimation/online/online.h"
#include "fixtures/arms.h"
#include "session/session_xml.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"
#include "vision/markers/body_candidates.h"
#include "vision/markers/first_observation.h"
#include "vision/markers/following_observation.h"

namespace handsight {
namespace {

Session without_mount(const char* name) {
  Session s = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name);
  s.mount.estimate = true;
  s.mount.known = false;
  s.mount.mount_from_sensor = Rigid{};
  return s;
}

void label(Session& s, std::size_t index, const std::vector<Vector2>& left, const std::vector<Vector2>& right) {
  for (std::size_t m = 0; m < left.size(); ++m)
    s.observations[index].sightings.push_back(seen_at(static_cast<int>(m), left[m], right[m], MarkedBy::hand));
}

/// As `label` would: the pointed corners with their partners.
void label_first_of(Session& s, const std::vector<Vector2>& pointed) {
  const Observation& o = s.observations.front();
  const FirstLabels labels = label_first(make_stereo(*s.rig), detect_corners(read_image(folder(s) / o.images[0])),
                                         detect_corners(read_image(folder(s) / o.images[1])), pointed);
  ASSERT_EQ(labels.refusal, "");
  std::vector<Vector2> left, right;
  for (const LabelledMarker& m : labels.markers) left.push_back(m.left), right.push_back(m.right);
  label(s, 0, left, right);
}

struct Played {
  std::map<std::int64_t, OnlineStep> steps;  // the last word on each
  OnlineStep last;
  Rigid mount_from_sensor;
  bool has_mount = false;
  std::optional<OnlineCalibration::MountProgress> progress;
};

Played play(const Session& s) {
  OnlineCalibration online(s);
  Played played;
  for (const Observation& o : s.observations) {
    ImagePair images;
    const bool has_images = !o.images[0].empty();
    if (has_images) images = {read_image(folder(s) / o.images[0]), read_image(folder(s) / o.images[1])};
    const OnlineStep step = online.add(o, has_images ? &images : nullptr);
    for (const OnlineStep& revised : online.take_revised()) played.steps[revised.id] = revised;
    played.steps[step.id] = step;
    if (step.has_estimate) played.last = step;
  }
  played.progress = online.mount_progress();
  if (!online.estimate()) return played;
  played.mount_from_sensor = online.estimate()->unknowns().mount_from_sensor;
  played.has_mount = true;
  return played;
}

std::size_t taken(const Played& played) {
  return static_cast<std::size_t>(
      std::count_if(played.steps.begin(), played.steps.end(), [](const auto& one) { return one.second.accepted; }));
}

TEST(MountSearch, OneLabelAndTheImagesOfTheOthersSettleAnUnknownMount) {
  Session s = without_mount("first_steps");
  label_first_of(s, {{421, 338}, {408, 411}, {473, 378}});
  const Played played = play(s);
  ASSERT_TRUE(played.has_mount);
  EXPECT_GE(taken(played), 10U) << "of 12";
  const Session truth = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps");
  const Vector6 off = small_motion_between(truth.mount.mount_from_sensor, played.mount_from_sensor);
  // The cameras' noise puts the mount of a dozen observations within a few mm and mrad; a wrong one is a metre off.
  EXPECT_LT(off.head<3>().norm(), 0.02);
  EXPECT_LT(off.tail<3>().norm(), 0.02);
  for (const auto& [id, step] : played.steps) EXPECT_FALSE(step.is_open) << id;
}

/// The markers of every observation among other corners, of which many lie on each other's epipolar lines.
struct Cluttered {
  SimulatedSession made;
  Problem problem;
  KnownMarkers known;
  std::vector<MountWitness> witnesses;
  std::vector<int> right_answers;  // which of a witness's bodies is the true one; -1: none
};

std::vector<Corner> corners_of(const Observation& o, bool left, const Camera& camera, int others,
                               std::mt19937& random) {
  const auto corner = [](const Vector2& px) {
    Corner c;
    c.position = px;
    c.covariance = 0.01 * Eigen::Matrix2d::Identity();
    c.contrast = 100;
    c.edges = {0.3, 1.8};
    return c;
  };
  std::vector<Corner> corners;
  for (const Sighting& s : o.sightings) corners.push_back(corner(seen_by(s, left ? 0 : 1)->pixel));
  std::uniform_real_distribution<double> u(0, camera.width - 1), v(0, camera.height - 1);
  for (int i = 0; i < others; ++i) corners.push_back(corner({u(random), v(random)}));
  return corners;
}

Cluttered cluttered(std::uint64_t seed, int observations, int others, double sag) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = observations;
  options.noise = 0.1;
  if (sag > 0) options.effects = {{"joint_elasticity", 1, {sag}}, {"joint_elasticity", 2, {sag}}};
  Cluttered c;
  c.made = simulate_session(fixture::stand_session(), options);
  Session& s = c.made.session;
  s.mount.estimate = true;
  s.mount.known = false;
  const Chain chain = make_chain(s);
  c.problem = make_problem(s, chain);
  std::mt19937 random(static_cast<unsigned>(seed));
  c.known.in_body.resize(3);
  c.known.sigma.assign(3, 1e-3);
  for (const Sighting& marker : s.observations[0].sightings)
    c.known.in_body[static_cast<std::size_t>(marker.marker)] = triangulate_unweighed(*s.rig, marker)->point;
  for (std::size_t i = 0; i < s.observations.size(); ++i) {
    MountWitness w{c.problem.observations[i], {}, i == 0};
    w.posture.sightings.clear();
    const auto left = corners_of(s.observations[i], true, s.rig->at(0).camera, i == 0 ? 0 : others, random);
    const auto right = corners_of(s.observations[i], false, s.rig->at(1).camera, i == 0 ? 0 : others, random);
    c.right_answers.push_back(-1);
    for (const BodyCandidate& body : body_candidates(make_stereo(*s.rig), left, right, c.known)) {
      SeenBody seen{{}, body.sensor_from_body, body.sigma, body.turn_sigma};
      bool is_true = body.markers.size() == 3;
      for (const MatchedMarker& m : body.markers) {
        seen.sightings.push_back(seen_at(m.marker, left[static_cast<std::size_t>(m.left)].position,
                                         right[static_cast<std::size_t>(m.right)].position, MarkedBy::tracker));
        is_true = is_true && m.left == m.marker && m.right == m.marker;
      }
      if (is_true) c.right_answers.back() = static_cast<int>(w.bodies.size());
      w.bodies.push_back(std::move(seen));
      if (i == 0) break;
    }
    c.witnesses.push_back(std::move(w));
  }
  return c;
}

TEST(MountSearch, AmongAHundredOtherCornersTheTrueOnesAreTaken) {
  for (const double sag : {0.0, 2e-4})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Cluttered c = cluttered(seed, 12, 100, sag);
      const auto found = search_mount(c.problem, c.witnesses, c.known, {});
      ASSERT_TRUE(found) << seed << " sag " << sag;
      int wrong = 0, taken = 0;
      for (std::size_t w = 0; w < c.witnesses.size(); ++w) {
        taken += found->chosen[w] >= 0 ? 1 : 0;
        wrong += found->chosen[w] >= 0 && found->chosen[w] != c.right_answers[w] ? 1 : 0;
      }
      EXPECT_EQ(wrong, 0) << seed << " sag " << sag;
      EXPECT_GE(taken, 8) << seed << " sag " << sag;
      const Vector6 off = small_motion_between(c.made.mount_from_sensor, found->start.mount_from_sensor);
      EXPECT_LT(off.tail<3>().norm(), 0.05) << seed << " sag " << sag;
    }
}

TEST(MountSearch, WhereTheMarkersAreNotSeenNothingAgrees) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Cluttered c = cluttered(seed, 12, 100, 0);
    for (std::size_t w = 1; w < c.witnesses.size(); ++w)
      if (c.right_answers[w] >= 0) c.witnesses[w].bodies.erase(c.witnesses[w].bodies.begin() + c.right_answers[w]);
    EXPECT_FALSE(search_mount(c.problem, c.witnesses, c.known, {})) << seed;
  }
}

TEST(MountSearch, ThreeObservationsAreTooFew) {
  const Cluttered c = cluttered(3, 3, 0, 0);
  EXPECT_FALSE(search_mount(c.problem, c.witnesses, c.known, {}));
  EXPECT_GT(most_telling_witness(c.witnesses), 0);
}

}  // namespace
}  // namespace handsight
