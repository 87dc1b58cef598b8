// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "cli/cli_runner.h"
#include "diagnosis/refitting.h"
#include "fixtures/arms.h"
#include "session/csv.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

SimulatedSession simulated(const Session& like, int observations, std::uint64_t seed,
                           const std::vector<EffectTerm>& effects = {}) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  o.effects = effects;
  return simulate_session(like, o);
}

/// Where the truth puts the markers in the sensor's frame in any pose (at rest).
std::vector<Vector3> true_markers(const SimulatedSession& s, const Chain& chain, const Eigen::VectorXd& position) {
  const Circumstances c = circumstances_at(chain, position);
  const Rigid left_from_tcp = sensor_from_tcp(observed_ends(c, moved_sites(c, s.effects)).ends, s.mount_from_sensor);
  std::vector<Vector3> all;
  for (const Vector3& m : s.markers_in_tcp) all.push_back(left_from_tcp * m);
  return all;
}

/// The session with the truth's measurements in these poses added.
Session measured(const SimulatedSession& s, Session session, const std::vector<Eigen::VectorXd>& poses, Random random) {
  const Chain chain = chain_of(s.session);
  for (const Eigen::VectorXd& pose : poses) {
    Observation o;
    o.id = session.observations.back().id + 1;
    o.time = session.observations.back().time + 4;
    o.position = pose;
    int marker = 0;
    for (const Vector3& x : true_markers(s, chain, pose)) {
      Sighting sighting{marker++, {}, {}, {}, MarkedBy::import};
      if (session.stereo) {
        const auto noisy = [&](const Vector2& p) {
          const double u = random.gaussian(), v = random.gaussian();
          return Vector2(p + s.noise * Vector2(u, v));
        };
        sighting.left = noisy(project(session.stereo->left, x));
        sighting.right = noisy(project(session.stereo->right, session.stereo->right_from_left * x));
      } else {
        sighting.point = x + s.noise * random.gaussian3();
      }
      o.sightings.push_back(sighting);
    }
    session.observations.push_back(o);
  }
  return session;
}

/// The first `count` observations measured anew, with noise of another draw.
Session remeasured(const SimulatedSession& s, std::size_t count, Random random) {
  Session session = s.session;
  session.observations.clear();
  std::vector<Eigen::VectorXd> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(s.session.observations[i].position);
  session.observations.push_back(s.session.observations.front());
  session = measured(s, session, poses, random);
  session.observations.erase(session.observations.begin());
  return session;
}

std::vector<Eigen::VectorXd> positions(const Plan& p) {
  std::vector<Eigen::VectorXd> all;
  for (const PlannedPose& pose : p.poses) all.push_back(pose.position);
  return all;
}

/// Poses of the simulation that were not taken: random ones.
std::vector<Eigen::VectorXd> random_poses(const SimulatedSession& s, std::size_t from, std::size_t count) {
  std::vector<Eigen::VectorXd> all;
  for (std::size_t i = from; i < from + count; ++i) all.push_back(s.session.observations[i].position);
  return all;
}

Session first_of(const SimulatedSession& s, std::size_t count) {
  Session session = s.session;
  session.observations.resize(count);
  return session;
}

void expect_within_limits(const Session& session, const Plan& p) {
  const Chain chain = chain_of(session);
  for (const PlannedPose& pose : p.poses) {
    const Eigen::VectorXd values = joint_values(chain.robot, chain.joints, pose.position);
    for (std::size_t j = 0; j < chain.robot.joints.size(); ++j) {
      const Joint& joint = chain.robot.joints[j];
      if (!joint.moves()) continue;
      EXPECT_GE(values[static_cast<Eigen::Index>(j)], joint.lower - 1e-12) << joint.name;
      EXPECT_LE(values[static_cast<Eigen::Index>(j)], joint.upper + 1e-12) << joint.name;
    }
  }
}

void expect_apart(const Session& session, const Plan& p, double least) {
  for (std::size_t i = 0; i < p.poses.size(); ++i) {
    for (const Observation& o : session.observations) EXPECT_GE((p.poses[i].position - o.position).norm(), least);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE((p.poses[i].position - p.poses[k].position).norm(), least);
  }
}

std::string refusal(const Session& session, const PlanOptions& options) {
  try {
    plan(session, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Planning, PosesAreWithinLimitsVisibleAndApart) {
  const SimulatedSession s = simulated(fixture::stand_session(), 20, 3);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  expect_within_limits(s.session, p);
  expect_apart(s.session, p, 0.17);
  const Chain chain = chain_of(s.session);
  for (const PlannedPose& pose : p.poses) {
    const Circumstances c = circumstances_at(chain, pose.position);
    const Rigid left_from_tcp = sensor_from_tcp(observed_ends(c, {}).ends, s.mount_from_sensor);
    for (const Vector3& x : true_markers(s, chain, pose.position)) {
      EXPECT_TRUE(is_visible(chain.stereo->left, x, 20));
      EXPECT_TRUE(is_visible(chain.stereo->right, chain.stereo->right_from_left * x, 20));
      EXPECT_LT(std::acos(-(left_from_tcp.rotation * s.normal_in_tcp).dot(x.normalized())), 1.3);
    }
  }
}

TEST(Planning, SigmaFallsWithEveryPoseAndGainsFall) {
  const SimulatedSession s = simulated(fixture::stand_session(), 12, 4);
  const Plan p = plan(s.session);
  Vector6 before = p.sigma_before;
  double gain = 1e300;
  for (const PlannedPose& pose : p.poses) {
    for (int i = 0; i < 6; ++i) EXPECT_LT(pose.sigma[i], before[i]);
    EXPECT_GT(pose.gain, 0);
    EXPECT_LE(pose.gain, gain * (1 + 1e-9));  // information gains are submodular
    before = pose.sigma;
    gain = pose.gain;
  }
  const Fit f = fit(s.session);
  EXPECT_LT((p.sigma_before - f.covariance.diagonal().cwiseSqrt()).norm(), 1e-3 * p.sigma_before.norm());
}

TEST(Planning, IsTheSameEveryTime) {
  const SimulatedSession s = simulated(fixture::stand_session(), 12, 5);
  PlanOptions o;
  o.count = 3;
  const Plan a = plan(s.session, o), b = plan(s.session, o);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) EXPECT_EQ(a.poses[i].position, b.poses[i].position);
}

TEST(Planning, JointsThatFollowOthersKeepTheirLimits) {
  Session like = fixture::tracker_session();
  like.robot = fixture::coupled_torso();
  like.mount.link = "base";
  like.joints = {"t1", "t2", "arm_1", "arm_2"};
  like.observations[0].position = Eigen::VectorXd::Zero(4);
  like.robot.joints[2].lower = -0.4;
  like.robot.joints[2].upper = 0.3;
  const SimulatedSession s = simulated(like, 15, 6);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  expect_within_limits(s.session, p);
}

TEST(Planning, ABeforeATrackerWithOneMarkerAnyPoseServes) {
  const SimulatedSession s = simulated(fixture::tracker_session(1), 10, 7);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  EXPECT_FALSE(p.rotation_is_observed);
  expect_within_limits(s.session, p);
  EXPECT_LT(p.poses.back().sigma.head<3>().norm(), 0.8 * p.sigma_before.head<3>().norm());
}

TEST(Planning, AJointThatHardlyMovesStaysAndIsNotToldApart) {
  Session like = fixture::stand_session();
  like.robot.joints[2].lower = 0.5;
  like.robot.joints[2].upper = 0.5 + 1e-6;
  const SimulatedSession s = simulated(like, 30, 8);
  const Chain chain = chain_of(s.session);
  PlanOptions o;
  o.count = 4;
  o.between = {"joint_scale:a3", "joint_offset:a3", effect_terms("joint_scale:a3", chain),
               effect_terms("joint_offset:a3", chain)};
  const Plan p = plan(s.session, o);
  ASSERT_EQ(p.poses.size(), 4u);
  expect_within_limits(s.session, p);
  EXPECT_FALSE(p.tells_apart);
  EXPECT_THAT(p.notes, testing::Contains(HasSubstr("cannot be told apart")));
}

TEST(Planning, RefusesWhatCannotBePlanned) {
  const SimulatedSession s = simulated(fixture::stand_session(), 8, 9);
  const Chain chain = chain_of(s.session);
  PlanOptions o;
  o.count = 0;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("expected 1 to 100"));
  o.count = most_planned_poses + 1;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("expected 1 to 100"));
  o.count = 2;
  o.between = {"joint_scale:a2", "joint_scale:a2", effect_terms("joint_scale:a2", chain),
               effect_terms("joint_scale:a2", chain)};
  EXPECT_THAT(refusal(s.session, o), HasSubstr("the same effect"));
  o.between->second = effect_terms("joint_offset:a2", chain);
  o.estimated = o.between->second;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("in the model already"));
}

TEST(Planning, WorksFromASingleObservation) {
  const SimulatedSession s = simulated(fixture::stand_session(), 1, 10);
  PlanOptions o;
  o.count = 3;
  const Plan p = plan(s.session, o);
  EXPECT_EQ(p.poses.size(), 3u);
  expect_within_limits(s.session, p);
}

TEST(Planning, PlannedPosesGiveABetterBodyThanRandomOnes) {
  constexpr std::size_t taken = 8, added = 6;
  constexpr int draws = 40;
  const std::vector<EffectTerm> offsets = effect_terms("joint_offset", chain_of(fixture::stand_session()));
  double planned_squares = 0, random_squares = 0, expected_squares = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const SimulatedSession s = simulated(fixture::stand_session(), static_cast<int>(taken + added), 100 + draw);
    const std::vector<std::optional<Vector3>> known(s.markers_in_tcp.begin(), s.markers_in_tcp.end());
    const Session start = first_of(s, taken);
    PlanOptions o;
    o.count = added;
    o.estimated = offsets;
    o.pool = 600;
    const Plan p = plan(start, o);
    FitOptions fitting;
    fitting.estimated = offsets;
    const auto error = [&](const std::vector<Eigen::VectorXd>& poses) {
      const Fit f = fit(measured(s, start, poses, Random(500 + static_cast<std::uint64_t>(draw))), fitting);
      const Rigid truth = body_frame(f.sides, s.markers_in_tcp).tcp_from_body;
      return small_motion_between(truth, f.tcp_from_body).head<3>().squaredNorm();
    };
    planned_squares += error(positions(p));
    random_squares += error(random_poses(s, taken, added));
    expected_squares += p.poses.back().sigma.head<3>().squaredNorm();
  }
  RecordProperty("planned_rms_um", static_cast<int>(1e6 * std::sqrt(planned_squares / draws)));
  RecordProperty("random_rms_um", static_cast<int>(1e6 * std::sqrt(random_squares / draws)));
  EXPECT_LT(std::sqrt(planned_squares), 0.9 * std::sqrt(random_squares));
  // The priors' offsets are wider than the truth's (none), so what is expected is no less than what is found.
  EXPECT_LT(planned_squares, 1.5 * expected_squares);
}

/// ln of the Bayes factor of the first against the second term in a session.
double ln_bayes_factor(const Session& session, const std::vector<EffectTerm>& first,
                       const std::vector<EffectTerm>& second) {
  FitOptions a, b;
  a.estimated = first;
  b.estimated = second;
  const double noise = session.is_tracker() ? *session.sigma_point : *session.sigma_pixel;
  return fit_evidence(fit(session, a), 0, noise, {}).ln_evidence -
         fit_evidence(fit(session, b), 0, noise, {}).ln_evidence;
}

TEST(Planning, PlannedPosesTellEffectsApartBetterThanRandomOnes) {
  constexpr std::size_t taken = 10, added = 5;
  constexpr int draws = 40;
  const Chain chain = chain_of(fixture::stand_session());
  const auto first = effect_terms("joint_scale:a2", chain), second = effect_terms("encoder_eccentricity:a2", chain);
  double planned = 0, random = 0, before = 0, expected = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Random size(static_cast<std::uint64_t>(900 + draw));
    std::vector<EffectTerm> truth = first;
    truth[0].values[0] = 4e-4 * size.gaussian();  // a fifth of the plausible size
    const SimulatedSession s = simulated(fixture::stand_session(), static_cast<int>(taken + added), 200 + draw, truth);
    const Session start = first_of(s, taken);
    PlanOptions o;
    o.count = added;
    o.pool = 600;
    o.between = {"scale", "eccentricity", first, second};
    const Plan p = plan(start, o);
    const Random noise(static_cast<std::uint64_t>(700 + draw));
    before += ln_bayes_factor(start, first, second);
    planned += ln_bayes_factor(measured(s, start, positions(p), noise), first, second);
    random += ln_bayes_factor(measured(s, start, random_poses(s, taken, added), noise), first, second);
    expected += (*p.poses.back().ln_bayes_factor)[0];
  }
  RecordProperty("before_milli", static_cast<int>(1e3 * before / draws));
  RecordProperty("planned_milli", static_cast<int>(1e3 * planned / draws));
  RecordProperty("random_milli", static_cast<int>(1e3 * random / draws));
  RecordProperty("expected_milli", static_cast<int>(1e3 * expected / draws));
  EXPECT_GT(planned, before);
  EXPECT_GT(planned - before, 1.2 * (random - before));
}

/// The linear theory: what a plan expects is what comes, in the mean, where the truth is drawn as the theory has it.
TEST(Planning, TheExpectedBayesFactorComesInTheMean) {
  constexpr int draws = 150;
  const Chain chain = chain_of(fixture::stand_session());
  const auto first = effect_terms("joint_scale:a2", chain), second = effect_terms("encoder_eccentricity:a2", chain);
  // One scale of the priors, not the mixture that fit_evidence has.
  const auto ln_evidence = [&](const Session& session, const std::vector<EffectTerm>& terms) {
    FitOptions o;
    o.estimated = terms;
    return fit_evidence(fit(session, o), static_cast<Eigen::Index>(0) + (terms[0].id == "joint_scale" ? 1 : 2),
                        *session.sigma_pixel, {})
        .ln_evidence;
  };
  double found = 0, expected = 0, squares = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Random size(static_cast<std::uint64_t>(4000 + draw));
    std::vector<EffectTerm> truth = first;
    truth[0].values[0] = 2e-3 * size.gaussian();
    const SimulatedSession s = simulated(fixture::stand_session(), 10, 5000 + draw, truth);
    PlanOptions o;
    o.count = 3;
    o.pool = 200;
    o.between = {"scale", "eccentricity", first, second};
    const Plan p = plan(s.session, o);
    const Session more = measured(s, s.session, positions(p), Random(static_cast<std::uint64_t>(6000 + draw)));
    const double gained = (ln_evidence(more, first) - ln_evidence(more, second)) -
                          (ln_evidence(s.session, first) - ln_evidence(s.session, second));
    const double difference = gained - (*p.poses.back().ln_bayes_factor)[0];
    found += gained / draws;
    expected += (*p.poses.back().ln_bayes_factor)[0] / draws;
    squares += difference * difference;
  }
  const double error = std::sqrt(squares) / draws;
  RecordProperty("found_milli", static_cast<int>(1e3 * found));
  RecordProperty("expected_milli", static_cast<int>(1e3 * expected));
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(found, expected, 4 * error + 0.02 * expected);
}

class PlanCommand : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path sample = HANDSIGHT_SOURCE_DIR "/sample_sessions/first_steps";
    std::filesystem::copy(sample, folder.path / "session", std::filesystem::copy_options::recursive);
    const Session like = read_session(folder.path / "session");
    Session labelled = simulated(like, 12, 11).session;
    labelled.file = like.file;
    labelled.source = nullptr;
    save_session(labelled);
  }

  test::CliResult plan_with(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plan", (folder.path / "session").string()});
    return test::run_cli(folder.path, arguments);
  }

  TemporaryFolder folder;
};

TEST_F(PlanCommand, WritesJsonAndATableThatReadsBack) {
  const auto csv = folder.path / "poses.csv";
  const test::CliResult r = plan_with({"--count", "3", "--json", "-", "--csv", csv.string()});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  const nlohmann::json json = r.json();
  const Session session = read_session(folder.path / "session");
  const std::vector<Eigen::VectorXd> poses = read_poses(csv, session.joints);
  ASSERT_EQ(poses.size(), 3u);
  ASSERT_EQ(json["poses"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& pose = json["poses"][i];
    EXPECT_EQ(pose["joints"].get<std::vector<std::string>>(), session.joints);
    EXPECT_EQ(pose["position"].get<std::vector<double>>(),
              std::vector<double>(poses[i].data(), poses[i].data() + poses[i].size()));
    EXPECT_GT(pose["expected_gain"].get<double>(), 0);
    EXPECT_EQ(pose["sigma"].size(), 6u);
  }
}

TEST_F(PlanCommand, RefusesBadInputInASentence) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--count", "0"},
           {"--count", "1000"},
           {"--effects", "joint_ofset"},
           {"--between", "joint_scale"},
           {"--between", "joint_scale,nothing"},
           {"--between", "joint_scale,joint_scale"},
           {"--between", "joint_scale,joint_offset:arm_1.offset=1e-3"},
           {"--count", "many"},
       }) {
    const test::CliResult r = plan_with(arguments);
    EXPECT_EQ(r.exit_code, 2) << arguments[1];
    EXPECT_GE(r.errors.size(), 20u) << arguments[1];
    EXPECT_EQ(r.output, "") << arguments[1];
  }
}

}  // namespace
}  // namespace handsight
