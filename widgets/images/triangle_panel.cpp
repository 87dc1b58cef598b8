// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/images/triangle_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/triangle_sketch.h"

namespace handsight::widgets {
namespace {

QTableWidget* make_table(const QStringList& head, QWidget* parent) {
  auto* table = new QTableWidget(0, static_cast<int>(head.size()), parent);
  table->setHorizontalHeaderLabels(head);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setShowGrid(false);
  table->setFrameShape(QFrame::NoFrame);
  table->setTabKeyNavigation(false);
  table->setMouseTracking(true);
  table->verticalHeader()->hide();
  table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table->verticalHeader()->setDefaultSectionSize(row_height_px);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setFixedHeight(row_height_px);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table->horizontalHeader()->setMinimumSectionSize(30);
  table->horizontalHeader()->setFont(text_font(TextRole::small));
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return table;
}

void set_cell(QTableWidget& table, int row, int column, const QString& text, bool is_number = true) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignVCenter | (is_number ? Qt::AlignRight : Qt::AlignLeft));
  if (is_number) item->setFont(number_font(TextRole::small));
  item->setToolTip(text);
  table.setItem(row, column, item);
}

QString seen_text(const TriangleMarker& marker) {
  if (marker.has_left && marker.has_right) return QObject::tr("both");
  return marker.has_left ? QObject::tr("left") : marker.has_right ? QObject::tr("right") : QStringLiteral("-");
}

/// Height of a table that shows all of a few rows.
void fit_height(QTableWidget& table, int most_rows) {
  const int rows = std::clamp(table.rowCount(), 1, most_rows);
  table.setFixedHeight(row_height_px * (rows + 1) + 2);
}

}  // namespace

TrianglePanel::TrianglePanel(QWidget* parent) : QFrame(parent) {
  setFrameShape(QFrame::NoFrame);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setMinimumWidth(260);
  title_ = new QLabel(QObject::tr("Triangle"), this);
  title_->setFont(text_font(TextRole::title));
  sketch_ = new TriangleSketch(this);
  sides_ = new QLabel(this);
  sides_->setWordWrap(true);
  sides_->setFont(number_font(TextRole::body));
  sides_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  markers_ = make_table(
      {QObject::tr("no."), QObject::tr("seen"), QObject::tr("depth m"), QStringLiteral("± mm"), QObject::tr("line px")},
      this);
  markers_->setContextMenuPolicy(Qt::CustomContextMenu);
  markers_->setAccessibleName(QObject::tr("Markers"));
  markers_->installEventFilter(this);
  sentence_ = new QLabel(this);
  sentence_->setWordWrap(true);
  sentence_->setMargin(layout_gap);
  sentence_->setAutoFillBackground(true);
  sentence_->setBackgroundRole(QPalette::Window);
  sentence_->setForegroundRole(QPalette::WindowText);
  action_ = new QPushButton(this);
  action_->setObjectName(QStringLiteral("triangle_action"));
  action_->setMinimumHeight(control_height);
  action_->hide();
  connect(action_, &QPushButton::clicked, this, &TrianglePanel::action_requested);
  candidates_title_ = new QLabel(this);
  candidate_table_ = make_table({QObject::tr("line px"), QObject::tr("depth m"), QObject::tr("sides")}, this);
  candidate_table_->setAccessibleName(QObject::tr("Candidates on the epipolar line"));
  candidate_table_->viewport()->installEventFilter(this);
  use_ = new QPushButton(QObject::tr("Use it"), this);
  use_->setDefault(true);
  use_->setMinimumHeight(control_height);
  discard_ = new QPushButton(QObject::tr("Next observation"), this);
  discard_->setMinimumHeight(control_height);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(layout_gap, 6, layout_gap, layout_gap);
  layout->setSpacing(layout_gap);
  for (QWidget* widget : std::initializer_list<QWidget*>{title_, sketch_, sides_, markers_, sentence_, action_,
                                                         candidates_title_, candidate_table_})
    layout->addWidget(widget);
  layout->setStretchFactor(sketch_, 1);
  layout->addWidget(use_);
  layout->addWidget(discard_);

  connect(use_, &QPushButton::clicked, this, &TrianglePanel::use_requested);
  connect(discard_, &QPushButton::clicked, this, &TrianglePanel::discard_requested);
  connect(sketch_, &TriangleSketch::marker_selected, this, &TrianglePanel::marker_selected);
  connect(markers_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!is_filling_ && row >= 0 && row < static_cast<int>(state_.markers.size()))
      emit marker_selected(state_.markers[static_cast<std::size_t>(row)].number);
  });
  connect(markers_, &QTableWidget::customContextMenuRequested, this, &TrianglePanel::show_marker_menu);
  const auto choose = [this](int row) {
    if (!is_filling_ && row >= 0 && row < static_cast<int>(candidates_.size()))
      emit candidate_chosen(candidates_[static_cast<std::size_t>(row)].index);
  };
  connect(candidate_table_, &QTableWidget::cellClicked, this, choose);
  connect(candidate_table_, &QTableWidget::cellActivated, this, choose);
  connect(candidate_table_, &QTableWidget::cellEntered, this, [this](int row) {
    if (row >= 0 && row < static_cast<int>(candidates_.size()))
      emit candidate_hovered(candidates_[static_cast<std::size_t>(row)].index);
  });
  refresh();
  refresh_candidates();
}

void TrianglePanel::set_state(TriangleState state) {
  state_ = std::move(state);
  refresh();
}

void TrianglePanel::set_candidates(int marker, std::vector<TriangleCandidate> candidates) {
  candidates_of_ = marker;
  candidates_ = std::move(candidates);
  refresh_candidates();
}

void TrianglePanel::refresh() {
  const Colors& c = colors();
  sketch_->set_state(state_);
  QStringList sides;
  for (const TriangleSide& side : state_.sides)
    sides += QStringLiteral("%1–%2: %3 mm")
                 .arg(side.from)
                 .arg(side.to)
                 .arg(side.sigma_mm ? with_sigma_text(side.length_mm, side.sigma_mm) : fixed_text(side.length_mm, 1));
  sides_->setText(sides.join(QLatin1Char('\n')));
  sides_->setVisible(!sides.isEmpty());
  QColor ground = c.sunken, ink = c.ink1;
  QString sign;
  if (state_.verdict == TriangleVerdict::good) ground = c.good_tint, ink = c.good, sign = QStringLiteral("✓ ");
  if (state_.verdict == TriangleVerdict::care) ground = c.care_tint, ink = c.care, sign = QStringLiteral("! ");
  if (state_.verdict == TriangleVerdict::bad) ground = c.bad_tint, ink = c.bad, sign = QStringLiteral("✗ ");
  QPalette colors_of_sentence = palette();
  colors_of_sentence.setColor(QPalette::Window, ground);
  colors_of_sentence.setColor(QPalette::WindowText, ink);
  sentence_->setPalette(colors_of_sentence);
  QPalette rows = palette();
  rows.setColor(QPalette::Highlight, c.selected_row);
  rows.setColor(QPalette::HighlightedText, c.ink1);
  markers_->setPalette(rows);
  candidate_table_->setPalette(rows);
  sentence_->setText(state_.sentence.isEmpty() ? QString() : sign + state_.sentence);
  sentence_->setVisible(!state_.sentence.isEmpty());
  action_->setText(state_.action);
  action_->setVisible(!state_.action.isEmpty());
  use_->setEnabled(state_.can_use);
  discard_->setEnabled(state_.can_discard);
  refresh_markers();
}

void TrianglePanel::refresh_markers() {
  is_filling_ = true;
  markers_->setRowCount(static_cast<int>(state_.markers.size()));
  int selected = -1;
  for (int row = 0; row < markers_->rowCount(); ++row) {
    const TriangleMarker& marker = state_.markers[static_cast<std::size_t>(row)];
    set_cell(*markers_, row, 0, QString::number(marker.number));
    set_cell(*markers_, row, 1, seen_text(marker), false);
    const auto depth = marker.in_left_camera ? std::optional(marker.in_left_camera->z()) : std::nullopt;
    set_cell(*markers_, row, 2, fixed_text(depth, 3));
    const auto sigma = marker.depth_sigma_m ? std::optional(*marker.depth_sigma_m * 1000) : std::nullopt;
    set_cell(*markers_, row, 3, fixed_text(sigma, 1));
    set_cell(*markers_, row, 4, fixed_text(marker.epipolar_distance, 1));
    if (marker.number == state_.selected_marker) selected = row;
  }
  if (selected >= 0)
    markers_->selectRow(selected);
  else
    markers_->clearSelection();
  markers_->setVisible(markers_->rowCount() > 0);
  fit_height(*markers_, 6);
  is_filling_ = false;
}

void TrianglePanel::refresh_candidates() {
  is_filling_ = true;
  candidate_table_->setRowCount(static_cast<int>(candidates_.size()));
  candidate_table_->clearSelection();
  for (int row = 0; row < candidate_table_->rowCount(); ++row) {
    const TriangleCandidate& candidate = candidates_[static_cast<std::size_t>(row)];
    set_cell(*candidate_table_, row, 0, fixed_text(candidate.distance, 2));
    set_cell(*candidate_table_, row, 1, fixed_text(candidate.depth_m, 3));
    set_cell(*candidate_table_, row, 2, candidate.sides + (candidate.is_taken ? QStringLiteral("  ✓") : QString()),
             false);
    if (candidate.is_taken) candidate_table_->selectRow(row);
  }
  const bool has_any = !candidates_.empty();
  candidates_title_->setText(QObject::tr("On the line of marker %1").arg(candidates_of_));
  candidates_title_->setVisible(has_any);
  candidate_table_->setVisible(has_any);
  fit_height(*candidate_table_, 5);
  is_filling_ = false;
}

void TrianglePanel::show_marker_menu(const QPoint& position) {
  const int row = markers_->rowAt(position.y());
  if (row < 0 || row >= static_cast<int>(state_.markers.size())) return;
  const int number = state_.markers[static_cast<std::size_t>(row)].number;
  QMenu menu(this);
  menu.addAction(QObject::tr("Remove"), this, [this, number] { emit marker_removed(number); });
  QMenu* renumber = menu.addMenu(QObject::tr("Renumber to"));
  for (const TriangleMarker& other : state_.markers) {
    if (other.number == number) continue;
    renumber->addAction(QString::number(other.number), this,
                        [this, number, to = other.number] { emit marker_renumbered(number, to); });
  }
  menu.exec(markers_->viewport()->mapToGlobal(position));
}

bool TrianglePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == candidate_table_->viewport() && event->type() == QEvent::Leave) emit candidate_hovered(-1);
  if (watched == markers_ && event->type() == QEvent::KeyPress && state_.selected_marker >= 0) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
      emit marker_removed(state_.selected_marker);
      return true;
    }
    if (key >= Qt::Key_0 && key <= Qt::Key_9 && key - Qt::Key_0 != state_.selected_marker) {
      emit marker_renumbered(state_.selected_marker, key - Qt::Key_0);
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

void TrianglePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && use_) refresh();
  QFrame::changeEvent(event);
}

}  // namespace handsight::widgets
