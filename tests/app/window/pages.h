// SPDX-License-Identifier: Apache-2.0
// The window's pages in the user's words.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>

#include "app/window/desk.h"
#include "explain/explain_workspace.h"
#include "widgets/explain/candidate_list.h"
#include "widgets/explain/verdict_line.h"
#include "widgets/images/image_view.h"
#include "widgets/images/triangle_panel.h"
#include "widgets/lists/decision_list.h"
#include "widgets/lists/observation_strip.h"
#include "widgets/lists/observation_table.h"

namespace handsight::test {

struct LabelPage {
  Desk& desk;
  widgets::ImageView* left() { return desk.find<widgets::ImageView>("label_left"); }
  widgets::ImageView* right() { return desk.find<widgets::ImageView>("label_right"); }
  const widgets::TriangleState& triangle() { return desk.find<widgets::TrianglePanel>("triangle")->state(); }

  /// In an image of a thumb's size a user zooms in before clicking.
  void click_left(const Vector2& px, Qt::KeyboardModifiers keys = {}) {
    constexpr double thumb = 0.5;
    if (left()->viewport().zoom < thumb) left()->show_point(px, 1);
    desk.click(left(), left()->to_screen(px).toPoint(), keys);
  }
  bool corners_are_found() {
    return desk.wait(
        [this] { return triangle().sentence == QObject::tr("Click a marker's corner in the left image."); });
  }
  void use() {
    for (auto* button : desk.find<QWidget>("triangle")->findChildren<QAbstractButton*>())
      if (button->text() == QObject::tr("Use it")) return desk.click(button);
    FAIL() << "no button to use the labels";
  }
};

struct CalibratePage {
  Desk& desk;
  void set_fastest() {
    auto* speed = desk.find<QComboBox>("speed");
    desk.click(speed);
    QTest::qWait(20);
    QTest::keyClick(speed->view(), Qt::Key_End);
    QTest::keyClick(speed->view(), Qt::Key_Return);
    QTest::qWait(20);
    EXPECT_EQ(speed->currentIndex(), speed->count() - 1);
  }
  bool play_to_the_end() {
    desk.press_button("play");
    return desk.wait([this] { return desk.find<QAbstractButton>("play")->text() == QObject::tr("Play again"); }) &&
           desk.settle();
  }
  int decisions() { return desk.find<widgets::DecisionList>("decisions")->count(); }
};

struct InspectPage {
  Desk& desk;
  widgets::ObservationTable* table() { return desk.find<widgets::ObservationTable>("inspect_table"); }
  /// Clicks the head of a column until it is sorted with the largest on top.
  void sort_worst_first(const QString& column) {
    QTableView* view = table()->view();
    QHeaderView* head = view->horizontalHeader();
    for (int c = 0; c < view->model()->columnCount(); ++c) {
      if (!view->model()->headerData(c, Qt::Horizontal).toString().contains(column)) continue;
      const QPoint at(head->sectionViewportPosition(c) + head->sectionSize(c) / 2, head->height() / 2);
      for (int tries = 0; tries < 3; ++tries) {
        if (head->sortIndicatorSection() == c && head->sortIndicatorOrder() == Qt::DescendingOrder) return;
        desk.click(head->viewport(), at);
      }
      return;
    }
    FAIL() << "no column " << column.toStdString();
  }
  void click_row(int row) {
    QTableView* view = table()->view();
    view->scrollTo(view->model()->index(row, 1));
    desk.click(view->viewport(), view->visualRect(view->model()->index(row, 1)).center());
  }
  std::int64_t id_at(int row) { return table()->shown()[static_cast<std::size_t>(row)]; }
};

struct ExplainPage {
  Desk& desk;
  widgets::CandidateList* cards() { return desk.find<widgets::CandidateList>("cards"); }
  const widgets::SessionVerdict& verdict() { return desk.find<widgets::VerdictLine>("verdict")->verdict(); }
  app::ExplainWorkspace* workspace() { return desk.find<app::ExplainWorkspace>("explain"); }
  /// Goes there, and waits until the cards are there.
  bool open() {
    desk.key(Qt::Key_4, Qt::ControlModifier);
    return is_settled();
  }
  bool is_settled(int milliseconds = 60000) {
    return desk.wait(
        [this] {
          auto& workbench = desk.window.workbench();
          return !workbench.jobs.is_busy() && !workbench.refit.is_pending() && !workbench.explaining.is_busy() &&
                 workbench.diagnosing.diagnosis() && cards()->count() > 0 && !workspace()->adding().is_running();
        },
        milliseconds);
  }
  const widgets::CardState& first() { return cards()->card(0)->state(); }
  bool can_add_first() {
    return cards()->count() > 0 && first().kind == widgets::CardKind::candidate && first().can_add;
  }
  /// Types what the robot showed into the first card, and Enter.
  void measure(const QString& text) {
    QLineEdit* field = cards()->card(0)->measured_field();
    for (auto* area : cards()->findChildren<QScrollArea*>()) area->ensureWidgetVisible(field);
    QTest::qWait(20);
    desk.type_into(field, text);
    desk.key(Qt::Key_Return);
  }
  /// Puts the pointer on a card.
  void look_at(int card) {
    auto* shown = cards()->card(card);
    const QRect seen = shown->visibleRegion().boundingRect();  // a tall card may be scrolled to its lower part
    QTest::mouseMove(shown->window()->windowHandle(),
                     shown->mapTo(shown->window(), seen.isEmpty() ? QPoint(20, 20) : seen.topLeft() + QPoint(20, 20)));
    QTest::qWait(20);
  }
  /// Scrolls a card to where the pointer can reach it, and presses its button.
  void press_add(int card = 0) {
    QPushButton* add = cards()->card(card)->add_button();
    ASSERT_TRUE(add->isVisible() && add->isEnabled());
    for (auto* area : cards()->findChildren<QScrollArea*>()) area->ensureWidgetVisible(add);
    QTest::qWait(10);
    desk.click(add);
  }
  /// Takes the first card until the program says stop. The number of cards taken.
  int take_the_first_until_it_says_stop() {
    int taken = 0;
    for (; taken < 16 && can_add_first(); ++taken) {
      const QString added = first().title;
      press_add();
      const bool has_begun = workspace()->adding().is_running() || !is_settled(0);
      EXPECT_TRUE(has_begun) << "nothing happens at " << added.toStdString();
      if (!has_begun) break;
      if (!is_settled()) {
        ADD_FAILURE() << "it does not come to an end";
        break;
      }
    }
    return taken;
  }
};

struct ExportPage {
  Desk& desk;
  bool save_as(const std::filesystem::path& file) {
    desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString(file.string()));
    desk.press_button("save_xml");
    return desk.wait([&] { return std::filesystem::exists(file); }, 5000);
  }
  QString said() { return desk.find<QLabel>("export_said")->text(); }
};

}  // namespace handsight::test
