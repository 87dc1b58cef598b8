// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/bill_list.h"

#include <QEvent>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/explain/text_lines.h"

namespace handsight::widgets {
namespace {

constexpr int most_lines = 6;  // of a cause, and of the remarks below it

/// Where the texts of a row stand, from its top left.
struct BillRow {
  QRectF cause, worth, remarks;
  int height = 0;
};

BillRow find_row(const BillEntry& entry, double width) {
  const QFont body = text_font(TextRole::body), small = text_font(TextRole::small);
  const double left = layout_gap + 2, room = width - left - layout_gap;
  const double wide = QFontMetricsF(number_font(TextRole::body)).horizontalAdvance(entry.worth) + 2;
  BillRow row;
  row.cause = {left, 4, room - wide - layout_gap, 0};
  row.cause.setHeight(lines_height(body, entry.cause, row.cause.width(), most_lines));
  row.worth = {left + room - wide, 4, wide, QFontMetricsF(body).lineSpacing()};
  row.remarks = {left, row.cause.bottom() + 2, room, lines_height(small, entry.remarks(), room, most_lines)};
  row.height = static_cast<int>(std::ceil(row.remarks.bottom())) + 5;
  return row;
}

class BillDelegate : public QStyledItemDelegate {
 public:
  BillDelegate(const BillList& list, QObject* parent) : QStyledItemDelegate(parent), list_(list) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override {
    const int width = list_.view()->viewport()->width();
    return {width, find_row(entry_at(index), width).height};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const BillEntry& entry = entry_at(index);
    const Colors& c = colors();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF area = option.rect;
    if (entry.is_stand_in) {
      painter->fillRect(area, c.care_tint);
      painter->fillRect(QRectF(area.left(), area.top(), 3, area.height()), c.care);
    }
    const BillRow row = find_row(entry, area.width());
    painter->setFont(number_font(TextRole::body));
    painter->setPen(c.ink1);
    draw_text(*painter, row.worth.translated(area.topLeft()), Qt::AlignRight | Qt::AlignVCenter, entry.worth);
    draw_lines(*painter, text_font(TextRole::body), row.cause.translated(area.topLeft()), entry.cause, most_lines);
    painter->setPen(entry.is_stand_in ? c.care : c.ink2);
    draw_lines(*painter, text_font(TextRole::small), row.remarks.translated(area.topLeft()), entry.remarks(),
               most_lines);
    painter->setPen(QPen(c.hairline, 1));
    painter->drawLine(area.bottomLeft(), area.bottomRight());
    if (option.state & QStyle::State_HasFocus) draw_focus(*painter, area);
    painter->restore();
  }

 private:
  const BillEntry& entry_at(const QModelIndex& index) const {
    return list_.entries()[static_cast<std::size_t>(index.row())];
  }
  const BillList& list_;
};

}  // namespace

QString BillEntry::remarks() const {
  QStringList list = is_stand_in ? QStringList{built, sure, reported} : QStringList{sure, built, reported};
  list.removeAll(QString());
  return list.join(QStringLiteral("; "));
}

BillList::BillList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  title_ = new QLabel(tr("The bill: what each cause is worth at the hand (rms)"), this);
  title_->setFont(text_font(TextRole::small));
  title_->setContentsMargins(layout_gap, 0, 0, 0);
  title_->setWordWrap(true);
  layout->addWidget(title_);
  view_ = new QListView(this);
  view_->setModel(new QStandardItemModel(this));
  view_->setItemDelegate(new BillDelegate(*this, this));
  lay_rows_out_again(view_);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setSelectionMode(QAbstractItemView::NoSelection);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setAccessibleName(tr("The bill of the model"));
  layout->addWidget(view_, 1);
  empty_ = new QLabel(tr("No cause is in the model."), this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  layout->addWidget(empty_, 1);
  note_ = new QLabel(this);
  note_->setObjectName("bill_note");
  note_->setFont(text_font(TextRole::small));
  note_->setContentsMargins(layout_gap, 0, layout_gap, 2);
  note_->setWordWrap(true);
  layout->addWidget(note_);
  set_entries({});
  set_note({});
}

void BillList::set_entries(std::vector<BillEntry> entries) {
  entries_ = std::move(entries);
  auto* model = static_cast<QStandardItemModel*>(view_->model());
  model->clear();
  for (const BillEntry& entry : entries_) {
    const QString text = tr("%1: %2 at the hand. %3").arg(entry.cause, entry.worth, entry.remarks());
    model->appendRow(new QStandardItem(text));
  }
  view_->setVisible(!entries_.empty());
  title_->setVisible(!entries_.empty());
  empty_->setVisible(entries_.empty());
}

void BillList::set_note(const QString& sentence) {
  note_->setText(sentence);
  note_->setVisible(!sentence.isEmpty());
}

void BillList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && view_) view_->viewport()->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
