// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/camera_strip.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

namespace handsight::app {

CameraStrip::CameraStrip(Workbench& bench, widgets::ImageView* first, widgets::ImageView* second, QWidget* parent)
    : QWidget(parent), bench_(bench), views_{first, second} {
  setObjectName("camera_strip");
  row_ = new QHBoxLayout(this);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(4);
  row_->addStretch(1);
  hide();
  connect(&bench.document, &Document::opened, this, &CameraStrip::rebuild);
}

void CameraStrip::rebuild() {
  const auto& rig = bench_.document.session().rig;
  cameras_ = {0, 1};
  next_ = 1;
  for (QToolButton* b : buttons_) delete b;
  buttons_.clear();
  names_ = rig ? camera_names_in_words(*rig) : QStringList();
  views_[1]->setVisible(rig && rig->count() > 1);
  setVisible(names_.size() > 2);
  for (int camera = 0; camera < names_.size() && names_.size() > 2; ++camera) {
    auto* b = new QToolButton(this);
    b->setObjectName(QString("camera_%1").arg(camera));
    b->setText(names_[camera]);
    b->setToolTip(tr("Shows the image of this camera"));
    b->setCheckable(true);
    connect(b, &QToolButton::clicked, this, [this, camera] { show_camera(camera); });
    row_->insertWidget(camera, b);
    buttons_.push_back(b);
  }
  refresh();
}

void CameraStrip::refresh() {
  for (int camera = 0; camera < static_cast<int>(buttons_.size()); ++camera)
    buttons_[static_cast<std::size_t>(camera)]->setChecked(camera == cameras_[0] || camera == cameras_[1]);
}

std::vector<ShownCamera> CameraStrip::shown() const {
  std::vector<ShownCamera> list{{views_[0], cameras_[0]}};
  const auto& rig = bench_.document.session().rig;
  if (rig && rig->count() > 1) list.push_back({views_[1], cameras_[1]});
  return list;
}

int CameraStrip::camera_of(const widgets::ImageView* view) const { return cameras_[view == views_[0] ? 0 : 1]; }

void CameraStrip::show_camera(int camera) {
  const bool is_shown = std::find(cameras_.begin(), cameras_.end(), camera) != cameras_.end();
  if (!is_shown && camera < names_.size()) {
    cameras_[static_cast<std::size_t>(next_)] = camera;
    next_ = 1 - next_;
    emit changed();
  }
  refresh();
}

}  // namespace handsight::app
