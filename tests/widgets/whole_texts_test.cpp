// SPDX-License-Identifier: Apache-2.0
// What has no room is reported in fewer words, not in half of one; and a plot of little height can still be read.
#include <gtest/gtest.h>

#include "app/window/painted_text.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/explain/verdict_line.h"
#include "widgets/mouse.h"
#include "widgets/plots/convergence_plot.h"

namespace handsight::widgets {
namespace {

QStringList painted(QWidget& widget) {
  QStringList all;
  for (const test::PaintedText& text : test::texts_of(widget)) all << text.text;
  return all;
}

void expect_nothing_cut(const QStringList& texts) {
  for (const QString& text : texts) EXPECT_FALSE(text.contains(QChar(0x2026))) << text.toStdString();
}

/// The texts of a page with one small plot, none of them cut.
QStringList painted_small_plot(const char* what, const char* against, const char* shows) {
  PatternPage page;
  PatternPlot plot{.id = "a", .what = what, .against = against};
  plot.points = {{1, 0, 0, 1.0, 2}, {2, 1, 1, 1.0, 2}};
  plot.shows = shows;
  page.set_plots({plot});
  test::show(page, {600, 240});
  const QStringList texts = painted(page);
  expect_nothing_cut(texts);
  return texts;
}

TEST(WholeTexts, ALongActionAboveTheCloudGivesWayToAfter) {
  ResidualCloud cloud;
  cloud.set_before({{.observation = 1, .du = 1}}, "as opened");
  cloud.set_after({{.observation = 1, .du = 0.1}},
                  "added joint elasticity of right_arm_1, right_arm_2 and right_arm_4");
  test::show(cloud, {332, 172});
  const QStringList texts = painted(cloud);
  EXPECT_TRUE(texts.contains("as opened")) << texts.join('|').toStdString();
  EXPECT_TRUE(texts.contains("after")) << texts.join('|').toStdString();
  expect_nothing_cut(texts);
}

TEST(WholeTexts, OfTheEffectsThatShowSomeAreNamedInFull) {
  const QStringList texts = painted_small_plot("error", "time", "camera intrinsics, stereo rig, link geometry");
  EXPECT_TRUE(texts.join('|').contains("camera intrinsics, stereo rig")) << texts.join('|').toStdString();
}

/// German at 1280 px: a long variable beside an effect that shows.
TEST(WholeTexts, AVariableIsWholeBeforeAnEffectIsNamed) {
  const QStringList texts =
      painted_small_plot("Fehler von right_arm_1", "Schweremoment an right_arm_3", "Gelenkelastizität");
  EXPECT_TRUE(texts.join(' ').contains("Schweremoment an right_arm_3")) << texts.join('|').toStdString();
}

/// Beside no large plot: numbers along both axes, and units.
TEST(WholeTexts, SmallPlotsByThemselvesHaveNumbersAndUnits) {
  PatternPage page;
  PatternPlot plot{.id = "a", .what = "error", .against = "torque", .x_unit = "N m", .y_unit = "mrad"};
  plot.points = {{1, -21, -1.4, 1.0, 2}, {2, 34, 2.6, 1.0, 2}};
  page.set_plots({plot, plot});
  page.show_numbers();
  for (const QSize size : {QSize(600, 110), QSize(1200, 300)}) {
    page.set_rows(1);
    test::show(page, size);
    const QStringList texts = painted(page);
    for (const QString& one : {QString("error (mrad)"), QString("against torque (N m)"), QString("0"), QString("2"),
                               QString("20"), QChar(0x2212) + QString("20")})
      EXPECT_TRUE(texts.contains(one)) << one.toStdString() << " in " << texts.join('|').toStdString();
  }
}

TEST(WholeTexts, AWholeHundredPerCentKeepsAwayFromTheNextLetter) {
  for (const ErrorAttribution& attribution :
       {ErrorAttribution{1, 0, 0}, ErrorAttribution{0, 1, 0}, ErrorAttribution{0, 0, 1}}) {
    VerdictLine line;
    SessionVerdict verdict{
        .state = SessionState::missing, .sentence = "The model misses.", .error_px = 1, .noise_px = 0.2};
    verdict.attribution = attribution;
    line.set_verdict(verdict);
    test::show(line, {1160, 72});
    std::vector<QRectF> letters;
    for (const test::PaintedText& text : test::texts_of(line))
      if (text.text.contains(QRegularExpression("^[CBR] [0-9]+ %$"))) letters.push_back(text.place);
    ASSERT_EQ(letters.size(), 3U);
    constexpr double swatch = 13, apart = 5;
    for (std::size_t i = 1; i < 3; ++i) EXPECT_GE(letters[i].left() - swatch, letters[i - 1].right() + apart) << i;
    EXPECT_LE(letters[2].right(), line.width());
  }
}

/// One tick tells no size.
TEST(WholeTexts, ALowPlotHasTwoTicksAtLeastWhateverItsRange) {
  ConvergencePlot plot("TCP to TCPest", "mm", {"x", "y", "z"});
  test::show(plot, {380, 122});
  for (double reach = 1e-3; reach < 0.05; reach *= 1.13) {
    std::vector<ConvergencePlot::Sample> samples;
    for (int i = 0; i < 20; ++i)
      samples.push_back({.count = i + 1, .observation = i, .value = {i % 2 ? reach : -0.7 * reach, 0, 0}});
    plot.set_samples(samples);
    plot.plot()->replot();
    const QCPAxis* axis = plot.plot()->yAxis;
    int inside = 0;
    for (const double tick : axis->tickVector()) inside += axis->range().contains(tick);
    EXPECT_GE(inside, 2) << reach;
  }
}

}  // namespace
}  // namespace handsight::widgets
