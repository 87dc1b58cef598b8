// SPDX-License-Identifier: Apache-2.0
// Verdict, patterns, staircase, cost, what-if, versions and truth: mouse and keyboard.
#include <gmock/gmock.h>

#include <QComboBox>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <cmath>

#include "widgets/base/theme.h"
#include "widgets/explain/cost_curve.h"
#include "widgets/explain/what_if_track.h"
#include "widgets/explain_samples.h"
#include "widgets/mouse.h"
#include "widgets/still.h"

namespace handsight::widgets {
namespace {

using test::Still;
using testing::ElementsAre;

int list_pixels(QWidget& widget, const QColor& color) {
  const QImage image = widget.grab().toImage();
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == color;
  return count;
}

TEST(VerdictLine, SaysStateAndSentenceToScreenReadersAndBlameIsClickable) {
  VerdictLine line;
  line.set_verdict(test::missing_verdict());
  test::show(line, {1056, 72});
  EXPECT_TRUE(line.accessibleDescription().startsWith("cause missing: Most likely missing"));
  QSignalSpy clicked(&line, &VerdictLine::attribution_clicked);
  test::click(&line, {1000, 36});
  EXPECT_EQ(clicked.size(), 1);
  test::click(&line, {300, 36});
  EXPECT_EQ(clicked.size(), 1);
  EXPECT_GT(list_pixels(line, colors().attribution_to_robot), 500);
  EXPECT_EQ(list_pixels(line, colors().candidate), 0);
}

TEST(PatternPage, ClickAndArrowsTakeAPlot) {
  PatternPage page;
  page.set_plots(test::nine_patterns(40));
  test::show(page, {600, 300});
  QSignalSpy selected(&page, &PatternPage::plot_selected);
  test::click(&page, page.plot_rect(4).center());
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toInt(), 4);
  QTest::keyClick(&page, Qt::Key_Down);
  QTest::keyClick(&page, Qt::Key_Right);
  QTest::keyClick(&page, Qt::Key_Right);  // at the end: stays
  ASSERT_EQ(selected.size(), 3);
  EXPECT_EQ(selected[2][0].toInt(), 8);
  EXPECT_EQ(page.selected_plot(), 8);
}

TEST(PatternPage, ShiftAndDraggingBrushesAndHoverReadsOut) {
  PatternPage page;
  page.set_plots(test::nine_patterns(40));
  test::show(page, {600, 300});
  QSignalSpy many(&page, &PatternPage::observations_selected), hovered(&page, &PatternPage::observation_hovered);
  QSignalSpy read_out(&page, &PatternPage::read_out);
  const std::vector<ScatterPoint> points = page.plots()[0].points;
  const QPointF from = page.on_screen(0, points[10].x, points[10].y),
                to = page.on_screen(0, points[14].x, points[14].y);
  test::drag(&page, from + QPointF(-2, 6), to + QPointF(2, -6), Qt::ShiftModifier);
  ASSERT_EQ(many.size(), 1);
  EXPECT_THAT(many[0][0].value<std::vector<qint64>>(), ElementsAre(10, 11, 12, 13, 14));
  test::hover(&page, page.on_screen(0, points[30].x, points[30].y));
  ASSERT_FALSE(hovered.empty());
  EXPECT_EQ(hovered.back()[0].toLongLong(), 30);
  EXPECT_TRUE(read_out.back()[0].toString().startsWith("obs 30: gravity torque of arm_2"));
}

TEST(PatternPage, AxesAreLockedUntilFitted) {
  PatternPage page;
  std::vector<PatternPlot> plots = test::nine_patterns(40);
  page.set_plots(plots);
  test::show(page, {600, 300});
  const QPointF before = page.on_screen(0, 10, 3);
  for (ScatterPoint& point : plots[0].points) point.y *= 0.05;  // the right effect was added
  page.update_plots(plots);
  EXPECT_EQ(page.on_screen(0, 10, 3), before);
  page.fit();
  EXPECT_NE(page.on_screen(0, 10, 3), before);
}

TEST(PatternPage, WithACompanionBothHaveTheAxesThatHoldBoth) {
  PatternPage page, other;
  page.set_companion(&other);
  other.set_companion(&page);
  std::vector<PatternPlot> plots = test::nine_patterns(40), larger = plots;
  for (ScatterPoint& point : larger[0].points) point.x += 3, point.y *= 20;
  larger[1].id = "another one";
  for (ScatterPoint& point : larger[1].points) point.y *= 20;
  page.set_plots(plots);
  other.set_plots(larger);
  for (PatternPage* p : {&page, &other}) p->fit();
  test::show(page, {600, 300});
  test::show(other, {600, 300});
  EXPECT_EQ(page.on_screen(0, 10, 3), other.on_screen(0, 10, 3));
  EXPECT_NE(page.on_screen(1, 10, 3), other.on_screen(1, 10, 3)) << "not the same plot";
}

TEST(PatternPage, PlotsMayGoWhileOneIsBrushed) {
  PatternPage page;
  page.set_plots(test::nine_patterns(40));
  test::show(page, {600, 300});
  QSignalSpy many(&page, &PatternPage::observations_selected);
  const QPoint from = page.plot_rect(8).center().toPoint();
  QTest::mousePress(&page, Qt::LeftButton, Qt::ShiftModifier, from);
  page.update_plots({page.plots()[0]});
  QTest::mouseRelease(&page, Qt::LeftButton, Qt::ShiftModifier, from + QPoint(10, 10));
  EXPECT_EQ(many.size(), 0) << "nothing of a plot that is gone";
}

TEST(PatternPage, NoiseNeverFillsAPlot) {
  PatternPage page;
  PatternPlot plot = test::nine_patterns(40)[0];
  for (ScatterPoint& point : plot.points) point.y = 1e-3;
  page.set_plots({plot});
  test::show(page, {600, 300});
  const QRectF cell = page.plot_rect(0);
  EXPECT_GT(page.on_screen(0, 0, 0.3).y(), cell.top() + 18);
  EXPECT_LT(page.on_screen(0, 0, -0.3).y(), cell.bottom() - 17);
}

TEST(PatternPage, ACandidateIsPurpleAndGoes) {
  PatternPage page;
  std::vector<PatternPlot> plots = test::nine_patterns(20);
  page.set_plots(plots);
  test::show(page, {900, 500});
  EXPECT_GT(list_pixels(page, colors().candidate), 50);
  page.set_candidates({});
  EXPECT_EQ(list_pixels(page, colors().candidate), 0);
}

TEST(Staircase, ClickTakesAVersionAndControlMarksTwo) {
  Staircase stairs;
  stairs.set_state(test::four_versions());
  test::show(stairs, {400, 180});
  QSignalSpy selected(&stairs, &Staircase::version_selected), compared(&stairs, &Staircase::compared);
  QSignalSpy read_out(&stairs, &Staircase::read_out);
  test::click(&stairs, stairs.step_rect(1).center());
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toInt(), 1);
  test::click(&stairs, stairs.step_rect(0).center(), Qt::ControlModifier);
  test::click(&stairs, stairs.step_rect(3).center(), Qt::ControlModifier);
  ASSERT_EQ(compared.size(), 2);
  EXPECT_EQ(compared[1][0].toInt(), 0);
  EXPECT_EQ(compared[1][1].toInt(), 3);
  EXPECT_EQ(selected.size(), 1);
  test::hover(&stairs, stairs.step_rect(2).center());
  EXPECT_TRUE(read_out.back()[0].toString().contains("not added: on unseen observations"));
  QTest::keyClick(&stairs, Qt::Key_Left);  // the shown one is the last: 3
  EXPECT_EQ(selected.back()[0].toInt(), 2);
  QTest::keyClick(&stairs, Qt::Key_Home);
  EXPECT_EQ(selected.back()[0].toInt(), 0);
}

TEST(Staircase, WhatIsTriedIsADashedStepThatMovesNothing) {
  Staircase stairs;
  stairs.set_state(test::four_versions());
  test::show(stairs, {400, 180});
  const QRectF before = stairs.step_rect(3);
  EXPECT_EQ(list_pixels(stairs, colors().candidate), 0);
  stairs.set_preview(VersionStep{"+ payload", {}, 0.22, false, {}});
  EXPECT_EQ(stairs.step_rect(3), before);
  EXPECT_GT(list_pixels(stairs, colors().candidate), 20);
  stairs.set_preview({});
  EXPECT_EQ(list_pixels(stairs, colors().candidate), 0);
}

/// How the stairs look right after a step has come, and a while later.
std::pair<QImage, QImage> a_step_comes() {
  Staircase stairs;
  StaircaseState state = test::four_versions();
  const VersionStep last = state.versions.back();
  state.versions.pop_back();
  state.current = -1;
  stairs.set_state(state);
  test::show(stairs, {400, 180});
  state.versions.push_back(last);
  stairs.set_state(state);
  const QImage at_once = stairs.grab().toImage();
  QTest::qWait(400);
  return {at_once, stairs.grab().toImage()};
}

TEST(Staircase, AStepFallsUnlessMotionIsReduced) {
  const auto moving = a_step_comes();
  EXPECT_NE(moving.first, moving.second) << "it falls to its place";
  const Still still;
  const auto resting = a_step_comes();
  EXPECT_EQ(resting.first, resting.second) << "it is there at once";
  EXPECT_EQ(resting.second, moving.second) << "and at the same place";
}

TEST(CostCurve, GrowsPointByPoint) {
  CostCurve curve;
  curve.start("rms", "px");
  test::show(curve, {332, 172});
  EXPECT_TRUE(curve.is_running());
  for (int i = 0; i < 6; ++i) curve.append(i, std::pow(10.0, 1 - i));
  curve.append(6, std::nan(""));  // a step that failed is not drawn
  EXPECT_EQ(curve.count(), 6);
  QSignalSpy read_out(&curve, &CostCurve::read_out);
  test::hover(&curve, {46, 80});
  ASSERT_EQ(read_out.size(), 1);
  EXPECT_TRUE(read_out[0][0].toString().startsWith("iteration 0: 10.0"));
  curve.finish("settled");
  EXPECT_FALSE(curve.is_running());
  curve.start("rms", "px");
  EXPECT_EQ(curve.count(), 0);
  curve.clear();
  EXPECT_FALSE(curve.is_running()) << "no fit starts where there is none";
}

TEST(WhatIfSlider, DraggingSaysSoAndADoubleClickGoesToTheBest) {
  WhatIfSlider slider;
  slider.set_state(test::eccentricity());
  test::show(slider, {592, 140});
  QSignalSpy changed(&slider, &WhatIfSlider::changed), settled(&slider, &WhatIfSlider::settled);
  WhatIfTrack* track = slider.track();
  test::drag(track, {track->find_x(1.0), 22}, {track->find_x(-2.0), 22});
  EXPECT_GE(changed.size(), 4);
  ASSERT_EQ(settled.size(), 1);
  EXPECT_NEAR(settled[0][0].toDouble(), -2, 0.05);
  QTest::mouseDClick(track, Qt::LeftButton, {}, QPoint(static_cast<int>(track->find_x(0)), 22));
  EXPECT_DOUBLE_EQ(slider.value(), 1.3);
  QTest::keyClick(track, Qt::Key_Home);
  EXPECT_DOUBLE_EQ(slider.value(), 0);
  QTest::keyClick(track, Qt::Key_Right);
  EXPECT_NEAR(slider.value(), 0.12, 1e-12);  // a hundredth of the range of -6 to 6
  QTest::keyClick(track, Qt::Key_B);
  EXPECT_DOUBLE_EQ(slider.value(), 1.3);
}

TEST(WhatIfSlider, TheWheelChangesNothingWithoutFocus) {
  WhatIfSlider slider;
  slider.set_state(test::eccentricity());
  test::show(slider, {592, 140});
  slider.setFocus();
  const double before = slider.value();
  slider.track()->clearFocus();
  test::wheel(slider.track(), {100, 22}, 3);
  EXPECT_DOUBLE_EQ(slider.value(), before);
}

TEST(WhatIfSlider, JointAndParameterAreChosenAndARoomForAFarBestIsMade) {
  WhatIfSlider slider;
  WhatIfState state = test::eccentricity();
  state.parameters[0].best = 20;
  slider.set_state(state);
  test::show(slider, {592, 140});
  EXPECT_GT(slider.track()->reach(), 20);
  QSignalSpy place(&slider, &WhatIfSlider::place_chosen), parameter(&slider, &WhatIfSlider::parameter_chosen);
  slider.place_box()->setFocus();
  QTest::keyClick(slider.place_box(), Qt::Key_Up);
  ASSERT_EQ(place.size(), 1);
  EXPECT_EQ(place[0][0].toInt(), 1);
  QTest::keyClick(slider.parameter_box(), Qt::Key_Down);
  ASSERT_EQ(parameter.size(), 1);
  EXPECT_EQ(parameter[0][0].toInt(), 1);
  EXPECT_DOUBLE_EQ(slider.track()->reach(), 6);
  QSignalSpy closed(&slider, &WhatIfSlider::closed);
  QTest::keyClick(slider.track(), Qt::Key_Escape);
  EXPECT_EQ(closed.size(), 1);
}

TEST(VersionList, ShowsPicksTwoAndTakesBack) {
  VersionList list;
  list.set_versions(test::version_entries(), "px");
  list.set_current(-1);
  test::show(list, {420, 320});
  QSignalSpy selected(&list, &VersionList::version_selected), compared(&list, &VersionList::compared);
  QSignalSpy back(&list, &VersionList::take_back_requested);
  EXPECT_FALSE(list.take_back_button()->isEnabled());  // the last one is the model already
  const QRect row = list.view()->visualRect(list.view()->model()->index(1, 0));
  QTest::mouseClick(list.view()->viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(40, 12));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toInt(), 1);
  list.set_current(1);
  ASSERT_TRUE(list.take_back_button()->isEnabled());
  test::click(list.take_back_button(), list.take_back_button()->rect().center());
  ASSERT_EQ(back.size(), 1);
  EXPECT_EQ(back[0][0].toInt(), 1);
  QTest::mouseClick(list.view()->viewport(), Qt::LeftButton, {}, list.letter_rect(0, false).center());
  QTest::mouseClick(list.view()->viewport(), Qt::LeftButton, {}, list.letter_rect(3, true).center());
  ASSERT_EQ(compared.size(), 2);
  EXPECT_EQ(compared[1][0].toInt(), 0);
  EXPECT_EQ(compared[1][1].toInt(), 3);
  QTest::mouseClick(list.view()->viewport(), Qt::LeftButton, {}, list.letter_rect(3, false).center());
  EXPECT_EQ(compared[2][0].toInt(), 3);
  EXPECT_EQ(compared[2][1].toInt(), -1);  // a version is not compared with itself
  QTest::keyClick(list.view(), Qt::Key_Down);
  EXPECT_EQ(selected.back()[0].toInt(), 2);
  list.set_current(2);
  EXPECT_FALSE(list.take_back_button()->isEnabled());  // it was refused
}

TEST(TruthPanel, RowsAreChosenByMouseAndKeyboard) {
  TruthPanel panel;
  panel.set_rows(test::truth_rows(), "Hidden were three effects.");
  test::show(panel, panel.sizeHint());
  QSignalSpy chosen(&panel, &TruthPanel::row_chosen);
  test::click(&panel, panel.row_rect(1).center());
  QTest::keyClick(&panel, Qt::Key_Down);
  QTest::keyClick(&panel, Qt::Key_Return);
  ASSERT_EQ(chosen.size(), 2);
  EXPECT_EQ(chosen[0][0].toInt(), 1);
  EXPECT_EQ(chosen[1][0].toInt(), 2);
  EXPECT_LE(panel.row_rect(3).bottom(), panel.height());
}

// The painting must leave time for the fit: a bound that is generous for a loaded machine; the gallery's mode "times"
// measures it.

}  // namespace
}  // namespace handsight::widgets
