// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of the observations as a histogram against what noise alone would show.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "widgets/base/cells.h"
#include "widgets/plots/plot_widget.h"

namespace handsight::widgets {

/// Sizes in one unit on a logarithmic axis, bars in the residual colours of the observations in them, the noise's own
/// distribution hatched behind them. A threshold can be dragged; it changes nothing by itself.
class HistogramPlot : public PlotWidget {
  Q_OBJECT
 public:
  explicit HistogramPlot(QWidget* parent = nullptr);
  /// Cells without a residual in the unit are left out and counted in the read-out; rejected and excluded ones too.
  void set_cells(std::vector<ObservationCell> cells);
  /// The unit of the axis and of the threshold, which is taken away where it changes.
  void set_unit(SizeUnit unit);
  /// px (or mm) of one sigma, for the axis's name; absent: the noise is not known, and no noise curve is drawn.
  void set_noise(std::optional<double> sigma, const QString& unit);
  /// The axis's name in mm where it is not the markers' distances; empty: it is.
  void set_distance_name(const QString& name);
  void set_selected(ObservationId id);
  void set_threshold(std::optional<double> size);  // absent: none is shown
  std::optional<double> threshold() const { return threshold_; }
  std::vector<ObservationId> beyond_threshold() const;
  void fit() override;

 signals:
  void threshold_changed(double size);                                 // while it is dragged
  void threshold_set(double size, const std::vector<qint64>& beyond);  // when it is let go
  void observations_selected(const std::vector<qint64>& ids);          // a bar was clicked

 protected:
  void restyle() override;
  std::vector<PlotColumn> columns() const override;
  QString text_at(const QPointF& position) override;
  void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers) override;
  bool is_empty() const override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Bars;
  void fill();
  void place_threshold_text();
  void place_threshold();
  void place_selected();
  double smallest() const;  // sizes below it are counted there
  QString axis_name() const;
  int bin_at(double x) const;
  std::vector<ObservationId> ids_in(int bin) const;

  std::vector<ObservationCell> cells_;
  std::optional<double> noise_, threshold_;
  SizeUnit unit_ = SizeUnit::sigma;
  QString noise_unit_ = "px";
  ObservationId selected_ = no_observation;
  bool is_moving_threshold_ = false;
  QString distance_name_;
  std::shared_ptr<Bars> bars_;
};

}  // namespace handsight::widgets
