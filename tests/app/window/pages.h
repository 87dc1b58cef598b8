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
#include <QTableView>

#include "app/window/desk.h"
#include "widgets/decision_list.h"
#include "widgets/image_view.h"
#include "widgets/observation_strip.h"
#include "widgets/observation_table.h"
#include "widgets/triangle_panel.h"

namespace handsight::test {

struct LabelPage {
  Desk& desk;
  widgets::ImageView* left() { return desk.find<widgets::ImageView>("label_left"); }
  widgets::ImageView* right() { return desk.find<widgets::ImageView>("label_right"); }
  const widgets::TriangleState& triangle() { return desk.find<widgets::TrianglePanel>("triangle")->state(); }

  void click_left(const Vector2& px, Qt::KeyboardModifiers keys = {}) {
    desk.click(left(), left()->to_screen(px).toPoint(), keys);
  }
  bool corners_are_found() {
    return desk.wait([this] { return triangle().sentence.startsWith("Click a marker"); });
  }
  void use() {
    for (auto* button : desk.find<QWidget>("triangle")->findChildren<QAbstractButton*>())
      if (button->text().contains("Use")) return desk.click(button);
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
    return desk.wait([this] { return desk.find<QAbstractButton>("play")->text() == "Play again"; }) && desk.settle();
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
