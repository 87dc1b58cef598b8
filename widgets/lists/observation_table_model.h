// SPDX-License-Identifier: GPL-3.0-or-later
// Model, filter and delegate of the table of observations. Internal to observation_table*.cpp.
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "widgets/lists/observation_rows.h"

namespace handsight::widgets {

enum class TableColumn { id, size, other_size, degree, worst, state, reason, count };

class ObservationTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// What a column is called here, and its tip; an invalid value: as usual.
  bool setHeaderData(int section, Qt::Orientation orientation, const QVariant& value, int role) override;

  void set_units(SizeUnit first, SizeUnit second);

  /// Rows of the same ids in the same order are changed in place, so that selection and order stay.
  void set_rows(std::vector<ObservationRow> rows);
  void set_row(const ObservationRow& row);
  void set_hovered(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);
  int find_row(ObservationId id) const;
  bool is_highlighted(ObservationId id) const;
  const std::vector<ObservationRow>& rows() const { return rows_; }
  ObservationId hovered() const { return hovered_; }

 private:
  void tell(int first, int last);
  void choose_decimals();
  std::vector<ObservationRow> rows_;
  std::array<SizeUnit, 2> units_ = {SizeUnit::pixel, SizeUnit::millimetre};  // of the two columns of sizes
  std::array<int, 2> decimals_ = {2, 2};
  std::vector<ObservationId> highlighted_;
  ObservationId hovered_ = no_observation;
  std::map<std::pair<int, int>, QVariant> own_heads_;  // by section and role
};

/// Sorts when asked to, not when the data change.
class ObservationTableFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit ObservationTableFilter(ObservationTableModel* model, QObject* parent);
  void set_kind(RowFilter kind);
  void set_text(const QString& text);
  void refilter() { invalidateFilter(); }
  bool is_in_order() const;  // by the column that was last sorted by
  RowFilter kind() const { return kind_; }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  ObservationTableModel* model_;
  RowFilter kind_ = RowFilter::all;
  QString text_;
};

class ObservationTableDelegate : public QStyledItemDelegate {
 public:
  ObservationTableDelegate(ObservationTableModel* model, QObject* parent);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  ObservationTableModel* model_;
};

/// Is the row in what the filter shows?
bool is_shown(const ObservationRow& row, RowFilter filter);

}  // namespace handsight::widgets
