// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/images/image_view.h"

#include <QMouseEvent>
#include <QObject>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_contrast.h"
#include "widgets/images/image_view_drag.h"

namespace handsight::widgets {
namespace {

constexpr double reach_px = 10;  // screen px: how near the pointer has to be to a mark
constexpr double header_height = 20;

}  // namespace

ImageView::ImageView(QWidget* parent) : QWidget(parent), empty_text_(QObject::tr("No image.")) {
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
  refresh_shown();
  frame_width_ = image.width();
  frame_height_ = image.height();
  if (before != frame_size() || is_fitted_) fit();
  update();
}

void ImageView::clear(const QString& sentence) {
  image_ = shown_ = {};
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

void ImageView::show_frame(int width, int height) {
  if (!image_.isNull()) clear({});
  empty_text_.clear();
  set_frame_size(width, height);
}

#define HANDSIGHT_SETTER(name, Type, member) \
  void ImageView::name(Type value) {         \
    (member) = std::move(value);             \
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

void ImageView::set_stretched(bool stretched) {
  if (is_stretched_ == stretched) return;
  is_stretched_ = stretched;
  refresh_shown();
  update();
}

void ImageView::refresh_shown() { shown_ = is_stretched_ ? with_stretched_contrast(image_) : image_; }

bool ImageView::is_inside(const Vector2& px) const {
  return px.x() >= -0.5 && px.y() >= -0.5 && px.x() <= frame_width_ - 0.5 && px.y() <= frame_height_ - 0.5;
}

Vector2 ImageView::nearest_inside(const Vector2& px) const {
  return px.cwiseMax(Vector2(0, 0)).cwiseMin(Vector2(frame_width_ - 1, frame_height_ - 1));
}

QRectF ImageView::image_area() const { return QRectF(rect()).adjusted(0, title_.isEmpty() ? 0 : header_height, 0, 0); }

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
  double nearest = reach_px;
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
  double nearest = reach_px;
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

void ImageView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
