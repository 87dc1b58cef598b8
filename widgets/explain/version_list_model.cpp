// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/version_list_model.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

QString said(const char* text) { return QCoreApplication::translate("handsight::widgets::VersionList", text); }

QString change_text(const VersionEntry& version, const QString& unit) {
  if (!version.change) return {};
  return said("change %1 %2").arg(with_sigma_text(version.change, version.change_sigma), unit);
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
    return said("%1: held out %2, fitted %3. %4")
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

QSize VersionListDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {240, version_row};
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
  const QRectF room = area.adjusted(layout_gap + 2, 2, -64, -2);
  const QRectF upper(room.left(), room.top(), room.width(), 20), lower(room.left(), upper.bottom(), room.width(), 18);
  const QString error = with_unit_text(version.held_out, model_->unit());
  painter->setFont(number_font(TextRole::body));
  const double wide = QFontMetricsF(painter->font()).horizontalAdvance(error) + 2;
  painter->setPen(version.is_refused ? c.ink3 : c.ink1);
  draw_text(*painter, QRectF(upper.right() - wide, upper.top(), wide, upper.height()),
            Qt::AlignRight | Qt::AlignVCenter, error);
  painter->setFont(text_font(TextRole::body));
  const QString name = version.is_refused ? said("%1: not added").arg(version.name) : version.name;
  draw_text(*painter, upper.adjusted(0, 0, -wide - layout_gap, 0), Qt::AlignLeft | Qt::AlignVCenter, name);
  painter->setFont(number_font(TextRole::small));
  painter->setPen(version.is_refused ? c.ink3 : c.ink2);
  draw_text(*painter, lower, Qt::AlignLeft | Qt::AlignVCenter, second_line(version, model_->unit()));
  painter->setPen(QPen(c.hairline, 1));
  painter->drawLine(area.bottomLeft(), area.bottomRight());
  if (option.state & QStyle::State_HasFocus) draw_focus(*painter, area);
  painter->restore();
}

}  // namespace handsight::widgets
