// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/effect_table.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/base/theme.h"
#include "widgets/explain/effect_table_model.h"

namespace handsight::widgets {

EffectTable::EffectTable(QWidget* parent) : QWidget(parent) {
  model_ = new EffectTableModel(this);
  filter_ = new EffectTableFilter(model_, this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  text_ = new QLineEdit(this);
  text_->setPlaceholderText(tr("Why not …? Type a name"));
  text_->setClearButtonEnabled(true);
  text_->setFixedHeight(control_height);
  layout->addWidget(text_);
  view_ = new QTableView(this);
  view_->setModel(filter_);
  view_->setItemDelegate(new EffectTableDelegate(this));
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setShowGrid(false);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setWordWrap(false);
  view_->setTabKeyNavigation(false);
  view_->setMouseTracking(true);
  view_->setAccessibleName(tr("All effects"));
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view_->verticalHeader()->setDefaultSectionSize(row_height_px);
  QHeaderView& header = *view_->horizontalHeader();
  header.setHighlightSections(false);
  header.setFixedHeight(control_height);
  header.setSectionResizeMode(2, QHeaderView::Stretch);
  header.setSectionResizeMode(3, QHeaderView::Stretch);
  header.setMinimumSectionSize(32);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(view_, 1);
  empty_ = new QLabel(this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  layout->addWidget(empty_, 1);
  summary_ = new QLabel(this);
  summary_->setFont(text_font(TextRole::small));
  summary_->setContentsMargins(layout_gap, 0, layout_gap, 0);
  layout->addWidget(summary_);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);
  text_->installEventFilter(this);
  connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->set_text(text);
    update_summary();
  });
  connect(view_, &QTableView::doubleClicked, this, [this](const QModelIndex& at) { emit chosen(id_at(at.row())); });
  update_summary();
}

void EffectTable::set_rows(std::vector<EffectRow> rows) {
  model_->set_rows(std::move(rows));
  fit_columns();
  update_summary();
}

/// Name and verdict are whole; where it is has the rest where all of it goes there.
void EffectTable::fit_columns() {
  constexpr int where_column = 2;
  constexpr int least_name = 150, least_verdict = 120, beside_text = 2 * layout_gap, mark = 24;
  const QFontMetrics metrics(text_font(TextRole::body));
  const auto width = [&](int row, int column) {
    return metrics.horizontalAdvance(model_->index(row, column).data().toString()) + beside_text;
  };
  int name = least_name, verdict = least_verdict, where = 0;
  for (int row = 0; row < model_->rowCount(); ++row) {
    name = std::max(name, width(row, 0));
    verdict = std::max(verdict, width(row, 1) + mark);
    where = std::max(where, width(row, where_column));
  }
  view_->setColumnWidth(0, name);
  view_->setColumnWidth(1, verdict);
  // The beginnings of names tell nothing: they stand whole in the line below the table.
  const bool has_room = view_->viewport()->width() - name - verdict >= where;
  view_->setColumnHidden(where_column, !has_room);
  view_->horizontalHeader()->setSectionResizeMode(1, has_room ? QHeaderView::Interactive : QHeaderView::Stretch);
}

void EffectTable::set_filter(const QString& text) { text_->setText(text); }

void EffectTable::set_progress(const QString& text) {
  progress_ = text;
  update_summary();
}

QString EffectTable::id_at(int row) const {
  const QModelIndex at = filter_->mapToSource(filter_->index(row, 0));
  return at.isValid() ? model_->rows()[static_cast<std::size_t>(at.row())].id : QString();
}

std::vector<QString> EffectTable::shown() const {
  std::vector<QString> ids;
  for (int row = 0; row < filter_->rowCount(); ++row) ids.push_back(id_at(row));
  return ids;
}

void EffectTable::update_summary() {
  const int shown_rows = filter_->rowCount(), all = model_->rowCount();
  view_->setVisible(shown_rows > 0);
  empty_->setVisible(shown_rows == 0);
  empty_->setText(all == 0 ? tr("No diagnosis yet.")
                           : tr("No effect is called \"%1\". What it does may still be in the catalogue: try another "
                                "word.")
                                 .arg(text_->text()));
  QString text = shown_rows == all ? tr("%1 effects").arg(all) : tr("%1 of %2 effects").arg(shown_rows).arg(all);
  if (!progress_.isEmpty()) text += QStringLiteral(", ") + progress_;
  summary_->setText(all == 0 ? progress_ : text);
}

bool EffectTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool is_enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (watched == view_ && is_enter && view_->currentIndex().isValid()) {
      emit chosen(id_at(view_->currentIndex().row()));
      return true;
    }
    if (watched == text_ && is_enter && filter_->rowCount() == 1) {
      emit chosen(id_at(0));
      return true;
    }
    if (watched == text_ && key == Qt::Key_Down && filter_->rowCount() > 0) {
      view_->setFocus();
      view_->selectRow(0);
      return true;
    }
  }
  if (watched == view_->viewport() && event->type() == QEvent::Resize) fit_columns();
  if (watched == view_->viewport() && (event->type() == QEvent::MouseMove || event->type() == QEvent::Leave)) {
    QString id;
    if (event->type() == QEvent::MouseMove) {
      const QModelIndex at = view_->indexAt(static_cast<QMouseEvent*>(event)->position().toPoint());
      if (at.isValid()) id = id_at(at.row());
    }
    if (id != hovered_) emit hovered(hovered_ = id);
  }
  return QWidget::eventFilter(watched, event);
}

void EffectTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && view_) view_->viewport()->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
