// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/bill_list.h"

#include <QEvent>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int row_height = 44;

class BillDelegate : public QStyledItemDelegate {
 public:
  BillDelegate(const BillList& list, QObject* parent) : QStyledItemDelegate(parent), list_(list) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {240, row_height}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const BillEntry& entry = list_.entries()[static_cast<std::size_t>(index.row())];
    const Colors& c = colors();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF area = option.rect;
    if (entry.is_stand_in) {
      painter->fillRect(area, c.care_tint);
      painter->fillRect(QRectF(area.left(), area.top(), 3, area.height()), c.care);
    }
    const QRectF room = area.adjusted(layout_gap + 2, 2, -layout_gap, -2);
    const QRectF upper(room.left(), room.top(), room.width(), 20), lower(room.left(), upper.bottom(), room.width(), 18);
    painter->setFont(number_font(TextRole::body));
    const double wide = QFontMetricsF(painter->font()).horizontalAdvance(entry.worth) + 2;
    painter->setPen(c.ink1);
    draw_text(*painter, QRectF(upper.right() - wide, upper.top(), wide, upper.height()),
              Qt::AlignRight | Qt::AlignVCenter, entry.worth);
    painter->setFont(text_font(TextRole::body));
    draw_text(*painter, upper.adjusted(0, 0, -wide - layout_gap, 0), Qt::AlignLeft | Qt::AlignVCenter, entry.cause);
    painter->setFont(text_font(TextRole::small));
    painter->setPen(entry.is_stand_in ? c.care : c.ink2);
    draw_text(*painter, lower, Qt::AlignLeft | Qt::AlignVCenter, entry.remarks());
    painter->setPen(QPen(c.hairline, 1));
    painter->drawLine(area.bottomLeft(), area.bottomRight());
    if (option.state & QStyle::State_HasFocus) draw_focus(*painter, area);
    painter->restore();
  }

 private:
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
  view_->setUniformItemSizes(true);
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
  set_entries({});
}

void BillList::set_entries(std::vector<BillEntry> entries) {
  entries_ = std::move(entries);
  auto* model = static_cast<QStandardItemModel*>(view_->model());
  model->clear();
  for (const BillEntry& entry : entries_) {
    const QString text = tr("%1: %2 at the hand. %3").arg(entry.cause, entry.worth, entry.remarks());
    auto* item = new QStandardItem(text);
    item->setToolTip("<p>" + text.toHtmlEscaped() + "</p>");
    model->appendRow(item);
  }
  view_->setVisible(!entries_.empty());
  title_->setVisible(!entries_.empty());
  empty_->setVisible(entries_.empty());
}

void BillList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && view_) view_->viewport()->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
