// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/pattern_page.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr int column_count = 3, reach_px = 8;
constexpr double gap_between = 4;

}  // namespace

QString PatternPage::with_unit(const QString& quantity, const QString& unit) {
  return unit.isEmpty() ? quantity : QStringLiteral("%1 (%2)").arg(quantity, unit);
}

PatternPage::PatternPage(QWidget* parent)
    : QWidget(parent), empty_text_(tr("Nine views of the residual appear here once there is a fit.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Nine patterns of the residual"));
}

QSize PatternPage::sizeHint() const { return {592, (has_numbers_ ? 110 : 84) * rows_}; }
QSize PatternPage::minimumSizeHint() const {
  return {480, rows_ * (has_numbers_ ? 100 : 80) + (rows_ - 1) * static_cast<int>(gap_between)};
}

void PatternPage::show_numbers() {
  has_numbers_ = true;
  updateGeometry();
  update();
}

void PatternPage::set_rows(int rows) {
  if (rows == rows_) return;
  rows_ = rows;
  for (int* place : {&selected_plot_, &hovered_plot_, &brushing_})
    if (*place >= count()) *place = -1;
  updateGeometry();
  update();
}

PatternPage::Range PatternPage::find_range(const PatternPlot& plot) {
  Range r{1e300, -1e300, 1e300, -1e300};
  for (const ScatterPoint& point : plot.points) {
    r.left = std::min(r.left, point.x);
    r.right = std::max(r.right, point.x);
  }
  const Span most = span_of_most(plot.points);
  r.low = most.low;
  r.high = most.high;
  if (plot.points.empty()) r = {0, 1, -1, 1};
  const double floor = noise_sigmas * plot.noise.value_or(0);  // noise alone never fills the plot
  r.low = std::min(r.low, -floor);
  r.high = std::max(r.high, floor);
  const double wide = std::max((r.right - r.left) * 0.03, 1e-12), tall = std::max((r.high - r.low) * 0.08, 1e-12);
  return {r.left - wide, r.right + wide, r.low - tall, r.high + tall};
}

/// The axes stay while one looks, but for what they can no longer hold.
bool PatternPage::outgrows(const Range& wanted, const Range& present) {
  constexpr double slack = 0.1;
  const double wide = slack * (present.right - present.left), tall = slack * (present.high - present.low);
  return wanted.left < present.left - wide || wanted.right > present.right + wide || wanted.low < present.low - tall ||
         wanted.high > present.high + tall;
}

bool PatternPage::is_filled_by_noise(const PatternPlot& plot, const Range& present) {
  const double floor = noise_sigmas * plot.noise.value_or(0);
  return present.low > -floor || present.high < floor;
}

void PatternPage::set_plots(std::vector<PatternPlot> plots) {
  plots_ = std::move(plots);
  if (plots_.size() > plot_count) plots_.resize(plot_count);
  if (selected_plot_ >= count()) selected_plot_ = -1;
  hovered_plot_ = brushing_ = -1;
  fit();
}

void PatternPage::update_plots(std::vector<PatternPlot> plots) {
  if (plots.size() > plot_count) plots.resize(plot_count);
  for (std::size_t i = 0; i < plots.size(); ++i)
    if (i >= plots_.size() || plots_[i].id != plots[i].id || outgrows(find_range(plots[i]), ranges_[i]) ||
        is_filled_by_noise(plots[i], ranges_[i]))
      ranges_[i] = find_range(plots[i]);
  plots_ = std::move(plots);
  for (int* place : {&selected_plot_, &hovered_plot_, &brushing_})
    if (*place >= count()) *place = -1;
  update();
}

void PatternPage::set_candidates(const std::vector<std::vector<TrendPoint>>& predictions) {
  for (std::size_t i = 0; i < plots_.size(); ++i)
    plots_[i].candidate = i < predictions.size() ? predictions[i] : std::vector<TrendPoint>();
  update();
}

void PatternPage::set_selected_plot(int place) {
  selected_plot_ = place < count() ? place : -1;
  update();
}

void PatternPage::set_selected(ObservationId id) {
  selected_ = id;
  update();
}

void PatternPage::set_hovered(ObservationId id) {
  if (id == hovered_) return;
  hovered_ = id;
  update();
}

void PatternPage::set_highlighted(std::vector<ObservationId> ids) {
  std::sort(ids.begin(), ids.end());
  highlighted_ = std::move(ids);
  update();
}

void PatternPage::set_progress(const QString& text) {
  progress_ = text;
  update();
}

void PatternPage::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

void PatternPage::fit() {
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    Range& r = ranges_[i];
    r = find_range(plots_[i]);
    if (!companion_) continue;
    for (const PatternPlot& other : companion_->plots_) {
      if (other.id != plots_[i].id) continue;
      const Range also = find_range(other);
      r = {std::min(r.left, also.left), std::max(r.right, also.right), std::min(r.low, also.low),
           std::max(r.high, also.high)};
    }
  }
  update();
}

QRectF PatternPage::plot_rect(int place) const {
  const double wide = (width() - 2 * gap_between) / column_count, tall = (height() - (rows_ - 1) * gap_between) / rows_;
  const int column = place % column_count, row = place / column_count;
  return {std::round(column * (wide + gap_between)), std::round(row * (tall + gap_between)), std::floor(wide),
          std::floor(tall)};
}

QRectF PatternPage::canvas(int place) const {
  return has_numbers_ ? plot_rect(place).adjusted(44, 22, -6, -46) : plot_rect(place).adjusted(6, 18, -6, -30);
}

QPointF PatternPage::on_screen(int place, double x, double y) const {
  const Range& r = ranges_[static_cast<std::size_t>(place)];
  const QRectF area = canvas(place);
  return {area.left() + area.width() * (x - r.left) / (r.right - r.left),
          area.bottom() - area.height() * (y - r.low) / (r.high - r.low)};
}

int PatternPage::place_at(const QPointF& position) const {
  for (int i = 0; i < count(); ++i)
    if (plot_rect(i).contains(position)) return i;
  return -1;
}

const ScatterPoint* PatternPage::point_at(int place, const QPointF& position) const {
  const ScatterPoint* best = nullptr;
  double nearest = reach_px;
  for (const ScatterPoint& point : plots_[static_cast<std::size_t>(place)].points) {
    const QPointF away = on_screen(place, point.x, point.y) - position;
    const double distance = std::hypot(away.x(), away.y());
    if (distance < nearest) nearest = distance, best = &point;
  }
  return best;
}

QString PatternPage::make_text(int place, const ScatterPoint* point) const {
  const PatternPlot& plot = plots_[static_cast<std::size_t>(place)];
  if (point)
    return tr("obs %1: %2 %3, %4 %5")
        .arg(QString::number(point->observation), plot.against, with_unit_text(point->x, plot.x_unit, 3), plot.what,
             with_unit_text(point->y, plot.y_unit, 3));
  QString text = tr("%1 against %2").arg(with_unit(plot.what, plot.y_unit), with_unit(plot.against, plot.x_unit));
  text += plot.is_chance ? tr("; no more than chance") : tr("; explains %1 %").arg(std::lround(100 * plot.strength));
  if (!plot.shows.isEmpty()) text += tr("; shows: %1").arg(plot.shows);
  return text;
}

void PatternPage::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const int place = place_at(event->position());
  if (place < 0) return;
  if (event->modifiers() & Qt::ShiftModifier) {
    brushing_ = place;
    brush_from_ = brush_to_ = event->position();
    return;
  }
  const ScatterPoint* point = point_at(place, event->position());
  const qint64 id = point ? point->observation : no_observation;
  const bool is_same = place == selected_plot_;
  set_selected_plot(place);
  if (!is_same) emit plot_selected(place);
  if (is_same && id >= 0) emit observation_selected(id);  // the first click takes the plot, the next a point in it
}

void PatternPage::mouseMoveEvent(QMouseEvent* event) {
  if (brushing_ >= 0) {
    brush_to_ = event->position();
    update();
    return;
  }
  const int place = place_at(event->position());
  const ScatterPoint* point = place < 0 ? nullptr : point_at(place, event->position());
  const ObservationId id = point ? point->observation : no_observation;
  if (place == hovered_plot_ && id == hovered_) return;
  const bool has_changed = id != hovered_;
  hovered_plot_ = place;
  hovered_ = id;
  update();
  if (has_changed) emit observation_hovered(id);
  emit read_out(place < 0 ? QString() : make_text(place, point));
}

void PatternPage::mouseReleaseEvent(QMouseEvent* event) {
  if (brushing_ < 0) return;
  const QRectF drawn = QRectF(brush_from_, event->position()).normalized();
  std::vector<qint64> ids;
  for (const ScatterPoint& point : plots_[static_cast<std::size_t>(brushing_)].points)
    if (drawn.contains(on_screen(brushing_, point.x, point.y))) ids.push_back(point.observation);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  brushing_ = -1;
  update();
  emit observations_selected(ids);
}

void PatternPage::leaveEvent(QEvent*) {
  const bool had_point = hovered_ >= 0;
  hovered_plot_ = -1;
  hovered_ = no_observation;
  update();
  if (had_point) emit observation_hovered(no_observation);
  emit read_out({});
}

void PatternPage::keyPressEvent(QKeyEvent* event) {
  int step = 0;
  if (event->key() == Qt::Key_Left) step = -1;
  if (event->key() == Qt::Key_Right) step = 1;
  if (event->key() == Qt::Key_Up) step = -column_count;
  if (event->key() == Qt::Key_Down) step = column_count;
  if (step == 0 || count() == 0) return QWidget::keyPressEvent(event);
  const int to = selected_plot_ < 0 ? 0 : selected_plot_ + step;
  if (to < 0 || to >= count() || to == selected_plot_) return;
  set_selected_plot(to);
  emit plot_selected(to);
  emit read_out(make_text(to, nullptr));
}

bool PatternPage::event(QEvent* event) {
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int place = place_at(help->pos());
  show_tip(this, *help, place < 0 ? rect() : plot_rect(place).toAlignedRect(),
           place < 0 ? QString() : make_text(place, nullptr));
  return true;
}

}  // namespace handsight::widgets
