// SPDX-License-Identifier: Apache-2.0
// A second session, or a calibration, beside the open one: what has changed in words, and the same plots for both.
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableWidget>
#include <fstream>

#include "app/window/pages.h"
#include "app/window/painted_text.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "compare/compare_page.h"
#include "compare/compare_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/plots/convergence_plot.h"
#include "window/find_box.h"
#include "window/rail_button.h"

namespace handsight::test {
namespace {

std::filesystem::path sample(const std::string& name) {
  return std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name;
}

class Compare : public testing::Test {
 protected:
  /// Half of the poses of a robot, the first or the second, with these effects hidden.
  std::filesystem::path simulate(const std::string& name, bool first_half, const std::vector<std::string>& effects) {
    const auto out = folder.path / name;
    std::vector<std::string> arguments{
        "simulate", "--like", sample("hidden_2").string(), "--out", out.string(), "--seed", "7", "--observations", "60",
        "--noise",  "0.2"};
    for (const std::string& e : effects) {
      arguments.emplace_back("--effect");
      arguments.push_back(e);
    }
    const CliResult made = run_cli(folder.path, arguments);
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    Session s = read_session(out);
    auto& all = s.observations;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    first_half ? all.erase(middle, all.end()) : all.erase(all.begin(), middle);
    replace_file(s.file, session_text(s));
    return out;
  }
  void open(const std::filesystem::path& session) {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
  }
  app::ComparePage* page() { return desk.find<app::ComparePage>("compare"); }
  void compare_with(const std::filesystem::path& other) {
    desk.window.compare_with(QString::fromStdString(other.string()));
    ASSERT_TRUE(is_settled());
  }
  bool is_settled() {
    return desk.wait([this] { return !desk.window.workbench().explaining.is_busy(); }, 120000);
  }
  QString said() { return desk.find<QLabel>("compare_said")->text(); }
  void show_tab(int tab) {
    auto* tabs = desk.find<QTabWidget>("compare_tabs");
    desk.click(tabs->tabBar(), tabs->tabBar()->tabRect(tab).center());
    ASSERT_EQ(tabs->currentIndex(), tab);
  }

  TemporaryFolder folder;
  Desk desk;
};

TEST_F(Compare, AJointThatLostItsZeroIsNamedAndBothAreShownOnTheSameAxes) {
  const auto before = simulate("march", true, {});
  const std::string joint = read_session(before).joints[2];
  const auto after = simulate("april", false, {"joint_offset:" + joint + ".offset=0.004"});
  const std::string before_text = read_file(before / "session.xml"), after_text = read_file(after / "session.xml");
  open(after);
  const int actions = desk.document().undo_stack().count();
  compare_with(before);
  EXPECT_TRUE(said().contains(QString("Joint %1 lost its zero").arg(QString::fromStdString(joint))))
      << said().toStdString();
  EXPECT_TRUE(said().contains(QRegularExpression("0\\.2\\d* ± 0\\.0\\d+ degrees"))) << said().toStdString();
  EXPECT_TRUE(desk.find<QLabel>("compare_names")->text().contains("Before: march. After: april."))
      << desk.find<QLabel>("compare_names")->text().toStdString();
  auto* changes = desk.find<QTableWidget>("compare_changes");
  ASSERT_GT(changes->rowCount(), 1);
  EXPECT_EQ(changes->item(0, 0)->text(), QString("joint offset of %1").arg(QString::fromStdString(joint)));
  EXPECT_GT(changes->item(0, 1)->text().toDouble(), page()->shown()->comparison.threshold);
  EXPECT_GE(desk.find<QTableWidget>("compare_numbers")->rowCount(), 6);

  auto* cloud = desk.find<widgets::ResidualCloud>("compare_cloud");
  EXPECT_TRUE(cloud->isVisible());
  EXPECT_GT(cloud->reach(), 1);
  show_tab(1);
  using widgets::ConvergencePlot;
  const auto plot = [&](int i) {
    return desk.find<ConvergencePlot>(QString("compare_convergence_%1").arg(i).toLatin1())->plot();
  };
  for (const int row : {0, 2}) {
    EXPECT_EQ(plot(row)->yAxis->range(), plot(row + 1)->yAxis->range());
    EXPECT_EQ(plot(row)->xAxis->range(), plot(row + 1)->xAxis->range());
    EXPECT_GT(plot(row)->graph(6)->data()->size(), 20);
    EXPECT_GT(plot(row + 1)->graph(6)->data()->size(), 20);
  }
  plot(0)->yAxis->setRange(-3, 7);
  EXPECT_EQ(plot(1)->yAxis->range(), QCPRange(-3, 7)) << "zoomed in one, zoomed in both";
  show_tab(2);
  auto* first = desk.find<widgets::PatternPage>("compare_patterns_0");
  auto* second = desk.find<widgets::PatternPage>("compare_patterns_1");
  ASSERT_GE(first->plots().size(), 3U);
  ASSERT_EQ(first->plots().size(), second->plots().size());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first->plots()[i].id, second->plots()[i].id);
    const int place = static_cast<int>(i);
    // One page may be a pixel higher than the other.
    const QPointF apart = (first->on_screen(place, 0.1, 0.2) - first->plot_rect(place).topLeft()) -
                          (second->on_screen(place, 0.1, 0.2) - second->plot_rect(place).topLeft());
    EXPECT_LT(apart.manhattanLength(), 2) << "the same axes";
  }
  std::size_t numbers = 0;
  for (const PaintedText& text : texts_of(*first))
    numbers += text.text.contains(QRegularExpression("^[\\x{2212}0-9.]+$"));
  EXPECT_GE(numbers, 3 * 4U) << "two along each axis of three plots at least: no large plot here has them";
  EXPECT_EQ(desk.document().undo_stack().count(), actions);
  EXPECT_EQ(read_file(before / "session.xml"), before_text);
  EXPECT_EQ(read_file(after / "session.xml"), after_text);
}

TEST_F(Compare, WhatIsAsItWasIsSaidAndSwappedItIsTheOtherWayRound) {
  const auto before = simulate("march", true, {}), after = simulate("april", false, {});
  open(after);
  compare_with(before);
  EXPECT_TRUE(said().contains("Nothing has changed that these poses show")) << said().toStdString();
  const double x = page()->shown()->comparison.numbers.at(0).after;
  desk.press_button("compare_swap");
  ASSERT_TRUE(is_settled());
  EXPECT_TRUE(desk.find<QLabel>("compare_names")->text().contains("Before: april. After: march."));
  EXPECT_DOUBLE_EQ(page()->shown()->comparison.numbers.at(0).before, x);
}

TEST_F(Compare, ARecheckFromFivePosesAgainstAnExportedCalibration) {
  const auto before = simulate("march", true, {});
  const CliResult exported =
      run_cli(folder.path, {"fit", before.string(), "--export", (folder.path / "calibration.xml").string()});
  ASSERT_EQ(exported.exit_code, 0) << exported.errors;
  const auto after = simulate("april", false, {"camera_mount:rx=0.004", "camera_mount:y=0.002"});
  Session five = read_session(after);
  five.observations.resize(5);
  replace_file(five.file, session_text(five));
  open(after);
  compare_with(folder.path / "calibration.xml");
  EXPECT_TRUE(said().contains("The camera turned by")) << said().toStdString();
  EXPECT_FALSE(desk.find<QPushButton>("compare_swap")->isEnabled());
  auto* cloud = desk.find<widgets::ResidualCloud>("compare_cloud");
  EXPECT_GT(cloud->reach(), 2) << "as the calibration has it the corners are px off";
  show_tab(1);
  EXPECT_GT(desk.find<widgets::ConvergencePlot>("compare_convergence_1")->plot()->graph(6)->data()->size(), 2);
  show_tab(2);
}

TEST_F(Compare, WhatCannotBeComparedIsSaidInPlaceAndTheSessionStaysOpen) {
  open(simulate("april", false, {}));
  compare_with(sample("thesis_simulation"));
  EXPECT_TRUE(said().contains("cannot be compared")) << said().toStdString();
  EXPECT_EQ(page()->shown(), nullptr);
  compare_with(folder.path / "nowhere.xml");
  EXPECT_TRUE(said().contains("nowhere.xml")) << said().toStdString();
  compare_with(desk.document().session().file);
  EXPECT_TRUE(said().contains("the session that is open")) << said().toStdString();
  EXPECT_TRUE(desk.document().is_open());
  desk.press_button("compare_close");
  EXPECT_FALSE(desk.window.is_comparing());
}

TEST_F(Compare, FromTheBoxThatFindsEverythingAndBackWithEscape) {
  open(copy_of_sample(folder.path, "hidden_2"));
  const app::Place place = desk.window.workspace();
  desk.key(Qt::Key_K, Qt::ControlModifier);
  for (const char c : std::string("compare with")) QTest::keyClick(desk.window.windowHandle(), c);
  desk.key(Qt::Key_Return);
  ASSERT_TRUE(desk.window.is_comparing());
  const auto where = QString::fromStdString(desk.document().file().parent_path().parent_path().string());
  auto* dialog = desk.window.findChild<QFileDialog*>("compare_dialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->directory().absolutePath(), where) << "it opens beside the session";
  dialog->reject();
  EXPECT_TRUE(desk.find<QLabel>("compare_empty")->isVisible()) << "nothing chosen: it says what could be";
  EXPECT_FALSE(desk.find<app::RailButton>("rail_explain")->isChecked());
  QTest::qWait(30);
  desk.window.activateWindow();
  page()->setFocus();
  desk.key(Qt::Key_Escape);
  EXPECT_FALSE(desk.window.is_comparing());
  EXPECT_EQ(desk.window.workspace(), place);
  desk.key(Qt::Key_O, Qt::ControlModifier);
  auto* open = desk.window.findChild<QFileDialog*>("open_dialog");
  ASSERT_NE(open, nullptr);
  EXPECT_EQ(open->directory().absolutePath(), where);
  open->reject();
}

TEST_F(Compare, StoppedItSaysSoAndCanBeTriedAgain) {
  const auto before = simulate("march", true, {});
  open(simulate("april", false, {}));
  desk.window.workbench().explaining.hold(true);
  desk.window.compare_with(QString::fromStdString(before.string()));
  ASSERT_TRUE(desk.wait([this] { return desk.find<QWidget>("cancel")->isVisible(); }));
  desk.press_button("cancel");
  desk.window.workbench().explaining.hold(false);
  ASSERT_TRUE(is_settled());
  EXPECT_TRUE(said().contains("Stopped")) << said().toStdString();
  EXPECT_EQ(page()->shown(), nullptr);
  desk.press_button("compare_again");
  ASSERT_TRUE(is_settled());
  ASSERT_NE(page()->shown(), nullptr);
  // What is changed in the open session afterwards is said.
  EXPECT_FALSE(desk.find<QLabel>("compare_names")->text().contains("changed since"));
  desk.window.workbench().exclude({desk.document().session().observations[3].id});
  ASSERT_TRUE(desk.settle());
  EXPECT_TRUE(desk.find<QLabel>("compare_names")->text().contains("changed since"));
  desk.document().close();
  EXPECT_EQ(page()->shown(), nullptr);
}

TEST_F(Compare, OnALaptopNothingIsCut) {
  const auto before = simulate("march", true, {});
  open(simulate("april", false, {"body_slip:x=0.003", "body_slip:rz=0.01"}));
  desk.window.resize(1366, 728);
  compare_with(before);
  QTest::qWait(50);
  EXPECT_EQ(desk.window.size(), QSize(1366, 728));
  for (int tab = 0; tab < 3; ++tab) {
    show_tab(tab);
    QTest::qWait(30);
    for (const char* name :
         {"compare_close", "compare_swap", "compare_said", "compare_tabs", "compare_changes", "compare_numbers"}) {
      auto* widget = desk.find<QWidget>(name);
      EXPECT_TRUE(widget->isVisible()) << name;
      for (QWidget* outer = widget->parentWidget(); outer; outer = outer->parentWidget())
        EXPECT_TRUE(outer->rect().contains(QRect(widget->mapTo(outer, QPoint()), widget->size())))
            << name << " in tab " << tab << " reaches out of " << outer->metaObject()->className();
    }
  }
}

TEST_F(Compare, OnALaptopWhatMayHaveChangedIsNotCutWhileTheNumbersHaveRoom) {
  const auto before = simulate("march", true, {});
  open(simulate("april", false, {"joint_offset:" + read_session(before).joints[2] + ".offset=0.004"}));
  desk.window.resize(1366, 728);
  compare_with(before);
  QTest::qWait(50);
  auto* changes = desk.find<QTableWidget>("compare_changes");
  auto* numbers = desk.find<QTableWidget>("compare_numbers");
  const auto cut = [](QTableWidget* table) { return table->verticalHeader()->length() - table->viewport()->height(); };
  EXPECT_TRUE(cut(changes) <= 0 || cut(numbers) > 0) << cut(changes) << " px of it, " << -cut(numbers) << " px free";
}

TEST_F(Compare, OfThreeSessionsItSaysBetweenWhichAJointLostItsZero) {
  const auto march = simulate("march", true, {});
  const std::string joint = read_session(march).joints[2];
  const std::string offset = "joint_offset:" + joint + ".offset=0.004";
  const auto april = simulate("april", false, {offset}), may = simulate("may", true, {offset});
  open(may);
  compare_with(march);  // one first: the page is in front
  page()->compare_with(std::vector{march, april});
  ASSERT_TRUE(is_settled());
  const app::ComparedSeveral* all = page()->all_shown();
  ASSERT_NE(all, nullptr) << said().toStdString();
  const auto cli =
      run_cli(folder.path, {"compare", march.string(), april.string(), may.string(), "--json", "-"}).json();
  EXPECT_EQ(said(),
            QString::fromUtf8("▲  ") + QString::fromStdString(cli["reason"].get<std::string>()).replace("+-", "±"))
      << "the command says the same";
  EXPECT_TRUE(said().contains("between march and april, may")) << said().toStdString();
  auto* changes = desk.find<QTableWidget>("compare_changes");
  ASSERT_GT(changes->rowCount(), 1);
  EXPECT_EQ(changes->item(0, 0)->text(),
            QString("joint offset of %1: march | april, may").arg(QString::fromStdString(joint)));
  EXPECT_TRUE(changes->item(0, 1)->text().endsWith('%'));
  ASSERT_EQ(desk.find<QTableWidget>("compare_numbers")->rowCount(), 1);
  // The two that the change lies between are shown by the same plots; others can be.
  EXPECT_EQ(page()->shown()->before.name, "march");
  EXPECT_EQ(page()->shown()->after.name, "april");
  auto* after = desk.find<QComboBox>("compare_after");
  ASSERT_TRUE(after->isVisible());
  after->setCurrentIndex(2);
  emit after->activated(2);
  EXPECT_EQ(page()->shown()->after.name, "may");
  EXPECT_TRUE(desk.find<QLabel>("compare_side_1")->text().contains("may"));
  desk.click(changes->viewport(), changes->visualItemRect(changes->item(0, 0)).center());
  EXPECT_EQ(page()->shown()->after.name, "april") << "a click on the change goes back to it";
}

TEST_F(Compare, TheSessionsOfACollectionAreComparedWithEachOther) {
  const auto march = simulate("march", true, {}), april = simulate("april", false, {});
  std::ofstream(folder.path / "collection.xml") << "<handsight_collection version=\"1\" title=\"Two days\">\n"
                                                   "  <session folder=\"march\" rig=\"stand\" body=\"hand\"/>\n"
                                                   "  <session folder=\"april\" rig=\"stand\" body=\"hand\"/>\n"
                                                   "</handsight_collection>\n";
  open(folder.path / "collection.xml");
  desk.window.compare_with({});
  ASSERT_TRUE(is_settled());
  ASSERT_NE(page()->all_shown(), nullptr) << said().toStdString();
  EXPECT_EQ(page()->all_shown()->comparison.rigs.size(), 1U) << "what the collection says that they share";
  EXPECT_EQ(page()->all_shown()->comparison.verdict, ComparisonVerdict::unchanged) << said().toStdString();
  EXPECT_TRUE(said().contains("Nothing has changed")) << said().toStdString();
  EXPECT_FALSE(desk.find<QAbstractButton>("compare_choose")->isVisible());
  EXPECT_TRUE(desk.find<QAbstractButton>("compare_again")->isVisible());
  // What is no session among several is refused with what to do.
  ASSERT_TRUE(desk.window.open(QString::fromStdString(april.string())));
  ASSERT_TRUE(desk.settle());
  page()->compare_with(std::vector{march, folder.path / "collection.xml"});
  ASSERT_TRUE(is_settled());
  EXPECT_EQ(page()->all_shown(), nullptr);
  EXPECT_TRUE(said().contains("is a collection")) << said().toStdString();
}

TEST(CompareTexts, NumbersTooSmallForTheirUnitAreToldInAThousandthOfIt) {
  Comparison c;
  c.numbers = {{"tcp_from_body x", "m", 0.012, 0.012 + 4e-7, 2e-7},
               {"tcp_from_body rx", "rad", 0, 7e-6, 4e-6},
               {"tcp_from_body y", "m", 0.012, 0.0133, 1e-3},
               {"lens_distortion: k1", "1", 0, 3e-6, 4e-6}};
  QStringList told;
  for (const app::NumberLine& line : app::number_lines(c)) told << line.change + ' ' + line.unit << line.before_after;
  const QString all = told.join('\n');
  EXPECT_TRUE(all.contains(QString::fromUtf8("0.40 ± 0.20 µm"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QString::fromUtf8("7.0 ± 4.0 µrad"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QString::fromUtf8("1.3 ± 1.0 mm"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QString::fromUtf8("3.0 ± 4.0 ppm"))) << all.toStdString();
  EXPECT_FALSE(all.contains(QString::fromUtf8("·10"))) << all.toStdString();
}

}  // namespace
}  // namespace handsight::test
