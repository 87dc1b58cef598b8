// SPDX-License-Identifier: GPL-3.0-or-later
// How one number went, over observations or over time, beside a limit.
#pragma once

#include <memory>
#include <optional>

#include "widgets/base/cells.h"
#include "widgets/plots/plot_widget.h"

namespace handsight::widgets {

struct HistoryPoint {
  double x = 0;  // observations, or s since 1970 (UTC)
  double y = 0;
  double sigma = 0;         // 0: no band
  bool stands_out = false;  // beyond the limit, or to be looked at
  ObservationId observation = no_observation;
};

/// A curve with a mark at each point, a band of two sigma where it is known, and a dashed line at the limit.
class HistoryPlot : public PlotWidget {
  Q_OBJECT
 public:
  enum class Along { observations, time };
  explicit HistoryPlot(Along along, QWidget* parent = nullptr);
  /// The y axis; `is_log`: decades, and what is not above 0 is left out.
  void set_quantity(const QString& quantity, const QString& unit, bool is_log);
  /// A line with its name, always in sight; none where there is no value.
  void set_limit(std::optional<double> value, const QString& name);
  void set_points(std::vector<HistoryPoint> points);
  const std::vector<HistoryPoint>& points() const { return points_; }
  std::optional<double> limit() const { return limit_; }
  void fit() override;

 signals:
  void observation_selected(qint64 id);

 protected:
  void restyle() override;
  std::vector<PlotColumn> columns() const override;
  QString text_at(const QPointF& position) override;
  void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers) override;
  bool is_empty() const override { return points_.empty(); }

 private:
  struct Layers;
  void fill();
  const HistoryPoint* point_at(const QPointF& position) const;
  QString x_text(double x) const;

  Along along_;
  QString quantity_, unit_, limit_name_;
  bool is_log_ = false;
  std::optional<double> limit_;
  std::vector<HistoryPoint> points_;
  std::shared_ptr<Layers> layers_;
};

}  // namespace handsight::widgets
