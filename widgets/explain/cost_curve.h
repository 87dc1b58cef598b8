// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a running fit, iteration by iteration.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace handsight::widgets {

/// Cost on a log axis over the iterations. Appending costs one small repaint, whatever the number of points.
class CostCurve : public QWidget {
  Q_OBJECT
 public:
  explicit CostCurve(QWidget* parent = nullptr);
  /// A new fit: an empty curve. `quantity` says what the cost is: "rms of the coordinates", with its unit.
  void start(const QString& quantity, const QString& unit);
  void clear();  // no fit, as at first
  void append(int iteration, double cost);
  void finish(const QString& outcome);         // "settled after 7 iterations", "stopped"; shown at the curve's end
  void set_floor(std::optional<double> cost);  // hatched: what noise alone leaves
  void set_empty_text(const QString& sentence);
  int count() const { return static_cast<int>(points_.size()); }
  bool is_running() const { return is_running_; }
  QSize sizeHint() const override { return {332, 172}; }
  QSize minimumSizeHint() const override { return {140, 90}; }

 signals:
  void read_out(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  struct Point {
    int iteration = 0;
    double cost = 0;
  };
  struct Scale;
  Scale scale() const;
  QRectF area() const;

  std::vector<Point> points_;
  QString quantity_, unit_, outcome_, empty_text_;
  std::optional<double> floor_;
  bool is_running_ = false;
  int hovered_ = -1;
};

}  // namespace handsight::widgets
