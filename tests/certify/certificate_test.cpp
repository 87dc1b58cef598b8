// SPDX-License-Identifier: Apache-2.0
// Certificates of simulated robots: what they say is what was simulated.
#include "certify/certificate.h"

#include <gtest/gtest.h>

#include <regex>

#include "certify/certificate_pdf.h"
#include "certify/request.h"
#include "estimation/report/export.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

std::vector<EffectTerm> wrong(const Chain& chain) {
  std::vector<EffectTerm> terms;
  for (int j = 1; j < 5; ++j)
    terms.push_back({"joint_offset", chain.joints[static_cast<std::size_t>(j)], {j % 2 ? 4e-3 : -3e-3}});
  terms.push_back({"joint_elasticity", chain.joints[1], {8e-5}});
  return terms;
}

/// Eighty poses; `repeats`: of each of the first five poses so many more.
Session simulated(std::uint64_t seed, int repeats = 0, double noise = 2e-5) {
  SimulationOptions options;
  options.observations = 80;
  options.seed = seed;
  options.noise = noise;
  Session like = fixture::tracker_session();
  options.effects = wrong(make_chain(like));
  if (repeats == 0) return simulate_session(like, options).session;
  Session poses = simulate_session(like, options).session;
  std::vector<Observation> all;
  for (int cycle = 0; cycle < repeats; ++cycle)
    for (int p = 0; p < 5; ++p) all.push_back(poses.observations[static_cast<std::size_t>(p)]);
  all.insert(all.end(), poses.observations.begin() + 5, poses.observations.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].id = static_cast<std::int64_t>(i);
    all[i].time = static_cast<double>(i);
    // Measured anew: the same pose with noise of its own.
    std::mt19937_64 random(seed + 100 * i);
    std::normal_distribution<double> normal(0, noise);
    for (Sighting& s : all[i].sightings)
      for (int k = 0; k < 3; ++k) (*s.point)[k] += normal(random);
  }
  poses.observations = std::move(all);
  poses.sigma_point = noise * std::sqrt(2.0);
  return poses;
}

CertificateRequest request_for(const Session& session, const std::vector<std::string>& effects) {
  FitOptions options;
  for (const std::string& id : effects)
    for (const EffectTerm& t : effect_terms(id, make_chain(session))) options.estimated.push_back(t);
  return certificate_request(session, fit(session, options), options, {}, "handsight test", "a test");
}

TEST(Certificate, TellsTheErrorBeforeAndAfterHeldOut) {
  const Session session = simulated(3);
  const Certificate c = make_certificate(session, request_for(session, {"joint_offset", "joint_elasticity"}));
  EXPECT_EQ(c.poses.size(), 80u);
  EXPECT_EQ(c.folds, 5);
  EXPECT_GT(c.before.rms, 1e-3);  // joints that are off by 3 to 4 mrad
  EXPECT_LT(c.after.rms, 1e-4);
  EXPECT_LE(c.after.rms, c.after.largest);
  EXPECT_LE(c.after.p95, c.after.largest);
  ASSERT_TRUE(c.after.rms_turn);
  EXPECT_LT(*c.after.rms_turn, *c.before.rms_turn);
  EXPECT_FALSE(c.expected.empty());
}

/// Where the model is right the promised limits hold as often as promised: over ten robots 800 observations.
TEST(Certificate, PromisedLimitsHoldAsOftenAsPromised) {
  int inside = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Session session = simulated(seed);
    CertificateRequest request = request_for(session, {"joint_offset", "joint_elasticity"});
    const AttainedPoses attained = attained_poses(session, request.model);
    for (const AttainedPose& p : attained.all)
      inside += (p.after.translation - p.commanded.translation).norm() <= length_limit(p.covariance, 0.95);
    all += static_cast<int>(attained.all.size());
  }
  EXPECT_GT(inside, 0.92 * all);
  EXPECT_LT(inside, 0.98 * all);
}

/// A model that is wrong promises too little where it does not know it: the certificate says what was measured.
TEST(Certificate, OfAModelThatLacksSomethingIsHonest) {
  const Session session = simulated(4);
  const Certificate lacking = make_certificate(session, request_for(session, {"joint_elasticity"})),
                    whole = make_certificate(session, request_for(session, {"joint_offset", "joint_elasticity"}));
  EXPECT_GT(lacking.after.rms, 3 * whole.after.rms);
  EXPECT_NEAR(lacking.before.rms, whole.before.rms, 1e-6);
}

TEST(Certificate, HasTheStandardsFiguresWhereThePosesAreRepeated) {
  const Session session = simulated(5, iso_cycles);
  const Certificate c = make_certificate(session, request_for(session, {"joint_offset", "joint_elasticity"}));
  EXPECT_TRUE(c.iso.has_accuracy);
  EXPECT_TRUE(c.iso.has_distance);
  ASSERT_GE(c.iso.poses.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const IsoPose& p = c.iso.poses[i];
    EXPECT_EQ(p.before.cycles, iso_cycles);
    EXPECT_LT(p.after.ap, 0.2 * p.before.ap);
    EXPECT_NEAR(*p.before.rp, *p.after.rp, 0.1 * *p.after.rp);  // correcting changes nothing of how well it repeats
    EXPECT_GT(*p.after.rp, 1e-5);
    EXPECT_LT(*p.after.rp, 5e-4);
  }
  EXPECT_FALSE(c.iso.has_directions);
  ASSERT_EQ(c.iso.lacking.size(), 1u);
  EXPECT_NE(c.iso.lacking[0].find("vAP"), std::string::npos);
}

TEST(Certificate, PlansWhatTheStandardAsksForBeside) {
  const Session session = simulated(6);
  const Certificate c = make_certificate(session, request_for(session, {"joint_offset"}));
  EXPECT_TRUE(c.iso.poses.empty());
  EXPECT_EQ(c.iso.lacking.size(), 3u);
  ASSERT_EQ(c.iso.plan.size(), 5u);
  for (const PoseToRecord& p : c.iso.plan) {
    EXPECT_EQ(p.cycles, 29);  // one has been measured
    EXPECT_EQ(p.position.size(), 6);
    EXPECT_TRUE(std::any_of(session.observations.begin(), session.observations.end(),
                            [&](const Observation& o) { return o.position == p.position; }));
  }
}

/// A calibration of the session itself has seen it: it is estimated again in each fold; one of another session is held.
TEST(Certificate, OfACalibrationOfTheSessionItselfIsNotOfWhatItHasSeen) {
  const Session session = simulated(7), other = simulated(8);
  FitOptions options;
  for (const char* id : {"joint_offset", "joint_elasticity"})
    for (const EffectTerm& t : effect_terms(id, make_chain(session))) options.estimated.push_back(t);
  const Calibration c = make_calibration(session, fit(session, options), {}, options, "test");
  EXPECT_TRUE(is_of_session(c, session));
  EXPECT_FALSE(is_of_session(c, other));
  const CertificateRequest own = certificate_request(session, c, "c.xml", "test"),
                           foreign = certificate_request(other, c, "c.xml", "test");
  EXPECT_FALSE(own.model.options.estimated.empty());
  EXPECT_TRUE(own.model.options.effects.empty());
  EXPECT_TRUE(foreign.model.options.estimated.empty());
  EXPECT_EQ(foreign.model.options.effects.size(), options.estimated.size());
  const Certificate reported = make_certificate(other, foreign);
  EXPECT_LT(reported.after.rms, 0.1 * reported.before.rms);
  EXPECT_GE(reported.coverage.interval.high, 0.9);
}

TEST(Certificate, NeedsTenObservations) {
  Session session = simulated(9);
  session.observations.resize(8);
  EXPECT_THROW(make_certificate(session, request_for(session, {})), InputError);
}

/// A camera on the hand: the hand is what moves, before and after.
TEST(Certificate, OfASensorOnTheHandIsOfTheHand) {
  Session like = fixture::tracker_session();
  std::swap(like.tcp, like.mount.link);
  like.mount.mount_from_sensor = {rotation_from_rpy({0.1, 0.2, 0.3}), {0.05, 0.02, 0.1}};
  SimulationOptions options;
  options.observations = 60;
  options.noise = 5e-6;  // turns of the device show at the hand by its distance from the markers
  options.farthest = 3;
  for (const int j : {1, 2, 3}) options.effects.push_back({"joint_offset", j, {5e-3}});
  Session session = simulate_session(like, options).session;
  session.mount.estimate = true;
  const Certificate c = make_certificate(session, request_for(session, {"joint_offset"}));
  EXPECT_EQ(c.hand, "hand");
  EXPECT_GT(c.before.rms, 5e-4);
  EXPECT_LT(c.after.rms, 0.3 * c.before.rms);
}

std::size_t count_numbers(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++count;
  return count;
}

TEST(CertificatePdf, HasTwoToFourPages) {
  for (const int repeats : {0, iso_cycles}) {
    const Session session = simulated(10, repeats);
    const Certificate c =
        make_certificate(session, request_for(session, {"joint_offset", "joint_elasticity", "link_geometry"}));
    const std::string pdf = certificate_pdf(c);
    EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.4");
    const std::size_t pages = count_numbers(pdf, "/Type /Page ");
    EXPECT_GE(pages, 2u);
    EXPECT_LE(pages, 4u);
    EXPECT_EQ(count_numbers(pdf, certificate_number(c)) > pages, true);
    // The table of the file's objects says where each of them is.
    const std::size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
    EXPECT_EQ(pdf.substr(table, 4), "xref");
    const std::size_t objects = std::stoul(pdf.substr(table + 7));
    for (std::size_t i = 1; i < objects; ++i) {
      const std::size_t entry = pdf.find("65535 f \n", table) + 9 + 20 * (i - 1);
      const std::string begin = fmt::format("{} 0 obj", i);
      EXPECT_EQ(pdf.substr(std::stoul(pdf.substr(entry, 10)), begin.size()), begin);
    }
  }
}

}  // namespace
}  // namespace handsight
