// SPDX-License-Identifier: GPL-3.0-or-later
// The lower row: its widgets and what they are connected to.
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "explain/watching_pane.h"
#include "widgets/base/motion.h"
#include "widgets/base/theme.h"
#include "widgets/explain/bill_list.h"
#include "widgets/explain/cost_curve.h"
#include "widgets/explain/version_list.h"
#include "widgets/scene/robot_view.h"
#include "workbench/link_selection.h"

namespace handsight::app {

WatchingPane::WatchingPane(Workbench& workbench, Adding& adding, QWidget* parent)
    : QWidget(parent), workbench_(workbench), adding_(adding), expecting_(workbench, adding) {
  make_layout();
  connect_all();
  bending_.setDuration(widgets::short_motion);
  bending_.setStartValue(0.0);
  bending_.setEndValue(1.0);
  connect(&bending_, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
    if (adding_.is_running()) bend(share.toDouble());
  });
}

void WatchingPane::make_layout() {
  stairs_ = new widgets::Staircase(this);
  stairs_->setObjectName("staircase");
  stairs_->set_empty_text(tr("The error of every version of the model comes here."));
  versions_ = new widgets::VersionList(this);
  versions_->setObjectName("versions");
  cost_ = new widgets::CostCurve(this);
  cost_->setObjectName("cost");
  cost_->set_empty_text(tr("Add a candidate, and its fit is drawn here as it runs."));
  left_ = new QStackedWidget(this);
  left_->addWidget(stairs_);
  bill_ = new widgets::BillList(this);
  bill_->setObjectName("bill");
  auto* both = new QWidget(this);
  auto* side_by_side = new QHBoxLayout(both);
  side_by_side->setContentsMargins(0, 0, 0, 0);
  side_by_side->setSpacing(8);
  side_by_side->addWidget(versions_, 5);
  side_by_side->addWidget(bill_, 6);
  left_->addWidget(both);
  left_->addWidget(cost_);
  tabs_ = new QButtonGroup(this);
  auto* tabs = new QHBoxLayout;
  tabs->setSpacing(0);
  const std::pair<const char*, QString> names[] = {
      {"tab_stairs", tr("Staircase")}, {"tab_versions", tr("Versions")}, {"tab_fit", tr("Fit")}};
  for (int i = 0; i < 3; ++i) {
    auto* b = new QToolButton(this);
    b->setObjectName(names[i].first);
    b->setText(names[i].second);
    b->setCheckable(true);
    b->setAutoRaise(true);
    tabs_->addButton(b, i);
    tabs->addWidget(b);
  }
  tabs->addStretch(1);
  tabs_->button(tab_stairs)->setChecked(true);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->addLayout(tabs);
  left->addWidget(left_, 1);

  cloud_ = new widgets::ResidualCloud(this);
  cloud_->setObjectName("cloud");
  cloud_->set_empty_text(tr("What is left of every point comes here."));
  robot_ = new widgets::RobotView(this);
  robot_->setObjectName("ghost_robot");
  robot_title_ = new QLabel(this);
  robot_title_->setObjectName("ghost_title");
  robot_title_->setFont(widgets::text_font(widgets::TextRole::small));
  robot_title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  robot_title_->setWordWrap(true);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(robot_title_);
  right->addWidget(robot_, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addLayout(left, 332);
  layout->addWidget(cloud_, 332);
  layout->addLayout(right, 380);
  columns_ = layout;
  setMinimumSize(620, 124);  // on a laptop also below a row of sessions
}

void WatchingPane::connect_all() {
  using widgets::Staircase;
  using widgets::VersionList;
  connect(tabs_, &QButtonGroup::idClicked, this, &WatchingPane::choose_tab);
  const auto choose = [this](int row) {
    if (const auto version = version_at(row)) emit version_chosen(version);
  };
  connect(stairs_, &Staircase::version_selected, this, choose);
  connect(versions_, &VersionList::version_selected, this, choose);
  connect(stairs_, &Staircase::compared, this, &WatchingPane::compare);
  connect(versions_, &VersionList::compared, this, &WatchingPane::compare);
  connect(versions_, &VersionList::take_back_requested, this, &WatchingPane::take_back);
  link_selection(stairs_, workbench_);
  link_selection(cost_, workbench_);
  link_selection(cloud_, workbench_);
  link_selection(robot_, workbench_);
  connect(&adding_, &Adding::began, this, &WatchingPane::began);
  connect(&adding_, &Adding::iterated, cost_, &widgets::CostCurve::append);
  connect(&adding_, &Adding::pictured, this, &WatchingPane::picture);
  connect(&adding_, &Adding::ended, this, &WatchingPane::ended);
  connect(&expecting_, &Expecting::changed, this, &WatchingPane::refresh_bill);
  connect(&workbench_.document, &Document::opened, this, [this] {
    robot_is_set_ = false;
    a_ = b_ = -1;
    rows_.clear();
    memory_ = remembered_stairs(workbench_.document.file());
    cost_->clear();
    cloud_->reset();
    choose_tab(tab_stairs);
  });
  connect(&workbench_.selection, &Selection::changed, this, [this] {
    if (!isVisible()) return;
    cloud_->set_selected(workbench_.selection.current().observation.value_or(widgets::no_observation));
    const auto& many = workbench_.selection.many();
    cloud_->set_highlighted(many.size() > 1 ? std::vector<widgets::ObservationId>(many.begin(), many.end())
                                            : std::vector<widgets::ObservationId>{});
    show_robot();
  });
}

}  // namespace handsight::app
