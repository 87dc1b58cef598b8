// SPDX-License-Identifier: GPL-3.0-or-later
// Room for a table or a list in which no row is cut.
#pragma once

#include <QAbstractItemView>

class QTableView;

namespace handsight::widgets {

/// Lets a table be no higher than its rows (and than its minimum): what room is left is for others.
void end_below_rows(QTableView* table);

/// Makes a list that scrolls to its end as high as whole rows of `row_height` px (all alike) go into the room that
/// there is; less than a row is left below it. At its end a list of any other height cuts its first row.
class WholeRows : public QWidget {
  Q_OBJECT
 public:
  WholeRows(QAbstractItemView* list, int row_height, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QAbstractItemView* list_;
  int row_height_;
  bool is_fitting_ = false;
};

}  // namespace handsight::widgets
