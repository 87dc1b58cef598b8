// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/residual_map.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "widgets/number_text.h"
#include "widgets/theme.h"

namespace handsight::widgets {
namespace {

constexpr int kColumns = 6, kRows = 4, kDirections = 16;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A line with its head as pieces of one curve, parted by NaN.
struct Strokes {
  QVector<double> t, x, y;
  void add(double px, double py) {
    t += static_cast<double>(t.size());
    x += px;
    y += py;
  }
  void add_arrow(const Vector2& from, const Vector2& to, double head) {
    const Vector2 d = to - from;
    const double length = d.norm();
    add(from.x(), from.y());
    add(to.x(), to.y());
    if (length > 1e-9) {
      const Vector2 back = d / length * std::min(head, length / 2), side(-back.y() * 0.5, back.x() * 0.5);
      add(to.x() - back.x() + side.x(), to.y() - back.y() + side.y());
      add(to.x(), to.y());
      add(to.x() - back.x() - side.x(), to.y() - back.y() - side.y());
    }
    add(kNaN, kNaN);
  }
};

}  // namespace

struct ResidualMap::Layers {
  std::array<QCPGraph*, 6> discs{};
  std::array<QCPCurve*, 6> arrows{};
  std::array<QCPGraph*, kDirections> directions{};
  QCPCurve* means = nullptr;
  QCPGraph *selected = nullptr, *hovered = nullptr;
  QCPItemRect* frame = nullptr;
  std::vector<QCPItemText*> counts;
  QCPItemLine* bar = nullptr;
  QCPItemText* bar_text = nullptr;
};

ResidualMap::ResidualMap(QWidget* parent) : PlotWidget(parent), layers_(std::make_shared<Layers>()) {
  allow_brush();
  const auto scatter = [this] {
    QCPGraph* graph = plot_->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    return graph;
  };
  for (QCPGraph*& graph : layers_->discs) graph = scatter();
  for (QCPGraph*& graph : layers_->directions) graph = scatter();
  for (QCPCurve*& curve : layers_->arrows) curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
  layers_->means = new QCPCurve(plot_->xAxis, plot_->yAxis);
  layers_->hovered = scatter();
  layers_->selected = scatter();
  for (QCPGraph* ring : {layers_->hovered, layers_->selected}) ring->setLayer(marks_layer);
  layers_->frame = new QCPItemRect(plot_);
  layers_->frame->setBrush(Qt::NoBrush);
  for (int i = 0; i < kColumns * kRows; ++i) {
    auto* text = new QCPItemText(plot_);
    text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    text->setPadding(QMargins(2, 1, 2, 1));
    layers_->counts.push_back(text);
  }
  layers_->bar = new QCPItemLine(plot_);
  layers_->bar_text = new QCPItemText(plot_);
  layers_->bar_text->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
  layers_->bar_text->setPadding(QMargins(4, 1, 4, 2));
  plot_->yAxis->setRangeReversed(true);
  style_axes();
  ResidualMap::restyle();
}

void ResidualMap::restyle() {
  const Colors& c = colors();
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = 4 + 2.0 * static_cast<double>(i);
    layers_->discs[i]->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(c.residual[i], 1), c.residual[i], size));
    layers_->arrows[i]->setPen(QPen(c.residual[i], 1.3));
  }
  for (int i = 0; i < kDirections; ++i) {
    const QColor color = direction_color((i + 0.5) / kDirections * 2 * M_PI - M_PI);
    layers_->directions[static_cast<std::size_t>(i)]->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(c.control_edge, 0.7), color, 9));
  }
  layers_->means->setPen(QPen(c.ink1, 2));
  layers_->selected->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(c.accent, 2), Qt::NoBrush, 14));
  layers_->hovered->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(c.ink2, 1.5), Qt::NoBrush, 14));
  layers_->frame->setPen(QPen(c.control_edge, 1));
  layers_->bar->setPen(QPen(c.ink1, 2));
  for (QCPItemText* text : layers_->counts) {
    text->setColor(c.ink3);
    text->setFont(number_font(TextRole::small));
    QColor plate = c.panel;
    plate.setAlpha(200);
    text->setBrush(plate);
  }
  layers_->bar_text->setColor(c.ink1);
  layers_->bar_text->setFont(text_font(TextRole::small));
  layers_->bar_text->setBrush(c.panel);
  plot_->xAxis->setLabel(QStringLiteral("u (px)"));
  plot_->yAxis->setLabel(QStringLiteral("v (px)"));
  fill();
}

void ResidualMap::set_image_size(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  fill();
  fit();
}

void ResidualMap::set_points(std::vector<MapPoint> points) {
  const bool was_empty = points_.empty();
  points_ = std::move(points);
  fill();
  if (was_empty) fit();
  replot();
}

void ResidualMap::set_side(std::optional<ImageSide> side) {
  side_ = side;
  fill();
  replot();
}

void ResidualMap::set_lens(MapLens lens) {
  if (lens == lens_) return;
  lens_ = lens;
  fill();
  replot();
  emit lens_changed(lens);
}

void ResidualMap::set_regions(bool shown) {
  has_regions_ = shown;
  fill();
  replot();
}

void ResidualMap::set_selected(ObservationId id) {
  selected_ = id;
  ring();
  replot_marks();
}

void ResidualMap::set_hovered(ObservationId id) {
  if (id == hovered_) return;
  hovered_ = id;
  ring();
  replot_marks();
}

double ResidualMap::exaggeration() const {
  std::vector<double> lengths;
  for (const MapPoint& point : points_)
    if (is_shown(point)) lengths.push_back(point.residual.norm());
  if (lengths.empty()) return 1;
  const auto high = lengths.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(lengths.size() - 1));
  std::nth_element(lengths.begin(), high, lengths.end());
  const double wanted = width_ / 12.0 / std::max(*high, 1e-6);
  double best = 1;
  for (double power = 1; power < 1e6; power *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * power <= wanted) best = step * power;
  return best;
}

void ResidualMap::fill_arrows() {
  std::array<Strokes, 6> strokes;
  const double times = exaggeration(), head = width_ / 80.0;
  if (lens_ == MapLens::arrows) {
    for (const MapPoint& point : points_) {
      if (!is_shown(point)) continue;
      const auto step = static_cast<std::size_t>(point.rms_over_sigma ? residual_step(*point.rms_over_sigma, 2) : 1);
      strokes[step].add_arrow(point.position, point.position + times * point.residual, head);
    }
  }
  for (std::size_t i = 0; i < 6; ++i) layers_->arrows[i]->setData(strokes[i].t, strokes[i].x, strokes[i].y, true);
}

void ResidualMap::fill_regions() {
  std::array<Vector2, kColumns * kRows> sums;
  sums.fill(Vector2(0, 0));
  std::array<int, kColumns * kRows> counts{};
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    const int column = std::clamp(static_cast<int>(point.position.x() / width_ * kColumns), 0, kColumns - 1);
    const int row = std::clamp(static_cast<int>(point.position.y() / height_ * kRows), 0, kRows - 1);
    const auto i = static_cast<std::size_t>(row * kColumns + column);
    sums[i] += point.residual;
    ++counts[i];
  }
  Strokes means;
  const double times = exaggeration();
  for (int i = 0; i < kColumns * kRows; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vector2 corner((i % kColumns) * width_ / double(kColumns), (i / kColumns) * height_ / double(kRows));
    const Vector2 middle = corner + Vector2(width_ / double(2 * kColumns), height_ / double(2 * kRows));
    layers_->counts[k]->position->setCoords(corner.x(), corner.y());
    layers_->counts[k]->setText(QString::number(counts[k]));
    layers_->counts[k]->setVisible(has_regions_ && !points_.empty());
    if (has_regions_ && counts[k] >= 3) means.add_arrow(middle, middle + times * sums[k] / counts[k], width_ / 50.0);
  }
  layers_->means->setData(means.t, means.x, means.y, true);
}

void ResidualMap::ring() {
  QVector<double> x, y, hovered_x, hovered_y;
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    if (point.observation == selected_) x += point.position.x(), y += point.position.y();
    if (point.observation == hovered_) hovered_x += point.position.x(), hovered_y += point.position.y();
  }
  layers_->selected->setData(x, y);
  layers_->hovered->setData(hovered_x, hovered_y);
}

void ResidualMap::fill() {
  std::array<QVector<double>, 6> x, y;
  std::array<QVector<double>, kDirections> direction_x, direction_y;
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    if (lens_ == MapLens::size) {
      const auto step = static_cast<std::size_t>(point.rms_over_sigma ? residual_step(*point.rms_over_sigma, 2) : 1);
      x[step] += point.position.x();
      y[step] += point.position.y();
    } else if (lens_ == MapLens::direction) {
      const double angle = std::atan2(point.residual.y(), point.residual.x());
      const int sector = static_cast<int>((angle + M_PI) / (2 * M_PI) * kDirections) % kDirections;
      direction_x[static_cast<std::size_t>(sector)] += point.position.x();
      direction_y[static_cast<std::size_t>(sector)] += point.position.y();
    }
  }
  // Smooth edges of so many marks are not seen, and take most of the time.
  const bool is_dense = points_.size() > 3000;
  for (std::size_t i = 0; i < 6; ++i) {
    layers_->discs[i]->setData(x[i], y[i]);
    layers_->discs[i]->setAntialiasedScatters(!is_dense);
    layers_->arrows[i]->setAntialiased(!is_dense);
  }
  for (std::size_t i = 0; i < kDirections; ++i) layers_->directions[i]->setData(direction_x[i], direction_y[i]);
  layers_->frame->topLeft->setCoords(-0.5, -0.5);
  layers_->frame->bottomRight->setCoords(width_ - 0.5, height_ - 0.5);
  fill_arrows();
  fill_regions();
  ring();
  // The scale bar: a round number of px of residual, near a tenth of the width.
  const double times = exaggeration();
  double shown = 1;
  for (double power = 0.001; power < 1000; power *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * power * times <= width_ / 8.0) shown = step * power;
  const double right = width_ * 0.98, bottom = height_ * 0.975;
  const bool has_bar = lens_ == MapLens::arrows && !points_.empty();
  layers_->bar->setVisible(has_bar);
  layers_->bar_text->setVisible(has_bar);
  layers_->bar->start->setCoords(right - shown * times, bottom);
  layers_->bar->end->setCoords(right, bottom);
  layers_->bar_text->position->setCoords(right, bottom - 2);
  layers_->bar_text->setText(QStringLiteral("%1 px, drawn %2 ×").arg(short_text(shown, 1), short_text(times, 1)));
}

void ResidualMap::fit() {
  const QSize room = plot_->axisRect()->size();
  double width = width_ * 1.04, height = height_ * 1.04;
  if (room.width() > 20 && room.height() > 20) {
    const double scale = std::max(width / room.width(), height / room.height());
    width = scale * room.width();
    height = scale * room.height();
  }
  plot_->xAxis->setRange(width_ / 2.0 - width / 2, width_ / 2.0 + width / 2);
  plot_->yAxis->setRange(height_ / 2.0 - height / 2, height_ / 2.0 + height / 2);
  replot();
}

void ResidualMap::resizeEvent(QResizeEvent* event) {
  PlotWidget::resizeEvent(event);
  // The size of the axes is only known once the plot has laid them out.
  QMetaObject::invokeMethod(
      this, [this] { fit(); }, Qt::QueuedConnection);
}

const MapPoint* ResidualMap::point_at(const QPointF& position) const {
  const MapPoint* best = nullptr;
  double nearest = 12;
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    const double dx = plot_->xAxis->coordToPixel(point.position.x()) - position.x();
    const double dy = plot_->yAxis->coordToPixel(point.position.y()) - position.y();
    if (std::hypot(dx, dy) >= nearest) continue;
    nearest = std::hypot(dx, dy);
    best = &point;
  }
  return best;
}

QString ResidualMap::text_at(const QPointF& position) {
  const MapPoint* point = point_at(position);
  const ObservationId id = point ? point->observation : kNoObservation;
  if (id != hovered_) {
    set_hovered(id);
    emit observation_hovered(id);
  }
  if (!point) return {};
  return QStringLiteral("obs %1, marker %2, %3: %4 px right, %5 px down")
      .arg(point->observation)
      .arg(point->marker)
      .arg(point->side == ImageSide::left ? QStringLiteral("left") : QStringLiteral("right"),
           fixed_text(point->residual.x(), 2), fixed_text(point->residual.y(), 2));
}

void ResidualMap::clicked_at(const QPointF& position, Qt::KeyboardModifiers) {
  if (const MapPoint* point = point_at(position)) emit observation_selected(point->observation);
}

void ResidualMap::brushed(const QRectF& in_plot) {
  std::set<qint64> ids;
  for (const MapPoint& point : points_)
    if (is_shown(point) && in_plot.contains(point.position.x(), point.position.y())) ids.insert(point.observation);
  if (!ids.empty()) emit observations_selected(std::vector<qint64>(ids.begin(), ids.end()));
}

std::vector<PlotColumn> ResidualMap::columns() const {
  std::vector<PlotColumn> all = {{QStringLiteral("observation id"), {}}, {QStringLiteral("marker"), {}},
                                 {QStringLiteral("right image"), {}},    {QStringLiteral("u (px)"), {}},
                                 {QStringLiteral("v (px)"), {}},         {QStringLiteral("residual u (px)"), {}},
                                 {QStringLiteral("residual v (px)"), {}}};
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    const std::array<double, 7> values = {static_cast<double>(point.observation),
                                          static_cast<double>(point.marker),
                                          point.side == ImageSide::right ? 1.0 : 0.0,
                                          point.position.x(),
                                          point.position.y(),
                                          point.residual.x(),
                                          point.residual.y()};
    for (std::size_t i = 0; i < values.size(); ++i) all[i].values.push_back(values[i]);
  }
  return all;
}

}  // namespace handsight::widgets
