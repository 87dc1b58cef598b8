// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of the observations as a histogram against what noise alone would show.
#pragma once

#include <memory>
#include <optional>

#include "widgets/cells.h"
#include "widgets/plot_widget.h"

namespace handsight::widgets {

/// The rms per coordinate over sigma on a logarithmic axis, bars in the residual colours, the noise's own distribution
/// hatched behind them (a chi distribution of each observation's number of coordinates). A threshold can be dragged;
/// it changes nothing by itself.
class HistogramPlot : public PlotWidget {
  Q_OBJECT
 public:
  explicit HistogramPlot(QWidget* parent = nullptr);
  /// Cells without a residual are left out and counted in the read-out; rejected and excluded ones too.
  void set_cells(std::vector<ObservationCell> cells);
  /// px (or mm) of one sigma, for the second axis; absent: the noise is not known, and no noise curve is drawn.
  void set_noise(std::optional<double> sigma, const QString& unit);
  void set_selected(ObservationId id);
  void set_threshold(std::optional<double> rms_over_sigma);  // absent: none is shown
  std::optional<double> threshold() const { return threshold_; }
  std::vector<ObservationId> beyond_threshold() const;
  void fit() override;

 signals:
  void threshold_changed(double rms_over_sigma);                                 // while it is dragged
  void threshold_set(double rms_over_sigma, const std::vector<qint64>& beyond);  // when it is let go
  void observations_selected(const std::vector<qint64>& ids);                    // a bar was clicked

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
  void place_threshold();
  void place_selected();
  int bin_at(double x) const;
  std::vector<ObservationId> ids_in(int bin) const;

  std::vector<ObservationCell> cells_;
  std::optional<double> noise_, threshold_;
  QString unit_ = "px";
  ObservationId selected_ = kNoObservation;
  bool is_moving_threshold_ = false;
  std::shared_ptr<Bars> bars_;
};

}  // namespace handsight::widgets
