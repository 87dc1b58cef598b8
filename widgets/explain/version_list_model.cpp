// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/version_list_model.h"

#include <QAbstractScrollArea>
#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/explain/text_lines.h"

namespace handsight::widgets {
namespace {

QString version_text(const char* text) { return QCoreApplication::translate("handsight::widgets::VersionList", text); }

QString change_text(const VersionEntry& version, const QString& unit) {
  constexpr double unseen = 1e-4;  // of the error
  if (!version.change) return {};
  if (version.held_out && std::abs(*version.change) < unseen * *version.held_out) return version_text("no change");
  return version_text("change %1")
      .arg(version.change_sigma ? with_sigma_unit_text(version.change, version.change_sigma, unit)
                                : with_unit_text(version.change, unit));
}

QString second_line(const VersionEntry& version, const QString& unit) {
  const QString change = change_text(version, unit);
  if (change.isEmpty() || version.detail.isEmpty()) return change + version.detail;
  return change + QStringLiteral("; ") + version.detail;
}

void paint_letter(QPainter& painter, const QRectF& area, const QString& letter, bool is_picked) {
  const Colors& c = colors();
  painter.setPen(is_picked ? QPen(Qt::NoPen) : QPen(c.hairline, 1));
  painter.setBrush(is_picked ? QBrush(c.ink2) : QBrush(c.panel));
  painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  painter.setPen(is_picked ? c.panel : c.ink3);
  painter.drawText(area, Qt::AlignCenter, letter);
}

}  // namespace

QRect find_letter(const QRect& row, bool is_b) {
  return {row.right() - (is_b ? 28 : 56), row.center().y() - 12, 24, 24};
}

int VersionListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(versions_.size());
}

QVariant VersionListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const VersionEntry& version = versions_[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole) return version.name;
  if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole)
    return version_text("%1: held out %2, fitted %3. %4")
        .arg(version.name, with_unit_text(version.held_out, unit_), with_unit_text(version.fitted, unit_),
             second_line(version, unit_));
  return {};
}

void VersionListModel::set_versions(std::vector<VersionEntry> versions, const QString& unit) {
  beginResetModel();
  versions_ = std::move(versions);
  unit_ = unit;
  endResetModel();
}

void VersionListModel::tell() {
  if (!versions_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

void VersionListModel::set_current(int version) {
  current_ = version;
  tell();
}

void VersionListModel::set_compared(int a, int b) {
  a_ = a;
  b_ = b;
  tell();
}

namespace {

constexpr int most_version_lines = 6;  // of a version's name, and of what stands below it

/// Where the texts of a row stand, from its top left.
struct VersionRow {
  QString name, error, below;
  QRectF name_at, error_at, below_at;
  int height = 0;
};

VersionRow find_row(const VersionEntry& version, const QString& unit, double width) {
  VersionRow row;
  row.name = version.is_refused ? version_text("%1: not added").arg(version.name) : version.name;
  row.error = with_unit_text(version.held_out, unit);
  row.below = second_line(version, unit);
  const QFont body = text_font(TextRole::body), small = number_font(TextRole::small);
  const double left = layout_gap + 2, room = width - left - 64;
  const double wide = QFontMetricsF(number_font(TextRole::body)).horizontalAdvance(row.error) + 2;
  row.name_at = {left, 4, room - wide - layout_gap, 0};
  row.name_at.setHeight(lines_height(body, row.name, row.name_at.width(), most_version_lines));
  row.error_at = {left + room - wide, 4, wide, QFontMetricsF(body).lineSpacing()};
  row.below_at = {left, row.name_at.bottom() + 2, room, lines_height(small, row.below, room, most_version_lines)};
  row.height = std::max(version_row, static_cast<int>(std::ceil(row.below_at.bottom())) + 5);
  return row;
}

}  // namespace

QSize VersionListDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* view = qobject_cast<const QAbstractScrollArea*>(option.widget);
  const int width = view ? view->viewport()->width() : 240;
  const VersionEntry& version = model_->versions()[static_cast<std::size_t>(index.row())];
  return {width, find_row(version, model_->unit(), width).height};
}

void VersionListDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Colors& c = colors();
  const int row = index.row();
  const VersionEntry& version = model_->versions()[static_cast<std::size_t>(row)];
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QRectF area = option.rect;
  if (row == model_->current()) {
    painter->fillRect(area, c.selected_row);
    painter->fillRect(QRectF(area.left(), area.top(), 3, area.height()), c.accent);
  }
  painter->setFont(text_font(TextRole::small));
  paint_letter(*painter, find_letter(option.rect, false), QStringLiteral("A"), row == model_->a());
  paint_letter(*painter, find_letter(option.rect, true), QStringLiteral("B"), row == model_->b());
  const VersionRow texts = find_row(version, model_->unit(), area.width());
  painter->setFont(number_font(TextRole::body));
  painter->setPen(version.is_refused ? c.ink3 : c.ink1);
  draw_text(*painter, texts.error_at.translated(area.topLeft()), Qt::AlignRight | Qt::AlignVCenter, texts.error);
  draw_lines(*painter, text_font(TextRole::body), texts.name_at.translated(area.topLeft()), texts.name,
             most_version_lines);
  painter->setPen(version.is_refused ? c.ink3 : c.ink2);
  draw_lines(*painter, number_font(TextRole::small), texts.below_at.translated(area.topLeft()), texts.below,
             most_version_lines);
  painter->setPen(QPen(c.hairline, 1));
  painter->drawLine(area.bottomLeft(), area.bottomRight());
  if (option.state & QStyle::State_HasFocus) draw_focus(*painter, area);
  painter->restore();
}

}  // namespace handsight::widgets
