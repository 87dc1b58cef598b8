// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/camera_strip.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

#include "workbench/session_parts.h"

namespace handsight::app {

CameraStrip::CameraStrip(Workbench& workbench, widgets::ImageView* first, widgets::ImageView* second, QWidget* parent)
    : QWidget(parent), workbench_(workbench), views_{first, second} {
  setObjectName("camera_strip");
  row_ = new QHBoxLayout(this);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(4);
  row_->addStretch(1);
  hide();
  connect(&workbench.document, &Document::opened, this, &CameraStrip::rebuild);
}

void CameraStrip::rebuild() {
  const Session& session = workbench_.document.session();
  const Observation* o = workbench_.selected_observation();
  const OwnSession own = take_own_session(session, o ? o->part : 0);
  first_ = own.first_camera;
  count_ = own.camera_count;
  cameras_ = {first_, first_ + 1};
  next_ = 1;
  for (QToolButton* b : buttons_) delete b;
  buttons_.clear();
  const QStringList names = session.rig ? camera_names_in_words(*session.rig) : QStringList();
  views_[1]->setVisible(count_ > 1);
  setVisible(count_ > 2);
  for (int camera = first_; camera < first_ + count_ && count_ > 2; ++camera) {
    auto* b = new QToolButton(this);
    b->setObjectName(QString("camera_%1").arg(camera));
    b->setText(names.value(camera));
    b->setToolTip(tr("Shows the image of this camera"));
    b->setCheckable(true);
    connect(b, &QToolButton::clicked, this, [this, camera] { show_camera(camera); });
    row_->insertWidget(camera - first_, b);
    buttons_.push_back(b);
  }
  refresh();
}

/// In a collection each observation has its own session's cameras.
void CameraStrip::follow() {
  const Observation* o = workbench_.selected_observation();
  if (!o) return;
  const OwnSession own = take_own_session(workbench_.document.session(), o->part);
  if (own.first_camera != first_ || own.camera_count != count_) rebuild();
}

void CameraStrip::refresh() {
  for (int i = 0; i < static_cast<int>(buttons_.size()); ++i)
    buttons_[static_cast<std::size_t>(i)]->setChecked(first_ + i == cameras_[0] || first_ + i == cameras_[1]);
}

std::vector<ShownCamera> CameraStrip::shown() {
  follow();
  if (count_ == 0) return {{views_[0], -1}};  // a tracker's, whatever other sessions have
  std::vector<ShownCamera> list{{views_[0], cameras_[0]}};
  if (count_ > 1) list.push_back({views_[1], cameras_[1]});
  return list;
}

int CameraStrip::look_up_camera(const widgets::ImageView* view) const { return cameras_[view == views_[0] ? 0 : 1]; }

void CameraStrip::show_camera(int camera) {
  const bool is_shown = std::find(cameras_.begin(), cameras_.end(), camera) != cameras_.end();
  if (!is_shown && camera >= first_ && camera < first_ + count_) {
    cameras_[static_cast<std::size_t>(next_)] = camera;
    next_ = 1 - next_;
    emit changed();
  }
  refresh();
}

}  // namespace handsight::app
