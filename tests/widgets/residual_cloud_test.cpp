// SPDX-License-Identifier: Apache-2.0
// The residual cloud before and after: axes, colours, motion, mouse.
#include <gmock/gmock.h>

#include <QSignalSpy>

#include "widgets/explain_samples.h"
#include "widgets/mouse.h"
#include "widgets/still.h"

namespace handsight::widgets {
namespace {

using test::Still;

TEST(ResidualCloud, DotsMoveUnlessMotionIsReduced) {
  const auto right_after = [] {
    ResidualCloud pair;
    pair.set_noise(0.2);
    pair.set_before(test::cloud(50, 9), "before");
    test::show(pair, {400, 240});
    pair.set_after(test::cloud(50, 0), "after");
    const QImage at_once = pair.grab().toImage();
    QTest::qWait(400);
    return at_once == pair.grab().toImage();
  };
  EXPECT_FALSE(right_after());
  const Still still;
  EXPECT_TRUE(right_after());
}

TEST(ResidualCloud, BothPanesHaveTheSameLockedAxes) {
  ResidualCloud pair;
  pair.set_noise(0.2);
  const Still still;
  pair.set_before(test::cloud(50, 9), "before");
  test::show(pair, {400, 240});
  const double reach = pair.reach();
  EXPECT_GT(reach, 9);
  pair.set_after(test::cloud(50, 0), "after");
  EXPECT_EQ(pair.reach(), reach);
  const QPointF offset = pair.pane(1).center() - pair.pane(0).center();
  for (const double px : {0.2, 1.0, 8.0}) EXPECT_EQ(pair.on_screen(1, 0, px), pair.on_screen(0, 0, px) + offset);
  // v grows downward; the distance from the middle grows with the residual and ends at the rim.
  EXPECT_GT(pair.on_screen(0, 0, 1).y(), pair.pane(0).center().y());
  EXPECT_LT(pair.on_screen(0, 0, 1).y(), pair.on_screen(0, 0, 5).y());
  EXPECT_NEAR(pair.on_screen(0, 0, 1e6).y(), pair.pane(0).bottom(), 1e-6);
  pair.fit();
  EXPECT_EQ(pair.reach(), reach);  // the larger of the two clouds
}

TEST(ResidualCloud, StandsInTheMiddleOfWhatIsHigherThanItNeeds) {
  ResidualCloud pair;
  pair.set_before(test::cloud(50, 9), "before");
  test::show(pair, {2000, 240});
  const QRectF flat = pair.pane(0);
  EXPECT_NEAR(flat.center().y(), 120, 1);
  pair.resize(400, 900);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(pair.pane(i).center().y(), 450, 1);
  EXPECT_LT(pair.pane(0).width(), 200);
  pair.resize(2000, 600);
  EXPECT_EQ(pair.pane(0).top(), flat.top()) << "as high as there is room, that for its title kept";
  EXPECT_EQ(pair.pane(0).height(), flat.height() + 360);
}

TEST(ResidualCloud, NoiseIsGreyAndErrorsAreNot) {
  ResidualCloud pair;
  pair.set_noise(0.2);
  const Still still;
  pair.set_before(test::cloud(200, 9), "before");
  pair.set_after(test::cloud(200, 0), "after");
  test::show(pair, {700, 380});
  const QImage image = pair.grab().toImage();
  const auto warm = [&](int pane) {
    int count = 0;
    const QRect area = pair.pane(pane).toRect();
    for (int y = area.top(); y < area.bottom(); ++y)
      for (int x = area.left(); x < area.right(); ++x) {
        const QColor color = image.pixelColor(x, y);
        count += color.red() > color.blue() + 30;
      }
    return count;
  };
  EXPECT_GT(warm(0), 1000);
  EXPECT_LT(warm(1), warm(0) / 10);  // one corner in a hundred by chance
}

TEST(ResidualCloud, ClickSelectsAndTheRightPaneMovesToItsNewState) {
  ResidualCloud pair;
  pair.set_noise(0.2);
  pair.set_camera_names({"left", "right"});
  std::vector<CloudPoint> before = {{7, 1, 0, 8, 0}, {9, 0, 1, -6, 3}};
  pair.set_before(before, "before");
  test::show(pair, {500, 280});
  std::vector<CloudPoint> after = before;
  for (CloudPoint& point : after) point.du *= 0.05, point.dv *= 0.05;
  pair.set_after(after, "after");
  QSignalSpy selected(&pair, &ResidualCloud::observation_selected), read_out(&pair, &ResidualCloud::read_out);
  QTest::qWait(400);  // longer than the motion
  test::click(&pair, pair.on_screen(1, after[0].du, after[0].dv));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 7);
  test::hover(&pair, pair.on_screen(0, -6, 3));
  EXPECT_EQ(read_out.back()[0].toString(), QString("obs 9, marker 0, right: −6.00, 3.00 px"));
}

TEST(ResidualCloud, OfTwoSessionsAnIdOfTheOneIsNothingInTheOther) {
  ResidualCloud pair;
  pair.set_noise(0.2);
  pair.set_apart(true);
  pair.set_camera_names({"left"});
  pair.set_before({{7, 1, 0, 8, 0}}, "before");
  test::show(pair, {500, 280});
  pair.set_after({{7, 1, 0, -8, 0}}, "after");
  const QImage plain = pair.grab().toImage();
  QSignalSpy selected(&pair, &ResidualCloud::observation_selected), hovered(&pair, &ResidualCloud::observation_hovered);
  test::click(&pair, pair.on_screen(1, -8, 0));
  test::hover(&pair, pair.on_screen(1, -8, 0));
  EXPECT_EQ(selected.size(), 0);
  EXPECT_EQ(hovered.size(), 0);
  const QImage ringed = pair.grab().toImage();
  EXPECT_EQ(plain.copy(pair.pane(0).toRect()), ringed.copy(pair.pane(0).toRect())) << "not ringed in the other pane";
  EXPECT_NE(plain.copy(pair.pane(1).toRect()), ringed.copy(pair.pane(1).toRect()));
}

}  // namespace
}  // namespace handsight::widgets
