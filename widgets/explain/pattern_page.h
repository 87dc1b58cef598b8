// SPDX-License-Identifier: GPL-3.0-or-later
// Nine small plots of the residual against what it may follow, in fixed places.
#pragma once

#include <QWidget>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "widgets/explain/dot_stamp.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::widgets {

/// One small plot. x and y in the units given; they are never scaled here.
struct PatternPlot {
  QString id;             // what names it from version to version
  QString what, against;  // "z of the TCP", "gravity torque of arm_2"
  QString x_unit, y_unit;
  std::vector<ScatterPoint> points;
  std::vector<TrendPoint> trend;      // with its band; may be empty
  std::vector<TrendPoint> candidate;  // what is being tried predicts: purple, dashed
  std::optional<double> noise;        // half the height that noise alone takes
  double strength = 0;                // share of the residual's square that follows, 0 to 1
  bool is_chance = false;             // no more than chance would show: the strength is drawn hollow
  QString shows;                      // "joint elasticity, payload": the effects that show here
};

/// 3 x 3, each at least 196 x 72. A click or the arrow keys select one; Shift and dragging selects observations in it.
/// The axes stay locked from `set_plots` on: `update_plots` keeps them where the id in a place is the same, until
/// `fit`.
class PatternPage : public QWidget {
  Q_OBJECT
 public:
  static constexpr int plot_count = 9;
  /// Three rows of three, or the strongest three alone where there is little height.
  void set_rows(int rows);
  /// `fit` gives a plot the axes that also hold the other page's plot of the same id. Null: none. It must live as long.
  void set_companion(const PatternPage* other) { companion_ = other; }
  int rows() const { return rows_; }
  /// Each plot has numbers along its axes, and units; where no large plot beside the page has them.
  void show_numbers();
  explicit PatternPage(QWidget* parent = nullptr);
  void set_plots(std::vector<PatternPlot> plots);     // at most nine, as read; axes are fitted
  void update_plots(std::vector<PatternPlot> plots);  // the same places: axes stay
  void set_candidates(const std::vector<std::vector<TrendPoint>>& predictions);  // one a place; empty: none
  void set_selected_plot(int place);                                             // -1: none
  void set_selected(ObservationId id);
  void set_hovered(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);
  void set_progress(const QString& text);  // "from 40 of 100"; empty: whole
  void set_empty_text(const QString& sentence);
  void fit();
  int selected_plot() const { return selected_plot_; }
  const std::vector<PatternPlot>& plots() const { return plots_; }
  QRectF plot_rect(int place) const;                       // the whole cell, widget coordinates
  QPointF on_screen(int place, double x, double y) const;  // widget coordinates
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void plot_selected(int place);
  void observation_selected(qint64 id);  // a click on a point of the plot that is selected
  void observation_hovered(qint64 id);   // -1: none
  void observations_selected(const std::vector<qint64>& ids);
  void read_out(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Range {
    double left = 0, right = 1, low = -1, high = 1;
  };
  static Range find_range(const PatternPlot& plot);
  static bool outgrows(const Range& wanted, const Range& present);
  static bool is_filled_by_noise(const PatternPlot& plot, const Range& present);
  static QString with_unit(const QString& quantity, const QString& unit);
  QRectF canvas(int place) const;  // where the points are
  int place_at(const QPointF& position) const;
  const ScatterPoint* point_at(int place, const QPointF& position) const;
  QString make_text(int place, const ScatterPoint* point) const;
  void paint_ground(QPainter& painter, int place) const;
  void paint_head(QPainter& painter, int place) const;
  void paint_numbers(QPainter& painter, int place) const;
  void paint_curves(QPainter& painter, int place) const;
  void paint_points(QImage& image, int place, const std::vector<DotStamp>& stamps, const DotStamp& plain) const;
  void paint_rings(QPainter& painter, int place) const;
  void paint_beyond(QPainter& painter, int place) const;

  std::vector<PatternPlot> plots_;
  std::array<Range, plot_count> ranges_{};
  int rows_ = 3;
  bool has_numbers_ = false;
  const PatternPage* companion_ = nullptr;
  int count() const { return std::min(static_cast<int>(plots_.size()), 3 * rows_); }
  std::vector<ObservationId> highlighted_;
  QString progress_, empty_text_;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  int selected_plot_ = -1, hovered_plot_ = -1;
  int brushing_ = -1;  // the place in which a rectangle is being drawn
  QPointF brush_from_, brush_to_;
};

}  // namespace handsight::widgets
