// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <QSignalSpy>

#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/lists/observation_strip.h"
#include "widgets/lists/three_numbers.h"
#include "widgets/mouse.h"
#include "widgets/sample_data.h"

namespace handsight::widgets {
namespace {

TEST(ObservationStrip, ClickSelectsAndArrowsStep) {
  ObservationStrip strip;
  strip.set_cells(test::many_cells(100));
  test::show(strip, {1100, 72});
  QSignalSpy selected(&strip, &ObservationStrip::observation_selected);
  test::click(&strip, strip.cell_rect(37).center());
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 37);
  strip.setFocus();
  QTest::keyClick(&strip, Qt::Key_Right);
  QTest::keyClick(&strip, Qt::Key_Left);
  QTest::keyClick(&strip, Qt::Key_Left);
  EXPECT_EQ(strip.selected(), 36);
  QTest::keyClick(&strip, Qt::Key_End);
  EXPECT_EQ(strip.selected(), 99);
}

TEST(ObservationStrip, ShiftAndDragSelectMany) {
  ObservationStrip strip;
  strip.set_cells(test::many_cells(100));
  test::show(strip, {1100, 72});
  QSignalSpy many(&strip, &ObservationStrip::observations_selected);
  test::drag(&strip, strip.cell_rect(10).center(), strip.cell_rect(14).center());
  ASSERT_EQ(many.size(), 1);
  EXPECT_THAT(many[0][0].value<std::vector<qint64>>(), testing::ElementsAre(10, 11, 12, 13, 14));
}

// The setter is called by the selection, not by the user: it must not answer, or signals would bounce.
TEST(ObservationStrip, SettingTheSelectionSaysNothing) {
  ObservationStrip strip;
  strip.set_cells(test::many_cells(100));
  QSignalSpy selected(&strip, &ObservationStrip::observation_selected);
  strip.set_selected(5);
  EXPECT_EQ(selected.size(), 0);
}

TEST(ObservationStrip, OfTenThousandTheWorstShowsAndTheWheelFindsSingleCells) {
  ObservationStrip strip;
  auto cells = test::many_cells(10000);
  for (auto& cell : cells) cell.rms_over_sigma = 0.8;
  cells[5000].rms_over_sigma = 30;
  strip.set_cells(cells);
  test::show(strip, {1200, 72});
  const QImage image = strip.grab().toImage();
  const QPoint at = strip.cell_rect(5000).center().toPoint();
  bool is_shown = false;
  for (int x = at.x() - 2; x <= at.x() + 2; ++x) is_shown |= image.pixelColor(x, at.y()) == colors().residual[5];
  EXPECT_TRUE(is_shown);
  const QPointF middle = strip.cell_rect(5000).center();
  for (int i = 0; i < 30; ++i) test::wheel(&strip, middle, 1);
  EXPECT_GT(strip.cell_rect(5000).width(), 10);
  EXPECT_EQ(strip.cell_at(strip.cell_rect(5001).center()), 5001);
}

/// The height at which a cell's bar begins, px above the cells' lower edge.
int height_of(ObservationStrip& strip, ObservationId id) {
  const QImage image = strip.grab().toImage();
  const QRectF cell = strip.cell_rect(id);
  const int x = static_cast<int>(cell.center().x());
  int y = static_cast<int>(cell.bottom()) - 1;
  const QColor ground = colors().sunken;
  while (y > cell.top() && image.pixelColor(x, y) != ground) --y;
  return static_cast<int>(cell.bottom()) - 1 - y;
}

TEST(ObservationStrip, WithoutAKnownNoiseTheHeightIsTheSizeBesideTheLargest) {
  ObservationStrip strip;
  auto cells = test::many_cells(40);
  for (auto& cell : cells) {
    cell.state = CellState::used;
    cell.rms_over_sigma.reset();
    cell.size = ShownSize{0.1, SizeUnit::millimetre};
  }
  cells[10].size->value = 2.0;
  cells[20].size->value = 0.6;
  cells[30].size->value = 40.0;
  cells[30].state = CellState::rejected;
  strip.set_cells(cells);
  test::show(strip, {1100, 72});
  const int largest = height_of(strip, 10), middling = height_of(strip, 20), small = height_of(strip, 5);
  EXPECT_GT(largest, 30) << "the largest that is used fills its cell, whatever a rejected one is";
  EXPECT_LT(middling, largest - 6);
  EXPECT_LT(small, middling - 6);
  EXPECT_GT(small, 2);
  const QRectF cell = strip.cell_rect(10);
  EXPECT_EQ(strip.grab().toImage().pixelColor(cell.center().toPoint()), colors().residual[1]) << "neither good nor bad";
}

double brightness(const QColor& c) { return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF(); }

TEST(ObservationStrip, AStrokeIsSeenOnABarOfAnyColour) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
    apply_theme(*qApp, kind);
    for (const double size : {0.5, 1.3, 4.0, 8.0, 30.0}) {
      ObservationStrip strip;
      auto cells = test::many_cells(40);
      for (auto& cell : cells) cell.rms_over_sigma = size;
      cells[20].state = CellState::rejected;
      strip.set_cells(cells);
      test::show(strip, {1100, 72});
      const QImage image = strip.grab().toImage();
      const QRect cell = strip.cell_rect(20).toRect();
      const double bar = brightness(colors().residual[static_cast<std::size_t>(residual_step(size, 12))]);
      double most = 0;
      for (int x = cell.left() + 2; x < cell.right() - 2; ++x)
        most = std::max(most, std::abs(brightness(image.pixelColor(x, cell.bottom() - 3)) - bar));
      EXPECT_GT(most, 0.25) << size << " times the noise";
    }
  }
  apply_theme(*qApp, ThemeKind::light);
}

TEST(ThreeNumbers, NothingIsCutOffAtAnyScale) {
  ThreeNumbers three;
  ErrorNumbers n;
  n.now = 8.34;
  n.noise = 0.2;
  n.excluded_note = "7 excluded: 9.4 px";
  three.set_numbers(n);
  three.resize(three.sizeHint());
  for (const double scale : {1.0, 1.5, 2.0, 3.0}) {
    QImage image(three.size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(colors().window);
    three.render(&image);
    const auto has_ink = [&](int y) {
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y) != colors().window) return true;
      return false;
    };
    for (const int edge : {0, 1}) {
      EXPECT_FALSE(has_ink(edge)) << scale;
      EXPECT_FALSE(has_ink(image.height() - 1 - edge)) << scale;
    }
    // Digits of 24 px are 17 px high or more; cut off at the top they would be less.
    int top = 0, bottom = 0;
    while (!has_ink(top)) ++top;
    for (bottom = top; has_ink(bottom);) ++bottom;
    EXPECT_GE(bottom - top, 17 * scale) << scale;
  }
}

TEST(ThreeNumbers, AClickOnAStepChoosesThatVersion) {
  ThreeNumbers three;
  ErrorNumbers n;
  n.now = 0.24, n.noise = 0.2;
  n.versions = {{"first", 9.0, 9.1, false, {}}, {"second", 0.2, 0.24, false, {}}};
  three.set_numbers(n);
  test::show(three, three.sizeHint());
  QSignalSpy chosen(&three, &ThreeNumbers::version_selected), read(&three, &ThreeNumbers::read_out);
  test::hover(&three, three.step_rect(0).center());
  ASSERT_EQ(read.size(), 1);
  EXPECT_THAT(read[0][0].toString().toStdString(), testing::HasSubstr("9.1"));
  test::click(&three, three.step_rect(0).center());
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 0);
}

}  // namespace
}  // namespace handsight::widgets
