// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/observation_table.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/lists/observation_table_model.h"
#include "widgets/lists/observation_table_view.h"
#include "widgets/lists/whole_rows.h"

namespace handsight::widgets {
ObservationTable::ObservationTable(QWidget* parent) : QWidget(parent) {
  model_ = new ObservationTableModel(this);
  filter_ = new ObservationTableFilter(model_, this);
  view_ = new QTableView(this);
  view_->setModel(filter_);
  view_->setItemDelegate(new ObservationTableDelegate(model_, this));
  set_up_view(*view_);
  view_->sortByColumn(0, Qt::AscendingOrder);
  view_->viewport()->installEventFilter(this);
  view_->installEventFilter(this);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* bar = new QHBoxLayout;
  bar->setSpacing(4);
  filter_buttons_ = new QButtonGroup(this);
  const std::array<QString, 4> names = {QObject::tr("all"), QObject::tr("odd"), QObject::tr("excluded"),
                                        QObject::tr("rejected")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto* button = new QPushButton(names[i], this);
    button->setCheckable(true);
    button->setFixedHeight(control_height);
    button->setMinimumWidth(QFontMetrics(button->font()).horizontalAdvance(button->text()) + 20);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    filter_buttons_->addButton(button, static_cast<int>(i));
    bar->addWidget(button);
  }
  filter_buttons_->button(0)->setChecked(true);
  text_ = new QLineEdit(this);
  text_->setAccessibleName(tr("Filter"));
  text_->setPlaceholderText(QObject::tr("Filter"));
  text_->setClearButtonEnabled(true);
  text_->setFixedHeight(control_height);
  text_->setMinimumWidth(60);
  bar->addWidget(text_, 1);
  layout->addLayout(bar);
  rows_ = new WholeRows(view_, row_height_px, this);
  layout->addWidget(rows_, 1);

  empty_ = new QLabel(this);
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(wide_gap);
  empty_action_ = new QPushButton(this);
  layout->addWidget(empty_, 1);
  layout->addWidget(empty_action_, 0, Qt::AlignHCenter);
  auto* foot = new QHBoxLayout;
  summary_ = new QLabel(this);
  summary_->setFont(text_font(TextRole::small));
  resort_ = new QPushButton(QObject::tr("Order changed: sort again"), this);
  resort_->setFont(text_font(TextRole::small));
  resort_->hide();
  foot->addWidget(summary_, 1);
  foot->addWidget(resort_);
  layout->addLayout(foot);
  reason_ = new QLabel(this);
  reason_->setObjectName("row_reason_line");
  reason_->setFont(text_font(TextRole::small));
  reason_->setWordWrap(true);
  reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  reason_->setMinimumHeight(2 * QFontMetrics(reason_->font()).lineSpacing());
  reason_->hide();
  layout->addWidget(reason_);

  connect(filter_buttons_, &QButtonGroup::idClicked, this, [this](int id) { set_filter(static_cast<RowFilter>(id)); });
  connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->set_text(text);
    update_summary();
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ObservationTable::report_selection);
  connect(view_, &QTableView::customContextMenuRequested, this, &ObservationTable::show_menu);
  connect(view_, &QTableView::doubleClicked, this, [this] {
    if (selected_ >= 0) emit relabel_requested(selected_);
  });
  connect(view_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, [this] { resort_->hide(); });
  connect(resort_, &QPushButton::clicked, this, [this] {
    filter_->sort(view_->horizontalHeader()->sortIndicatorSection(), view_->horizontalHeader()->sortIndicatorOrder());
    resort_->hide();
  });
  connect(empty_action_, &QPushButton::clicked, this, [this] {
    const bool is_filtered = !model_->rows().empty();
    if (!is_filtered) return emit empty_action_requested();
    text_->clear();
    set_filter(RowFilter::all);
  });
  set_empty_text(QObject::tr("No observations yet."));
}

void ObservationTable::set_units(SizeUnit first, std::optional<SizeUnit> second) {
  model_->set_units(first, second.value_or(first));
  view_->setColumnHidden(static_cast<int>(TableColumn::other_size), !second);
  give_room_to_reason(*view_, has_reasons_);
  const int sorted_by = view_->horizontalHeader()->sortIndicatorSection();
  resort_->setVisible(!filter_->is_in_order() && sorted_by >= 0);
}

void ObservationTable::set_rows(std::vector<ObservationRow> rows) {
  const std::vector<ObservationId> chosen = selected_many();
  is_telling_ = true;
  const bool is_first = model_->rows().empty();
  if (is_first && !rows.empty() && rows.front().session >= 0) {  // with room for the session's mark
    constexpr int with_mark = 64;
    view_->setColumnWidth(static_cast<int>(TableColumn::id), std::max(with_mark, view_->columnWidth(0)));
  }
  has_reasons_ = std::any_of(rows.begin(), rows.end(), [](const ObservationRow& row) { return !row.reason.isEmpty(); });
  model_->set_rows(std::move(rows));
  give_room_to_reason(*view_, has_reasons_);
  filter_->refilter();
  if (is_first)
    filter_->sort(view_->horizontalHeader()->sortIndicatorSection(), view_->horizontalHeader()->sortIndicatorOrder());
  is_telling_ = false;
  select_again(chosen);
  update_summary();
  resort_->setVisible(!is_first && !filter_->is_in_order());
}

void ObservationTable::set_row(const ObservationRow& row) {
  model_->set_row(row);
  if (!row.reason.isEmpty() && !std::exchange(has_reasons_, true)) give_room_to_reason(*view_, true);
  update_summary();
}

void ObservationTable::set_selected(ObservationId id) {
  const int row = model_->find_row(id);
  if (id == selected_ && row >= 0 && selected_many().size() == 1) return;
  selected_ = row < 0 ? no_observation : id;
  are_many_ = false;
  is_telling_ = true;
  const QModelIndex index = row < 0 ? QModelIndex() : filter_->mapFromSource(model_->index(row, 0));
  if (index.isValid()) {
    view_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    view_->scrollTo(index);
  } else {
    view_->clearSelection();
  }
  is_telling_ = false;
  show_reason();
}

void ObservationTable::set_selected_many(const std::vector<ObservationId>& ids, ObservationId current) {
  if (ids.size() < 2) return set_selected(current);
  std::vector<ObservationId> now = selected_many(), wanted;
  for (const ObservationId id : ids)
    if (const int row = model_->find_row(id); row >= 0 && filter_->mapFromSource(model_->index(row, 0)).isValid())
      wanted.push_back(id);
  std::sort(now.begin(), now.end());
  std::sort(wanted.begin(), wanted.end());
  selected_ = model_->find_row(current) < 0 ? no_observation : current;
  are_many_ = wanted.size() > 1;
  if (now == wanted) return;
  is_telling_ = true;
  QItemSelection rows;
  for (const ObservationId id : wanted) {
    const QModelIndex index = filter_->mapFromSource(model_->index(model_->find_row(id), 0));
    rows.select(index, index);
  }
  view_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  is_telling_ = false;
  update_summary();
}

/// What was chosen stays chosen when rows come anew or are filtered.
void ObservationTable::select_again(const std::vector<ObservationId>& ids) {
  const ObservationId before = std::exchange(selected_, no_observation);
  ids.size() > 1 ? set_selected_many(ids, before) : set_selected(before);
}

void ObservationTable::set_hovered(ObservationId id) {
  hovered_ = id;
  model_->set_hovered(id);
  show_reason();
}

/// Of the row that is pointed at, else of the chosen one. Where any row has one, its lines are kept for it.
void ObservationTable::show_reason() {
  reason_->setVisible(!rows_->isHidden() && has_reasons_);
  QString text;
  for (const ObservationId id : {hovered_, selected_}) {
    const int at = model_->find_row(id);
    if (at < 0 || !text.isEmpty()) continue;
    const ObservationRow& row = model_->rows()[static_cast<std::size_t>(at)];
    if (!row.reason.isEmpty())
      text = QStringLiteral("%1 %2, %3: %4").arg(QObject::tr("obs")).arg(id).arg(state_name(row.state), row.reason);
  }
  reason_->setText(text);
}

void ObservationTable::set_highlighted(std::vector<ObservationId> ids) { model_->set_highlighted(std::move(ids)); }

void ObservationTable::set_filter(RowFilter filter) {
  filter_buttons_->button(static_cast<int>(filter))->setChecked(true);
  const std::vector<ObservationId> chosen = selected_many();
  filter_->set_kind(filter);
  select_again(chosen);
  update_summary();
}

void ObservationTable::set_empty_text(const QString& sentence, const QString& action) {
  empty_text_ = sentence;
  empty_action_text_ = action;
  update_summary();
}

std::vector<ObservationId> ObservationTable::selected_many() const {
  QModelIndexList indices = view_->selectionModel()->selectedRows();
  std::sort(indices.begin(), indices.end(), [](const auto& a, const auto& b) { return a.row() < b.row(); });
  std::vector<ObservationId> ids;
  for (const QModelIndex& index : indices)
    ids.push_back(model_->rows()[static_cast<std::size_t>(filter_->mapToSource(index).row())].id);
  return ids;
}

std::vector<ObservationId> ObservationTable::shown() const {
  std::vector<ObservationId> ids;
  for (int row = 0; row < filter_->rowCount(); ++row)
    ids.push_back(model_->rows()[static_cast<std::size_t>(filter_->mapToSource(filter_->index(row, 0)).row())].id);
  return ids;
}

void ObservationTable::report_selection() {
  if (is_telling_) return;
  const std::vector<ObservationId> ids = selected_many();
  update_summary();
  if (ids.size() > 1) emit observations_selected(std::vector<qint64>(ids.begin(), ids.end()));
  const bool were_many = std::exchange(are_many_, ids.size() > 1);
  if (ids.size() != 1 || (ids.front() == selected_ && !were_many)) return;
  selected_ = ids.front();
  show_reason();
  emit observation_selected(selected_);
}

void ObservationTable::ask_for_change(bool exclude) {
  std::vector<qint64> ids;
  for (const ObservationId id : selected_many()) {
    const ObservationRow& row = model_->rows()[static_cast<std::size_t>(model_->find_row(id))];
    if (exclude ? row.state == CellState::used : row.state == CellState::excluded) ids.push_back(id);
  }
  if (ids.empty()) return;
  if (exclude)
    emit exclude_requested(ids);
  else
    emit include_requested(ids);
}

void ObservationTable::show_menu(const QPoint& position) {
  const std::vector<ObservationId> ids = selected_many();
  if (ids.empty()) return;
  const auto has = [&](CellState state) {
    return std::any_of(ids.begin(), ids.end(), [&](ObservationId id) {
      return model_->rows()[static_cast<std::size_t>(model_->find_row(id))].state == state;
    });
  };
  QMenu menu(this);
  menu.addAction(QObject::tr("Exclude"), this, [this] { ask_for_change(true); })->setEnabled(has(CellState::used));
  menu.addAction(QObject::tr("Include"), this, [this] { ask_for_change(false); })->setEnabled(has(CellState::excluded));
  menu.addAction(QObject::tr("Relabel"), this, [this, id = ids.front()] { emit relabel_requested(id); })
      ->setEnabled(ids.size() == 1);
  menu.exec(view_->viewport()->mapToGlobal(position));
}

void ObservationTable::update_summary() {
  const int shown_rows = filter_->rowCount(), all = model_->rowCount();
  const std::size_t chosen = selected_many().size();
  QString text = shown_rows == all ? QObject::tr("%1 observations").arg(all)
                                   : QObject::tr("%1 of %2 observations").arg(shown_rows).arg(all);
  if (chosen > 1) text += QObject::tr(", %1 chosen").arg(chosen);
  summary_->setText(text);
  const bool is_empty = shown_rows == 0;
  const bool is_filtered = all > 0;
  rows_->setVisible(!is_empty);
  empty_->setVisible(is_empty);
  const QString nothing_odd = QObject::tr("No observation stands out of the noise.");
  const QString nothing_found = QObject::tr("No observation is like that.");
  empty_->setText(!is_filtered ? empty_text_ : filter_->kind() == RowFilter::odd ? nothing_odd : nothing_found);
  const QString action = is_filtered ? QObject::tr("Show all") : empty_action_text_;
  empty_action_->setText(action);
  empty_action_->setVisible(is_empty && !action.isEmpty());
  summary_->setVisible(!is_empty);
  show_reason();
}

bool ObservationTable::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && (event->type() == QEvent::MouseMove || event->type() == QEvent::Leave)) {
    ObservationId id = no_observation;
    if (event->type() == QEvent::MouseMove) {
      const QModelIndex index = view_->indexAt(static_cast<QMouseEvent*>(event)->position().toPoint());
      if (index.isValid()) id = model_->rows()[static_cast<std::size_t>(filter_->mapToSource(index).row())].id;
    }
    if (id != hovered_) {
      set_hovered(id);
      emit observation_hovered(id);
    }
  } else if (watched == view_->viewport() && event->type() == QEvent::Resize) {
    give_room_to_reason(*view_, has_reasons_);
  } else if (watched == view_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Insert) {
      ask_for_change(key == Qt::Key_Delete);
      return true;
    }
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && selected_ >= 0) {
      emit relabel_requested(selected_);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void ObservationTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && view_) view_->viewport()->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
