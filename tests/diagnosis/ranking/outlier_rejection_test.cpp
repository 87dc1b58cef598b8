// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/outlier_rejection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/simulated_stand.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

TEST(OutlierRejection, KeepsPointsThatAnEffectMakesRight) {
  const Session session = simulated({{"marker_slip", 2, {3e-3, 2e-3, -2e-3, 45}}}, 9);
  const CleanFit alone = clean_fit(session, {}), model = fit_without_outliers(session, {});
  ASSERT_GE(alone.wrong.size(), 8u) << "without the effect they look wrong";
  EXPECT_TRUE(model.wrong.empty());
  EXPECT_EQ(model.fit.rows, fit(session, {}).rows);
}

TEST(OutlierRejection, LeavesOutPointsThatNothingMakesRight) {
  Session session = fixture::tracker_session(4);
  session = simulated({}, 12, 50, session);
  const std::vector<std::size_t> wrong = {5, 17, 23, 31, 44};
  for (const std::size_t i : wrong) session.observations[i].sightings[i % 4].point->x() += 5e-3;
  const CleanFit model = fit_without_outliers(session, {});
  ASSERT_EQ(model.wrong.size(), wrong.size());
  for (const WrongPoint& w : model.wrong) {
    EXPECT_EQ(std::count(wrong.begin(), wrong.end(), static_cast<std::size_t>(w.index)), 1);
    EXPECT_EQ(w.marker, w.index % 4);
    EXPECT_NEAR(w.distance, 5e-3, 2e-3);
  }
}

/// Points that are wrong by metres leave a fit without an answer; one of an observation is found a round.
TEST(OutlierRejection, FindsTheWrongPointsOfAFitWithoutAnAnswer) {
  Session session = simulated({}, 12, 50, fixture::tracker_session(5));
  for (const std::size_t i : {5, 17, 23, 31})
    for (const std::size_t m : {0, 1}) session.observations[i].sightings[m].point->x() += 4;
  ASSERT_TRUE(has_no_answer(fit(session, {})));
  const CleanFit model = clean_fit(session, {});
  EXPECT_EQ(model.wrong.size(), 8u);
  EXPECT_FALSE(has_no_answer(model.fit));
}

TEST(OutlierRejection, BelievesADeclaredNoiseThatIsLargerThanWhatOnePoseShows) {
  // Points of one rigid thing that fit each other to a tenth of what the tracker is good for: none of them is wrong.
  Session session = simulated({}, 12, 50, fixture::tracker_session(4));
  for (Observation& o : session.observations)
    for (Sighting& s : o.sightings) s.point->y() += o.id % 7 == 0 && s.marker == 1 ? 1.5e-3 : 0;
  EXPECT_FALSE(clean_fit(session, {}).wrong.empty());
  session.sigma_point = 2e-3;
  EXPECT_TRUE(clean_fit(session, {}).wrong.empty());
}

}  // namespace
}  // namespace handsight
