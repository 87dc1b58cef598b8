// SPDX-License-Identifier: Apache-2.0
#include "label/labeller.h"

#include <gtest/gtest.h>

#include "session/session_xml.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"

namespace handsight::app {
namespace {

class LabellerTest : public testing::Test {
 protected:
  LabellerTest() {
    const Observation& o = session.observations[0];
    corners = {detect_corners(read_image(folder(session) / o.images[0])),
               detect_corners(read_image(folder(session) / o.images[1]))};
    labeller.start(session, o, corners);
  }
  void place_three() {
    for (const Vector2& click : {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)})
      ASSERT_EQ(labeller.point(click, false), QString());
  }
  Session session = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps");
  CornersOfPair corners;
  Labeller labeller;
};

TEST_F(LabellerTest, ThreeClicksGiveTheLabelsOfTheCommandLine) {
  place_three();
  ASSERT_TRUE(labeller.will_do()) << labeller.refusal().toStdString();
  const FirstLabels cli = label_first(make_stereo(*session.rig), corners.left, corners.right,
                                      {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)});
  const auto sightings = labeller.sightings();
  ASSERT_EQ(sightings.size(), 3U);
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_EQ(seen_by(sightings[m], 0)->pixel, cli.markers[m].left);
    EXPECT_EQ(seen_by(sightings[m], 1)->pixel, cli.markers[m].right);
    EXPECT_EQ(sightings[m].by, MarkedBy::hand);
  }
  EXPECT_GT(*labeller.side_sigma(0, 1), 0);
  EXPECT_TRUE(labeller.point({100, 100}, true).contains("All 3 markers are placed"));
}

TEST_F(LabellerTest, FarFromEveryCornerItRefusesAndAltSetsFreely) {
  Vector2 empty(20, 20);
  EXPECT_TRUE(labeller.point(empty, false).contains("No corner within 12 px. Hold Alt"));
  EXPECT_TRUE(labeller.markers().empty());
  EXPECT_EQ(labeller.point(empty, true), QString());
  EXPECT_EQ(labeller.markers().at(0).left.position, empty);
}

TEST_F(LabellerTest, TheUsersPartnerIsKept) {
  place_three();
  const auto candidates = labeller.candidates(1);
  ASSERT_GE(candidates.size(), 1U);
  EXPECT_TRUE(std::any_of(candidates.begin(), candidates.end(), [](const auto& c) { return c.is_taken; }));
  for (const LabelCandidate& c : candidates) {
    if (c.is_taken) continue;
    labeller.choose_partner(1, c.corner);
    EXPECT_EQ(labeller.markers().at(1).right->position, c.position);
    labeller.move(0, true, labeller.markers().at(0).left.position + Vector2(0.1, 0), true);
    EXPECT_EQ(labeller.markers().at(1).right->position, c.position) << "moving another marker leaves it";
    break;
  }
}

TEST_F(LabellerTest, NudgingIsFreeAndDraggingSnaps) {
  place_three();
  const Vector2 corner = labeller.markers().at(2).left.position;
  labeller.move(2, true, corner + Vector2(0.1, 0), true);
  EXPECT_EQ(labeller.markers().at(2).left.position, Vector2(corner + Vector2(0.1, 0)));
  labeller.move(2, true, corner + Vector2(3, -2), false);
  EXPECT_EQ(labeller.markers().at(2).left.position, corner);
}

TEST_F(LabellerTest, NumbersAreSwappedAndFreedOnesUsedAgain) {
  place_three();
  const Vector2 first = labeller.markers().at(0).left.position;
  labeller.renumber(0, 2);
  EXPECT_EQ(labeller.markers().at(2).left.position, first);
  EXPECT_EQ(labeller.markers().size(), 3U);
  labeller.remove(1);
  EXPECT_FALSE(labeller.will_do());
  EXPECT_EQ(labeller.point({408, 411}, false), QString());
  EXPECT_TRUE(labeller.markers().contains(1));
}

TEST_F(LabellerTest, TheEpipolarLineRunsThroughThePartner) {
  place_three();
  for (const auto& [number, m] : labeller.markers()) {
    const auto line = labeller.epipolar_line(m.left.position);
    ASSERT_GT(line.size(), 5U);
    double nearest = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 d = line[i] - line[i - 1];
      const double t = std::clamp((m.right->position - line[i - 1]).dot(d) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (line[i - 1] + t * d - m.right->position).norm());
    }
    EXPECT_LT(nearest, 1.0) << "marker " << number;
  }
}

TEST_F(LabellerTest, StartsWithTheLabelsThatAreThere) {
  place_three();
  Observation o = session.observations[0];
  o.sightings = labeller.sightings();
  Labeller again;
  again.start(session, o, corners);
  EXPECT_TRUE(again.will_do());
  EXPECT_EQ(seen_by(again.sightings()[1], 1)->pixel, seen_by(o.sightings[1], 1)->pixel);
}

}  // namespace
}  // namespace handsight::app
