// SPDX-License-Identifier: Apache-2.0
// Orders of their own of what was seen and of where the robot stood are found, and put right.
#include <numeric>

#include "blunder_fixture.h"
#include "blunders/mended.h"

namespace handsight {
namespace {

using fixture::six_axes;
using testing::HasSubstr;

/// What was seen stays where it is; observation i gets the robot of order[i].
Session with_robots_of(const Session& right, const std::vector<std::size_t>& order) {
  Session s = right;
  for (std::size_t i = 0; i < order.size(); ++i) s.observations[i].position = right.observations[order[i]].position;
  return s;
}

/// Observations by their numbers from `first` on, sorted as text.
std::vector<std::size_t> as_text(std::size_t count, std::size_t first) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::to_string(a + first) < std::to_string(b + first); });
  return order;
}

TEST(PairingOrder, ImagesSortedAsText) {
  for (const std::size_t first : {0, 1}) {
    const Session right = six_axes(11 + first);
    const Session wrong = with_robots_of(right, as_text(right.observations.size(), first));
    const std::vector<Blunder> found = find_blunders(wrong, fit(wrong));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].id, "pairing_order");
    EXPECT_THAT(found[0].text.english(), HasSubstr("sorted as text"));
    EXPECT_NEAR(fit(mended(wrong, display_name(found[0]))).residual_rms, fit(right).residual_rms, 1e-6);
  }
}

TEST(PairingOrder, OneMarkerBeforeATrackerSortedAsTextOrBackwards) {
  const Session right = fixture::simulated_right(fixture::with_free_mount(fixture::tracker_session(1)), 13);
  const std::size_t count = right.observations.size();
  const Session wrong = with_robots_of(right, as_text(count, 1));
  std::vector<Blunder> found = find_blunders(wrong, fit(wrong));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].text.english(), HasSubstr("sorted as text"));
  std::vector<std::size_t> backwards(count);
  for (std::size_t i = 0; i < count; ++i) backwards[i] = count - 1 - i;
  found = find_blunders(with_robots_of(right, backwards), fit(with_robots_of(right, backwards)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].text.english(), HasSubstr("opposite orders"));
}

TEST(PairingOrder, PosesInAnyOrderWhereOneHasNoPartner) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Session right = fixture::pose_session(seed, 14);
    std::vector<std::size_t> order(14);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 random(seed);
    std::shuffle(order.begin(), order.end(), random);
    right.observations[5].position = make_position(Rigid{rotation_from_rpy({1.0, 2.0, 0.3}), {1.0, 0.2, 0.9}});
    const Session wrong = with_robots_of(right, order);
    const std::vector<Blunder> found = find_blunders(wrong, fit(wrong));
    ASSERT_EQ(found.size(), 1u) << seed;
    EXPECT_EQ(found[0].id, "pairing_order") << seed;
    EXPECT_THAT(found[0].text.english(), HasSubstr("for 13 of 14 measurements")) << seed;
    const Session again = mended(wrong, display_name(found[0]));
    EXPECT_LT(fit(again).residual_rms, 1e-3) << seed;
    for (std::size_t i = 0; i < order.size(); ++i)
      if (is_used(again.observations[i])) EXPECT_EQ(again.observations[i].position, right.observations[i].position);
  }
}

}  // namespace
}  // namespace handsight
