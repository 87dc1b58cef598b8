// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the comparison.
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "compare/compare_page.h"
#include "widgets/base/theme.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/lists/whole_rows.h"

namespace handsight::app {
namespace {

using widgets::TextRole;

QTableWidget* plain_table(const QStringList& heads, const char* name, QWidget* parent) {
  auto* table = new QTableWidget(0, static_cast<int>(heads.size()), parent);
  table->setObjectName(name);
  table->setHorizontalHeaderLabels(heads);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(widgets::row_height_px);
  table->setShowGrid(false);
  table->setFrameShape(QFrame::NoFrame);
  table->setWordWrap(false);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  return table;
}

QLabel* title_label(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setFont(widgets::text_font(TextRole::title));
  return label;
}

}  // namespace

QWidget* ComparePage::make_head() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  names_ = new QLabel(head);
  names_->setObjectName("compare_names");
  names_->setFont(widgets::text_font(TextRole::title));
  names_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names must not widen the window
  names_->setWordWrap(true);
  row->addWidget(names_, 1);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* b = new QPushButton(text, head);
    b->setObjectName(name);
    b->setToolTip(tip);
    b->setMinimumHeight(widgets::control_height);
    b->setAutoDefault(false);
    row->addWidget(b);
    return b;
  };
  swap_ = button("compare_swap", tr("Swap"), tr("The earlier one is the later one, and the other way round"));
  again_ = button("compare_again", tr("Compare again"), tr("With the open session as it is now"));
  choose_ = button("compare_choose", tr("Another one…"), tr("Another session of the same robot, or a calibration"));
  close_ = button("compare_close", tr("Close"), tr("Back to the workspaces; both sessions are as they were"));
  return head;
}

QWidget* ComparePage::make_lists() {
  auto* lists = new QWidget(body_);
  auto* column = new QVBoxLayout(lists);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  changes_title_ = title_label("compare_changes_title", lists);
  changes_ = plain_table({tr("What may have changed"), tr("ln Bayes")}, "compare_changes", lists);
  changes_->setAccessibleName(tr("What may have changed"));
  numbers_title_ = title_label("compare_numbers_title", lists);
  numbers_ = plain_table({tr("Number"), tr("change"), tr("unit"), tr("in σ")}, "compare_numbers", lists);
  numbers_->horizontalHeaderItem(2)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);  // as the units below it
  numbers_->setAccessibleName(tr("Numbers of both"));
  column->addWidget(changes_title_);
  for (QTableWidget* table : {changes_, numbers_}) widgets::end_below_rows(table);
  column->addWidget(changes_, 2);
  column->addWidget(numbers_title_);
  column->addWidget(numbers_, 3);
  column->addStretch(0);
  lists->setMinimumWidth(340);
  return lists;
}

QWidget* ComparePage::make_which() {
  which_ = new QWidget(body_);
  auto* row = new QHBoxLayout(which_);
  row->setContentsMargins(0, 0, 0, 4);
  row->setSpacing(8);
  for (std::size_t i = 0; i < shown_sides_.size(); ++i) {
    row->addWidget(new QLabel(i == 0 ? tr("Plots before:") : tr("after:"), which_));
    shown_sides_[i] = new QComboBox(which_);
    shown_sides_[i]->setObjectName(i == 0 ? "compare_before" : "compare_after");
    shown_sides_[i]->setAccessibleName(i == 0 ? tr("Session before") : tr("Session after"));
    shown_sides_[i]->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(shown_sides_[i]);
  }
  row->addStretch(1);
  return which_;
}

QWidget* ComparePage::make_clouds() {
  cloud_ = new widgets::ResidualCloud;
  cloud_->setObjectName("compare_cloud");
  cloud_->set_apart(true);
  return cloud_;
}

QWidget* ComparePage::make_convergence() {
  auto* page = new QWidget;
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(1);
  using widgets::ConvergencePlot;
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    const bool is_position = i < 2;
    plots_[i] = is_position ? new ConvergencePlot(tr("position"), QStringLiteral("mm"), {"x", "y", "z"}, page)
                            : new ConvergencePlot(tr("rotation"), QStringLiteral("deg"), {"rx", "ry", "rz"}, page);
    plots_[i]->setObjectName(QString("compare_convergence_%1").arg(i));
    grid->addWidget(plots_[i], static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    connect(plots_[i], &widgets::PlotWidget::read_out, &workbench_, &Workbench::pointed_at);
    connect(plots_[i], &widgets::PlotWidget::message, &workbench_.document, &Document::noticed);
  }
  ConvergencePlot::share_axes({{plots_[0], plots_[1]}, {plots_[2], plots_[3]}});
  return page;
}

QWidget* ComparePage::make_patterns() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  for (std::size_t i = 0; i < patterns_.size(); ++i) {
    sides_[i] = new QLabel(page);
    sides_[i]->setObjectName(QString("compare_side_%1").arg(i));
    sides_[i]->setFont(widgets::text_font(TextRole::small));
    sides_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    patterns_[i] = new widgets::PatternPage(page);
    patterns_[i]->setObjectName(QString("compare_patterns_%1").arg(i));
    patterns_[i]->set_rows(1);
    patterns_[i]->show_numbers();
    connect(patterns_[i], &widgets::PatternPage::read_out, &workbench_, &Workbench::pointed_at);
    column->addWidget(sides_[i]);
    column->addWidget(patterns_[i], 1);
  }
  patterns_[0]->set_companion(patterns_[1]);
  patterns_[1]->set_companion(patterns_[0]);
  return page;
}

void ComparePage::make_layout() {
  verdict_box_ = new QWidget(this);
  verdict_box_->setAutoFillBackground(true);
  auto* verdict = new QVBoxLayout(verdict_box_);
  verdict->setContentsMargins(12, 6, 12, 6);
  verdict->setSpacing(2);
  said_ = new QLabel(verdict_box_);
  said_->setObjectName("compare_said");
  said_->setFont(widgets::text_font(TextRole::title));
  more_ = new QLabel(verdict_box_);
  more_->setObjectName("compare_more");
  for (QLabel* label : {said_, more_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    verdict->addWidget(label);
  }
  empty_ = new QLabel(tr("Choose another session of this robot, or several, or a calibration that was exported for it: "
                         "what has changed is told here, and two are shown by the same plots."),
                      this);
  empty_->setObjectName("compare_empty");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  choose_first_ = new QPushButton(tr("Choose…"), this);
  choose_first_->setObjectName("compare_choose_first");
  choose_first_->setMinimumHeight(widgets::control_height);
  body_ = new QSplitter(Qt::Horizontal, this);
  body_->setChildrenCollapsible(false);
  body_->addWidget(make_lists());
  auto* right = new QWidget(body_);
  auto* plots = new QVBoxLayout(right);
  plots->setContentsMargins(0, 0, 0, 0);
  plots->setSpacing(0);
  plots->addWidget(make_which());
  tabs_ = new QTabWidget(right);
  plots->addWidget(tabs_, 1);
  tabs_->setObjectName("compare_tabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(make_clouds(), tr("Residuals"));
  tabs_->addTab(make_convergence(), tr("Convergence"));
  tabs_->addTab(make_patterns(), tr("Where it fails"));
  body_->addWidget(right);
  body_->setStretchFactor(0, 0);
  body_->setStretchFactor(1, 1);
  body_->setSizes({380, 840});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 8);
  layout->setSpacing(8);
  layout->addWidget(make_head());
  layout->addWidget(verdict_box_);
  layout->addWidget(empty_, 1);
  layout->addWidget(choose_first_, 0, Qt::AlignHCenter);
  layout->addWidget(body_, 1);
  layout->addStretch(0);
}

}  // namespace handsight::app
