// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/find_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPointer>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

constexpr std::size_t most_found = 12;
constexpr int hint_role = Qt::UserRole, kind_role = Qt::UserRole + 1;

class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {300, 28}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto& c = widgets::colors();
    const QRectF row = QRectF(option.rect).adjusted(12, 0, -12, 0);
    painter->save();
    if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, c.selected_row);
    painter->setFont(widgets::text_font(widgets::TextRole::small));
    painter->setPen(c.ink2);
    constexpr double kind_width = 84, hint_width = 230;
    widgets::draw_text(*painter, QRectF(row.left(), row.top(), kind_width, row.height()),
                       Qt::AlignLeft | Qt::AlignVCenter, index.data(kind_role).toString());
    const QString hint = index.data(hint_role).toString();
    const double wide = std::min(hint_width, QFontMetricsF(painter->font()).horizontalAdvance(hint) + 2);
    widgets::draw_text(*painter, QRectF(row.right() - wide, row.top(), wide, row.height()),
                       Qt::AlignRight | Qt::AlignVCenter, hint);
    painter->setFont(widgets::text_font(widgets::TextRole::body));
    painter->setPen(c.ink1);
    widgets::draw_text(*painter, row.adjusted(kind_width + 8, 0, -wide - 12, 0), Qt::AlignLeft | Qt::AlignVCenter,
                       index.data(Qt::DisplayRole).toString());
    painter->restore();
  }
};

}  // namespace

std::vector<const FindEntry*> found(const std::vector<FindEntry>& entries, const QString& words, std::size_t most) {
  const QStringList parts = words.simplified().split(' ', Qt::SkipEmptyParts);
  std::vector<const FindEntry*> first, others;
  for (const FindEntry& e : entries) {
    const QString all = e.kind + ' ' + e.text + ' ' + e.hint;
    if (parts.isEmpty() && e.kind != entries.front().kind) break;
    if (!std::all_of(parts.begin(), parts.end(),
                     [&](const QString& part) { return all.contains(part, Qt::CaseInsensitive); }))
      continue;
    // "58" is observation 58 before 158 and 580.
    const QStringList own = e.text.split(' ');
    const bool begins = e.text.startsWith(words.trimmed(), Qt::CaseInsensitive);
    const bool has_word = !parts.isEmpty() && own.contains(parts.back(), Qt::CaseInsensitive);
    (begins || has_word ? first : others).push_back(&e);
    if (first.size() >= most) break;
  }
  first.insert(first.end(), others.begin(), others.end());
  if (first.size() > most) first.resize(most);
  return first;
}

void FindBox::show_over(QWidget* window, std::vector<FindEntry> entries) {
  if (auto* open = window->findChild<FindBox*>()) {
    open->close();
    return;
  }
  auto* box = new FindBox(window, std::move(entries));
  box->show();
  box->raise();
  box->words_->setFocus();
}

FindBox::FindBox(QWidget* window, std::vector<FindEntry> entries) : QWidget(window), entries_(std::move(entries)) {
  setObjectName("find_box");
  setAttribute(Qt::WA_DeleteOnClose);
  setGeometry(window->rect());
  sheet_ = new QWidget(this);
  sheet_->setGeometry(std::max(8, width() / 2 - 320), 72, std::min(640, width() - 16), 60 + 28 * 12);
  words_ = new QLineEdit(sheet_);
  words_->setObjectName("find_words");
  words_->setMinimumHeight(32);
  words_->setPlaceholderText(tr("An action, observation, joint, effect or key"));
  list_ = new QListWidget(sheet_);
  list_->setObjectName("find_list");
  list_->setItemDelegate(new EntryDelegate(list_));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(sheet_);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(4);
  layout->addWidget(words_);
  layout->addWidget(list_, 1);
  words_->installEventFilter(this);
  window->installEventFilter(this);
  connect(words_, &QLineEdit::textChanged, this, &FindBox::refresh);
  connect(list_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { run(list_->row(item)); });
  refresh();
}

void FindBox::refresh() {
  shown_ = found(entries_, words_->text(), most_found);
  list_->clear();
  for (const FindEntry* e : shown_) {
    auto* item = new QListWidgetItem(e->text, list_);
    item->setData(hint_role, e->hint);
    item->setData(kind_role, e->kind);
  }
  if (shown_.empty()) {
    auto* item = new QListWidgetItem(tr("Nothing is called that."), list_);
    item->setFlags(Qt::NoItemFlags);
  } else {
    list_->setCurrentRow(0);
  }
  sheet_->resize(sheet_->width(), 54 + 28 * list_->count());
  update();
}

void FindBox::run(int row) {
  if (row < 0 || static_cast<std::size_t>(row) >= shown_.size()) return;
  const std::function<void()> chosen = shown_[static_cast<std::size_t>(row)]->run;
  close();
  // After the box is gone: what is chosen may want the focus, or close the session.
  QMetaObject::invokeMethod(parent(), chosen, Qt::QueuedConnection);
}

void FindBox::paintEvent(QPaintEvent*) {
  const auto& c = widgets::colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor veil = c.window;
  veil.setAlpha(160);
  painter.fillRect(rect(), veil);
  painter.setPen(c.control_edge);
  painter.setBrush(c.panel);
  painter.drawRoundedRect(QRectF(sheet_->geometry()).adjusted(-0.5, -0.5, 0.5, 0.5), 6, 6);
}

void FindBox::mousePressEvent(QMouseEvent*) { close(); }

bool FindBox::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent()) {
    if (event->type() == QEvent::Resize) close();
    return false;
  }
  if (event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int row = list_->currentRow(), last = list_->count() - 1;
  if (key == Qt::Key_Escape) {
    close();
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    run(row);
  } else if (key == Qt::Key_Down || key == Qt::Key_Up) {
    list_->setCurrentRow(std::clamp(row + (key == Qt::Key_Down ? 1 : -1), 0, last));
  } else {
    return false;
  }
  return true;
}

}  // namespace handsight::app
