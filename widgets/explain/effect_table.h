// SPDX-License-Identifier: GPL-3.0-or-later
// "Why not ...?": all effects of the catalogue with one verdict each.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/explain/effect_rows.h"

class QLabel;
class QLineEdit;
class QTableView;

namespace handsight::widgets {

class EffectTableModel;
class EffectTableFilter;

/// Model and view, rows of 24 px. Rows of the same ids keep their order; Enter or a double click chooses.
class EffectTable : public QWidget {
  Q_OBJECT
 public:
  explicit EffectTable(QWidget* parent = nullptr);
  void set_rows(std::vector<EffectRow> rows);
  void set_filter(const QString& text);  // in name, verdict, joints and reason
  void set_progress(const QString& text);
  std::vector<QString> shown() const;  // ids in the order shown
  QTableView* view() const { return view_; }
  QLineEdit* filter_field() const { return text_; }

 signals:
  void chosen(const QString& id);
  void hovered(const QString& id);  // empty: none

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QString id_at(int row) const;
  void fit_columns();
  void update_summary();

  EffectTableModel* model_;
  EffectTableFilter* filter_;
  QTableView* view_ = nullptr;
  QLineEdit* text_;
  QLabel *summary_, *empty_;
  QString progress_, hovered_;
};

}  // namespace handsight::widgets
