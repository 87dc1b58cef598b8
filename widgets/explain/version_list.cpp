// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/version_list.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QMouseEvent>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/base/theme.h"
#include "widgets/explain/text_lines.h"
#include "widgets/explain/version_list_model.h"

namespace handsight::widgets {

VersionList::VersionList(QWidget* parent) : QWidget(parent) {
  model_ = new VersionListModel(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  view_ = new QListView(this);
  view_->setModel(model_);
  view_->setItemDelegate(new VersionListDelegate(model_, this));
  lay_rows_out_again(view_);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setSelectionMode(QAbstractItemView::NoSelection);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setMouseTracking(true);
  view_->setAccessibleName(tr("Versions of the model"));
  layout->addWidget(view_, 1);
  empty_ = new QLabel(tr("No version of the model yet."), this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  layout->addWidget(empty_, 1);
  comparison_ = new QLabel(this);
  comparison_->setWordWrap(true);
  comparison_->setContentsMargins(layout_gap, 0, layout_gap, 0);
  layout->addWidget(comparison_);
  take_back_ = new QPushButton(tr("Take back to here"), this);
  take_back_->setFixedHeight(control_height);
  take_back_->setToolTip(tr("Undoes every action after the version that is shown; Ctrl+Shift+Z does them again"));
  take_back_->setMinimumWidth(take_back_->sizeHint().width() + 12);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(layout_gap, 0, layout_gap, 4);
  foot->addWidget(take_back_);
  foot->addStretch(1);
  layout->addLayout(foot);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);
  connect(take_back_, &QPushButton::clicked, this, [this] { emit take_back_requested(model_->current()); });
  refresh();
}

int VersionList::count() const { return model_->rowCount(); }

void VersionList::set_versions(std::vector<VersionEntry> versions, const QString& unit) {
  model_->set_versions(std::move(versions), unit);
  refresh();
}

void VersionList::set_current(int version) {
  model_->set_current(version < 0 ? count() - 1 : version);
  refresh();
}

void VersionList::set_compared(int a, int b) { model_->set_compared(a, b); }

void VersionList::set_comparison(const QString& sentence) {
  comparison_->setText(sentence);
  refresh();
}

void VersionList::set_empty_text(const QString& sentence) { empty_->setText(sentence); }

void VersionList::refresh() {
  const int current = model_->current();
  const bool has_rows = count() > 0;
  view_->setVisible(has_rows);
  empty_->setVisible(!has_rows);
  comparison_->setVisible(has_rows && !comparison_->text().isEmpty());
  take_back_->setVisible(has_rows);
  const bool is_there = current >= 0 && current < count();
  take_back_->setEnabled(is_there && current + 1 < count() &&
                         !model_->versions()[static_cast<std::size_t>(current)].is_refused);
  if (is_there) view_->setCurrentIndex(model_->index(current));
}

QRect VersionList::letter_rect(int version, bool is_b) const {
  return find_letter(view_->visualRect(model_->index(version)), is_b);
}

void VersionList::pick(int version, bool as_b) {
  int a = model_->a(), b = model_->b();
  int& mine = as_b ? b : a;
  int& other = as_b ? a : b;
  mine = mine == version ? -1 : version;  // a second time: let go
  if (other == version) other = -1;
  model_->set_compared(a, b);
  emit compared(a, b);
}

bool VersionList::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::MouseButtonPress) {
    const QPoint at = static_cast<QMouseEvent*>(event)->position().toPoint();
    const QModelIndex index = view_->indexAt(at);
    if (!index.isValid()) return false;
    for (const bool is_b : {false, true})
      if (letter_rect(index.row(), is_b).contains(at)) {
        pick(index.row(), is_b);
        return true;
      }
    emit version_selected(index.row());
    return true;
  }
  if (watched == view_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int current = model_->current();
    if ((key == Qt::Key_A || key == Qt::Key_B) && current >= 0) {
      pick(current, key == Qt::Key_B);
      return true;
    }
    const int to = key == Qt::Key_Up ? current - 1 : key == Qt::Key_Down ? current + 1 : -1;
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      if (to >= 0 && to < count()) emit version_selected(to);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void VersionList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && view_) view_->viewport()->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
