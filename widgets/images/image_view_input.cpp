// SPDX-License-Identifier: GPL-3.0-or-later
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMetaMethod>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/images/image_view_drag.h"

namespace handsight::widgets {
namespace {

constexpr double most_zoom = 64;

}  // namespace

void ImageView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (frame_size().isEmpty() || event->angleDelta().y() == 0) return;
  const Vector2 under = to_image(event->position());
  const double least = std::min(fitted().zoom / 2, 1.0);
  ImageViewport v = viewport_;
  v.zoom = std::clamp(v.zoom * std::pow(1.25, event->angleDelta().y() / 120.0), least, most_zoom);
  const QPointF d = event->position() - image_area().center();
  v.center = {under.x() - d.x() / v.zoom, under.y() - d.y() / v.zoom};
  change_viewport(v);
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (frame_size().isEmpty() || event->button() == Qt::RightButton) return;
  drag_ = std::make_unique<ImageDrag>();
  drag_->button = event->button();
  drag_->from = event->position();
  drag_->viewport = viewport_;
  const int mark = event->button() == Qt::LeftButton ? mark_at(event->position()) : -1;
  if (mark < 0) return;
  const ImageMark& m = marks_[static_cast<std::size_t>(mark)];
  if (is_labelling_) {
    drag_->kind = ImageDrag::marker;
    drag_->grip = to_screen(m.position) - event->position();
  }
  drag_->number = m.marker;
  emit marker_selected(m.marker);
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (!frame_size().isEmpty()) emit pointer_moved(to_image(event->position()));
  if (has_loupe_) update();
  if (!drag_) {
    hover(event->position());
    return;
  }
  const QPointF d = event->position() - drag_->from;
  if (!drag_->has_moved && std::hypot(d.x(), d.y()) < 4) return;
  drag_->has_moved = true;
  if (drag_->kind == ImageDrag::marker) {
    const Vector2 to = nearest_inside(to_image(event->position() + drag_->grip));
    emit marker_dragged(drag_->number, to, false, event->modifiers());
    return;
  }
  ImageViewport v = drag_->viewport;
  v.center -= Vector2(d.x() / v.zoom, d.y() / v.zoom);
  change_viewport(v);
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
  if (!drag_ || event->button() != drag_->button) return;
  const std::unique_ptr<ImageDrag> drag = std::move(drag_);
  if (drag->kind == ImageDrag::marker && drag->has_moved) {
    const Vector2 to = nearest_inside(to_image(event->position() + drag->grip));
    emit marker_dragged(drag->number, to, true, event->modifiers());
    return;
  }
  if (drag->has_moved || drag->button != Qt::LeftButton || drag->number >= 0) return;
  const int candidate = candidate_at(event->position());
  if (candidate >= 0)
    emit candidate_chosen(candidates_[static_cast<std::size_t>(candidate)].index);
  else if (is_labelling_ && is_inside(to_image(event->position())))
    emit pointed(to_image(event->position()), event->modifiers());
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return mousePressEvent(event);
  // While labelling the first click has done what is to be done: the second one places nothing.
  if (is_labelling_ && isSignalConnected(QMetaMethod::fromSignal(&ImageView::pointed))) return;
  fit();
  emit viewport_changed(viewport_);
}

void ImageView::leaveEvent(QEvent*) {
  pointer_.reset();
  if (hovered_marker_ >= 0) emit marker_hovered(-1);
  if (hovered_candidate_ >= 0) emit candidate_hovered(-1);
  hovered_marker_ = hovered_candidate_ = -1;
  emit pointer_left();
  emit read_out({});
  update();
}

void ImageView::hover(const QPointF& position) {
  const int mark = mark_at(position);
  const int candidate = mark < 0 ? candidate_at(position) : -1;
  const int marker = mark < 0 ? -1 : marks_[static_cast<std::size_t>(mark)].marker;
  const int index = candidate < 0 ? -1 : candidates_[static_cast<std::size_t>(candidate)].index;
  if (marker != hovered_marker_) {
    hovered_marker_ = marker;
    emit marker_hovered(marker);
    update();
  }
  if (index != hovered_candidate_) {
    hovered_candidate_ = index;
    emit candidate_hovered(index);
    update();
  }
  if (frame_size().isEmpty()) return;
  const Vector2 px = mark < 0 ? to_image(position) : marks_[static_cast<std::size_t>(mark)].position;
  QString text = QStringLiteral("%1, %2 px").arg(fixed_text(px.x(), 1), fixed_text(px.y(), 1));
  if (mark >= 0) {
    const QString& own = marks_[static_cast<std::size_t>(mark)].text;
    text = own.isEmpty() ? QObject::tr("marker %1 at %2").arg(marker).arg(text) : own;
  } else if (candidate >= 0) {
    text = QObject::tr("corner at %1: %2").arg(text, candidates_[static_cast<std::size_t>(candidate)].label);
  }
  emit read_out(text);
}

bool ImageView::act_on_marker(QKeyEvent* event) {
  if (!is_labelling_ || selected_marker_ < 0) return false;
  const double step = event->modifiers() & Qt::ShiftModifier ? 1.0 : 0.1;
  switch (event->key()) {
    case Qt::Key_Left:
      emit marker_nudged(selected_marker_, Vector2(-step, 0));
      return true;
    case Qt::Key_Right:
      emit marker_nudged(selected_marker_, Vector2(step, 0));
      return true;
    case Qt::Key_Up:
      emit marker_nudged(selected_marker_, Vector2(0, -step));
      return true;
    case Qt::Key_Down:
      emit marker_nudged(selected_marker_, Vector2(0, step));
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      emit marker_removed(selected_marker_);
      return true;
    default:
      break;
  }
  if (event->key() < Qt::Key_0 || event->key() > Qt::Key_9 || event->modifiers() & Qt::ControlModifier) return false;
  const int to = event->key() - Qt::Key_0;
  if (to != selected_marker_) emit marker_renumbered(selected_marker_, to);
  return true;
}

void ImageView::keyPressEvent(QKeyEvent* event) {
  if (act_on_marker(event)) return;
  const double turns = event->key() == Qt::Key_Plus ? 1 : event->key() == Qt::Key_Minus ? -1 : 0;
  if (event->key() == Qt::Key_F && !event->modifiers()) {
    fit();
    emit viewport_changed(viewport_);
  } else if (turns != 0) {
    ImageViewport v = viewport_;
    v.zoom = std::clamp(v.zoom * std::pow(1.25, turns), fitted().zoom / 2, most_zoom);
    change_viewport(v);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void ImageView::contextMenuEvent(QContextMenuEvent* event) {
  const int mark = mark_at(event->pos());
  QMenu menu(this);
  if (is_labelling_ && mark >= 0) {
    const int number = marks_[static_cast<std::size_t>(mark)].marker;
    menu.addAction(QObject::tr("Remove marker %1").arg(number), this, [this, number] { emit marker_removed(number); });
    QMenu* renumber = menu.addMenu(QObject::tr("Renumber to"));
    for (int to = 0; to < 10; ++to)
      if (to != number)
        renumber->addAction(QString::number(to), this, [this, number, to] { emit marker_renumbered(number, to); });
    menu.addSeparator();
  }
  menu.addAction(QObject::tr("Fit the image"), this, [this] {
    fit();
    emit viewport_changed(viewport_);
  });
  menu.addAction(QObject::tr("True size"), this, [this] { change_viewport({viewport_.center, 1}); });
  menu.exec(event->globalPos());
}

}  // namespace handsight::widgets
