// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

#include "widgets/base/read_out_line.h"
#include "widgets/images/triangle_panel.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/decision_list.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/observation_table.h"
#include "widgets/mouse.h"

namespace handsight::widgets {
namespace {

using testing::ElementsAre;

std::vector<ObservationRow> rows(int count) {
  std::vector<ObservationRow> all;
  for (int i = 0; i < count; ++i) {
    ObservationRow row;
    row.id = i;
    row.state = CellState::used;
    row.rms_pixel = (7 * i) % count;
    row.is_odd = i == 3;
    if (i == 5) row.state = CellState::excluded;
    all.push_back(row);
  }
  return all;
}

QPointF middle_of_row(ObservationTable& table, int row) {
  return table.view()->visualRect(table.view()->model()->index(row, 0)).center();
}

TEST(ObservationTable, SortsByResidualWorstFirst) {
  ObservationTable table;
  table.set_rows(rows(10));
  test::show(table, {460, 400});
  QHeaderView* header = table.view()->horizontalHeader();
  const QPoint at(header->sectionViewportPosition(1) + 20, header->height() / 2);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
  EXPECT_EQ(table.shown().front(), 7);  // 49 mod 10 = 9
  EXPECT_EQ(table.shown().back(), 0);
}

TEST(ObservationTable, KeepsItsOrderWhenResidualsChangeAndOffersToSort) {
  ObservationTable table;
  table.set_rows(rows(10));
  table.view()->sortByColumn(1, Qt::DescendingOrder);
  test::show(table, {460, 400});
  const auto before = table.shown();
  auto changed = rows(10);
  changed[0].rms_pixel = 100;
  table.set_rows(changed);
  EXPECT_EQ(table.shown(), before);
  QPushButton* again = nullptr;
  for (QPushButton* button : table.findChildren<QPushButton*>())
    if (button->text().contains("sort again")) again = button;
  ASSERT_TRUE(again && again->isVisible());
  QTest::mouseClick(again, Qt::LeftButton);
  EXPECT_EQ(table.shown().front(), 0);
}

TEST(ObservationTable, ClickSelectsDeleteExcludesInsertIncludes) {
  ObservationTable table;
  table.set_rows(rows(10));
  test::show(table, {460, 400});
  QSignalSpy selected(&table, &ObservationTable::observation_selected);
  QSignalSpy exclude(&table, &ObservationTable::exclude_requested),
      include(&table, &ObservationTable::include_requested);
  QSignalSpy many(&table, &ObservationTable::observations_selected);
  QWidget* viewport = table.view()->viewport();
  test::click(viewport, middle_of_row(table, 4));
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 4);
  test::click(viewport, middle_of_row(table, 6), Qt::ShiftModifier);
  ASSERT_EQ(many.size(), 1);
  QTest::keyClick(table.view(), Qt::Key_Delete);
  ASSERT_EQ(exclude.size(), 1);
  EXPECT_THAT(exclude[0][0].value<std::vector<qint64>>(), ElementsAre(4, 6));  // 5 is excluded already
  QTest::keyClick(table.view(), Qt::Key_Insert);
  ASSERT_EQ(include.size(), 1);
  EXPECT_THAT(include[0][0].value<std::vector<qint64>>(), ElementsAre(5));
}

TEST(ObservationTable, FiltersAndSaysWhenNothingIsLeft) {
  ObservationTable table;
  table.set_rows(rows(10));
  test::show(table, {460, 400});
  table.set_filter(RowFilter::odd);
  EXPECT_THAT(table.shown(), ElementsAre(3));
  table.set_filter(RowFilter::rejected);
  EXPECT_TRUE(table.shown().empty());
  QPushButton* all = nullptr;
  for (QPushButton* button : table.findChildren<QPushButton*>())
    if (button->text() == "Show all" && button->isVisible()) all = button;
  ASSERT_TRUE(all);
  QTest::mouseClick(all, Qt::LeftButton);
  EXPECT_EQ(table.shown().size(), 10u);
  QTest::keyClicks(table.findChild<QLineEdit*>(), "7");
  EXPECT_THAT(table.shown(), ElementsAre(7));
}

TEST(ObservationTable, TenThousandRowsKeepOneSelection) {
  ObservationTable table;
  table.set_rows(rows(10000));
  table.set_selected(9000);
  table.set_rows(rows(10000));
  EXPECT_THAT(table.selected_many(), ElementsAre(9000));
}

TEST(ModelPanel, TickingAsksAndChangesNothingElse) {
  ModelPanel panel;
  ModelEffect body{"tcp", "TCP->Body", {}, true, true};
  ModelEffect elastic{"joint_elasticity", "Joint elasticity"};
  elastic.parameters = {{"arm_2", "compliance", 1e-4, 1e-6, "rad/(N m)", 1e-4}};
  ModelEffect blocked{"payload", "Payload"};
  blocked.can_change = false;
  panel.set_effects({body, elastic, blocked});
  test::show(panel, {288, 400});
  QSignalSpy toggled(&panel, &ModelPanel::effect_toggled), joint(&panel, &ModelPanel::joint_selected);
  auto* box = panel.findChild<QCheckBox*>("effect_joint_elasticity");
  ASSERT_TRUE(box);
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Space);
  ASSERT_EQ(toggled.size(), 1);
  EXPECT_EQ(toggled[0][0].toString(), "joint_elasticity");
  EXPECT_TRUE(toggled[0][1].toBool());
  EXPECT_FALSE(panel.findChild<QCheckBox*>("effect_payload")->isEnabled());
  EXPECT_FALSE(panel.findChild<QCheckBox*>("effect_tcp"));
  for (QWidget* row : panel.findChildren<QWidget*>())
    if (row->property("joint").toString() == "arm_2") test::click(row, QPointF(20, 8));
  ASSERT_EQ(joint.size(), 1);
  panel.set_folded(true);
  EXPECT_EQ(panel.width(), 36);
}

TEST(ModelPanel, ATitleOfAnyLengthLeavesTheNumbersInSight) {
  ModelPanel panel;
  ModelEffect effect;
  effect.id = "curve";
  effect.title = QString::fromUtf8("Ein Fehler von right_arm_3, der sich dreimal je Umdrehung wiederholt (± 1,5 mrad)");
  effect.is_in_model = effect.can_change = true;
  panel.set_effects({effect});
  test::show(panel, {288, 400});
  const auto* area = panel.findChild<QScrollArea*>();
  EXPECT_LE(area->widget()->width(), area->viewport()->width()) << "what stands right ends beyond the edge";
}

TEST(ModelPanel, EveryNumberCanBeHeldAndTyped) {
  ModelPanel panel;
  ModelEffect wheel{"encoder_eccentricity", "Encoder eccentricity", {}, true};
  wheel.can_hold = true;
  for (const char* name : {"sine", "cosine"})
    wheel.parameters.push_back(
        {.of = "arm_2", .name = name, .value = 1.5, .sigma = 0.1, .unit = "mrad", .plausible = 2.0, .can_hold = true});
  wheel.parameters[1].is_held = true;
  wheel.parameters[1].sigma.reset();
  panel.set_effects({wheel});
  test::show(panel, {288, 400});
  QSignalSpy held(&panel, &ModelPanel::number_held), typed(&panel, &ModelPanel::value_typed);
  auto* free_lock = panel.findChild<QAbstractButton*>("hold_encoder_eccentricity_0");
  auto* closed_lock = panel.findChild<QAbstractButton*>("hold_encoder_eccentricity_1");
  ASSERT_TRUE(free_lock && closed_lock);
  EXPECT_FALSE(free_lock->isChecked());
  EXPECT_TRUE(closed_lock->isChecked());
  EXPECT_FALSE(panel.findChild<QLineEdit*>("value_encoder_eccentricity_0")) << "the fit's own";
  test::click(free_lock, free_lock->rect().center());
  ASSERT_EQ(held.size(), 1);
  EXPECT_EQ(held[0][1].toInt(), 0);
  EXPECT_TRUE(held[0][2].toBool());
  closed_lock->setFocus();
  QTest::keyClick(closed_lock, Qt::Key_Space);
  ASSERT_EQ(held.size(), 2);
  EXPECT_EQ(held[1][1].toInt(), 1);
  EXPECT_FALSE(held[1][2].toBool());
  auto* field = panel.findChild<QLineEdit*>("value_encoder_eccentricity_1");
  ASSERT_TRUE(field);
  EXPECT_FALSE(field->geometry().intersects(closed_lock->geometry()));
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "-2.5");
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_EQ(typed.size(), 1);
  EXPECT_EQ(typed[0][1].toInt(), 1);
  EXPECT_EQ(typed[0][2].toDouble(), -2.5);
}

TEST(DecisionList, ClickSelectsAndSetterIsSilent) {
  DecisionList list;
  list.set_entries(
      {{1, CellState::used, {}, {0.2, SizeUnit::pixel}, 1.0, 12}, {2, CellState::rejected, "too near", {}, {}, 12}});
  list.append({{3, CellState::used, {}, {0.3, SizeUnit::pixel}, 1.5, 12}});
  test::show(list, {300, 120});
  QSignalSpy selected(&list, &DecisionList::observation_selected);
  list.set_selected(3);
  EXPECT_EQ(selected.size(), 0);
  test::click(list.viewport(), list.visualRect(list.model()->index(1, 0)).center());
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 2);
}

TEST(ReadOutLine, WhatDoesNotFitEndsInAnEllipsisAndIsWholeInTheToolTip) {
  ReadOutLine line;
  test::show(line, {500, 24});
  const QString long_one = QString("a sentence that goes on and on ").repeated(6);
  line.show_message(long_one);
  QTest::qWait(20);
  const auto labels = line.findChildren<QLabel*>();
  const auto shown =
      std::find_if(labels.begin(), labels.end(), [](auto* l) { return l->text().startsWith("a sentence"); });
  ASSERT_NE(shown, labels.end());
  EXPECT_TRUE((*shown)->text().endsWith(QChar(0x2026)));
  EXPECT_LE((*shown)->fontMetrics().horizontalAdvance((*shown)->text()), (*shown)->width());
  EXPECT_EQ((*shown)->toolTip(), long_one);
  line.resize(2000, 24);
  QTest::qWait(20);
  EXPECT_EQ((*shown)->text(), long_one);
}

TEST(ReadOutLine, CrumbsCanBeClickedAndMessagesGiveWay) {
  ReadOutLine line;
  line.set_crumbs({"obs 37", "marker 2"});
  test::show(line, {700, 24});
  QSignalSpy clicked(&line, &ReadOutLine::crumb_clicked);
  QTest::mouseClick(line.findChild<QToolButton*>("crumb_1"), Qt::LeftButton);
  ASSERT_EQ(clicked.size(), 1);
  EXPECT_EQ(clicked[0][0].toInt(), 1);
  line.show_message("Excluded 3 observations.");
  EXPECT_EQ(line.pointer_text(), "Excluded 3 observations.");
  line.set_pointer("obs 41");
  EXPECT_EQ(line.pointer_text(), "Excluded 3 observations.") << "for its time";
}

TEST(TrianglePanel, TellsAndAsks) {
  TrianglePanel panel;
  TriangleState state;
  state.markers = {{0, true, true, Vector3(0, 0, 0.8), 0.001, 0.1}, {1, true, false, {}, {}, {}}};
  state.sentence = "Side 3 mm: too small.";
  state.verdict = TriangleVerdict::bad;
  panel.set_state(state);
  panel.set_candidates(1, {{4, 0.3, 0.85, "fits", false}, {9, 1.1, 0.6, "-14 mm", true}});
  test::show(panel, {288, 640});
  QPushButton *use = nullptr, *next = nullptr;
  for (QPushButton* button : panel.findChildren<QPushButton*>()) (button->text() == "Use it" ? use : next) = button;
  ASSERT_TRUE(use && next);
  EXPECT_FALSE(use->isEnabled());
  QSignalSpy discarded(&panel, &TrianglePanel::discard_requested), chosen(&panel, &TrianglePanel::candidate_chosen);
  QTest::mouseClick(next, Qt::LeftButton);
  EXPECT_EQ(discarded.size(), 1);
  auto* candidates = panel.findChildren<QTableWidget*>()[1];
  test::click(candidates->viewport(), candidates->visualItemRect(candidates->item(0, 0)).center());
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 4);
}

}  // namespace
}  // namespace handsight::widgets
