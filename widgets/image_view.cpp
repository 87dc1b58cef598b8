// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/image_view_drag.h"
#include "widgets/number_text.h"
#include "widgets/theme.h"

namespace handsight::widgets {
namespace {

constexpr double kReach = 10;  // screen px: how near the pointer has to be to a mark
constexpr double kHeader = 20, kMostZoom = 64;

}  // namespace

ImageView::ImageView(QWidget* parent) : QWidget(parent), empty_text_(QStringLiteral("No image.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

ImageView::~ImageView() = default;

QSize ImageView::sizeHint() const { return {424, 338}; }
QSize ImageView::minimumSizeHint() const { return {160, 130}; }

void ImageView::set_title(const QString& title) {
  title_ = title;
  setAccessibleName(title);
  update();
}

void ImageView::set_image(const QImage& image) {
  const QSizeF before = frame_size();
  image_ = image;
  frame_width_ = image.width();
  frame_height_ = image.height();
  if (before != frame_size() || is_fitted_) fit();
  update();
}

void ImageView::clear(const QString& sentence) {
  image_ = {};
  frame_width_ = frame_height_ = 0;
  empty_text_ = sentence;
  corners_.clear(), epipolar_line_.clear(), marks_.clear(), axes_.clear(), arrows_.clear(), candidates_.clear();
  drag_.reset();
  update();
}

void ImageView::set_frame_size(int width, int height) {
  if (!image_.isNull()) return;
  const bool is_new = width != frame_width_ || height != frame_height_;
  frame_width_ = width;
  frame_height_ = height;
  if (is_new || is_fitted_) fit();
  update();
}

#define HANDSIGHT_SETTER(name, Type, member) \
  void ImageView::name(Type value) {         \
    member = std::move(value);               \
    update();                                \
  }
HANDSIGHT_SETTER(set_corners, std::vector<Vector2>, corners_)
HANDSIGHT_SETTER(set_marks, std::vector<ImageMark>, marks_)
HANDSIGHT_SETTER(set_selected_marker, int, selected_marker_)
HANDSIGHT_SETTER(set_hovered_marker, int, hovered_marker_)
HANDSIGHT_SETTER(set_axes, std::vector<ImageAxes>, axes_)
HANDSIGHT_SETTER(set_arrows, std::vector<ImageArrow>, arrows_)
HANDSIGHT_SETTER(set_magnification, double, magnification_)
HANDSIGHT_SETTER(set_epipolar_line, std::vector<Vector2>, epipolar_line_)
HANDSIGHT_SETTER(set_candidates, std::vector<ImageCandidate>, candidates_)
HANDSIGHT_SETTER(set_hovered_candidate, int, hovered_candidate_)
HANDSIGHT_SETTER(set_loupe, bool, has_loupe_)
#undef HANDSIGHT_SETTER

void ImageView::set_labelling(bool labelling) {
  is_labelling_ = labelling;
  setCursor(labelling ? Qt::CrossCursor : Qt::ArrowCursor);
}

QRectF ImageView::image_area() const { return QRectF(rect()).adjusted(0, title_.isEmpty() ? 0 : kHeader, 0, 0); }

QSizeF ImageView::frame_size() const { return {double(frame_width_), double(frame_height_)}; }

ImageViewport ImageView::fitted() const {
  const QSizeF frame = frame_size();
  const QRectF area = image_area();
  if (frame.isEmpty() || area.isEmpty()) return {};
  ImageViewport v;
  v.center = {(frame.width() - 1) / 2, (frame.height() - 1) / 2};
  v.zoom = std::min(area.width() / frame.width(), area.height() / frame.height());
  return v;
}

void ImageView::fit() {
  viewport_ = fitted();
  is_fitted_ = true;
  update();
}

void ImageView::set_viewport(const ImageViewport& viewport) {
  viewport_ = viewport;
  is_fitted_ = false;
  update();
}

void ImageView::show_point(const Vector2& px, double zoom) { set_viewport({px, zoom}); }

void ImageView::change_viewport(const ImageViewport& viewport) {
  viewport_ = viewport;
  is_fitted_ = false;
  update();
  emit viewport_changed(viewport_);
}

QPointF ImageView::to_screen(const Vector2& px) const {
  return image_area().center() +
         QPointF((px.x() - viewport_.center.x()) * viewport_.zoom, (px.y() - viewport_.center.y()) * viewport_.zoom);
}

Vector2 ImageView::to_image(const QPointF& position) const {
  const QPointF d = (position - image_area().center()) / viewport_.zoom;
  return {viewport_.center.x() + d.x(), viewport_.center.y() + d.y()};
}

int ImageView::mark_at(const QPointF& position) const {
  int best = -1;
  double nearest = kReach;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (marks_[i].role != MarkRole::measured) continue;
    const QPointF d = to_screen(marks_[i].position) - position;
    const double distance = std::hypot(d.x(), d.y());
    if (distance >= nearest) continue;
    nearest = distance;
    best = static_cast<int>(i);
  }
  return best;
}

int ImageView::candidate_at(const QPointF& position) const {
  int best = -1;
  double nearest = kReach;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const QPointF d = to_screen(candidates_[i].position) - position;
    const double distance = std::hypot(d.x(), d.y());
    if (distance >= nearest) continue;
    nearest = distance;
    best = static_cast<int>(i);
  }
  return best;
}

void ImageView::resizeEvent(QResizeEvent*) {
  if (is_fitted_) fit();
}

void ImageView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (frame_size().isEmpty() || event->angleDelta().y() == 0) return;
  const Vector2 under = to_image(event->position());
  const double least = std::min(fitted().zoom / 2, 1.0);
  ImageViewport v = viewport_;
  v.zoom = std::clamp(v.zoom * std::pow(1.25, event->angleDelta().y() / 120.0), least, kMostZoom);
  const QPointF d = event->position() - image_area().center();
  v.center = {under.x() - d.x() / v.zoom, under.y() - d.y() / v.zoom};
  change_viewport(v);
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (frame_size().isEmpty() || event->button() == Qt::RightButton) return;
  drag_ = std::make_unique<Drag>();
  drag_->button = event->button();
  drag_->from = event->position();
  drag_->viewport = viewport_;
  const int mark = event->button() == Qt::LeftButton ? mark_at(event->position()) : -1;
  if (mark < 0) return;
  const ImageMark& m = marks_[static_cast<std::size_t>(mark)];
  if (is_labelling_) {
    drag_->kind = Drag::marker;
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
  if (drag_->kind == Drag::marker) {
    emit marker_dragged(drag_->number, to_image(event->position() + drag_->grip), false, event->modifiers());
    return;
  }
  ImageViewport v = drag_->viewport;
  v.center -= Vector2(d.x() / v.zoom, d.y() / v.zoom);
  change_viewport(v);
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
  if (!drag_ || event->button() != drag_->button) return;
  const std::unique_ptr<Drag> drag = std::move(drag_);
  if (drag->kind == Drag::marker && drag->has_moved) {
    emit marker_dragged(drag->number, to_image(event->position() + drag->grip), true, event->modifiers());
    return;
  }
  if (drag->has_moved || drag->button != Qt::LeftButton || drag->number >= 0) return;
  const int candidate = candidate_at(event->position());
  if (candidate >= 0)
    emit candidate_chosen(candidates_[static_cast<std::size_t>(candidate)].index);
  else if (is_labelling_)
    emit pointed(to_image(event->position()), event->modifiers());
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* event) {
  // While labelling two quick clicks are two clicks.
  if (is_labelling_ || event->button() != Qt::LeftButton) {
    mousePressEvent(event);
    return;
  }
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
    text = own.isEmpty() ? QStringLiteral("marker %1 at %2").arg(marker).arg(text) : own;
  } else if (candidate >= 0) {
    text = QStringLiteral("corner at %1: %2").arg(text, candidates_[static_cast<std::size_t>(candidate)].label);
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
    v.zoom = std::clamp(v.zoom * std::pow(1.25, turns), fitted().zoom / 2, kMostZoom);
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
    menu.addAction(QStringLiteral("Remove marker %1").arg(number), this,
                   [this, number] { emit marker_removed(number); });
    QMenu* renumber = menu.addMenu(QStringLiteral("Renumber to"));
    for (int to = 0; to < 10; ++to)
      if (to != number)
        renumber->addAction(QString::number(to), this, [this, number, to] { emit marker_renumbered(number, to); });
    menu.addSeparator();
  }
  menu.addAction(QStringLiteral("Fit the image"), this, [this] {
    fit();
    emit viewport_changed(viewport_);
  });
  menu.addAction(QStringLiteral("True size"), this, [this] { change_viewport({viewport_.center, 1}); });
  menu.exec(event->globalPos());
}

void ImageView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
