// SPDX-License-Identifier: GPL-3.0-or-later
#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "inspect/inspect_workspace.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/observation_table.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/scene/robot_view.h"
#include "workbench/camera_strip.h"

namespace handsight::app {

QWidget* InspectWorkspace::make_actions() {
  auto* row = new QWidget(this);
  const auto button = [row](const char* name, const QString& text, const QString& tip) {
    auto* b = new QPushButton(text, row);
    b->setObjectName(name);
    b->setToolTip(tip);
    b->setMinimumHeight(28);
    return b;
  };
  exclude_ = button("exclude", tr("Exclude"), tr("Leaves the chosen observations out of the fit (Delete)"));
  include_ = button("include", tr("Include"), tr("Takes the chosen observations into the fit (Insert)"));
  look_ = button("look", tr("Look there"), tr("Zooms to the marker that is worst off"));
  relabel_ = button("relabel", tr("Relabel"), tr("Opens the observation in Label"));
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  for (QPushButton* b : {exclude_, include_, look_, relabel_}) layout->addWidget(b);
  layout->addStretch(1);
  return row;
}

QWidget* InspectWorkspace::make_map() {
  auto* page = new QWidget(this);
  map_ = new widgets::ResidualMap(page);
  map_->setObjectName("residual_map");
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 4, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const auto group = [&](std::initializer_list<QString> names, int checked, auto slot) {
    auto* buttons = new QButtonGroup(page);
    int i = 0;
    for (const QString& name : names) {
      auto* b = new QToolButton(page);
      b->setText(name);
      b->setCheckable(true);
      b->setAutoRaise(true);
      b->setChecked(i == checked);
      buttons->addButton(b, i++);
      row->addWidget(b);
    }
    connect(buttons, &QButtonGroup::idClicked, this, slot);
  };
  group({tr("Size"), tr("Arrows"), tr("Direction")}, 1,
        [this](int id) { map_->set_lens(static_cast<widgets::MapLens>(id)); });
  row->addStretch(1);
  map_camera_ = new QComboBox(page);
  map_camera_->setObjectName("map_camera");
  map_camera_->setAccessibleName(tr("Camera"));
  row->addWidget(map_camera_);
  connect(map_camera_, &QComboBox::currentIndexChanged, this,
          [this](int i) { map_->set_camera(i > 0 ? std::optional(i - 1) : std::nullopt); });
  layout->addLayout(row);
  layout->addWidget(map_, 1);
  return page;
}

QWidget* InspectWorkspace::make_threshold() {
  auto* page = new QWidget(this);
  histogram_ = new widgets::HistogramPlot(page);
  histogram_->setObjectName("histogram");
  histogram_->setAccessibleName(tr("Histogram of the residuals"));
  beyond_text_ = new QLabel(tr("Drag the threshold: what lies beyond it can be excluded."), page);
  beyond_text_->setObjectName("beyond_text");
  beyond_text_->setWordWrap(true);
  exclude_beyond_ = new QPushButton(tr("Exclude them"), page);
  exclude_beyond_->setObjectName("exclude_beyond");
  exclude_beyond_->setEnabled(false);
  auto* row = new QHBoxLayout;
  row->addWidget(beyond_text_, 1);
  row->addWidget(exclude_beyond_);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(histogram_, 1);
  layout->addLayout(row);
  return page;
}

void InspectWorkspace::make_layout() {
  table_ = new widgets::ObservationTable(this);
  table_->setObjectName("inspect_table");
  table_->set_empty_text(tr("No fit yet."), tr("Fit now"));
  left_ = new widgets::ImageView(this);
  right_ = new widgets::ImageView(this);
  left_->setObjectName("inspect_left");
  right_->setObjectName("inspect_right");
  for (widgets::ImageView* view : {left_, right_}) view->set_labelling(true);
  attribution_ = new widgets::AttributionBar(this);
  attribution_->setObjectName("blame");
  scene_ = new widgets::RobotView(this);
  scene_->setObjectName("inspect_scene");
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("inspect_tabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(make_threshold(), tr("Histogram"));
  tabs_->addTab(make_map(), tr("Over the image"));

  auto* pair = new QSplitter(Qt::Horizontal, this);
  pair->addWidget(left_);
  pair->addWidget(right_);
  cameras_ = new CameraStrip(workbench_, left_, right_, this);
  auto* images = images_ = new QWidget(this);
  auto* images_layout = new QVBoxLayout(images);
  images_layout->setContentsMargins(0, 0, 0, 0);
  images_layout->setSpacing(4);
  images_layout->addWidget(cameras_);
  images_layout->addWidget(pair, 1);
  auto* attribution = new QWidget(this);
  auto* attribution_layout = new QVBoxLayout(attribution);
  attribution_layout->setContentsMargins(0, 0, 0, 0);
  attribution_layout->setSpacing(8);
  attribution_layout->addWidget(attribution_, 1);
  attribution_layout->addWidget(make_actions());
  auto* lower = new QSplitter(Qt::Horizontal, this);
  lower->addWidget(scene_);
  lower->addWidget(tabs_);
  lower->setSizes({330, 340});
  auto* rows = new QSplitter(Qt::Vertical, this);
  rows->addWidget(images);
  rows->addWidget(attribution);
  rows->addWidget(lower);
  rows->setSizes({260, 120, 350});
  auto* columns = new QSplitter(Qt::Horizontal, this);
  columns->addWidget(table_);
  columns->addWidget(rows);
  columns->setSizes({400, 640});
  columns->setStretchFactor(0, 37);
  columns->setStretchFactor(1, 63);
  for (QSplitter* s : {pair, lower, rows, columns}) {
    s->setChildrenCollapsible(false);
    s->setHandleWidth(8);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(columns);
}

}  // namespace handsight::app
