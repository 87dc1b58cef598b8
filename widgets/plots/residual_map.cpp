// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/residual_map.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/residual_map_layers.h"

namespace handsight::widgets {

ResidualMap::ResidualMap(QWidget* parent) : PlotWidget(parent), layers_(std::make_shared<ResidualMapLayers>()) {
  allow_brush();
  const auto repeatability = [this] {
    QCPGraph* graph = plot_->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    return graph;
  };
  for (QCPGraph*& graph : layers_->discs) graph = repeatability();
  for (QCPGraph*& graph : layers_->directions) graph = repeatability();
  for (QCPCurve*& curve : layers_->arrows) curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
  layers_->means = new QCPCurve(plot_->xAxis, plot_->yAxis);
  layers_->hovered = repeatability();
  layers_->selected = repeatability();
  for (QCPGraph* ring : {layers_->hovered, layers_->selected}) ring->setLayer(marks_layer);
  layers_->frame = new QCPItemRect(plot_);
  layers_->frame->setBrush(Qt::NoBrush);
  for (int i = 0; i < column_count * row_count; ++i) {
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
  for (int i = 0; i < direction_count; ++i) {
    const QColor color = direction_color((i + 0.5) / direction_count * 2 * M_PI - M_PI);
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

void ResidualMap::set_unit(SizeUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  fill();
  replot();
}

void ResidualMap::set_camera_names(const QStringList& names) { camera_names_ = names; }

void ResidualMap::set_camera(std::optional<int> camera) {
  camera_ = camera;
  fill();
  replot();
}

void ResidualMap::set_lens(MapLens lens) {
  if (lens == lens_) return;
  lens_ = lens;
  fill();
  replot();
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
  const ObservationId id = point ? point->observation : no_observation;
  if (id != hovered_) {
    set_hovered(id);
    emit observation_hovered(id);
  }
  if (!point) return {};
  const QString text = QObject::tr("obs %1, marker %2, %3: %4 %6 right, %5 %6 down")
                           .arg(point->observation)
                           .arg(point->marker)
                           .arg(camera_names_.value(point->camera), fixed_text(point->residual.x(), 2),
                                fixed_text(point->residual.y(), 2), unit_name(unit_));
  return unit_ == SizeUnit::millimetre ? text + QObject::tr(", across the line of sight") : text;
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
  std::vector<PlotColumn> all = {{QObject::tr("observation id"), {}},
                                 {QObject::tr("marker"), {}},
                                 {QObject::tr("camera"), {}},
                                 {QStringLiteral("u (px)"), {}},
                                 {QStringLiteral("v (px)"), {}},
                                 {QObject::tr("residual u (%1)").arg(unit_name(unit_)), {}},
                                 {QObject::tr("residual v (%1)").arg(unit_name(unit_)), {}}};
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    const std::array<double, 7> values = {static_cast<double>(point.observation),
                                          static_cast<double>(point.marker),
                                          static_cast<double>(point.camera),
                                          point.position.x(),
                                          point.position.y(),
                                          point.residual.x(),
                                          point.residual.y()};
    for (std::size_t i = 0; i < values.size(); ++i) all[i].values.push_back(values[i]);
  }
  return all;
}

}  // namespace handsight::widgets
