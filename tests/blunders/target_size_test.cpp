// SPDX-License-Identifier: Apache-2.0
// Boards that are described much too large or too small are reported at once.
#include "blunders/target_size.h"

#include "blunder_fixture.h"
#include "blunders/blunder_kinds.h"
#include "effects/own_effect.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

using fixture::eye_in_hand_session;
using fixture::target_session;

SimulatedSession simulated(const Session& like, std::uint64_t seed) {
  SimulationOptions o;
  o.observations = 30;
  o.seed = seed;
  return simulate_session(like, o);
}

/// The same measurements of a board that is described so that it really is larger by this share.
Session described_otherwise(Session session, double larger_by) {
  set_target(session, scaled(*session.target, 1 / (1 + larger_by)));
  return session;
}

std::optional<TargetSize> measure_size(const Session& session) { return other_target_size(session, fit(session), {}); }

TEST(TargetSizeAtOnce, IsToldHoweverWrongTheDescription) {
  for (const Session& like : {target_session(fixture::charuco(), 2), eye_in_hand_session()})
    for (const double by : {0.09, 0.31, 1.0, -0.11, -0.4}) {
      const Session session = described_otherwise(simulated(like, 3).session, by);
      const auto size = measure_size(session);
      ASSERT_TRUE(size.has_value()) << by;
      EXPECT_NEAR(size->scale, by, 4 * size->sigma + 0.01 * std::abs(by));
      EXPECT_LT(size->rms_after, 0.2 * size->rms_before);
      EXPECT_NE(size->text.find(by > 0 ? "larger" : "smaller"), std::string::npos) << size->text;
    }
}

TEST(TargetSizeAtOnce, IsNotToldOfARightOne) {
  for (const Session& like : {target_session(fixture::charuco(), 2), target_session(), eye_in_hand_session()})
    EXPECT_FALSE(measure_size(simulated(like, 4).session).has_value());
}

TEST(TargetSizeAtOnce, IsNotToldWhereItIsInTheModel) {
  const Session session = described_otherwise(simulated(eye_in_hand_session(), 5).session, 0.1);
  const Chain chain = make_chain(session);
  const FitOptions with{.estimated = effect_terms("target_scale", chain, list_own_effects(session, chain))};
  EXPECT_FALSE(other_target_size(session, fit(session, with), with).has_value());
}

/// Tags that each lie anywhere have a size, too.
TEST(TargetSizeAtOnce, OfSingleTags) {
  Session like = eye_in_hand_session();
  set_target(like, {.kind = TargetKind::tags, .tag = 0.06, .dictionary = "tag36h11", .ids = {0, 1}});
  const SimulatedSession right = simulated(like, 6);
  EXPECT_FALSE(measure_size(right.session).has_value());
  for (const double by : {0.2, -0.15, 0.03}) {
    Session session = right.session;
    set_target(session, scaled(*session.target, 1 / (1 + by)));
    const auto size = measure_size(session);
    ASSERT_TRUE(size.has_value()) << by;
    EXPECT_NEAR(size->scale, by, 4 * size->sigma + 0.01 * std::abs(by));
    EXPECT_NE(size->text.find("its tags are about "), std::string::npos) << size->text;
    EXPECT_EQ(size->fix.find("target_scale"), std::string::npos) << "no effect says it of single tags";
  }
}

/// Squares of 21.8 mm, described as 20, 19 % and 118 % off: what the fit leaves is never called converged beyond what
/// any robot explains.
TEST(TargetSizeAtOnce, OfARealBoard) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/real_square_size";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Session as_described = read_session(folder);
  for (const double square : {0.02, 0.0166, 0.01}) {
    const Session session = described_otherwise(as_described, 0.02 / square - 1);
    const Fit f = fit(session);
    const auto size = other_target_size(session, f, {});
    ASSERT_TRUE(size.has_value()) << square;
    EXPECT_NEAR(square * (1 + size->scale), 0.0218, 0.0003) << size->text;
    if (f.residual_rms > 25) EXPECT_FALSE(f.converged()) << f.residual_rms;
  }
}

/// The size that a blunder says, of a square or tag; nothing where none is named alone.
std::optional<double> size_named(const Session& session) {
  const auto found = fixture::blunders_in(session);
  const std::string name = "target_size:";
  if (found.size() != 1 || !found[0].starts_with(name)) return std::nullopt;
  return std::stod(found[0].substr(name.size()));
}

/// Too far off for an effect to reach it.
TEST(TargetSizeBlunder, IsFoundHoweverWrongTheDescription) {
  Session tags = eye_in_hand_session();
  set_target(tags, {.kind = TargetKind::tags, .tag = 0.06, .dictionary = "tag36h11", .ids = {0, 1}});
  for (const Session& like : {target_session(fixture::charuco(), 2), eye_in_hand_session(), tags}) {
    const Session right = simulated(fixture::with_free_mount(like), 7).session;
    EXPECT_FALSE(size_named(right).has_value());
    const double length = right.target->kind == TargetKind::tags ? right.target->tag : right.target->square;
    for (const double times : {1500.0, 6.0, 1 / 900.0}) {
      const auto size = size_named(described_otherwise(right, times - 1));
      ASSERT_TRUE(size.has_value()) << times;
      EXPECT_NEAR(*size, length, 0.03 * length) << times;
    }
  }
}

TEST(TargetSizeBlunder, IsMillimetresWhereItIsAThousandth) {
  const Session right = simulated(eye_in_hand_session(), 7).session;
  EXPECT_THAT(fixture::blunders_in(described_otherwise(right, 1e-3 - 1)), testing::ElementsAre("length_unit:board"));
}

TEST(TargetSizeBlunder, IsPutRight) {
  const Session right = simulated(eye_in_hand_session(), 8).session;
  const Session wrong = described_otherwise(right, 249);
  const BlunderKind* kind = find_blunder_kind("target_size");
  ASSERT_NE(kind, nullptr);
  Session mended = wrong;
  kind->mend(kind->places(wrong).at(0), mended);
  EXPECT_NEAR(mended.target->square, right.target->square, 0.02 * right.target->square);
  EXPECT_NE(kind->fix("0.02", wrong).find("square=\"0.02\""), std::string::npos);
  EXPECT_THROW(kind->mend("-1", mended), InputError);
  EXPECT_THROW(kind->mend("large", mended), InputError);
}

/// Squares of 21.9 mm by a robot of poses that errs by millimetres.
TEST(TargetSizeBlunder, OfARealBoard) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/real_square_size";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Session as_described = read_session(folder);
  for (const double times : {1e3, 1e-3}) {
    const Session session = described_otherwise(as_described, times - 1);
    const auto size = size_named(session);
    ASSERT_TRUE(size.has_value()) << times;
    EXPECT_NEAR(*size, 0.0219, 0.0005) << times;
  }
}

}  // namespace
}  // namespace handsight
