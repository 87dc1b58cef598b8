// SPDX-License-Identifier: Apache-2.0
#include "widgets/lists/whole_rows.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>

#include "widgets/mouse.h"

namespace handsight::widgets {
namespace {

constexpr int row_height = 24, rows = 30;

QTableWidget* make_table() {
  auto* table = new QTableWidget(rows, 2);
  for (int row = 0; row < rows; ++row) table->setItem(row, 0, new QTableWidgetItem(QString::number(row)));
  table->verticalHeader()->setDefaultSectionSize(row_height);
  return table;
}

TEST(WholeRows, NoRowIsCutAtTheEndWhateverTheRoom) {
  auto* table = make_table();
  WholeRows room(table, row_height);
  test::show(room, {300, 200});
  for (int height = 200; height < 200 + row_height; height += 5) {
    room.resize(300, height);
    QTest::qWait(10);
    for (const int to : {rows - 1, 0, rows / 2}) {
      table->scrollToItem(table->item(to, 0));
      const int first = table->rowAt(0);
      EXPECT_EQ(table->visualRect(table->model()->index(first, 0)).top(), 0) << "row " << first << " at " << height;
    }
    EXPECT_LT(height - table->height(), row_height) << "no more than a row is left";
    EXPECT_GT(table->rowAt(table->viewport()->height() - 1), 0);
  }
}

TEST(WholeRows, AScrollBarBelowThemTakesNoPartOfARow) {
  auto* table = make_table();
  table->setColumnWidth(0, 600);
  WholeRows room(table, row_height);
  test::show(room, {300, 211});
  table->scrollToBottom();
  EXPECT_TRUE(table->horizontalScrollBar()->isVisible());
  EXPECT_EQ(table->viewport()->height() % row_height, 0);
  table->setColumnWidth(0, 100);
  QTest::qWait(20);
  EXPECT_EQ(table->viewport()->height() % row_height, 0);
  EXPECT_LT(room.height() - table->height(), row_height);
}

}  // namespace
}  // namespace handsight::widgets
