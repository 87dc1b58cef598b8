// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/decision_list.h"

#include <QAbstractListModel>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTimer>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {

class DecisionModel : public QAbstractListModel {
 public:
  using QAbstractListModel::QAbstractListModel;
  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(entries.size());
  }
  QVariant data(const QModelIndex& index, int role) const override {
    if (!index.isValid()) return {};
    const DecisionEntry& entry = entries[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
      return QStringLiteral("%1 %2 %3").arg(entry.id).arg(what(entry), entry.reason).trimmed();
    if (role == Qt::AccessibleTextRole)
      return QStringLiteral("%1 %2 %3 %4")
          .arg(entry.id)
          .arg(what(entry), size_text(entry.size), entry.reason)
          .trimmed();
    if (role == Qt::ToolTipRole) return entry.reason.isEmpty() ? QVariant() : entry.reason;
    return {};
  }
  void replace(std::vector<DecisionEntry> all) {
    beginResetModel();
    entries = std::move(all);
    endResetModel();
  }
  void append(const std::vector<DecisionEntry>& more) {
    if (more.empty()) return;
    const int row = static_cast<int>(entries.size());
    beginInsertRows({}, row, row + static_cast<int>(more.size()) - 1);
    entries.insert(entries.end(), more.begin(), more.end());
    endInsertRows();
  }
  int find_row(ObservationId id) const {
    for (std::size_t i = entries.size(); i-- > 0;)
      if (entries[i].id == id) return static_cast<int>(i);
    return -1;
  }
  static QString what(const DecisionEntry& entry) {
    return entry.state == CellState::used ? QObject::tr("taken") : state_name(entry.state);
  }

  std::vector<DecisionEntry> entries;
};

namespace {

class DecisionDelegate : public QStyledItemDelegate {
 public:
  DecisionDelegate(DecisionModel* model, QObject* parent) : QStyledItemDelegate(parent), model_(model) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, row_height_px}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Colors& c = colors();
    const DecisionEntry& entry = model_->entries[static_cast<std::size_t>(index.row())];
    const QRectF row = option.rect;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (option.state & QStyle::State_Selected) painter->fillRect(row, c.selected_row);
    if (option.state & QStyle::State_MouseOver) {
      painter->setPen(QPen(c.control_edge, 1));
      painter->drawRect(row.adjusted(0.5, 0.5, -0.5, -0.5));
    }
    const bool is_taken = entry.state == CellState::used;
    const QRectF sign(row.left() + layout_gap, row.center().y() - 5, 10, 10);
    painter->setPen(Qt::NoPen);
    painter->setBrush(is_taken ? residual_color(entry.rms_over_sigma, entry.coordinates) : c.hairline);
    painter->drawRect(sign);
    if (!is_taken) {
      painter->setPen(QPen(c.ink1, 1.5));
      painter->drawLine(sign.bottomLeft(), sign.topRight());
    }
    painter->setFont(number_font(TextRole::body));
    painter->setPen(c.ink2);
    painter->drawText(QRectF(sign.right() + 2, row.top(), 38, row.height()), Qt::AlignRight | Qt::AlignVCenter,
                      QString::number(entry.id));
    const QRectF rest(sign.right() + 48, row.top(), row.right() - sign.right() - 48 - layout_gap, row.height());
    painter->setFont(text_font(TextRole::body));
    painter->setPen(c.ink1);
    QString text = DecisionModel::what(entry);
    if (is_taken && entry.size.value) text += QStringLiteral("  ") + size_text(entry.size);
    // Reasons often begin with the word themselves.
    if (!entry.reason.isEmpty())
      text = entry.reason.startsWith(text, Qt::CaseInsensitive) ? entry.reason
                                                                : text + QStringLiteral(": ") + entry.reason;
    draw_text(*painter, rest, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter->restore();
  }

 private:
  DecisionModel* model_;
};

}  // namespace

DecisionList::DecisionList(QWidget* parent)
    : QListView(parent), decisions_(new DecisionModel(this)), empty_text_(QObject::tr("No decisions yet.")) {
  setModel(decisions_);
  setItemDelegate(new DecisionDelegate(decisions_, this));
  setUniformItemSizes(true);
  setMouseTracking(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setAccessibleName(QObject::tr("Decisions"));
  setMinimumWidth(160);
}

void DecisionList::set_entries(std::vector<DecisionEntry> entries) {
  const ObservationId before = currentIndex().isValid()
                                   ? decisions_->entries[static_cast<std::size_t>(currentIndex().row())].id
                                   : no_observation;
  is_telling_ = true;
  decisions_->replace(std::move(entries));
  is_telling_ = false;
  set_selected(before);
  if (before == no_observation) scrollToBottom();
}

void DecisionList::append(const std::vector<DecisionEntry>& entries) {
  const bool is_at_end = verticalScrollBar()->value() >= verticalScrollBar()->maximum() - row_height_px;
  decisions_->append(entries);
  if (is_at_end) scrollToBottom();
}

void DecisionList::set_selected(ObservationId id) {
  const int row = decisions_->find_row(id);
  is_telling_ = true;
  if (row < 0) {
    clearSelection();
    setCurrentIndex({});
  } else if (currentIndex().row() != row) {
    setCurrentIndex(decisions_->index(row, 0));
  }
  is_telling_ = false;
}

void DecisionList::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  viewport()->update();
}

int DecisionList::count() const { return static_cast<int>(decisions_->entries.size()); }

void DecisionList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QListView::currentChanged(current, previous);
  if (!is_telling_ && current.isValid())
    emit observation_selected(decisions_->entries[static_cast<std::size_t>(current.row())].id);
}

void DecisionList::mouseMoveEvent(QMouseEvent* event) {
  QListView::mouseMoveEvent(event);
  const QModelIndex index = indexAt(event->position().toPoint());
  emit observation_hovered(index.isValid() ? decisions_->entries[static_cast<std::size_t>(index.row())].id
                                           : no_observation);
}

void DecisionList::leaveEvent(QEvent* event) {
  QListView::leaveEvent(event);
  emit observation_hovered(no_observation);
}

void DecisionList::paintEvent(QPaintEvent* event) {
  QListView::paintEvent(event);
  if (count() > 0) return;
  QPainter painter(viewport());
  draw_sentence(painter, viewport()->rect(), empty_text_);
}

void DecisionList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) viewport()->update();
  QListView::changeEvent(event);
}

}  // namespace handsight::widgets
