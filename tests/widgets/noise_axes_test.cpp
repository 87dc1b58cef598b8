// SPDX-License-Identifier: Apache-2.0
// No plot magnifies noise: where nothing but noise is shown its axis spans six sigma all the same, and a plot whose
// noise grows opens with it.
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <cmath>

#include "widgets/explain/log_axis.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/mouse.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::widgets {
namespace {

constexpr double sigma = 0.2;
constexpr double rounding = 1e-9;

/// So little that an axis by the data alone would show nothing but it.
double little(int i) { return 0.01 * sigma * std::sin(3.0 * i); }

std::vector<ScatterPoint> little_points() {
  std::vector<ScatterPoint> points;
  for (int i = 0; i < 12; ++i) points.push_back({100 + i, double(i), little(i), 0.01, 2});
  return points;
}

void expect_six_sigma(const QCPRange& range, double of = sigma) {
  EXPECT_GE(range.size(), 6 * of - rounding) << range.lower << " to " << range.upper;
}

TEST(NoiseAxes, ScatterPlot) {
  ScatterPlot plot;
  plot.set_noise_band(sigma);
  plot.set_points(little_points());
  plot.fit();
  expect_six_sigma(plot.plot()->yAxis->range());
  for (const double more : {1.05, 1.1, 1.15, 1.3}) {  // other versions, within the slack of axes that stay and beyond
    plot.set_noise_band(more * sigma);
    plot.fit_if_outgrown();
    expect_six_sigma(plot.plot()->yAxis->range(), more * sigma);
  }
}

TEST(NoiseAxes, ScatterPlotOfAProofWhoseNoiseStandsAboutTheCurve) {
  ScatterPlot plot;
  plot.set_noise_band(sigma, false);
  plot.set_points(little_points());
  plot.set_candidate({{0, 0, -sigma, sigma}, {11, 0.01, 0.01 - sigma, 0.01 + sigma}});
  plot.fit();
  expect_six_sigma(plot.plot()->yAxis->range());
}

TEST(NoiseAxes, PatternPageAndProofPlots) {
  PatternPage page;
  PatternPlot plot{.id = "z / time", .points = little_points(), .noise = sigma};
  page.set_plots({plot});
  test::show(page, {620, 300});
  const auto share_of_noise = [&](double noise) {
    const double high = page.on_screen(0, 0, noise).y(), low = page.on_screen(0, 0, -noise).y();
    return (low - high) / page.plot_rect(0).height();
  };
  EXPECT_LE(share_of_noise(3 * sigma), 1 + rounding);
  // What fills the plot stays as far as it goes when the axes are kept.
  plot.noise = 1.17 * sigma;
  page.update_plots({plot});
  const QRectF area = page.plot_rect(0);
  EXPECT_GE(page.on_screen(0, 0, 3 * *plot.noise).y(), area.top());
  EXPECT_LE(page.on_screen(0, 0, -3 * *plot.noise).y(), area.bottom());
  EXPECT_LE(share_of_noise(3 * *plot.noise), 1 + rounding);
}

std::vector<ConvergencePlot::Sample> still_samples(bool has_band) {
  std::vector<ConvergencePlot::Sample> samples;
  for (int i = 0; i < 30; ++i) {
    ConvergencePlot::Sample s{.count = i + 1, .observation = i, .value = {1 + 1e-6 * i, 1, 1}};
    (has_band ? s.sigma : s.noise) = {1e-3, 5e-4, 5e-4};
    samples.push_back(s);
  }
  return samples;
}

TEST(NoiseAxes, ConvergencePlotWithBands) {
  ConvergencePlot plot("TCP to body", "mm", {"x", "y", "z"});
  plot.set_samples(still_samples(true));
  expect_six_sigma(plot.plot()->yAxis->range(), 1);  // mm
  plot.append(still_samples(true));
  expect_six_sigma(plot.plot()->yAxis->range(), 1);
}

TEST(NoiseAxes, ConvergencePlotOfSingleObservations) {
  ConvergencePlot plot("TCP to TCPest", "mm", {"x", "y", "z"});
  plot.set_samples(still_samples(false));
  expect_six_sigma(plot.plot()->yAxis->range(), 1);
  ConvergenceBoard board;
  ConvergencePoint point{.count = 1, .observation = 0};
  point.tcp_from_tcp_est = Vector6::Zero();
  point.sigma = Vector6::Constant(1e-3);
  point.deviation_sigma = Vector6::Constant(2e-3);
  board.set_points({point});
  constexpr double degrees = 57.29577951308232;
  const double wanted[] = {1, 1e-3 * degrees, 2, 2e-3 * degrees};
  for (int i = 0; i < 4; ++i) expect_six_sigma(board.plot(i)->plot()->yAxis->range(), wanted[i]);
}

TEST(NoiseAxes, HistogramPlotShowsThreeTimesTheNoiseAndAThirdOfIt) {
  for (const SizeUnit unit : {SizeUnit::sigma, SizeUnit::pixel}) {
    HistogramPlot plot;
    std::vector<ObservationCell> cells;
    const double noise = unit == SizeUnit::sigma ? 1 : sigma;
    for (int i = 0; i < 20; ++i) {
      ObservationCell cell{i, CellState::used, 1.0, {}, 12, {}};
      cell.size = ShownSize{noise, unit};
      cell.noise = NoiseShape{noise, 12};
      cells.push_back(cell);
    }
    plot.set_unit(unit);
    plot.set_noise(sigma, "px");
    plot.set_cells(cells);
    plot.fit();
    const QCPRange range = plot.plot()->xAxis->range();  // log10 of the size, which has no sign
    EXPECT_GE(range.upper, std::log10(3 * noise));
    EXPECT_LE(range.lower, std::log10(noise / 3));
  }
}

TEST(NoiseAxes, ResidualMapDrawsThreeSigmaNoLongerThanATwelfth) {
  ResidualMap map;
  map.set_image_size(640, 480);
  std::vector<MapPoint> points;
  for (int i = 0; i < 50; ++i) {
    const Vector2 residual(little(i), little(i + 1));
    points.push_back({i, 0, 0, Vector2(10 * i, 5 * i), residual, residual.norm() / std::sqrt(2.0) / sigma});
  }
  map.set_points(points);
  EXPECT_LE(3 * sigma * map.exaggeration(), 640 / 12.0);
  EXPECT_GE(3 * sigma * map.exaggeration(), 640 / 12.0 / 2.5) << "the next of 1, 2, 5 would be too long";
}

TEST(NoiseAxes, ResidualCloudReachesFiveSigma) {
  std::vector<CloudPoint> points;
  for (int i = 0; i < 12; ++i) points.push_back({.observation = i, .du = little(i), .dv = little(i + 1)});
  ResidualCloud cloud;
  cloud.set_noise(sigma);
  cloud.set_before(points, "before");
  EXPECT_GE(cloud.reach(), 3 * sigma);
  cloud.set_noise(3 * sigma);  // told after the points
  EXPECT_GE(cloud.reach(), 3 * 3 * sigma);
}

/// Errors are rms of many coordinates: that of a hundred is known to 7 %, six of which are 42 %.
TEST(NoiseAxes, StaircaseAndCostSpanSixSigmaOfAnErrorOfAHundredCoordinates) {
  const LogAxis axis = LogAxis::over(sigma, 1.0001 * sigma, 100, 0);
  EXPECT_GE(axis.high / axis.low, 1.42);
  EXPECT_GE(axis.high / axis.low, 2) << "as it says of itself";
}

}  // namespace
}  // namespace handsight::widgets
