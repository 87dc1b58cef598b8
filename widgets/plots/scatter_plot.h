// SPDX-License-Identifier: GPL-3.0-or-later
// A residual against what it may follow: points, trend with its band, a candidate's prediction, rectangle selection.
#pragma once

#include <memory>
#include <optional>

#include "widgets/base/cells.h"
#include "widgets/plots/plot_widget.h"

namespace handsight::widgets {

struct ScatterPoint {
  ObservationId observation = no_observation;
  double x = 0, y = 0;
  std::optional<double> rms_over_sigma;  // colours it; absent: neutral
  int coordinates = 12;
  double bar = 0;        // half the length of its error bar; 0: none
  bool is_weak = false;  // it says little: hollow
  int session = -1;      // drawn as this session's mark (session_mark.h) in place of the residual's colour
};

/// The span of y that an axis shows: all points, but where a few of many lie far outside of the others (beyond twice
/// the span of the middle nine tenths) only the others, so that one wrong point does not flatten a plot.
struct Span {
  double low = 1e300, high = -1e300;
};
Span span_of_most(const std::vector<ScatterPoint>& points);

/// x ascending; `low` and `high` bound the band, equal to y where there is none.
/// Of the noise, on each side of zero, an axis shows so many sigma at least: noise alone never fills a plot.
inline constexpr double noise_sigmas = 3;

struct TrendPoint {
  double x = 0, y = 0, low = 0, high = 0;
};

class ScatterPlot : public PlotWidget {
  Q_OBJECT
 public:
  explicit ScatterPlot(QWidget* parent = nullptr);
  void set_axes(const QString& x_quantity, const QString& x_unit, const QString& y_quantity, const QString& y_unit);
  void set_points(std::vector<ScatterPoint> points);
  void set_trend(std::vector<TrendPoint> trend);
  void set_candidate(std::vector<TrendPoint> prediction);  // purple, dashed; its band hatched: noise about it
  /// Half the height that noise alone takes; the y axis never shows less than noise_sigmas of it on each side.
  /// `is_drawn` false: a band of its own stands about the candidate's curve.
  void set_noise_band(std::optional<double> sigma, bool is_drawn = true);
  void set_selected(ObservationId id);
  void set_hovered(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);
  void set_brushing(bool brushing);  // dragging selects instead of panning; Shift does so always
  void fit() override;
  const std::vector<ScatterPoint>& points() const { return points_; }
  const std::vector<TrendPoint>& candidate() const { return candidate_; }
  /// Fits anew only where the points have outgrown the axes of the last fit.
  void fit_if_outgrown();

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void observations_selected(const std::vector<qint64>& ids);

 protected:
  void restyle() override;
  std::vector<PlotColumn> columns() const override;
  QString text_at(const QPointF& position) override;
  void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers) override;
  void brushed(const QRectF& in_plot) override;
  bool is_empty() const override { return points_.empty(); }

 private:
  struct Layers;
  void fill();
  void fill_bars();
  void fill_points();
  void mark_beyond();
  void ring();
  void shorten_label();
  const ScatterPoint* point_at(const QPointF& position) const;
  QString point_text(const ScatterPoint& point) const;

  std::vector<ScatterPoint> points_;
  std::vector<TrendPoint> trend_, candidate_;
  std::optional<double> noise_;
  bool draws_noise_ = true;
  std::vector<ObservationId> highlighted_;
  QString x_quantity_, x_unit_, y_quantity_, y_unit_;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  std::shared_ptr<Layers> layers_;
  struct Extent {
    double left = 0, right = 0, low = 0, high = 0;
  };
  Extent extent() const;
  Extent fitted_;
};

}  // namespace handsight::widgets
