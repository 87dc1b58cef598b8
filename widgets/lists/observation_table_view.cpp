// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/observation_table_view.h"

#include <QHeaderView>
#include <QTableView>
#include <algorithm>
#include <array>

#include "widgets/base/theme.h"
#include "widgets/lists/observation_table_model.h"

namespace handsight::widgets {
namespace {

/// What these words need in the view's font, with so much round them.
int width_of(const QTableView& view, const QStringList& words, int round_them) {
  int wide = 0;
  for (const QString& word : words) wide = std::max(wide, view.fontMetrics().horizontalAdvance(word));
  return wide + round_them;
}

int state_width(const QTableView& view) {
  return width_of(view,
                  {QObject::tr("used"), QObject::tr("odd"), QObject::tr("rejected"), QObject::tr("excluded"),
                   QObject::tr("waiting")},
                  14);
}

}  // namespace

void set_up_view(QTableView& view) {
  view.setSelectionBehavior(QAbstractItemView::SelectRows);
  view.setSelectionMode(QAbstractItemView::ExtendedSelection);
  view.setSortingEnabled(true);
  view.setShowGrid(false);
  view.setAlternatingRowColors(false);
  view.setFrameShape(QFrame::NoFrame);
  view.setMouseTracking(true);
  view.viewport()->setMouseTracking(true);
  view.setWordWrap(false);
  view.setContextMenuPolicy(Qt::CustomContextMenu);
  view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view.setTabKeyNavigation(false);
  view.setAccessibleName(QObject::tr("Observations"));
  view.verticalHeader()->hide();
  view.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view.verticalHeader()->setDefaultSectionSize(row_height_px);
  QHeaderView& header = *view.horizontalHeader();
  header.setHighlightSections(false);
  header.setFixedHeight(control_height);
  header.setMinimumSectionSize(36);
  const int id = width_of(view, {view.model()->headerData(0, Qt::Horizontal).toString()}, 26);  // and the arrow
  const int worst = width_of(view, {"0, " + QObject::tr("right"), "0, " + QObject::tr("left")}, 32);
  const std::array<int, 6> widths = {std::max(46, id), 50, 50, 50, worst, state_width(view)};
  for (std::size_t i = 0; i < widths.size(); ++i) view.setColumnWidth(static_cast<int>(i), widths[i]);
  header.setSectionResizeMode(static_cast<int>(TableColumn::reason), QHeaderView::Stretch);
}

void give_room_to_reason(QTableView& view, bool has_reasons) {
  constexpr int least_width = 420;
  const int state_needs = state_width(view);
  const int reason = static_cast<int>(TableColumn::reason), state = static_cast<int>(TableColumn::state);
  int room = view.viewport()->width() - state_needs;
  for (int i = 0; i < state; ++i) room -= view.isColumnHidden(i) ? 0 : view.columnWidth(i);
  const bool is_hidden = room < least_width || !has_reasons;
  if (view.isColumnHidden(reason) == is_hidden) return;
  view.setColumnHidden(reason, is_hidden);
  view.horizontalHeader()->setSectionResizeMode(state, is_hidden ? QHeaderView::Stretch : QHeaderView::Interactive);
  if (!is_hidden) view.setColumnWidth(state, state_needs);
}

}  // namespace handsight::widgets
