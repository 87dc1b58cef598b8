// SPDX-License-Identifier: Apache-2.0
// One choice of the unit, and every view tells its sizes in it.
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QRegularExpression>
#include <QToolButton>

#include "app/window/pages.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/read_out_line.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/explain/staircase.h"
#include "widgets/lists/three_numbers.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/plots/scatter_plot.h"
#include "workbench/preferences.h"

namespace handsight::test {
namespace {

using widgets::SizeUnit;

class Units : public testing::Test {
 protected:
  ~Units() override { app::remember_preference("unit", "px"); }
  std::filesystem::path make_copy(const char* name) {
    const auto copy = folder.path / name;
    std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name, copy,
                          std::filesystem::copy_options::recursive);
    return copy;
  }
  void open(Desk& desk, const std::filesystem::path& session) {
    desk.window.resize(1440, 900);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_NE(desk.document().model(), nullptr);
    ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  }
  static const widgets::ErrorNumbers& numbers(Desk& desk) {
    return desk.find<widgets::ThreeNumbers>("three_numbers")->numbers();
  }
  static QString head_of_sizes(Desk& desk) {
    return InspectPage{desk}.table()->view()->model()->headerData(1, Qt::Horizontal).toString();
  }
  static double first_size(Desk& desk) {
    auto* model = InspectPage{desk}.table()->view()->model();
    return model->index(0, 1).data().toString().toDouble();
  }
  static QString crumb(Desk& desk, const char* name) { return desk.find<QToolButton>(name)->text(); }
  TemporaryFolder folder;
};

TEST_F(Units, UTurnsEveryViewFromPxToMmToSigmaAndBack) {
  Desk desk;
  open(desk, make_copy("hidden_3"));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  InspectPage inspect{desk};
  inspect.click_row(0);
  const InspectionRow& row = *desk.window.workbench().selected_row();
  const ErrorSummary held_out = desk.document().model()->report->held_out;
  const double noise = *desk.document().model()->fit->noise;
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  auto* histogram = desk.find<widgets::HistogramPlot>("histogram");
  const auto cell = [&] { return strip->cells()[static_cast<std::size_t>(row.index)]; };
  const auto colour = cell().rms_over_sigma;
  const auto expect = [&](SizeUnit unit, double error, double of_row, double floor, double floor_of_row) {
    const QString name = widgets::unit_name(unit);
    EXPECT_EQ(numbers(desk).unit, name);
    EXPECT_NEAR(*numbers(desk).now, error, 1e-9 * error);
    EXPECT_NEAR(*numbers(desk).noise, floor, 1e-9 * floor);
    EXPECT_NEAR(*numbers(desk).ratio, error / floor, 1e-9) << "of the numbers beside it";
    EXPECT_NEAR(*numbers(desk).versions.back().held_out, error, 1e-9 * error) << "the small staircase too";
    EXPECT_EQ(head_of_sizes(desk), name);
    EXPECT_NEAR(first_size(desk), of_row, 0.5);
    EXPECT_TRUE(widgets::cell_text(cell()).contains(name)) << widgets::cell_text(cell()).toStdString();
    EXPECT_EQ(cell().rms_over_sigma, colour) << "colours stay";
    EXPECT_TRUE(crumb(desk, "crumb_0").endsWith(name)) << crumb(desk, "crumb_0").toStdString();
    EXPECT_TRUE(desk.find<QToolButton>(unit == SizeUnit::pixel        ? "unit_px"
                                       : unit == SizeUnit::millimetre ? "unit_mm"
                                                                      : "unit_sigma")
                    ->isChecked());
    const QString axis = histogram->plot()->xAxis->label();
    EXPECT_TRUE(axis.contains(unit == SizeUnit::sigma ? QString("rms / noise") : "(" + name + ")"))
        << axis.toStdString();
    EXPECT_NEAR(*histogram->threshold(), 3 * floor_of_row, 1e-9) << "three times the noise, whatever it is told in";
  };
  expect(SizeUnit::pixel, *held_out.rms_pixel, *row.rms, noise, noise);
  desk.key(Qt::Key_U);
  expect(SizeUnit::millimetre, 1e3 * *held_out.hand_m, 1e3 * *row.hand_m,
         1e3 * *desk.document().model()->report->noise_of_hand_m,
         1e3 * *desk.document().model()->report->rms_of_noise_m);
  desk.key(Qt::Key_U);
  expect(SizeUnit::sigma, *held_out.rms_pixel / noise, *row.ratio, 1, 1);
  desk.key(Qt::Key_U);
  expect(SizeUnit::pixel, *held_out.rms_pixel, *row.rms, noise, noise);
}

TEST_F(Units, ACornerInMmIsAcrossItsLineOfSight) {
  Desk desk;
  open(desk, make_copy("hidden_3"));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  InspectPage{desk}.click_row(0);
  const auto& workbench = desk.window.workbench();
  const MarkerResidual& m = workbench.selected_row()->markers[0];
  desk.window.workbench().selection.select(
      {.observation = workbench.selection.current().observation, .marker = m.marker, .camera = 0});
  EXPECT_TRUE(crumb(desk, "crumb_2").endsWith("px"));
  desk.press_button("unit_mm");
  const double px = (*m.corners[0].measured - *m.corners[0].predicted).norm();
  const double mm = 1e3 * px * m.predicted_in_sensor.z() / workbench.document.session().rig->at(0).camera.fx;
  const QString reported = crumb(desk, "crumb_2");
  EXPECT_NEAR(reported.section("  ", 1).section(QChar(0x00A0), 0, 0).toDouble(), mm, 0.06 * mm)
      << reported.toStdString();
  EXPECT_TRUE(reported.endsWith("mm"));
}

TEST_F(Units, TheResidualsOverTheImageKeepTheirPlacesAndColours) {
  Desk desk;
  open(desk, make_copy("hidden_3"));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  auto* map = desk.find<widgets::ResidualMap>("residual_map");
  const auto column = [&](int i) {
    std::vector<double> values;
    for (const QString& line : map->csv().split('\n', Qt::SkipEmptyParts).mid(1))
      values.push_back(line.section(',', i, i).toDouble());
    return values;
  };
  const auto u = column(3), residual = column(5);
  ASSERT_GT(u.size(), 100U);
  desk.key(Qt::Key_U);
  desk.key(Qt::Key_U);
  EXPECT_EQ(column(3), u) << "places in the image are in px";
  EXPECT_TRUE(map->csv().section('\n', 0, 0).contains(QString::fromUtf8("residual u (σ)")));
  const double noise = *desk.document().model()->fit->noise;
  const auto in_sigma = column(5);
  for (std::size_t i = 0; i < residual.size(); i += 17) EXPECT_NEAR(in_sigma[i], residual[i] / noise, 1e-4);
}

TEST_F(Units, ExplainTellsTheVerdictTheStaircaseAndThePatternsInIt) {
  Desk desk;
  open(desk, make_copy("hidden_3"));
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  auto* stairs = desk.find<widgets::Staircase>("staircase");
  auto* page = desk.find<widgets::PatternPage>("pattern_page");
  ASSERT_TRUE(desk.wait([&] { return desk.find<QAbstractButton>("tab_patterns")->isVisible(); }));
  desk.press_button("tab_patterns");
  const auto in_px = page->plots();
  const double step = *stairs->state().versions.back().held_out;
  ASSERT_EQ(stairs->state().unit, "px");
  EXPECT_TRUE(explain.verdict().figures.contains(QRegularExpression(": [0-9.]+.px \\([0-9.]+.mm at the hand\\)")))
      << explain.verdict().figures.toStdString();
  EXPECT_TRUE(explain.verdict().sentence.contains("mm")) << "of the hand, which the header does not say in px";
  desk.key(Qt::Key_U);
  EXPECT_EQ(stairs->state().unit, "mm");
  EXPECT_NEAR(*stairs->state().versions.back().held_out, 1e3 * *desk.document().model()->report->held_out.hand_m, 1e-9);
  EXPECT_TRUE(explain.verdict().figures.contains(QRegularExpression(": [0-9.]+.mm at the hand \\([0-9.]+.px\\)")))
      << explain.verdict().figures.toStdString();
  EXPECT_FALSE(explain.verdict().sentence.contains("mm")) << "the header says it";
  ASSERT_EQ(page->plots().size(), in_px.size());
  EXPECT_EQ(page->plots()[0].y_unit, in_px[0].y_unit) << "a motion of the hand has its own unit";
  desk.key(Qt::Key_U);
  EXPECT_EQ(stairs->state().unit, QString::fromUtf8("σ"));
  EXPECT_NEAR(*stairs->state().versions.back().held_out, step / *desk.document().model()->fit->noise, 1e-9);
  EXPECT_DOUBLE_EQ(*stairs->state().noise, 1);
  for (std::size_t i = 0; i < in_px.size(); ++i) {
    EXPECT_EQ(page->plots()[i].id, in_px[i].id) << "no plot changes its place";
    EXPECT_EQ(page->plots()[i].y_unit, QString::fromUtf8("σ"));
    EXPECT_DOUBLE_EQ(page->plots()[i].noise.value_or(0), 1);
    EXPECT_EQ(page->plots()[i].points[0].rms_over_sigma, in_px[i].points[0].rms_over_sigma);
  }
  const auto& error = explain.first().error;
  EXPECT_EQ(error.unit, QString::fromUtf8("σ"));
  EXPECT_NEAR(*error.noise, 1, 1e-12);
}

TEST_F(Units, TheChoiceOutlivesTheWindow) {
  const auto session = make_copy("thesis_simulation");
  {
    Desk desk;
    open(desk, session);
    desk.press_button("unit_sigma");
    EXPECT_EQ(numbers(desk).unit, QString::fromUtf8("σ"));
  }
  Desk desk;
  open(desk, session);
  EXPECT_EQ(numbers(desk).unit, QString::fromUtf8("σ"));
  EXPECT_TRUE(desk.find<QToolButton>("unit_sigma")->isChecked());
}

TEST_F(Units, AUThatIsTypedIsALetter) {
  Desk desk;
  open(desk, make_copy("thesis_simulation"));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  auto* filter = InspectPage{desk}.table()->findChild<QLineEdit*>();
  desk.type_into(filter, "u");
  EXPECT_EQ(filter->text(), "u");
  EXPECT_EQ(numbers(desk).unit, "px");
  desk.key(Qt::Key_K, Qt::ControlModifier);
  for (const char c : std::string("sigma")) QTest::keyClick(desk.window.windowHandle(), c);
  desk.key(Qt::Key_Return);
  QTest::qWait(20);
  EXPECT_EQ(numbers(desk).unit, QString::fromUtf8("σ")) << "Ctrl+K finds it";
}

TEST_F(Units, ATrackerHasNoPxAndItsErrorIsHeldAgainstTheNoiseOfAPosition) {
  Session like = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/thesis_simulation");
  like.rig.reset();
  like.sigma_pixel.reset();
  SimulationOptions options;
  options.observations = 40;
  options.noise = 2e-4;
  write_simulated(simulate_session(like, options), options, handsight::folder(like) / like.robot_file, {},
                  folder.path / "tracker");
  Desk desk;
  open(desk, folder.path / "tracker");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(numbers(desk).unit, "mm");
  EXPECT_NEAR(*numbers(desk).noise, 0.2 * std::sqrt(3.0), 0.03);
  EXPECT_NEAR(*numbers(desk).ratio, 1, 0.15) << "nothing is hidden: the error is the noise";
  EXPECT_NEAR(*numbers(desk).now / *numbers(desk).noise, *numbers(desk).ratio, 0.02);
  auto* px = desk.find<QToolButton>("unit_px");
  EXPECT_FALSE(px->isEnabled());
  EXPECT_TRUE(px->toolTip().contains("tracker")) << px->toolTip().toStdString();
  EXPECT_TRUE(InspectPage{desk}.table()->view()->isColumnHidden(2)) << "no column of px";
  desk.key(Qt::Key_U);
  EXPECT_EQ(numbers(desk).unit, QString::fromUtf8("σ"));
  EXPECT_EQ(head_of_sizes(desk), QString::fromUtf8("σ"));
  desk.key(Qt::Key_U);
  EXPECT_EQ(numbers(desk).unit, "mm") << "and round again, past px";
}

}  // namespace
}  // namespace handsight::test
