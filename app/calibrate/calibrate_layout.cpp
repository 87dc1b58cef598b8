// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the Calibrate workspace.
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "calibrate/calibrate_workspace.h"
#include "calibrate/fixtures_page.h"
#include "calibrate/hands_page.h"
#include "calibrate/objective_page.h"
#include "calibrate/one_marker_page.h"
#include "calibrate/own_pose_page.h"
#include "calibrate/transport.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/decision_list.h"
#include "widgets/lists/whole_rows.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/scene/robot_view.h"
#include "workbench/camera_strip.h"

namespace handsight::app {

void CalibrateWorkspace::make_layout() {
  transport_ = new Transport(workbench_, player_, this);
  left_ = new widgets::ImageView(this);
  right_ = new widgets::ImageView(this);
  left_->setObjectName("calibrate_left");
  right_->setObjectName("calibrate_right");
  scene_ = new widgets::RobotView(this);
  scene_->setObjectName("calibrate_scene");
  connect(scene_, &widgets::RobotView::notes_changed, this, &CalibrateWorkspace::say_notes);
  board_ = new widgets::ConvergenceBoard(this);
  board_->set_empty_text(tr("Play, and the six parameters converge here."));
  decisions_ = new widgets::DecisionList(this);
  decisions_->setObjectName("decisions");
  decisions_->set_empty_text(tr("Play: each observation is taken, or rejected with its reason."));
  objectives_ = new ObjectivePage(workbench_, this);
  one_marker_ = new OneMarkerPage(workbench_, this);
  own_pose_ = new OwnPosePage(workbench_, this);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("calibrate_tabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(new widgets::WholeRows(decisions_, widgets::row_height_px, tabs_), tr("Decisions"));
  tabs_->addTab(objectives_, tr("Objective"));
  tabs_->addTab(one_marker_, tr("One marker"));
  tabs_->addTab(own_pose_, tr("Own pose"));
  auto* upper = new QSplitter(Qt::Horizontal, this);
  for (QWidget* w : std::initializer_list<QWidget*>{left_, right_, scene_}) upper->addWidget(w);
  upper->setSizes({32, 32, 36});
  auto* lower = new QSplitter(Qt::Horizontal, this);
  lower->addWidget(board_);
  hands_ = new HandsPage(workbench_, this);
  hands_->hide();
  lower->insertWidget(0, hands_);
  fixtures_ = new FixturesPage(workbench_, this);
  fixtures_->hide();
  lower->insertWidget(1, fixtures_);
  lower->addWidget(tabs_);
  for (int side : {0, 1, 2}) lower->setStretchFactor(side, 62);  // one of them is shown
  lower->setStretchFactor(3, 38);
  lower->setSizes({800, 800, 800, 620});
  auto* rows = new QSplitter(Qt::Vertical, this);
  rows->addWidget(upper);
  rows->addWidget(lower);
  rows->setSizes({400, 360});
  for (QSplitter* s : {upper, lower, rows}) {
    s->setChildrenCollapsible(false);
    s->setHandleWidth(8);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 8);
  layout->setSpacing(4);
  layout->addWidget(transport_);
  cameras_ = new CameraStrip(workbench_, left_, right_, this);
  connect(cameras_, &CameraStrip::changed, this, &CalibrateWorkspace::refresh_observation);
  layout->addWidget(cameras_);
  layout->addWidget(rows, 1);
  const auto magnify = [this](double times) {
    scene_->set_ghost_magnification(times);
    scene_->set_arrow_magnification(times);
    left_->set_magnification(times);
    right_->set_magnification(times);
  };
  connect(transport_, &Transport::magnification_changed, this, magnify);
  magnify(transport_->magnification());
}

}  // namespace handsight::app
