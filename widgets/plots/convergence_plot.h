// SPDX-License-Identifier: GPL-3.0-or-later
// How parameters converge with the number of observations (thesis, figures 5.3 to 5.6).
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "geometry/rigid.h"
#include "widgets/base/cells.h"
#include "widgets/plots/plot_widget.h"

namespace handsight::widgets {

/// After each accepted observation. x y z in m, then rotations in rad; what is shown is mm and degrees.
struct ConvergencePoint {
  int count = 0;  // observations in the estimate
  ObservationId observation = no_observation;
  Vector6 tcp_from_body = Vector6::Zero();
  Vector6 sigma = Vector6::Zero();
  std::optional<Vector6> tcp_from_tcp_est;
  Vector6 deviation_sigma = Vector6::Zero();  // of tcp_from_tcp_est, that of one observation; 0: not known
};

/// Three curves: translation or rotation of one motion, with a band of two sigma where it is known and a mark where
/// each has settled: from there on it stays within two sigma (as they are at the end) of its last value.
class ConvergencePlot : public PlotWidget {
  Q_OBJECT
 public:
  struct Sample {
    int count = 0;
    ObservationId observation = no_observation;
    std::array<double, 3> value{};
    std::array<double, 3> sigma{};  // 0: no band
    std::array<double, 3> noise{};  // of a value without a band: one sigma of it alone; 0: not known
  };
  /// `unit` "mm" or "deg"; names of the three curves, `quantity` for the axis.
  ConvergencePlot(const QString& quantity, const QString& unit, const std::array<QString, 3>& names,
                  QWidget* parent = nullptr);
  void set_samples(std::vector<Sample> samples);
  void append(const std::vector<Sample>& samples);
  void set_selected(ObservationId id);  // a line at its count
  void set_show_settled(bool shown);
  /// What the values are counted from, in m or rad; absent: from the last one where there are bands, else from 0.
  void set_origin(const std::optional<std::array<double, 3>>& origin);
  /// Plots that have one x axis and, in each row, one y axis from now on; the fit of one is that of its row.
  static void share_axes(const std::vector<std::vector<ConvergencePlot*>>& rows);
  /// The y axis spans six sigma of the last values at least, so that noise alone never fills the plot.
  void fit() override;
  /// Where a curve has settled: a count, or 0 while it has not.
  int settled_at(int curve) const;

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void restyle() override;
  std::vector<PlotColumn> columns() const override;
  QString text_at(const QPointF& position) override;
  void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers) override;
  bool is_empty() const override { return samples_.empty(); }

 private:
  struct Reach {
    double left = 0, right = 1, low = 0, high = 1;
  };
  std::optional<Reach> reach() const;  // that shows everything; absent without samples
  void fill();
  void name_y_axis();
  void place_selected();
  void mark_settled();
  const Sample* sample_at(const QPointF& position) const;

  struct Curves;
  QString quantity_, unit_;  // as it is shown
  double factor_;            // from m or rad
  std::array<QString, 3> names_;
  std::vector<Sample> samples_;
  std::optional<std::array<double, 3>> origin_;
  std::vector<ConvergencePlot*> row_, all_;  // that share the y and the x axis, this one among them; empty: none
  ObservationId selected_ = no_observation;
  bool shows_settled_ = true, follows_ = true;
  std::shared_ptr<Curves> curves_;
};

/// Four plots with one x axis: tcp_from_body (mm, deg) above tcp_from_tcp_est (mm, deg).
class ConvergenceBoard : public QWidget {
  Q_OBJECT
 public:
  explicit ConvergenceBoard(QWidget* parent = nullptr);
  void set_points(const std::vector<ConvergencePoint>& points);
  void append(const std::vector<ConvergencePoint>& points);
  void set_selected(ObservationId id);
  void set_empty_text(const QString& sentence);
  ConvergencePlot* plot(int index) const { return plots_[static_cast<std::size_t>(index)]; }  // 0 to 3, as read

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void read_out(const QString& text);
  void message(const QString& sentence);

 private:
  std::array<ConvergencePlot*, 4> plots_{};
};

}  // namespace handsight::widgets
