// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/effect_table_model.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <array>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

QString table_text(const char* text) { return QCoreApplication::translate("handsight::widgets::EffectTable", text); }

QString verdict_of(const EffectRow& row) {
  const QString text = effect_verdict_text(row.verdict);
  return row.verdict == EffectVerdict::same_as ? text + QLatin1Char(' ') + row.same_as : text;
}

QString make_text(const EffectRow& row, EffectColumn column) {
  switch (column) {
    case EffectColumn::name:
      return row.name;
    case EffectColumn::verdict:
      return verdict_of(row);
    case EffectColumn::where:
      return row.where;
    default:
      return row.reason;
  }
}

/// A sign before the verdict: it is read without colour.
QString sign_of(EffectVerdict verdict) {
  switch (verdict) {
    case EffectVerdict::in_model:
      return QStringLiteral("✓");
    case EffectVerdict::would_help:
      return QStringLiteral("+");
    case EffectVerdict::may_be_there:
      return QStringLiteral("~");
    case EffectVerdict::worse:
      return QStringLiteral("−");
    case EffectVerdict::no_sign:
      return QStringLiteral("·");
    case EffectVerdict::cannot_be_seen:
      return QStringLiteral("?");
    case EffectVerdict::same_as:
      return QStringLiteral("=");
    case EffectVerdict::unknown:
      return {};
  }
  return {};
}

QColor ink_of(EffectVerdict verdict) {
  const Colors& c = colors();
  switch (verdict) {
    case EffectVerdict::in_model:
      return c.good;
    case EffectVerdict::would_help:
      return c.candidate;
    case EffectVerdict::cannot_be_seen:
    case EffectVerdict::same_as:
      return c.care;
    default:
      return c.ink2;
  }
}

}  // namespace

int EffectTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int EffectTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(EffectColumn::count);
}

QVariant EffectTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const EffectRow& row = rows_[static_cast<std::size_t>(index.row())];
  const auto column = static_cast<EffectColumn>(index.column());
  if (role == Qt::DisplayRole) return make_text(row, column);
  if (role == verdict_role) return static_cast<int>(row.verdict);
  if (role == Qt::ToolTipRole && column == EffectColumn::where) return row.where;  // all, where there is no room
  if (role == Qt::ToolTipRole && column == EffectColumn::verdict && row.verdict == EffectVerdict::cannot_be_seen)
    return table_text("These poses could not show it, if it were there.");
  return {};
}

QVariant EffectTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section > 3) return {};
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const std::array<QString, 4> names = {table_text("effect"), table_text("verdict"), table_text("where"),
                                        table_text("why")};
  return names[static_cast<std::size_t>(section)];
}

void EffectTableModel::set_rows(std::vector<EffectRow> rows) {
  const bool are_the_same = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                       [](const auto& a, const auto& b) { return a.id == b.id; });
  if (!are_the_same) beginResetModel();
  rows_ = std::move(rows);
  if (!are_the_same)
    endResetModel();
  else if (!rows_.empty())
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

EffectTableFilter::EffectTableFilter(EffectTableModel* model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(model);
}

void EffectTableFilter::set_text(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
}

bool EffectTableFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const EffectRow& r = model_->rows()[static_cast<std::size_t>(row)];
  if (text_.isEmpty()) return true;
  for (const QString& text : {r.name, r.id, verdict_of(r), r.where, r.reason})
    if (text.contains(text_, Qt::CaseInsensitive)) return true;
  return false;
}

QSize EffectTableDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QFontMetrics(option.font).horizontalAdvance(index.data().toString()) + 32, row_height_px};
}

void EffectTableDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Colors& c = colors();
  const auto verdict = static_cast<EffectVerdict>(index.data(EffectTableModel::verdict_role).toInt());
  painter->save();
  if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, c.selected_row);
  QRectF room = QRectF(option.rect).adjusted(6, 0, -6, 0);
  painter->setFont(text_font(TextRole::body));
  const bool is_verdict = index.column() == static_cast<int>(EffectColumn::verdict);
  painter->setPen(is_verdict ? ink_of(verdict) : index.column() == 0 ? c.ink1 : c.ink2);
  if (is_verdict) {
    painter->drawText(QRectF(room.left(), room.top(), 16, room.height()), Qt::AlignCenter, sign_of(verdict));
    room.setLeft(room.left() + 20);
  }
  draw_text(*painter, room, Qt::AlignLeft | Qt::AlignVCenter, index.data().toString());
  painter->restore();
}

}  // namespace handsight::widgets
