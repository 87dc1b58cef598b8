// SPDX-License-Identifier: Apache-2.0
// A thing is told once and in one way: one size of an observation, one true minus, one title; what cannot be done is
// not offered.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

#include "app/window/pages.h"
#include "base/files.h"
#include "findings/inspection_rows.h"
#include "temporary_folder.h"
#include "widgets/base/number_text.h"
#include "widgets/scene/robot_view.h"
#include "window/language.h"
#include "words/core_words.h"

namespace handsight::test {
namespace {

class OneFigure : public testing::Test {
 protected:
  void open(const char* name) {
    desk.window.resize(1366, 728);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, name).string())));
    ASSERT_TRUE(desk.settle());
  }
  void choose(std::int64_t id) {
    desk.window.workbench().selection.select_observation(id);
    QTest::qWait(20);
  }
  void show_tab(int index) {
    desk.key(Qt::Key_2, Qt::ControlModifier);
    desk.find<QTabWidget>("calibrate_tabs")->setCurrentIndex(index);
  }
  TemporaryFolder folder;
  Desk desk;
};

TEST_F(OneFigure, HowFarTheHandIsOffIsOneFigureInInspect) {
  open("hidden_3");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  const app::Workbench& workbench = desk.window.workbench();
  int told = 0;
  for (const Observation& o : desk.document().session().observations) {
    const InspectionRow* row = workbench.row(o.id);
    ASSERT_TRUE(row && row->hand_m);
    const QString sentence = app::attribution_sentence(workbench, row, &o);
    static const QRegularExpression size("whole hand, ([\\d.]+) mm");
    const auto said = size.match(sentence);
    if (!said.hasMatch()) continue;
    ++told;
    EXPECT_EQ(said.captured(1), widgets::short_text(1e3 * *row->hand_m)) << o.id << ": " << sentence.toStdString();
  }
  EXPECT_GT(told, 40);
}

TEST_F(OneFigure, ThereIsNothingToLookAtWithoutImages) {
  open("hidden_3");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  choose(0);
  EXPECT_FALSE(desk.find<QPushButton>("look")->isEnabled());
}

TEST_F(OneFigure, WhereThereAreImagesOneLooksAtTheWorstMarker) {
  // The observations of the sample that have labels come without images: one of them gets some.
  const std::filesystem::path session = copy_of_sample(folder.path, "hundred_poses");
  std::string xml = read_file(session / "session.xml");
  const std::string end = "</velocity>";
  const std::size_t at = xml.find(end, xml.find("<observation id=\"1\"")) + end.size();
  replace_file(session / "session.xml",
               xml.insert(at, R"(<images left="images/000_left.png" right="images/000_right.png"/>)"));
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  choose(1);
  EXPECT_TRUE(desk.find<QPushButton>("look")->isEnabled());
}

TEST_F(OneFigure, AFieldShowsATrueMinusAndTakesAPlainOne) {
  open("hidden_3");
  show_tab(3);
  auto* box = desk.find<QDoubleSpinBox>("own_pose_joint_1");
  box->setValue(-12.5);
  EXPECT_TRUE(box->text().startsWith(QChar(0x2212))) << box->text().toStdString();
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "-7.25");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(box->value(), -7.25);
  box->stepUp();
  EXPECT_EQ(box->value(), -6.25);
}

TEST_F(OneFigure, NumbersOfTheEngineHaveATrueMinusToo) {
  EXPECT_EQ(app::translated(message("from {} to {} degrees", -53, 77)), QString::fromUtf8("from −53 to 77 degrees"));
  EXPECT_EQ(app::translated(verbatim("robot-2")), "robot-2");
}

TEST_F(OneFigure, NoLineEndsBetweenANumberAndItsUnitOrSigma) {
  const QChar kept(0x00A0);
  const QString text = widgets::unbroken(QString::fromUtf8("(± 1.5 mrad) of 3 poses: 12 ± 3 mm, 100 % of it"));
  for (const char* pair : {"±|1.5", "1.5|mrad", "12|±", "±|3", "3|mm", "100|%"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(pair).replace('|', kept))) << pair << " in " << text.toStdString();
  EXPECT_TRUE(text.contains("3 poses"));
}

TEST_F(OneFigure, TheObjectivesStandBesideEachOtherInGermanToo) {
  const QLocale before;
  const QChar mark = widgets::decimal_mark();
  app::speak(*qApp, "de");
  {
    Desk german;
    german.window.resize(1366, 728);
    ASSERT_TRUE(german.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
    ASSERT_TRUE(german.settle());
    german.key(Qt::Key_2, Qt::ControlModifier);
    german.find<QTabWidget>("calibrate_tabs")->setCurrentIndex(1);
    auto* table = german.find<QTableWidget>("objective_table");
    ASSERT_TRUE(german.wait([&] { return table->item(0, 2) && table->item(0, 2)->text().size() > 1; }));
    EXPECT_FALSE(table->horizontalScrollBar()->isVisible());
    for (int row = 0; row < table->rowCount(); ++row)
      for (int column = 0; column < table->columnCount(); ++column) {
        const QTableWidgetItem* item = table->item(row, column);
        const int wide = QFontMetrics(item->font()).horizontalAdvance(item->text());
        EXPECT_LE(wide + 6, table->columnWidth(column)) << item->text().toStdString();
      }
  }
  qDeleteAll(qApp->findChildren<QTranslator*>());  // it speaks English again
  QLocale::setDefault(before);
  widgets::set_decimal_mark(mark);
}

TEST_F(OneFigure, TheTourRingsWhatIsInSight) {
  open("hidden_3");
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  desk.press_button("start_tour");
  for (int step = 0; step < 3; ++step) desk.press_button("tour_next");
  const auto* ring = desk.find<QWidget>("tour_ring");
  const auto* cards = desk.find<QWidget>("cards");
  const QRect room(cards->mapTo(&desk.window, QPoint()), cards->size());
  ASSERT_TRUE(ring->isVisible());
  EXPECT_TRUE(room.adjusted(-4, -4, 4, 4).contains(ring->geometry())) << "it goes over what lies below the card";
  desk.press_button("tour_close");
}

TEST_F(OneFigure, AJobsNameIsWholeOrLeftAway) {
  open("hidden_3");
  app::Jobs& jobs = desk.window.workbench().jobs;
  const QString name = "Seeking what may be long and has a name that is longer than the room beside the three numbers";
  jobs.hold(true);
  jobs.start<int>(
      "long", name, [](app::JobControl&) { return 0; }, [](const int&) {});
  auto* job = desk.find<QLabel>("job");
  EXPECT_TRUE(desk.wait([&] { return desk.find<QToolButton>("cancel")->isVisible(); }));
  EXPECT_TRUE(job->text().isEmpty() || job->text() == name) << job->text().toStdString();
  EXPECT_EQ(job->toolTip(), name);
  jobs.hold(false);
}

TEST_F(OneFigure, ThereIsNoViewToChooseBeforeThereIsARobot) {
  desk.press_button("start_new");
  QDialog* wizard = desk.window.findChild<QDialog*>("wizard");
  ASSERT_TRUE(wizard && QTest::qWaitForWindowExposed(wizard));
  auto* scene = desk.find<widgets::RobotView>("wizard_scene");
  const auto shown = [&] {
    const auto all = scene->findChildren<QToolButton*>();
    return std::count_if(all.begin(), all.end(), [](const QToolButton* b) { return b->isVisible(); });
  };
  EXPECT_EQ(shown(), 0);
  desk.find<QLineEdit>("wizard_robot")
      ->setText(QString(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/robots/six_axis.urdf");
  EXPECT_TRUE(desk.wait([&] { return shown() == 6; }));
  wizard->reject();
}

}  // namespace
}  // namespace handsight::test
