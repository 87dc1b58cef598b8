// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the page of an experiment.
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "experiment/experiment_page.h"
#include "experiment/goals_form.h"
#include "experiment/moving_robot.h"
#include "widgets/base/theme.h"
#include "widgets/lists/whole_rows.h"
#include "widgets/plots/history_plot.h"
#include "widgets/scene/robot_view.h"
#include "workbench/heading.h"
#include "workbench/link_selection.h"

namespace handsight::app {
namespace {

using widgets::HistoryPlot;
using widgets::TextRole;

QLabel* wrapped(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  return label;
}

QScrollArea* scrolled(QWidget* content, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  return area;
}

}  // namespace

QWidget* ExperimentPage::make_views() {
  auto* views = new QSplitter(Qt::Vertical, this);
  scene_ = new widgets::RobotView(views);
  scene_->setObjectName("experiment_scene");
  views->addWidget(scene_);
  auto* plots = new QSplitter(Qt::Horizontal, views);
  hand_plot_ = new HistoryPlot(HistoryPlot::Along::observations, plots);
  hand_plot_->setObjectName("experiment_hand_plot");
  hand_plot_->set_quantity(tr("95 % limit"), QStringLiteral("mm"), true);
  hand_plot_->set_title(tr("How well the hand is known"));
  hand_plot_->set_empty_text(tr("Measure, and the expected error of the hand falls here."));
  odds_plot_ = new HistoryPlot(HistoryPlot::Along::observations, plots);
  odds_plot_->setObjectName("experiment_odds_plot");
  odds_plot_->set_quantity(tr("odds, to one"), {}, true);
  odds_plot_->set_title(tr("How sure the cause is"));
  odds_plot_->set_empty_text(tr("Measure, and the odds of the likeliest cause rise here."));
  for (HistoryPlot* plot : {hand_plot_, odds_plot_}) {
    plots->addWidget(plot);
    link_selection(plot, workbench_);
  }
  link_selection(scene_, workbench_);
  views->addWidget(plots);
  views->setSizes({330, 190});
  for (QSplitter* s : {views, plots}) {
    s->setChildrenCollapsible(false);
    s->setHandleWidth(8);
  }
  return views;
}

QWidget* ExperimentPage::make_welcome() {
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(10);
  column->addWidget(heading(tr("Let the robot measure by itself"), page));
  for (const QString& text :
       {tr("The program chooses the most useful poses, drives there, looks (or touches), and stops when enough is "
           "known: where the "
           "hand sits, and what is missing in the model."),
        tr("1.  Write the command of your robot's driver above: a program of yours that moves the robot and takes the "
           "images, or feels for what is touched. A template of thirty lines is in docs/examples/drivers."),
        tr("2.  Connect. The driver says where the robot stands, and the first poses and the ways to them are shown. "
           "Nothing moves."),
        tr("3.  Start. You are asked once more. Then each move is shown as it happens; Esc and the red button stop "
           "the robot at any time."),
        tr("No robot at hand? Try it with the simulated one: a copy of this session is measured on, and nothing comes "
           "among your own measurements.")}) {
    auto* label = wrapped("", page);
    label->setText(text);
    column->addWidget(label);
  }
  column->addStretch(1);
  return scrolled(page, this);
}

QWidget* ExperimentPage::make_known() {
  auto* page = new QWidget(this);
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(8, 8, 8, 8);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  int row = 0;
  const auto add = [&](const QString& name, const char* object) {
    auto* head = new QLabel(name, page);
    head->setForegroundRole(QPalette::PlaceholderText);
    QLabel* value = wrapped(object, page);
    grid->addWidget(head, row, 0, Qt::AlignTop);
    grid->addWidget(value, row++, 1);
    return value;
  };
  used_ = add(tr("Used"), "experiment_used");
  hand_ = add(tr("Hand"), "experiment_hand");
  missing_ = add(tr("What is missing"), "experiment_missing");
  causes_[0] = add(tr("Likeliest"), "experiment_cause_0");
  causes_[1] = add(tr("Next likeliest"), "experiment_cause_1");
  next_ = add(tr("Next pose"), "experiment_next");
  more_ = add(tr("One more hour"), "experiment_more");
  grid->setRowStretch(row, 1);
  return scrolled(page, this);
}

void ExperimentPage::make_layout() {
  goals_ = new GoalsForm(this);
  auto* goals_page = new QWidget(this);
  auto* goals_room = new QVBoxLayout(goals_page);
  goals_room->setContentsMargins(8, 8, 8, 8);
  goals_room->addWidget(goals_);
  goals_room->addStretch(1);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("experiment_side");
  tabs_->setDocumentMode(true);
  tabs_->addTab(scrolled(goals_page, tabs_), tr("When to stop"));
  tabs_->addTab(make_known(), tr("What is known"));
  poses_ = new QTableWidget(0, 3, this);
  poses_->setObjectName("experiment_poses");
  poses_->setAccessibleName(tr("Poses that were taken and that come next"));
  poses_->setHorizontalHeaderLabels({tr("Pose"), tr("What for"), tr("Result")});
  poses_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  poses_->setSelectionBehavior(QAbstractItemView::SelectRows);
  poses_->setSelectionMode(QAbstractItemView::SingleSelection);
  poses_->verticalHeader()->hide();
  poses_->verticalHeader()->setDefaultSectionSize(widgets::row_height_px);
  poses_->setShowGrid(false);
  poses_->setFrameShape(QFrame::NoFrame);
  poses_->setWordWrap(false);
  poses_->setTabKeyNavigation(false);
  poses_->horizontalHeader()->setHighlightSections(false);
  poses_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  poses_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  poses_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  auto* work = new QSplitter(Qt::Vertical, this);
  work->addWidget(tabs_);
  work->addWidget(new widgets::WholeRows(poses_, widgets::row_height_px, work));
  work->setSizes({290, 210});
  work->setChildrenCollapsible(false);
  work->setHandleWidth(8);
  side_ = new QStackedWidget(this);
  side_->addWidget(make_welcome());
  side_->addWidget(work);
  side_->setMinimumWidth(360);
  auto* columns = new QSplitter(Qt::Horizontal, this);
  columns->addWidget(make_views());
  columns->addWidget(side_);
  columns->setStretchFactor(0, 1);
  columns->setStretchFactor(1, 0);
  columns->setSizes({760, 430});
  columns->setChildrenCollapsible(false);
  columns->setHandleWidth(8);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(columns);
}

}  // namespace handsight::app
