// SPDX-License-Identifier: GPL-3.0-or-later
#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include "export/correction_box.h"
#include "export/export_workspace.h"
#include "export/exported.h"
#include "widgets/lists/whole_rows.h"
#include "workbench/heading.h"

namespace handsight::app {
namespace {

constexpr int row_height = 22;  // px: nine numbers and what they buy are in sight on a laptop

/// As low as a few rows until it is known how many there are.
class LowTable : public QTableWidget {
 public:
  using QTableWidget::QTableWidget;
  QSize sizeHint() const override { return {QTableWidget::sizeHint().width(), find_least_height()}; }
  /// Of six numbers, none of them cut.
  int find_least_height() const { return horizontalHeader()->sizeHint().height() + 6 * row_height; }
};

LowTable* plain_table(int columns, QWidget* parent) {
  auto* table = new LowTable(0, columns, parent);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(row_height);
  table->setShowGrid(false);
  table->setFrameShape(QFrame::NoFrame);
  table->setWordWrap(false);
  return table;
}

/// Scrolls up and down alone: never narrower than what it holds, and the bar beside it.
class ScrolledColumn : public QScrollArea {
 public:
  ScrolledColumn(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  QSize minimumSizeHint() const override {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

QWidget* ExportWorkspace::make_left() {
  auto* left = new QWidget(body_);
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  auto* titles = new QHBoxLayout;
  titles->addWidget(heading(tr("TCP→Body"), left));
  hand_ = new QComboBox(left);
  hand_->setObjectName("export_hand");
  hand_->setAccessibleName(tr("Session whose hand is shown"));
  hand_->setToolTip(
      tr("Whose hand is shown, copied, certified and saved for other programs; the XML holds all of them"));
  hand_->hide();
  titles->addWidget(hand_);
  titles->addStretch(1);
  layout->addLayout(titles);
  auto* row = new QHBoxLayout;
  forms_ = new QButtonGroup(this);
  const QString names[] = {tr("Matrix"), tr("xyz + rpy"), tr("Quaternion")};
  for (int i = 0; i < 3; ++i) {
    auto* b = new QRadioButton(names[i], left);
    b->setObjectName("form_" + QString::number(i));
    forms_->addButton(b, i);
    row->addWidget(b);
  }
  forms_->button(1)->setChecked(true);
  row->addStretch(1);
  copy_ = new QPushButton(tr("Copy"), left);
  copy_->setObjectName("copy");
  row->addWidget(copy_);
  layout->addLayout(row);
  auto* motion = plain_table(4, left);
  motion_ = motion;
  motion_->setObjectName("motion");
  motion_->setAccessibleName(tr("TCP→Body"));
  motion_->setWordWrap(true);
  motion_->installEventFilter(this);
  motion_->verticalHeader()->setMinimumSectionSize(row_height);
  motion_->setHorizontalHeaderLabels({QString(), tr("value"), tr("±"), tr("unit")});
  for (const int c : {1, 2}) motion_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  motion_->horizontalHeaderItem(3)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  motion_->setMinimumHeight(motion->find_least_height());
  widgets::end_below_rows(motion_);
  layout->addWidget(motion_, 2);
  correction_ = new CorrectionBox(workbench_, left);
  layout->addWidget(correction_);
  excluded_title_ = heading(tr("Not used"), left);
  layout->addWidget(excluded_title_);
  fresh_ = new QLabel(left);
  fresh_->setObjectName("fresh");
  fresh_->setWordWrap(true);
  layout->addWidget(fresh_);
  excluded_ = plain_table(3, left);
  excluded_->setObjectName("not_used");
  excluded_->setHorizontalHeaderLabels({tr("obs"), tr("prediction, mm"), tr("why not used")});
  excluded_->horizontalHeaderItem(1)->setToolTip(tr(
      "How far the hand was from where the model predicts it, and how far 95 of 100 poses like the fitted ones are."));
  excluded_->horizontalHeader()->setStretchLastSection(true);
  excluded_->setWordWrap(true);
  excluded_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  layout->addWidget(excluded_, 1);
  layout->addStretch(0);
  return left;
}

QWidget* ExportWorkspace::make_right() {
  auto* right = new QWidget(body_);
  auto* layout = new QVBoxLayout(right);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(heading(tr("XML as it will be written"), right));
  xml_ = new QPlainTextEdit(right);
  xml_->setObjectName("xml");
  xml_->setAccessibleName(tr("XML as it will be written"));
  xml_->setReadOnly(true);
  xml_->setLineWrapMode(QPlainTextEdit::NoWrap);
  QFont mono = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  mono.setPixelSize(12);
  xml_->setFont(mono);
  layout->addWidget(xml_, 1);
  return right;
}

void ExportWorkspace::make_layout() {
  reported_ = new QWidget;
  reported_->setAutoFillBackground(true);
  remarks_ = new QVBoxLayout(reported_);
  remarks_->setContentsMargins(12, 8, 12, 8);
  remarks_->setSpacing(4);
  before_ = new QScrollArea(this);
  before_->setObjectName("export_remarks");
  before_->setAccessibleName(tr("Before you use it"));
  before_->setWidget(reported_);
  before_->setWidgetResizable(true);
  before_->setFrameShape(QFrame::NoFrame);
  before_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  body_ = new QWidget(this);
  auto* columns = new QHBoxLayout(body_);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(16);
  columns->addWidget(new ScrolledColumn(make_left(), body_), 45);
  columns->addWidget(make_right(), 55);
  empty_ = new QLabel(tr("Nothing to export: TCP→Body has not been estimated."), this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  calibrate_ = new QPushButton(tr("Calibrate"), this);
  path_ = new QLineEdit(this);
  path_->setObjectName("export_path");
  path_->setAccessibleName(tr("File to write"));
  save_ = new QPushButton(tr("Save XML"), this);
  save_->setObjectName("save_xml");
  save_->setDefault(true);
  html_ = new QPushButton(tr("Report HTML"), this);
  html_->setObjectName("report_html");
  pdf_ = new QPushButton(tr("Report PDF"), this);
  pdf_->setObjectName("report_pdf");
  certificate_ = new QPushButton(tr("Certificate"), this);
  certificate_->setObjectName("certificate");
  certificate_->setToolTip(tr("As PDF: errors before and after by ISO 9283, promised limits and how often they held"));
  said_ = new QLabel(this);
  said_->setObjectName("export_said");
  said_->setWordWrap(true);
  said_->setContentsMargins(12, 6, 12, 6);
  said_->setAutoFillBackground(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(path_, 1);
  for (QPushButton* b : {save_, html_, pdf_, certificate_}) {
    b->setMinimumHeight(28);
    row->addWidget(b);
  }
  other_ = new QComboBox(this);
  other_->setObjectName("other_kind");
  other_->setAccessibleName(tr("For other programs"));
  for (const char* kind : export_kinds) other_->addItem(export_kind(kind).title, QString(kind));
  save_other_ = new QPushButton(tr("Save for it"), this);
  save_other_->setObjectName("save_other");
  save_other_->setToolTip(tr("Beside the XML, for another program: the robot, the hand and what corrects them"));
  row->addSpacing(8);
  for (QWidget* w : {static_cast<QWidget*>(other_), static_cast<QWidget*>(save_other_)}) {
    w->setMinimumHeight(28);
    row->addWidget(w);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 12);
  layout->setSpacing(12);
  layout->addWidget(before_);
  layout->addWidget(empty_, 1);
  layout->addWidget(calibrate_, 0, Qt::AlignHCenter);
  layout->addWidget(body_, 1);
  layout->addWidget(said_);
  layout->addLayout(row);
  said_->hide();
}

std::size_t ExportWorkspace::hand() const { return static_cast<std::size_t>(std::max(hand_->currentIndex(), 0)); }

MotionForm ExportWorkspace::form() const { return static_cast<MotionForm>(forms_->checkedId()); }

std::filesystem::path ExportWorkspace::path() const { return path_->text().trimmed().toStdString(); }

}  // namespace handsight::app
