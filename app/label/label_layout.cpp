// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>

#include "label/label_workspace.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/images/loupe.h"
#include "widgets/images/triangle_panel.h"

namespace handsight::app {

void LabelWorkspace::make_layout() {
  left_ = new widgets::ImageView(this);
  right_ = new widgets::ImageView(this);
  left_->setObjectName("label_left");
  right_->setObjectName("label_right");
  left_->set_labelling(true);
  right_->set_labelling(true);
  left_->set_stretched(true);
  right_->set_stretched(true);
  left_->set_loupe(true);
  left_loupe_ = new widgets::Loupe(this);
  right_loupe_ = new widgets::Loupe(this);
  left_loupe_->set_title(tr("Left"));
  right_loupe_->set_title(tr("Right, on the line"));
  left_loupe_->set_hints(tr("arrows 0.1 px, Shift 1, Alt free"));
  triangle_ = new widgets::TrianglePanel(this);
  triangle_->setObjectName("triangle");
  triangle_->setMinimumWidth(288);
  triangle_->setMaximumWidth(360);
  together_ = new QCheckBox(this);
  together_->setObjectName("together");
  together_->setText(tr("Zoom both together"));
  hint_ = new QLabel(this);
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  hint_->setText(
      tr("Click near a marker's corner in the left image: it snaps, and its partner in the right image is found along "
         "the epipolar line. Drag a marker, nudge it with the arrows, press a digit to renumber it, Delete to remove "
         "it. Hold Alt to set it freely."));
  auto* const grid = grid_ = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 8);
  grid->setSpacing(8);
  auto* loupes = new QHBoxLayout;
  loupes->setSpacing(8);
  loupes->addWidget(left_loupe_);
  loupes->addWidget(right_loupe_);
  auto* words = new QVBoxLayout;
  words->addWidget(together_, 0, Qt::AlignLeft);
  words->addWidget(hint_, 1);
  loupes->addSpacing(8);
  loupes->addLayout(words, 1);
  grid->addWidget(left_, 0, 0);
  grid->addWidget(right_, 0, 1);
  grid->addLayout(loupes, 1, 0, 1, 2);
  grid->addWidget(triangle_, 0, 2, 2, 1);
  grid->setRowStretch(0, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
}

/// On a small screen the images need the room that the words would take.
void LabelWorkspace::resizeEvent(QResizeEvent* event) {
  Workspace::resizeEvent(event);
  constexpr int roomy = 1000;
  hint_->setVisible(width() >= roomy && is_labelled_here_);
  left_->setToolTip(width() >= roomy ? QString() : hint_->text());
}

void LabelWorkspace::connect_left() {
  using widgets::ImageView;
  connect(left_, &ImageView::pointed, this,
          [this](const Vector2& px, Qt::KeyboardModifiers keys) { placed(px, keys.testFlag(Qt::AltModifier)); });
  connect(left_, &ImageView::pointer_moved, this, [this](const Vector2& px) {
    left_loupe_->set_center(px);
    right_->set_epipolar_line(labeller_.epipolar_line(px));
  });
  connect(left_, &ImageView::pointer_left, this, &LabelWorkspace::refresh);
  connect(left_, &ImageView::viewport_changed, this, [this](const widgets::ImageViewport& viewport) {
    if (together_->isChecked()) right_->set_viewport(viewport);
  });
  connect(right_, &ImageView::viewport_changed, this, [this](const widgets::ImageViewport& viewport) {
    if (together_->isChecked()) left_->set_viewport(viewport);
  });
  for (ImageView* view : {left_, right_}) {
    const bool is_left = view == left_;
    connect(view, &ImageView::marker_selected, this, &LabelWorkspace::select_marker);
    connect(view, &ImageView::marker_hovered, this, [this](int marker) {
      left_->set_hovered_marker(marker);
      right_->set_hovered_marker(marker);
    });
    connect(view, &ImageView::marker_dragged, this,
            [this, is_left](int marker, const Vector2& px, bool finished, Qt::KeyboardModifiers keys) {
              marker_ = marker;
              labeller_.move(marker, is_left, px, !finished || keys.testFlag(Qt::AltModifier));
              if (!finished) return refresh();
              remember(tr("moved marker %1 of observation %2").arg(marker).arg(observation_));
            });
    connect(view, &ImageView::marker_nudged, this, [this, is_left](int marker, const Vector2& delta) {
      const auto found = labeller_.markers().find(marker);
      if (found == labeller_.markers().end() || (!is_left && !found->second.right)) return;
      const Vector2 from = is_left ? found->second.left.position : found->second.right->position;
      labeller_.move(marker, is_left, from + delta, true);
      if (nudged_ != marker) nudge_join_ = workbench_.document.new_join();
      nudged_ = marker;
      remember(tr("nudged marker %1 of observation %2").arg(marker).arg(observation_), nudge_join_);
    });
    connect(view, &ImageView::marker_removed, this, &LabelWorkspace::remove_marker);
    connect(view, &ImageView::marker_renumbered, this, &LabelWorkspace::renumber);
    connect(view, &ImageView::read_out, &workbench_, &Workbench::pointed_at);
  }
}

void LabelWorkspace::connect_right() {
  using widgets::ImageView;
  connect(right_, &ImageView::candidate_chosen, this, &LabelWorkspace::choose_partner);
  connect(right_, &ImageView::candidate_hovered, this, [this](int index) {
    const auto& corners = labeller_.corners().right;
    if (index >= 0 && index < static_cast<int>(corners.size()))
      right_loupe_->set_center(corners[static_cast<std::size_t>(index)].position);
  });
  connect(right_, &ImageView::pointer_moved, this, [this](const Vector2& px) { right_loupe_->set_center(px); });
  connect(right_, &ImageView::pointed, this, [this](const Vector2& px, Qt::KeyboardModifiers keys) {
    if (marker_ < 0) {
      say(tr("Click a marker's corner in the left image first."));
      return;
    }
    labeller_.move(marker_, false, px, keys.testFlag(Qt::AltModifier));
    remember(tr("chose the partner of marker %1 of observation %2").arg(marker_).arg(observation_));
  });
}

void LabelWorkspace::connect_panel() {
  using widgets::TrianglePanel;
  connect(triangle_, &TrianglePanel::use_requested, this, &LabelWorkspace::use);
  connect(triangle_, &TrianglePanel::discard_requested, this, &LabelWorkspace::next_observation);
  connect(triangle_, &TrianglePanel::marker_selected, this, &LabelWorkspace::select_marker);
  connect(triangle_, &TrianglePanel::marker_removed, this, &LabelWorkspace::remove_marker);
  connect(triangle_, &TrianglePanel::marker_renumbered, this, &LabelWorkspace::renumber);
  connect(triangle_, &TrianglePanel::candidate_chosen, this, &LabelWorkspace::choose_partner);
  connect(triangle_, &TrianglePanel::action_requested, &workbench_.document, &Document::undo);
  connect(triangle_, &TrianglePanel::candidate_hovered, right_, &widgets::ImageView::set_hovered_candidate);
}

}  // namespace handsight::app
