// SPDX-License-Identifier: GPL-3.0-or-later
// Model and delegate of the list of versions. Internal to version_list*.cpp.
#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>
#include <vector>

#include "widgets/explain/version_entry.h"

namespace handsight::widgets {

class VersionListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  void set_versions(std::vector<VersionEntry> versions, const QString& unit);
  void set_current(int version);
  void set_compared(int a, int b);

  const std::vector<VersionEntry>& versions() const { return versions_; }
  const QString& unit() const { return unit_; }
  int current() const { return current_; }
  int a() const { return a_; }
  int b() const { return b_; }

 private:
  void tell();
  std::vector<VersionEntry> versions_;
  QString unit_;
  int current_ = -1, a_ = -1, b_ = -1;
};

inline constexpr int version_row = 44;  // at least

/// The letter A or B of a row.
QRect find_letter(const QRect& row, bool is_b);

class VersionListDelegate : public QStyledItemDelegate {
 public:
  VersionListDelegate(VersionListModel* model, QObject* parent) : QStyledItemDelegate(parent), model_(model) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  VersionListModel* model_;
};

}  // namespace handsight::widgets
