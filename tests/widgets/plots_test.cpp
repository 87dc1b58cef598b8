// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <qcustomplot.h>

#include <QSignalSpy>
#include <cmath>

#include "temporary_folder.h"
#include "widgets/base/theme.h"
#include "widgets/mouse.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/plots/histogram_bins.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::widgets {
namespace {

using testing::ElementsAre;

QPointF on_screen(const PlotWidget& plot, double x, double y) {
  return {plot.plot()->xAxis->coordToPixel(x), plot.plot()->yAxis->coordToPixel(y)};
}

std::vector<ScatterPoint> line_of_points() {
  std::vector<ScatterPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({100 + i, double(i), double(i), 1.0, 2});
  return points;
}

TEST(ScatterPlot, ClickSelectsAndARectangleSelectsMany) {
  ScatterPlot plot;
  plot.set_points(line_of_points());
  test::show(plot, {500, 400});
  QSignalSpy selected(&plot, &ScatterPlot::observation_selected), many(&plot, &ScatterPlot::observations_selected);
  test::click(plot.plot(), on_screen(plot, 3, 3));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 103);
  const QCPRange before = plot.plot()->xAxis->range();
  test::drag(plot.plot(), on_screen(plot, 4.5, 7.5), on_screen(plot, 7.5, 4.5), Qt::ShiftModifier);
  ASSERT_EQ(many.size(), 1);
  EXPECT_THAT(many[0][0].value<std::vector<qint64>>(), ElementsAre(105, 106, 107));
  EXPECT_EQ(plot.plot()->xAxis->range(), before);  // brushing does not pan
  EXPECT_EQ(selected.size(), 1);
}

TEST(ScatterPlot, WheelZoomsDragPansDoubleClickFits) {
  ScatterPlot plot;
  plot.set_points(line_of_points());
  test::show(plot, {500, 400});
  const QCPRange fitted = plot.plot()->xAxis->range();
  test::wheel(plot.plot(), on_screen(plot, 5, 5), 3);
  EXPECT_LT(plot.plot()->xAxis->range().size(), 0.8 * fitted.size());
  test::drag(plot.plot(), on_screen(plot, 5, 5), on_screen(plot, 6, 5));
  EXPECT_LT(plot.plot()->xAxis->range().center(), fitted.center() - 0.3);
  const QPoint at = on_screen(plot, 5, 5).toPoint();
  QTest::mouseDClick(plot.plot(), Qt::LeftButton, {}, at);
  EXPECT_NEAR(plot.plot()->xAxis->range().size(), fitted.size(), 1e-9);
}

TEST(PlotWidget, SavesPngSvgAndCsvWholeOrSaysWhyNot) {
  const TemporaryFolder folder;
  ScatterPlot plot;
  plot.set_axes("torque", "N m", "residual", "px");
  plot.set_points(line_of_points());
  test::show(plot, {400, 300});
  for (const char* name : {"/a.png", "/a.svg", "/a.csv"}) {
    const QString path = QString::fromStdString(folder.path.string()) + name;
    EXPECT_EQ(plot.save(path), "") << name;
    EXPECT_GT(QFileInfo(path).size(), 100) << name;
  }
  EXPECT_FALSE(QImage(QString::fromStdString(folder.path.string()) + "/a.png").isNull());
  EXPECT_TRUE(plot.csv().startsWith("\"observation id\",\"torque (N m)\",\"residual (px)\"\n100,0,0\n"));
  EXPECT_FALSE(plot.save("/nowhere/a.csv").isEmpty());
}

/// A picture is of the plot, not of who looks at it.
TEST(PlotWidget, PicturesHoldNeitherSelectionNorPointer) {
  ScatterPlot plot;
  plot.set_points(line_of_points());
  test::show(plot, {400, 300});
  const QImage before = plot.picture(1);
  plot.set_selected(103);
  plot.set_hovered(105);
  plot.set_highlighted({101, 102});
  EXPECT_EQ(plot.picture(1), before);
}

TEST(ScatterPlot, OneOutlierDoesNotFlattenThePlot) {
  std::vector<ScatterPoint> points;
  for (int i = 0; i < 40; ++i) points.push_back({i, double(i), std::sin(i), 1.0, 2});
  ScatterPlot plot;
  plot.set_points(points);
  test::show(plot, {500, 400});
  const QCPRange without = plot.plot()->yAxis->range();
  points[20].y = 1000;
  plot.set_points(points);
  plot.fit();
  EXPECT_LT(plot.plot()->yAxis->range().size(), 1.5 * without.size());
}

TEST(ConvergencePlot, SettlesWhereItStaysWithinTwoSigma) {
  ConvergencePlot plot("position", "mm", {"x", "y", "z"});
  std::vector<ConvergencePlot::Sample> samples;
  for (int i = 1; i <= 20; ++i) {
    const double x = i < 8 ? 0.010 : 0.001;  // m; sigma 1 mm
    samples.push_back({i, i, {x, i * 0.01, 0}, {0.001, 0.001, 0.001}});
  }
  plot.set_samples(samples);
  EXPECT_EQ(plot.settled_at(0), 8);
  EXPECT_EQ(plot.settled_at(1), 0);  // still moves by ten sigma a step
  EXPECT_EQ(plot.settled_at(2), 1);
}

std::vector<ConvergencePlot::Sample> samples_about(double x, int count) {
  std::vector<ConvergencePlot::Sample> samples;
  for (int i = 1; i <= count; ++i) samples.push_back({i, i, {x + 0.01 / i, x, x}, {0.001, 0.001, 0.001}});
  return samples;
}

TEST(ConvergencePlot, PlotsThatShareTheirAxesShowAllOfEachOther) {
  ConvergencePlot a("position", "mm", {"x", "y", "z"}), b("position", "mm", {"x", "y", "z"}),
      c("rotation", "deg", {"rx", "ry", "rz"});
  ConvergencePlot::share_axes({{&a, &b}, {&c}});
  a.set_origin(std::array<double, 3>{0, 0, 0});
  b.set_origin(std::array<double, 3>{0, 0, 0});
  a.set_samples(samples_about(0, 10));
  b.set_samples(samples_about(0.05, 40));  // 5 cm off
  c.set_samples(samples_about(0, 5));
  a.fit();
  EXPECT_EQ(a.plot()->yAxis->range(), b.plot()->yAxis->range());
  EXPECT_TRUE(a.plot()->yAxis->range().contains(50)) << "counted from the common origin, not from each one's last";
  EXPECT_TRUE(a.plot()->yAxis->range().contains(0));
  for (const ConvergencePlot* plot : {&a, &b, &c}) EXPECT_DOUBLE_EQ(plot->plot()->xAxis->range().upper, 40);
  EXPECT_LT(c.plot()->yAxis->range().upper, 5) << "another row has a y axis of its own";
  b.plot()->yAxis->setRange(10, 20);
  EXPECT_EQ(a.plot()->yAxis->range(), QCPRange(10, 20));
  b.plot()->xAxis->setRange(3, 9);
  EXPECT_EQ(c.plot()->xAxis->range(), QCPRange(3, 9));
}

TEST(ConvergencePlot, WhereTheAxisIsTooShortToSayThatItIsAChangeTheTitleDoes) {
  ConvergencePlot plot("position", "mm", {"x", "y", "z"});
  plot.set_title("TCP, position");
  std::vector<ConvergencePlot::Sample> samples = samples_about(3, 10);
  for (auto& sample : samples) sample.sigma = {0.1, 0.1, 0.1};
  plot.set_samples(samples);
  const auto title = [&] { return qobject_cast<QCPTextElement*>(plot.plot()->plotLayout()->element(0, 0))->text(); };
  test::show(plot, {420, 130});
  plot.plot()->replot();
  EXPECT_EQ(title(), "TCP, position, change from final");
  plot.resize(420, 400);
  QTest::qWait(50);
  plot.plot()->replot();
  EXPECT_EQ(title(), "TCP, position");
  EXPECT_EQ(plot.plot()->yAxis->label(), "change from final (mm)");
}

TEST(ConvergencePlot, TheLettersAtTheCurvesEndsNeverMeet) {
  ConvergencePlot plot("position", "mm", {"x", "y", "z"});
  test::show(plot, {500, 120});
  for (const double end : {-1.0, -0.9, 0.0, 0.9, 1.0}) {
    // The first ones reach up and down, so that the ends are at the border where `end` is.
    plot.set_samples({{1, 1, {1, -1, 0}, {0, 0, 0}}, {2, 2, {end, end, end}, {0, 0, 0}}});
    plot.plot()->replot();
    std::vector<double> places;
    for (int i = 0; i < plot.plot()->itemCount(); ++i)
      if (const auto* label = qobject_cast<QCPItemText*>(plot.plot()->item(i)))
        if (QStringList{"x", "y", "z"}.contains(label->text().section(' ', 0, 0)))
          places.push_back(label->position->pixelPosition().y());
    ASSERT_EQ(places.size(), 3U);
    std::sort(places.begin(), places.end());
    const double height = QFontMetricsF(number_font(TextRole::small)).ascent();
    for (int i = 1; i < 3; ++i) EXPECT_GE(places[i] - places[i - 1], height) << end;
    EXPECT_GE(places[0], plot.plot()->axisRect()->rect().top()) << end;
    EXPECT_LE(places[2], plot.plot()->axisRect()->rect().bottom() + height) << end;
  }
}

TEST(ConvergencePlot, ClickSelectsTheObservationOfThatCount) {
  ConvergencePlot plot("position", "mm", {"x", "y", "z"});
  std::vector<ConvergencePlot::Sample> samples;
  for (int i = 1; i <= 20; ++i) samples.push_back({i, 100 + i, {0, 0, 0}, {0.001, 0.001, 0.001}});
  plot.set_samples(samples);
  test::show(plot, {500, 200});
  QSignalSpy selected(&plot, &ConvergencePlot::observation_selected);
  test::click(plot.plot(), on_screen(plot, 12.2, 0));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 112);
}

TEST(HistogramPlot, TheThresholdCanBeDraggedAndNamesWhatIsBeyond) {
  HistogramPlot plot;
  std::vector<ObservationCell> cells;
  for (int i = 0; i < 20; ++i) cells.push_back({i, CellState::used, i < 17 ? 1.0 : 12.0, {}, 12, {}});
  cells[19].state = CellState::excluded;
  plot.set_cells(cells);
  plot.set_noise(0.2, "px");
  plot.set_threshold(30);
  test::show(plot, {420, 300});
  plot.fit();
  EXPECT_TRUE(plot.beyond_threshold().empty());
  plot.set_threshold(2);
  QSignalSpy set(&plot, &HistogramPlot::threshold_set);
  test::drag(plot.plot(), on_screen(plot, std::log10(2.0), 3), on_screen(plot, std::log10(5.0), 3));
  ASSERT_EQ(set.size(), 1);
  EXPECT_NEAR(set[0][0].toDouble(), 5, 0.3);
  EXPECT_THAT(set[0][1].value<std::vector<qint64>>(), ElementsAre(17, 18));
}

TEST(HistogramPlot, InMmEverythingIsInMmAndTheNoiseHasItsOwnShape) {
  std::vector<ObservationCell> cells;
  for (int i = 0; i < 100; ++i) {
    ObservationCell cell{i, CellState::used, 1.0, {}, 12, {}};
    cell.size = ShownSize{i < 90 ? 0.4 : 3.0, SizeUnit::millimetre};
    cell.noise = NoiseShape{i % 2 == 0 ? 0.3 : 0.5, 4.5};
    cells.push_back(cell);
  }
  cells[7].size = ShownSize{2.0, SizeUnit::pixel};  // seen by one camera alone: it has no mm
  const auto noise = noise_bins(cells, SizeUnit::millimetre);
  double all = 0, below = 0;
  for (const auto& [bin, expected] : noise) {
    all += expected;
    if (std::pow(10, (bin + 1) * histogram_bin) <= 0.41) below += expected;
  }
  EXPECT_NEAR(all, 99, 1.5) << "noise alone puts every observation somewhere";
  EXPECT_GT(below, 35) << "those of little noise below 0.4 mm";
  EXPECT_LT(below, 75) << "the others above";
  EXPECT_TRUE(noise_bins(cells, SizeUnit::pixel).size() <= 21);
  HistogramPlot plot;
  plot.set_unit(SizeUnit::millimetre);
  plot.set_noise(0.2, "px");
  plot.set_cells(cells);
  plot.set_threshold(1.0);
  test::show(plot, {420, 300});
  EXPECT_TRUE(plot.plot()->xAxis->label().contains("(mm)")) << plot.plot()->xAxis->label().toStdString();
  EXPECT_EQ(plot.beyond_threshold().size(), 10U);
  EXPECT_EQ(plot.csv().section('\n', 0, 0), "\"observation id\",\"rms (mm)\"");
  plot.set_unit(SizeUnit::sigma);
  EXPECT_FALSE(plot.threshold()) << "1 mm is not 1 sigma";
}

TEST(ResidualMap, ExaggerationIsARoundNumber) {
  ResidualMap map;
  map.set_image_size(640, 480);
  std::vector<MapPoint> points;
  for (int i = 0; i < 50; ++i) points.push_back({i, 0, 0, Vector2(10 * i, 5 * i), Vector2(0.3, -0.2), 1.5});
  map.set_points(points);
  EXPECT_DOUBLE_EQ(map.exaggeration(), 100);  // 640 / 12 / 0.36 = 148
  test::show(map, {420, 340});
  QSignalSpy selected(&map, &ResidualMap::observation_selected);
  test::click(map.plot(), on_screen(map, 200, 100));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 20);
  // v grows downward, and both axes have one scale.
  EXPECT_GT(on_screen(map, 0, 400).y(), on_screen(map, 0, 100).y());
  EXPECT_NEAR(on_screen(map, 100, 0).x() - on_screen(map, 0, 0).x(),
              on_screen(map, 0, 100).y() - on_screen(map, 0, 0).y(), 1.5);
}

}  // namespace
}  // namespace handsight::widgets
