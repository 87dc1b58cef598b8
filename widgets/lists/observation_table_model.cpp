// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/observation_table_model.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/median.h"
#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int sort_role = Qt::UserRole;

double sort_number(std::optional<double> value) { return value.value_or(-std::numeric_limits<double>::infinity()); }

/// As many decimals as long as there is room for them.
QString column_text(std::optional<double> value, int decimals = 2) {
  return fixed_text(value, value && *value >= 99.995 ? 0 : decimals);
}

using Units = std::array<SizeUnit, 2>;

bool is_size(TableColumn column) { return column == TableColumn::size || column == TableColumn::other_size; }

std::optional<double> measure_size(const ObservationRow& row, SizeUnit unit) {
  return unit == SizeUnit::pixel ? row.rms_pixel : unit == SizeUnit::millimetre ? row.rms_mm : row.rms_over_sigma;
}

SizeUnit find_unit(TableColumn column, const Units& units) { return units[column == TableColumn::size ? 0 : 1]; }

QString about_size(SizeUnit unit) {
  switch (unit) {
    case SizeUnit::pixel:
      return QObject::tr("Root mean square of its image coordinates' residuals, px");
    case SizeUnit::millimetre:
      return QObject::tr("Root mean square of its markers' residuals in space, mm");
    case SizeUnit::sigma:
      return QObject::tr("Root mean square of its coordinates' residuals over the noise of one");
  }
  return {};
}

/// So many that what is usual in a column has two digits, and two at least.
int find_decimals(const std::vector<ObservationRow>& rows, SizeUnit unit) {
  std::vector<double> values;
  for (const ObservationRow& row : rows)
    if (const auto value = measure_size(row, unit); value && *value > 0) values.push_back(*value);
  if (values.empty()) return 2;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(median(std::move(values))))), 2, 4);
}

QString shown(const ObservationRow& row, TableColumn column, const Units& units, const std::array<int, 2>& decimals) {
  switch (column) {
    case TableColumn::id:
      return QString::number(row.id);
    case TableColumn::size:
    case TableColumn::other_size:
      return column_text(measure_size(row, find_unit(column, units)), decimals[column == TableColumn::size ? 0 : 1]);
    case TableColumn::degree:
      return column_text(row.angle_deg);
    case TableColumn::worst:
      return row.worst.isEmpty() ? QStringLiteral("-") : row.worst;
    case TableColumn::state:
      return row.state == CellState::used && row.is_odd ? QObject::tr("odd") : state_name(row.state);
    case TableColumn::reason:
    case TableColumn::count:
      return row.reason;
  }
  return {};
}

QVariant sort_value(const ObservationRow& row, TableColumn column, const Units& units) {
  switch (column) {
    case TableColumn::id:
      return static_cast<double>(row.id);
    case TableColumn::size:
    case TableColumn::other_size:
      return sort_number(measure_size(row, find_unit(column, units)));
    case TableColumn::degree:
      return sort_number(row.angle_deg);
    case TableColumn::worst:
      return sort_number(row.worst_over_sigma);
    default:
      return shown(row, column, units, {2, 2});
  }
}

bool is_number(TableColumn column) {
  return column == TableColumn::id || is_size(column) || column == TableColumn::degree;
}

}  // namespace

bool is_shown(const ObservationRow& row, RowFilter filter) {
  switch (filter) {
    case RowFilter::all:
      return true;
    case RowFilter::odd:
      return row.is_odd;
    case RowFilter::excluded:
      return row.state == CellState::excluded;
    case RowFilter::rejected:
      return row.state == CellState::rejected;
  }
  return true;
}

int ObservationTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ObservationTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(TableColumn::count);
}

QVariant ObservationTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ObservationRow& row = rows_[static_cast<std::size_t>(index.row())];
  const auto column = static_cast<TableColumn>(index.column());
  if (role == Qt::DisplayRole) return shown(row, column, units_, decimals_);
  if (role == sort_role) return sort_value(row, column, units_);
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((is_number(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return {};
}

QVariant ObservationTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const std::array<QString, 7> names = {
      QObject::tr("obs"),   QString(),         QString(), QObject::tr("deg"), QObject::tr("worst"),
      QObject::tr("state"), QObject::tr("why")};
  const std::array<QString, 7> tips = {QObject::tr("The observation's id"),
                                       QString(),
                                       QString(),
                                       QObject::tr("How far TCPest is turned from the TCP, degrees"),
                                       QObject::tr("The marker and image with the largest residual; sorts by its size"),
                                       QObject::tr("Whether the fit uses it; odd: it stands out of the others"),
                                       QObject::tr("Why it is rejected or excluded, or what is to be said of it")};
  if (section < 0 || section >= static_cast<int>(names.size())) return {};
  if (const auto own = own_heads_.find({section, role}); own != own_heads_.end()) return own->second;
  if (const auto column = static_cast<TableColumn>(section); is_size(column)) {
    const SizeUnit unit = find_unit(column, units_);
    if (role == Qt::DisplayRole) return unit_name(unit);
    if (role == Qt::ToolTipRole) return about_size(unit);
  }
  if (role == Qt::DisplayRole) return names[static_cast<std::size_t>(section)];
  if (role == Qt::ToolTipRole) return tips[static_cast<std::size_t>(section)];
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((is_number(static_cast<TableColumn>(section)) ? Qt::AlignRight : Qt::AlignLeft) |
                            Qt::AlignVCenter);
  return {};
}

void ObservationTableModel::tell(int first, int last) {
  if (first <= last) emit dataChanged(index(first, 0), index(last, columnCount() - 1));
}

void ObservationTableModel::choose_decimals() {
  for (std::size_t i = 0; i < units_.size(); ++i) decimals_[i] = find_decimals(rows_, units_[i]);
}

void ObservationTableModel::set_units(SizeUnit first, SizeUnit second) {
  const Units units = {first, second};
  if (units == units_) return;
  units_ = units;
  choose_decimals();
  emit headerDataChanged(Qt::Horizontal, static_cast<int>(TableColumn::size),
                         static_cast<int>(TableColumn::other_size));
  tell(0, rowCount() - 1);
}

bool ObservationTableModel::setHeaderData(int section, Qt::Orientation orientation, const QVariant& value, int role) {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return false;
  if (value.isValid())
    own_heads_[{section, role}] = value;
  else
    own_heads_.erase({section, role});
  emit headerDataChanged(orientation, section, section);
  return true;
}

void ObservationTableModel::set_rows(std::vector<ObservationRow> rows) {
  const bool are_the_same = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                       [](const auto& a, const auto& b) { return a.id == b.id; });
  if (are_the_same) {
    rows_ = std::move(rows);
    choose_decimals();
    tell(0, rowCount() - 1);
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  choose_decimals();
  endResetModel();
}

void ObservationTableModel::set_row(const ObservationRow& row) {
  const int at = find_row(row.id);
  if (at >= 0) {
    rows_[static_cast<std::size_t>(at)] = row;
    tell(at, at);
    return;
  }
  beginInsertRows({}, rowCount(), rowCount());
  rows_.push_back(row);
  endInsertRows();
}

void ObservationTableModel::set_hovered(ObservationId id) {
  if (id == hovered_) return;
  const int before = find_row(hovered_), after = find_row(id);
  hovered_ = id;
  if (before >= 0) tell(before, before);
  if (after >= 0) tell(after, after);
}

void ObservationTableModel::set_highlighted(std::vector<ObservationId> ids) {
  std::sort(ids.begin(), ids.end());
  if (ids == highlighted_) return;
  highlighted_ = std::move(ids);
  tell(0, rowCount() - 1);
}

bool ObservationTableModel::is_highlighted(ObservationId id) const {
  return std::binary_search(highlighted_.begin(), highlighted_.end(), id);
}

int ObservationTableModel::find_row(ObservationId id) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [id](const auto& row) { return row.id == id; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

ObservationTableFilter::ObservationTableFilter(ObservationTableModel* model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(model);
  setDynamicSortFilter(false);
  setSortRole(sort_role);
}

void ObservationTableFilter::set_kind(RowFilter kind) {
  kind_ = kind;
  invalidateFilter();
}

void ObservationTableFilter::set_text(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
}

bool ObservationTableFilter::is_in_order() const {
  const int column = sortColumn();
  if (column < 0) return true;
  for (int row = 1; row < rowCount(); ++row) {
    QModelIndex first = mapToSource(index(row - 1, column)), second = mapToSource(index(row, column));
    if (sortOrder() == Qt::DescendingOrder) std::swap(first, second);
    if (lessThan(second, first)) return false;
  }
  return true;
}

bool ObservationTableFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const ObservationRow& r = model_->rows()[static_cast<std::size_t>(row)];
  if (!is_shown(r, kind_)) return false;
  if (text_.isEmpty()) return true;
  return QString::number(r.id) == text_ || r.reason.contains(text_, Qt::CaseInsensitive) ||
         r.worst.contains(text_, Qt::CaseInsensitive) ||
         shown(r, TableColumn::state, {}, {2, 2}).contains(text_, Qt::CaseInsensitive);
}

bool ObservationTableFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const QVariant a = left.data(sort_role), b = right.data(sort_role);
  if (a.typeId() == QMetaType::Double) return a.toDouble() < b.toDouble();
  return a.toString().compare(b.toString(), Qt::CaseInsensitive) < 0;
}

ObservationTableDelegate::ObservationTableDelegate(ObservationTableModel* model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize ObservationTableDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QFontMetrics metrics(number_font(TextRole::body));
  return {metrics.horizontalAdvance(index.data().toString()) + 20, row_height_px};
}

void ObservationTableDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) const {
  const Colors& c = colors();
  const auto* proxy = static_cast<const QSortFilterProxyModel*>(index.model());
  const ObservationRow& row = model_->rows()[static_cast<std::size_t>(proxy->mapToSource(index).row())];
  const auto column = static_cast<TableColumn>(index.column());
  const QRectF cell = option.rect;
  painter->save();
  if (option.state & QStyle::State_Selected)
    painter->fillRect(cell, c.selected_row);
  else if (model_->is_highlighted(row.id))
    painter->fillRect(cell, c.care_tint);
  if (row.id == model_->hovered()) {
    painter->setPen(QPen(c.control_edge, 1));
    painter->drawLine(cell.topLeft(), cell.topRight());
    painter->drawLine(cell.bottomLeft() - QPointF(0, 1), cell.bottomRight() - QPointF(0, 1));
  }
  QRectF room = cell.adjusted(6, 0, -6, 0);
  if (column == TableColumn::id || column == TableColumn::worst) {
    const bool is_id = column == TableColumn::id;
    const std::optional<double> ratio = is_id ? row.rms_over_sigma : row.worst_over_sigma;
    const QRectF swatch(cell.left() + 6, cell.center().y() - 5, 8, 10);
    if (ratio) painter->fillRect(swatch, residual_color(ratio, is_id ? row.coordinates : 2));
    room.setLeft(swatch.right() + 4);
    if (is_id && row.session >= 0) {
      draw_session_mark(*painter, QPointF(swatch.right() + 8, cell.center().y() + 0.5), 8, row.session);
      room.setLeft(swatch.right() + 14);
    }
  }
  const bool is_out = row.state == CellState::rejected || row.state == CellState::excluded;
  QFont font = is_number(column) ? number_font(TextRole::body) : text_font(TextRole::body);
  font.setStrikeOut(is_out && column == TableColumn::id);
  painter->setFont(font);
  painter->setPen(is_out || row.state == CellState::waiting ? c.ink2 : c.ink1);
  const auto alignment = Qt::AlignVCenter | (is_number(column) ? Qt::AlignRight : Qt::AlignLeft);
  draw_text(*painter, room, alignment, index.data().toString());
  painter->restore();
}

}  // namespace handsight::widgets
