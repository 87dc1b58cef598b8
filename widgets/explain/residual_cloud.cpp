// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/residual_cloud.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/base/motion.h"
#include "widgets/base/number_text.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr int blink = 450;  // ms
constexpr double reach_pixels = 8;

double measure_size(const CloudPoint& point) { return std::hypot(point.du, point.dv); }

double largest(const std::vector<CloudPoint>& points) {
  double most = 0;
  for (const CloudPoint& point : points)
    if (std::isfinite(point.du) && std::isfinite(point.dv)) most = std::max(most, measure_size(point));
  return most;
}

}  // namespace

ResidualCloud::ResidualCloud(QWidget* parent)
    : QWidget(parent), empty_text_(tr("No residuals yet.")), after_empty_text_(tr("Try a card, or add it.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Residuals of all corners, before and after"));
  animation_.setDuration(short_motion);
  animation_.setStartValue(0.0);
  animation_.setEndValue(1.0);
  animation_.setEasingCurve(QEasingCurve::InOutQuad);
  connect(&animation_, &QVariantAnimation::valueChanged, this,
          [this](const QVariant& value) { move(value.toDouble()); });
  connect(&animation_, &QVariantAnimation::finished, this, [this] {
    moving_.clear();
    update();
  });
  blink_.setInterval(blink);
  connect(&blink_, &QTimer::timeout, this, [this] {
    is_swapped_ = !is_swapped_;
    update();
  });
}

void ResidualCloud::set_noise(std::optional<double> sigma) {
  noise_ = sigma && *sigma > 0 ? sigma : std::nullopt;
  if (noise_ && reach_ > 0) reach_ = std::max(reach_, 5 * *noise_);
  update();
}

void ResidualCloud::set_unit(SizeUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  reset();
}

void ResidualCloud::set_before(std::vector<CloudPoint> points, const QString& title) {
  still_ = {};
  before_ = {std::move(points), title};
  hold(before_.points);
  update();
}

void ResidualCloud::set_after(std::vector<CloudPoint> points, const QString& title) {
  animation_.stop();
  moving_from_ = !moving_.empty() ? moving_ : after_.points.empty() ? before_.points : after_.points;
  moving_.clear();
  after_ = {std::move(points), title};
  hold(after_.points);
  const bool can_move = !is_apart_ && moving_from_.size() == after_.points.size() && !after_.points.empty();
  if (can_move && !motion_is_reduced() && isVisible()) {
    moving_ = moving_from_;
    animation_.start();
  }
  update();
}

/// Lets the axes grow to what they cannot hold; a cloud that shrinks is seen to shrink.
void ResidualCloud::hold(const std::vector<CloudPoint>& points) {
  constexpr double slack = 1.1;
  if (reach_ <= 0 || largest(points) > slack * reach_) fit();
}

void ResidualCloud::reset() {
  animation_.stop();
  moving_from_.clear();
  moving_.clear();
  before_ = after_ = {};
  still_ = {};
  is_predicted_ = false;
  noise_.reset();
  reach_ = 0;
  update();
}

void ResidualCloud::set_live(const std::vector<CloudPoint>& points, const QString& title) {
  animation_.stop();
  moving_ = points;
  after_.title = title;
  if (reach_ <= 0) fit();
  update();
}

void ResidualCloud::move(double share) {
  if (moving_.size() != after_.points.size() || moving_from_.size() != moving_.size()) return;
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const CloudPoint &from = moving_from_[i], &to = after_.points[i];
    moving_[i] = to;
    moving_[i].du = from.du + share * (to.du - from.du);
    moving_[i].dv = from.dv + share * (to.dv - from.dv);
  }
  update();
}

void ResidualCloud::set_predicted(bool predicted) {
  is_predicted_ = predicted;
  update();
}

void ResidualCloud::clear_after() {
  animation_.stop();
  after_ = {};
  moving_.clear();
  is_predicted_ = false;
  update();
}

void ResidualCloud::set_selected(ObservationId id) {
  selected_ = id;
  update();
}

void ResidualCloud::set_highlighted(std::vector<ObservationId> ids) {
  std::sort(ids.begin(), ids.end());
  highlighted_ = std::move(ids);
  update();
}

void ResidualCloud::set_linear(bool linear) {
  is_linear_ = linear;
  update();
}

void ResidualCloud::set_blinking(bool blinking) {
  if (blinking == blink_.isActive()) return;
  is_swapped_ = blinking;
  blinking ? blink_.start() : blink_.stop();
  update();
}

void ResidualCloud::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

void ResidualCloud::fit() {
  reach_ = 1.05 * std::max({largest(before_.points), largest(after_.points), largest(moving_)});
  if (noise_ && reach_ > 0) reach_ = std::max(reach_, 5 * *noise_);  // noise alone never fills the picture
  update();
}

double ResidualCloud::radius(double size) const {
  if (!(reach_ > 0)) return 0;
  const double bend = 3 * noise_.value_or(reach_ / 10);
  if (is_linear_ || bend * 5 > reach_) return std::min(size / reach_, 1.0);
  return std::min(std::asinh(size / bend) / std::asinh(reach_ / bend), 1.0);
}

QRectF ResidualCloud::pane(int index) const {
  constexpr double line = 20;  // px, of the text above it and of that below
  const double side = std::floor(std::min((width() - 3.0 * layout_gap) / 2, height() - 2 * line));
  const double left = (width() - 2 * side - layout_gap) / 2, above = std::max(0.0, (height() - 2 * line - side) / 2);
  return {std::floor(left + index * (side + layout_gap)), std::floor(above + line), side, side};
}

QPointF ResidualCloud::on_screen(int index, double du, double dv) const {
  const QRectF area = pane(index);
  const double size = std::hypot(du, dv);
  if (!(size > 0)) return area.center();
  const double scale = radius(size) * area.width() / 2 / size;
  return area.center() + QPointF(du, dv) * scale;
}

const std::vector<CloudPoint>& ResidualCloud::shown(int index) const {
  const bool is_after = (index == 1) != is_swapped_;
  if (!is_after) return before_.points;
  return moving_.empty() ? after_.points : moving_;
}

const CloudPoint* ResidualCloud::point_at(const QPointF& position, int* pane_of_it) const {
  const CloudPoint* best = nullptr;
  double nearest = reach_pixels;
  for (int i = 0; i < 2; ++i) {
    if (!pane(i).adjusted(-4, -4, 4, 4).contains(position)) continue;
    for (const CloudPoint& point : shown(i)) {
      const QPointF away = on_screen(i, point.du, point.dv) - position;
      const double distance = std::hypot(away.x(), away.y());
      if (distance >= nearest) continue;
      nearest = distance;
      best = &point;
      if (pane_of_it) *pane_of_it = i;
    }
  }
  return best;
}

void ResidualCloud::mousePressEvent(QMouseEvent* event) {
  const CloudPoint* point = point_at(event->position());
  if (event->button() == Qt::LeftButton && point && !is_apart_) emit observation_selected(point->observation);
}

void ResidualCloud::mouseMoveEvent(QMouseEvent* event) {
  int pane_of_it = hovered_pane_;
  const CloudPoint* point = point_at(event->position(), &pane_of_it);
  const ObservationId id = point ? point->observation : no_observation;
  if (point)
    emit read_out(tr("obs %1, marker %2, %3: %4, %5 %6")
                      .arg(QString::number(id), QString::number(point->marker), camera_names_.value(point->camera),
                           fixed_text(point->du, 2), fixed_text(point->dv, 2), unit_name(unit_)));
  else if (hovered_ >= 0)
    emit read_out({});
  if (id == hovered_ && pane_of_it == hovered_pane_) return;
  hovered_ = id;
  hovered_pane_ = pane_of_it;
  update();
  if (!is_apart_) emit observation_hovered(id);
}

void ResidualCloud::leaveEvent(QEvent*) {
  if (hovered_ < 0) return;
  hovered_ = no_observation;
  update();
  if (!is_apart_) emit observation_hovered(no_observation);
  emit read_out({});
}

void ResidualCloud::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F)
    fit();
  else if (event->key() == Qt::Key_L)
    set_linear(!is_linear_);
  else
    QWidget::keyPressEvent(event);
}

bool ResidualCloud::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  show_tip(this, *static_cast<QHelpEvent*>(event), rect(),
           tr("Each dot is the residual of one corner, to the right and down in %1; the rings are one and "
              "three sigma of the noise. F fits the axes, L makes them linear.")
               .arg(unit_name(unit_)));
  return true;
}

}  // namespace handsight::widgets
