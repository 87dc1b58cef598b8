// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/scatter_plot.h"

#include <qcustomplot.h>

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr double outer_margin = 0.06;  // of what is shown, above and below it

struct Line {
  QVector<double> x, y, low, high;
};

QString axis_label(const QString& quantity, const QString& unit) {
  return unit.isEmpty() ? quantity : QStringLiteral("%1 (%2)").arg(quantity, unit);
}

Line find_line(const std::vector<TrendPoint>& points) {
  Line line;
  for (const TrendPoint& point : points) {
    line.x += point.x;
    line.y += point.y;
    line.low += point.low;
    line.high += point.high;
  }
  return line;
}

}  // namespace

Span span_of_most(const std::vector<ScatterPoint>& points) {
  constexpr std::size_t few = 12;
  constexpr double far = 2;
  std::vector<double> y;
  for (const ScatterPoint& p : points) y.push_back(p.y);
  std::sort(y.begin(), y.end());
  Span span;
  if (y.empty()) return span;
  double low = y.front(), high = y.back();
  if (y.size() >= few) {
    const std::size_t twentieth = std::max<std::size_t>(y.size() / 20, 1);
    const double from = y[twentieth], to = y[y.size() - 1 - twentieth], wide = to - from;
    if (wide > 0) low = from - far * wide, high = to + far * wide;
  }
  for (const double value : y)
    if (value >= low && value <= high) span = {std::min(span.low, value), std::max(span.high, value)};
  return span;
}

struct ScatterPlot::Layers {
  QCPItemRect* noise = nullptr;
  QCPGraph *low = nullptr, *high = nullptr, *trend = nullptr, *candidate = nullptr;
  QCPGraph *candidate_low = nullptr, *candidate_high = nullptr, *bars = nullptr, *weak = nullptr;
  std::array<QCPGraph*, 6> points{};
  std::array<QCPGraph*, session_mark_count> of_session{}, weak_of_session{};
  QCPGraph *above = nullptr, *below = nullptr;  // points beyond the axis, at its ends
  QCPGraph *plain = nullptr, *highlighted = nullptr, *hovered = nullptr, *selected = nullptr;
};

ScatterPlot::ScatterPlot(QWidget* parent) : PlotWidget(parent), layers_(std::make_shared<Layers>()) {
  allow_brush();
  layers_->noise = new QCPItemRect(plot_);
  layers_->noise->setLayer(QStringLiteral("background"));
  layers_->noise->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
  layers_->noise->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
  layers_->low = plot_->addGraph();
  layers_->high = plot_->addGraph();
  layers_->high->setChannelFillGraph(layers_->low);
  const auto repeatability = [this] {
    QCPGraph* graph = plot_->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    return graph;
  };
  layers_->candidate_low = plot_->addGraph();
  layers_->candidate_high = plot_->addGraph();
  layers_->candidate_high->setChannelFillGraph(layers_->candidate_low);
  layers_->bars = plot_->addGraph();
  layers_->weak = repeatability();
  layers_->plain = repeatability();
  for (QCPGraph*& graph : layers_->points) graph = repeatability();
  for (auto* graphs : {&layers_->weak_of_session, &layers_->of_session})
    for (QCPGraph*& graph : *graphs) graph = repeatability();
  layers_->trend = plot_->addGraph();
  layers_->candidate = plot_->addGraph();
  layers_->above = repeatability();
  layers_->below = repeatability();
  layers_->highlighted = repeatability();
  layers_->hovered = repeatability();
  layers_->selected = repeatability();
  for (QCPGraph* ring : {layers_->highlighted, layers_->hovered, layers_->selected}) ring->setLayer(marks_layer);
  style_axes();
  ScatterPlot::restyle();
  connect(plot_, &QCustomPlot::afterLayout, this, &ScatterPlot::shorten_label);
  connect(plot_->yAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &ScatterPlot::mark_beyond);
}

void ScatterPlot::restyle() {
  const Colors& c = colors();
  const auto disc = [](const QColor& color) {
    return QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(color, 1), color, 5);
  };
  const auto ring_style = [](const QColor& color, double pen) {
    return QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(color, pen), Qt::NoBrush, 12);
  };
  for (std::size_t i = 0; i < 6; ++i) layers_->points[i]->setScatterStyle(disc(c.residual[i]));
  constexpr double mark = 8;  // px
  for (int i = 0; i < session_mark_count; ++i) {
    const QColor color = session_mark_color(i);
    const auto at = static_cast<std::size_t>(i);
    layers_->of_session[at]->setScatterStyle(
        QCPScatterStyle(session_mark_path(i), QPen(color, 0.5), QBrush(color), mark));
    layers_->weak_of_session[at]->setScatterStyle(
        QCPScatterStyle(session_mark_path(i), QPen(color, 1), QBrush(c.panel), mark));
  }
  layers_->plain->setScatterStyle(disc(c.ink3));
  layers_->weak->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(c.control_edge, 1), QBrush(c.panel), 5));
  layers_->bars->setPen(QPen(c.control_edge, 1));
  layers_->above->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle, QPen(c.bad, 1), c.bad, 8));
  layers_->below->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangleInverted, QPen(c.bad, 1), c.bad, 8));
  layers_->highlighted->setScatterStyle(ring_style(c.ink1, 1));
  layers_->hovered->setScatterStyle(ring_style(c.ink2, 1.5));
  layers_->selected->setScatterStyle(ring_style(c.accent, 2));
  QColor band = c.ink2;
  band.setAlpha(40);
  layers_->low->setPen(Qt::NoPen);
  layers_->high->setPen(Qt::NoPen);
  layers_->high->setBrush(band);
  layers_->trend->setPen(QPen(c.ink1, 2));
  layers_->candidate->setPen(QPen(c.candidate, 2, Qt::DashLine));
  layers_->candidate_low->setPen(Qt::NoPen);
  layers_->candidate_high->setPen(Qt::NoPen);
  layers_->candidate_high->setBrush(QBrush(c.hairline, Qt::BDiagPattern));
  layers_->noise->setPen(Qt::NoPen);
  layers_->noise->setBrush(QBrush(c.hairline, Qt::BDiagPattern));
  fill();
}

void ScatterPlot::set_axes(const QString& x_quantity, const QString& x_unit, const QString& y_quantity,
                           const QString& y_unit) {
  x_quantity_ = x_quantity, x_unit_ = x_unit, y_quantity_ = y_quantity, y_unit_ = y_unit;
  plot_->xAxis->setLabel(axis_label(x_quantity, x_unit));
  plot_->yAxis->setLabel(axis_label(y_quantity, y_unit));
  replot();
}

/// In a low plot the unit alone: the title says the rest.
void ScatterPlot::shorten_label() {
  const QString whole = axis_label(y_quantity_, y_unit_);
  const double length = QFontMetricsF(plot_->yAxis->labelFont()).horizontalAdvance(whole);
  plot_->yAxis->setLabel(length <= plot_->axisRect()->height() || y_unit_.isEmpty() ? whole : y_unit_);
}

void ScatterPlot::set_points(std::vector<ScatterPoint> points) {
  const bool was_empty = points_.empty();
  points_ = std::move(points);
  fill();
  if (was_empty) fit();
  replot();
}

void ScatterPlot::set_trend(std::vector<TrendPoint> trend) {
  trend_ = std::move(trend);
  fill();
  replot();
}

void ScatterPlot::set_candidate(std::vector<TrendPoint> prediction) {
  candidate_ = std::move(prediction);
  fill();
  replot();
}

void ScatterPlot::set_noise_band(std::optional<double> sigma, bool is_drawn) {
  noise_ = sigma;
  draws_noise_ = is_drawn;
  fill();
  replot();
}

void ScatterPlot::set_selected(ObservationId id) {
  selected_ = id;
  const auto found = std::find_if(points_.begin(), points_.end(), [&](const auto& p) { return p.observation == id; });
  setAccessibleDescription(found == points_.end() ? QString() : point_text(*found));
  ring();
  replot();
}

void ScatterPlot::set_hovered(ObservationId id) {
  if (id == hovered_) return;
  hovered_ = id;
  ring();
  replot();
}

void ScatterPlot::set_highlighted(std::vector<ObservationId> ids) {
  std::sort(ids.begin(), ids.end());
  highlighted_ = std::move(ids);
  ring();
  replot();
}

void ScatterPlot::set_brushing(bool brushing) { set_brush_always(brushing); }

void ScatterPlot::ring() {
  const auto show = [this](QCPGraph* graph, auto&& wanted) {
    QVector<double> x, y;
    for (const ScatterPoint& point : points_)
      if (wanted(point.observation)) x += point.x, y += point.y;
    graph->setData(x, y);
  };
  show(layers_->selected, [this](ObservationId id) { return id == selected_; });
  show(layers_->hovered, [this](ObservationId id) { return id == hovered_; });
  show(layers_->highlighted,
       [this](ObservationId id) { return std::binary_search(highlighted_.begin(), highlighted_.end(), id); });
}

/// Where there are so many that they would be a carpet, points alone say more.
void ScatterPlot::fill_bars() {
  constexpr std::size_t most = 300;
  std::vector<ScatterPoint> sorted = points_;
  std::erase_if(sorted, [](const ScatterPoint& p) { return !(p.bar > 0); });
  if (sorted.size() > most) sorted.clear();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ScatterPoint& a, const ScatterPoint& b) { return a.x < b.x; });
  QVector<double> x, y;
  for (const ScatterPoint& point : sorted) {
    x << point.x << point.x << point.x;
    y << point.y - point.bar << point.y + point.bar << qQNaN();  // what is no number parts the lines
  }
  layers_->bars->setData(x, y, true);
}

void ScatterPlot::fill_points() {
  struct Points {
    QVector<double> x, y;
    void add(const ScatterPoint& p) { x += p.x, y += p.y; }
  };
  std::array<Points, 6> steps;
  std::array<Points, session_mark_count> of_session, weak_of_session;
  Points plain, weak;
  for (const ScatterPoint& point : points_) {
    if (point.session >= 0)
      (point.is_weak ? weak_of_session : of_session)[static_cast<std::size_t>(point.session % session_mark_count)].add(
          point);
    else if (point.is_weak)
      weak.add(point);
    else if (!point.rms_over_sigma)
      plain.add(point);
    else
      steps[static_cast<std::size_t>(residual_step(*point.rms_over_sigma, point.coordinates))].add(point);
  }
  const auto show = [](QCPGraph* graph, const Points& points) { graph->setData(points.x, points.y); };
  for (std::size_t i = 0; i < steps.size(); ++i) show(layers_->points[i], steps[i]);
  for (std::size_t i = 0; i < of_session.size(); ++i) {
    show(layers_->of_session[i], of_session[i]);
    show(layers_->weak_of_session[i], weak_of_session[i]);
  }
  show(layers_->plain, plain);
  show(layers_->weak, weak);
}

void ScatterPlot::fill() {
  fill_points();
  fill_bars();
  mark_beyond();
  const Line trend = find_line(trend_), candidate = find_line(candidate_);
  layers_->trend->setData(trend.x, trend.y);
  layers_->low->setData(trend.x, trend.low);
  layers_->high->setData(trend.x, trend.high);
  layers_->candidate->setData(candidate.x, candidate.y);
  layers_->candidate_low->setData(candidate.x, candidate.low);
  layers_->candidate_high->setData(candidate.x, candidate.high);
  layers_->noise->setVisible(noise_ && draws_noise_);
  layers_->noise->topLeft->setCoords(0, noise_.value_or(0));
  layers_->noise->bottomRight->setCoords(1, -noise_.value_or(0));
  ring();
}

/// What lies beyond the axis is not forgotten: a red triangle at its end.
void ScatterPlot::mark_beyond() {
  const QCPRange shown = plot_->yAxis->range();
  const double edge = 0.03 * shown.size();
  QVector<double> above, below;
  for (const ScatterPoint& p : points_) {
    if (p.y > shown.upper) above += p.x;
    if (p.y < shown.lower) below += p.x;
  }
  layers_->above->setData(above, QVector<double>(above.size(), shown.upper - edge));
  layers_->below->setData(below, QVector<double>(below.size(), shown.lower + edge));
}

ScatterPlot::Extent ScatterPlot::extent() const {
  const double floor = noise_sigmas * noise_.value_or(0);  // noise alone never fills the plot
  Extent e{1e300, -1e300, -floor, floor};
  if (!noise_) e.low = 1e300, e.high = -1e300;
  for (const ScatterPoint& point : points_) {
    e.left = std::min(e.left, point.x);
    e.right = std::max(e.right, point.x);
  }
  const Span most = span_of_most(points_);
  e.low = std::min(e.low, most.low);
  e.high = std::max(e.high, most.high);
  for (const TrendPoint& point : candidate_) {
    if (!(point.low < point.high)) continue;    // what a band goes round is to be seen whole,
    e.low = std::min({e.low, point.low, 0.0});  // and so is the level line on which it comes to lie
    e.high = std::max({e.high, point.high, 0.0});
  }
  return e;
}

void ScatterPlot::fit() {
  if (points_.empty()) return replot();
  fitted_ = extent();
  const double wide = std::max((fitted_.right - fitted_.left) * 0.04, 1e-9),
               tall = std::max((fitted_.high - fitted_.low) * outer_margin, 1e-9);
  plot_->xAxis->setRange(fitted_.left - wide, fitted_.right + wide);
  plot_->yAxis->setRange(fitted_.low - tall, fitted_.high + tall);
  replot();
}

void ScatterPlot::fit_if_outgrown() {
  if (points_.empty()) return;
  constexpr double slack = 0.1;
  const Extent now = extent();
  const double wide = slack * (fitted_.right - fitted_.left), tall = slack * (fitted_.high - fitted_.low);
  const bool is_outgrown = now.left < fitted_.left - wide || now.right > fitted_.right + wide ||
                           now.low < fitted_.low - tall || now.high > fitted_.high + tall;
  const double floor = noise_sigmas * noise_.value_or(0);
  const double margin = outer_margin * (fitted_.high - fitted_.low);
  const bool is_filled_by_noise = fitted_.low - margin > -floor || fitted_.high + margin < floor;
  if (is_outgrown || is_filled_by_noise) fit();
}

const ScatterPoint* ScatterPlot::point_at(const QPointF& position) const {
  const ScatterPoint* best = nullptr;
  double nearest = 10;
  for (const ScatterPoint& point : points_) {
    const double dx = plot_->xAxis->coordToPixel(point.x) - position.x();
    const double dy = plot_->yAxis->coordToPixel(point.y) - position.y();
    if (std::hypot(dx, dy) >= nearest) continue;
    nearest = std::hypot(dx, dy);
    best = &point;
  }
  return best;
}

QString ScatterPlot::text_at(const QPointF& position) {
  const ScatterPoint* point = point_at(position);
  const ObservationId id = point ? point->observation : no_observation;
  if (id != hovered_) {
    set_hovered(id);
    emit observation_hovered(id);
  }
  if (!point) return {};
  return point_text(*point);
}

QString ScatterPlot::point_text(const ScatterPoint& point) const {
  return tr("obs %1: %2 %3 %4, %5 %6 %7")
      .arg(point.observation)
      .arg(x_quantity_, short_text(point.x, 3), x_unit_, y_quantity_, short_text(point.y, 3), y_unit_);
}

void ScatterPlot::clicked_at(const QPointF& position, Qt::KeyboardModifiers) {
  if (const ScatterPoint* point = point_at(position)) emit observation_selected(point->observation);
}

void ScatterPlot::brushed(const QRectF& in_plot) {
  std::vector<qint64> ids;
  for (const ScatterPoint& point : points_)
    if (in_plot.contains(point.x, point.y)) ids.push_back(point.observation);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (!ids.empty()) emit observations_selected(ids);
}

std::vector<PlotColumn> ScatterPlot::columns() const {
  std::vector<PlotColumn> all = {{QObject::tr("observation id"), {}},
                                 {QStringLiteral("%1 (%2)").arg(x_quantity_, x_unit_), {}},
                                 {QStringLiteral("%1 (%2)").arg(y_quantity_, y_unit_), {}}};
  for (const ScatterPoint& point : points_) {
    all[0].values.push_back(static_cast<double>(point.observation));
    all[1].values.push_back(point.x);
    all[2].values.push_back(point.y);
  }
  return all;
}

}  // namespace handsight::widgets
