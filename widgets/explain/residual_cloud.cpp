// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/residual_cloud.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/number_text.h"
#include "widgets/paint_tools.h"
#include "widgets/theme.h"

namespace handsight::widgets {
namespace {

constexpr int kMilliseconds = 160, kBlink = 450;
constexpr double kReachPixels = 8;

double size_of(const CloudPoint& point) { return std::hypot(point.du, point.dv); }

double largest(const std::vector<CloudPoint>& points) {
  double most = 0;
  for (const CloudPoint& point : points)
    if (std::isfinite(point.du) && std::isfinite(point.dv)) most = std::max(most, size_of(point));
  return most;
}

}  // namespace

ResidualCloud::ResidualCloud(QWidget* parent) : QWidget(parent), empty_text_(tr("No residuals yet.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Residuals of all corners, before and after"));
  animation_.setDuration(kMilliseconds);
  animation_.setStartValue(0.0);
  animation_.setEndValue(1.0);
  animation_.setEasingCurve(QEasingCurve::InOutQuad);
  connect(&animation_, &QVariantAnimation::valueChanged, this,
          [this](const QVariant& value) { move(value.toDouble()); });
  connect(&animation_, &QVariantAnimation::finished, this, [this] {
    moving_.clear();
    update();
  });
  blink_.setInterval(kBlink);
  connect(&blink_, &QTimer::timeout, this, [this] {
    is_swapped_ = !is_swapped_;
    update();
  });
}

void ResidualCloud::set_noise(std::optional<double> sigma_px) {
  noise_ = sigma_px && *sigma_px > 0 ? sigma_px : std::nullopt;
  update();
}

void ResidualCloud::set_before(std::vector<CloudPoint> points, const QString& title) {
  before_ = {std::move(points), title};
  if (reach_ <= 0) fit();
  update();
}

void ResidualCloud::set_after(std::vector<CloudPoint> points, const QString& title) {
  animation_.stop();
  moving_from_ = !moving_.empty() ? moving_ : after_.points.empty() ? before_.points : after_.points;
  moving_.clear();
  after_ = {std::move(points), title};
  if (reach_ <= 0) fit();
  const bool can_move = moving_from_.size() == after_.points.size() && !after_.points.empty();
  if (can_move && !reduced_motion_ && isVisible()) {
    moving_ = moving_from_;
    animation_.start();
  }
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

double ResidualCloud::radius(double px) const {
  if (!(reach_ > 0)) return 0;
  const double bend = 3 * noise_.value_or(reach_ / 10);
  if (is_linear_ || bend * 5 > reach_) return std::min(px / reach_, 1.0);
  return std::min(std::asinh(px / bend) / std::asinh(reach_ / bend), 1.0);
}

QRectF ResidualCloud::pane(int index) const {
  const double side = std::floor(std::min((width() - 3.0 * kGap) / 2, height() - 20.0 - 20));
  const double left = (width() - 2 * side - kGap) / 2;
  return {std::floor(left + index * (side + kGap)), 20.0, side, side};
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

void ResidualCloud::paint_ground(QPainter& painter, int index) const {
  const Colors& c = colors();
  const QRectF area = pane(index);
  const QPointF middle = area.center();
  const double half = area.width() / 2;
  painter.setBrush(c.sunken);
  painter.setPen(QPen(c.hairline, 1));
  painter.drawEllipse(middle, half - 0.5, half - 0.5);
  painter.setBrush(Qt::NoBrush);
  if (shown(index).empty()) return;
  painter.drawLine(QPointF(area.left(), middle.y()), QPointF(area.right(), middle.y()));
  painter.drawLine(QPointF(middle.x(), area.top()), QPointF(middle.x(), area.bottom()));
  for (double px = std::pow(10.0, std::ceil(std::log10(std::max(reach_ / 100, 1e-9)))); px < reach_; px *= 10)
    painter.drawEllipse(middle, half * radius(px), half * radius(px));
}

void ResidualCloud::paint_ring_names(QPainter& painter, const QRectF& area) const {
  const Colors& c = colors();
  const double half = area.width() / 2;
  painter.setFont(number_font(TextRole::small));
  painter.setBrush(Qt::NoBrush);
  for (const double sigmas : {1.0, 3.0}) {
    if (!noise_) break;
    const double r = half * radius(sigmas * *noise_);
    painter.setPen(QPen(c.ink2, 1, Qt::DashLine));
    painter.drawEllipse(area.center(), r, r);
    if (r < 16) continue;  // no room for its name
    painter.setPen(c.ink2);
    painter.drawText(QRectF(area.center().x() - 20, area.center().y() - r - 15, 40, 15), Qt::AlignCenter,
                     QStringLiteral("%1 σ").arg(sigmas));
  }
  painter.setPen(c.ink3);
  for (double px = std::pow(10.0, std::ceil(std::log10(std::max(reach_ / 100, 1e-9)))); px < reach_; px *= 10) {
    const double r = half * radius(px);
    if (px > 0.7 * reach_ || (noise_ && px < 4 * *noise_) || r < 16) continue;
    painter.drawText(QRectF(area.center().x() + r * 0.7071 - 2, area.center().y() + r * 0.7071 - 4, 44, 15),
                     Qt::AlignLeft | Qt::AlignVCenter, with_unit_text(px, QStringLiteral("px"), 1));
  }
}

void ResidualCloud::paint_points(QImage& image, int index) const {
  const double ratio = image.devicePixelRatio();
  const std::vector<CloudPoint>& points = shown(index);
  const std::vector<DotStamp> stamps = residual_stamps((points.size() > 3000 ? 2.2 : 3) * ratio, 200);
  const DotStamp plain(colors().ink3, 3 * ratio);
  for (const CloudPoint& point : points) {
    const QPointF at = on_screen(index, point.du, point.dv) * ratio;
    if (!noise_) {
      plain.put(image, at.x(), at.y());
      continue;
    }
    const int step = residual_step(size_of(point) / std::sqrt(2.0) / *noise_, 2);
    stamps[static_cast<std::size_t>(step)].put(image, at.x(), at.y());
  }
}

void ResidualCloud::paint_marked(QPainter& painter, int index) const {
  if (selected_ < 0 && hovered_ < 0 && highlighted_.empty()) return;
  const Colors& c = colors();
  painter.setBrush(Qt::NoBrush);
  for (const CloudPoint& point : shown(index)) {
    const bool is_selected = point.observation == selected_, is_hovered = point.observation == hovered_;
    const bool is_high = std::binary_search(highlighted_.begin(), highlighted_.end(), point.observation);
    if (!is_selected && !is_hovered && !is_high) continue;
    painter.setPen(is_selected ? QPen(c.accent, 1.5) : QPen(is_hovered ? c.ink2 : c.ink1, is_hovered ? 1.5 : 1));
    const double r = is_selected || is_hovered ? 4.5 : 3;
    painter.drawEllipse(on_screen(index, point.du, point.dv), r, r);
  }
}

void ResidualCloud::paint_pane(QPainter& painter, int index) const {
  const Colors& c = colors();
  const QRectF area = pane(index);
  const bool is_after = (index == 1) != is_swapped_;
  const QString title = is_after ? (after_.title.isEmpty() ? tr("after") : after_.title)
                                 : (before_.title.isEmpty() ? tr("before") : before_.title);
  const bool is_tried = is_after && is_predicted_;
  painter.setFont(text_font(TextRole::small));
  painter.setPen(is_tried ? c.candidate : c.ink2);
  draw_text(painter, QRectF(area.left(), 0, area.width(), 18), Qt::AlignHCenter | Qt::AlignVCenter, title);
  if (shown(index).empty()) {
    painter.setPen(c.ink2);
    painter.drawText(area.adjusted(kWideGap, 0, -kWideGap, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     is_after ? tr("Try a card, or add it.") : empty_text_);
    return;
  }
  paint_ring_names(painter, area);
  paint_marked(painter, index);
  if (!is_tried) return;
  QPen pen(c.candidate, 2);
  pen.setDashPattern({4, 3});
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawEllipse(area.adjusted(1, 1, -1, -1));
}

void ResidualCloud::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  if (before_.points.empty() && after_.points.empty() && moving_.empty()) {
    draw_sentence(painter, rect(), empty_text_);
    return;
  }
  for (int i = 0; i < 2; ++i) paint_ground(painter, i);
  QImage dots = dot_canvas(size(), devicePixelRatioF());
  for (int i = 0; i < 2; ++i) paint_points(dots, i);
  painter.drawImage(0, 0, dots);
  for (int i = 0; i < 2; ++i) paint_pane(painter, i);
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink3);
  const bool is_bent = noise_ && !is_linear_ && 15 * *noise_ <= reach_;
  const QString rim = tr("rim %1").arg(with_unit_text(reach_, QStringLiteral("px")));
  draw_text(painter, QRectF(kGap, height() - 18.0, width() - 2.0 * kGap, 16), Qt::AlignCenter,
            is_bent ? rim + tr(", compressed beyond 3 σ") : rim);
  if (hasFocus()) draw_focus(painter, rect());
}

const CloudPoint* ResidualCloud::point_at(const QPointF& position) const {
  const CloudPoint* best = nullptr;
  double nearest = kReachPixels;
  for (int i = 0; i < 2; ++i) {
    if (!pane(i).adjusted(-4, -4, 4, 4).contains(position)) continue;
    for (const CloudPoint& point : shown(i)) {
      const QPointF away = on_screen(i, point.du, point.dv) - position;
      const double distance = std::hypot(away.x(), away.y());
      if (distance < nearest) nearest = distance, best = &point;
    }
  }
  return best;
}

void ResidualCloud::mousePressEvent(QMouseEvent* event) {
  const CloudPoint* point = point_at(event->position());
  if (event->button() == Qt::LeftButton && point) emit observation_selected(point->observation);
}

void ResidualCloud::mouseMoveEvent(QMouseEvent* event) {
  const CloudPoint* point = point_at(event->position());
  const ObservationId id = point ? point->observation : kNoObservation;
  if (point)
    emit read_out(tr("obs %1, marker %2, %3: %4, %5 px")
                      .arg(QString::number(id), QString::number(point->marker),
                           point->side == ImageSide::left ? tr("left") : tr("right"), fixed_text(point->du, 2),
                           fixed_text(point->dv, 2)));
  else if (hovered_ >= 0)
    emit read_out({});
  if (id == hovered_) return;
  hovered_ = id;
  update();
  emit observation_hovered(id);
}

void ResidualCloud::leaveEvent(QEvent*) {
  if (hovered_ < 0) return;
  hovered_ = kNoObservation;
  update();
  emit observation_hovered(kNoObservation);
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
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     tr("Each dot is the residual of one corner, to the right and down in px; the rings are one and "
                        "three sigma of the noise. F fits the axes, L makes them linear."),
                     this);
  return true;
}

}  // namespace handsight::widgets
