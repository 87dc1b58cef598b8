// SPDX-License-Identifier: GPL-3.0-or-later
// Model, filter and delegate of the table of effects. Internal to effect_table*.cpp.
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <vector>

#include "widgets/explain/effect_rows.h"

namespace handsight::widgets {

enum class EffectColumn { name, verdict, where, reason, count };

class EffectTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int verdict_role = Qt::UserRole;
  using QAbstractTableModel::QAbstractTableModel;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Rows of the same ids in the same order are changed in place, so that selection and scroll stay.
  void set_rows(std::vector<EffectRow> rows);
  const std::vector<EffectRow>& rows() const { return rows_; }

 private:
  std::vector<EffectRow> rows_;
};

class EffectTableFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  EffectTableFilter(EffectTableModel* model, QObject* parent);
  void set_text(const QString& text);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  EffectTableModel* model_;
  QString text_;
};

class EffectTableDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace handsight::widgets
