// SPDX-License-Identifier: GPL-3.0-or-later
#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/residual_map.h"
#include "widgets/plots/residual_map_layers.h"

namespace handsight::widgets {
namespace {

constexpr double na_n = std::numeric_limits<double>::quiet_NaN();

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
    add(na_n, na_n);
  }
};

/// The value that this share of them does not exceed; 0 of none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double ResidualMap::exaggeration() const {
  std::vector<double> lengths, sigmas;
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    lengths.push_back(point.residual.norm());
    if (point.rms_over_sigma.value_or(0) > 0) sigmas.push_back(lengths.back() / std::sqrt(2.0) / *point.rms_over_sigma);
  }
  if (lengths.empty()) return 1;
  const double shown = std::max(quantile(lengths, 0.95), 3 * quantile(sigmas, 0.5));
  const double wanted = width_ / 12.0 / std::max(shown, 1e-6);
  double best = 1;
  for (int power = 0; power < 6; ++power)
    for (const double step : {1.0, 2.0, 5.0})
      if (const double times = step * std::pow(10.0, power); times <= wanted) best = times;
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
  std::array<Vector2, column_count * row_count> sums;
  sums.fill(Vector2(0, 0));
  std::array<int, column_count * row_count> counts{};
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    const int column = std::clamp(static_cast<int>(point.position.x() / width_ * column_count), 0, column_count - 1);
    const int row = std::clamp(static_cast<int>(point.position.y() / height_ * row_count), 0, row_count - 1);
    const auto i = static_cast<std::size_t>(row * column_count + column);
    sums[i] += point.residual;
    ++counts[i];
  }
  Strokes means;
  const double times = exaggeration();
  for (int i = 0; i < column_count * row_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int column = i % column_count, row = i / column_count;
    const Vector2 corner(column * width_ / double(column_count), row * height_ / double(row_count));
    const Vector2 middle = corner + Vector2(width_ / double(2 * column_count), height_ / double(2 * row_count));
    layers_->counts[k]->position->setCoords(corner.x(), corner.y());
    layers_->counts[k]->setText(QString::number(counts[k]));
    layers_->counts[k]->setVisible(has_regions_ && !points_.empty() && lens_ != MapLens::arrows);
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
  std::array<QVector<double>, direction_count> direction_x, direction_y;
  for (const MapPoint& point : points_) {
    if (!is_shown(point)) continue;
    if (lens_ == MapLens::size) {
      const auto step = static_cast<std::size_t>(point.rms_over_sigma ? residual_step(*point.rms_over_sigma, 2) : 1);
      x[step] += point.position.x();
      y[step] += point.position.y();
    } else if (lens_ == MapLens::direction) {
      const double angle = std::atan2(point.residual.y(), point.residual.x());
      const int sector = static_cast<int>((angle + M_PI) / (2 * M_PI) * direction_count) % direction_count;
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
  for (std::size_t i = 0; i < direction_count; ++i) layers_->directions[i]->setData(direction_x[i], direction_y[i]);
  layers_->frame->topLeft->setCoords(-0.5, -0.5);
  layers_->frame->bottomRight->setCoords(width_ - 0.5, height_ - 0.5);
  fill_arrows();
  fill_regions();
  ring();
  // The scale bar: a round number of the residuals' unit, near a tenth of the width.
  const double times = exaggeration();
  double shown = 1;
  for (int power = -3; power < 3; ++power)
    for (const double step : {1.0, 2.0, 5.0})
      if (const double length = step * std::pow(10.0, power); length * times <= width_ / 8.0) shown = length;
  const double right = width_ * 0.98, bottom = height_ * 0.975;
  const bool has_bar = lens_ == MapLens::arrows && !points_.empty();
  layers_->bar->setVisible(has_bar);
  layers_->bar_text->setVisible(has_bar);
  layers_->bar->start->setCoords(right - shown * times, bottom);
  layers_->bar->end->setCoords(right, bottom);
  layers_->bar_text->position->setCoords(right, bottom - 2);
  const QString length = size_text({shown, unit_}, 1);
  layers_->bar_text->setText(unit_ == SizeUnit::pixel ? QObject::tr("%1, drawn %2 ×").arg(length, short_text(times, 1))
                             : unit_ == SizeUnit::millimetre ? QObject::tr("%1 across the line of sight").arg(length)
                                                             : length);
}

}  // namespace handsight::widgets
