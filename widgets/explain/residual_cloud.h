// SPDX-License-Identifier: GPL-3.0-or-later
// The residuals (du, dv) of all corners, before and after, side by side on the same axes.
#pragma once

#include <QImage>
#include <QStringList>
#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "widgets/base/cells.h"
#include "widgets/explain/dot_stamp.h"

namespace handsight::widgets {

/// A corner's residual measured - predicted, in the cloud's unit.
struct CloudPoint {
  ObservationId observation = no_observation;
  int marker = 0;
  int camera = 0;
  double du = 0, dv = 0;
};

/// Painted straight into an image: 6000 points are drawn in a few ms. Beyond three sigma the distance from the middle
/// is compressed (rings say how much), so that noise and errors of many px show on one picture; `is_linear` switches
/// that off. The axes are locked by the larger cloud of the first `set_before`; they change where a cloud outgrows
/// them, and at `fit`.
class ResidualCloud : public QWidget {
  Q_OBJECT
 public:
  explicit ResidualCloud(QWidget* parent = nullptr);
  void set_noise(std::optional<double> sigma);
  void set_camera_names(const QStringList& names) { camera_names_ = names; }  // by camera
  /// px at first; the axes are locked anew where it changes.
  void set_unit(SizeUnit unit);
  void set_before(std::vector<CloudPoint> points, const QString& title);
  /// Where points of the same corners were shown in this pane they move there within 160 ms.
  void set_after(std::vector<CloudPoint> points, const QString& title);
  /// An iteration of a running fit: as it is, at once. `points` as long as those of set_after or set_before.
  void set_live(const std::vector<CloudPoint>& points, const QString& title);
  void set_predicted(bool predicted);  // the right pane shows a prediction: dashed purple frame
  void clear_after();
  void reset();  // of another session: nothing is shown, and the axes are open
  void set_selected(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);
  void set_linear(bool linear);
  void set_blinking(bool blinking);  // before and after alternate in both panes
  void set_empty_text(const QString& sentence);
  void set_after_empty_text(const QString& sentence) { after_empty_text_ = sentence; }
  /// The panes show observations of two sessions: an id in one is nothing in the other, a click selects nothing, and no
  /// dot moves from the one to the other.
  void set_apart(bool apart) { is_apart_ = apart; }
  void fit();
  double reach() const { return reach_; }  // size at the rim
  QRectF pane(int index) const;            // 0 before, 1 after: the square with the points
  QPointF on_screen(int pane, double du, double dv) const;
  QSize sizeHint() const override { return {332, 172}; }
  QSize minimumSizeHint() const override { return {220, 120}; }

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void read_out(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Cloud {
    std::vector<CloudPoint> points;
    QString title;
  };
  void move(double share);
  void hold(const std::vector<CloudPoint>& points);
  double radius(double size) const;  // of a residual -> 0 (middle) to 1 (rim)
  const std::vector<CloudPoint>& shown(int pane) const;
  const CloudPoint* point_at(const QPointF& position, int* pane = nullptr) const;
  void paint_pane(QPainter& painter, int index) const;
  void paint_ground(QPainter& painter, int pane) const;
  void paint_ring_names(QPainter& painter, const QRectF& area) const;
  const QImage& still_dots() const;
  void paint_points(QImage& image, int pane) const;
  void paint_marked(QPainter& painter, int index) const;

  Cloud before_, after_;
  /// The dots of the left pane as they were last painted: they stay while the right pane moves.
  struct Still {
    QImage dots;
    QSizeF size;
    double reach = 0, noise = 0;
    bool is_linear = false;
    QRgb ground = 0;
  };
  mutable Still still_;
  std::vector<CloudPoint> moving_from_, moving_;  // of the right pane, while it moves
  std::vector<ObservationId> highlighted_;
  std::optional<double> noise_;
  SizeUnit unit_ = SizeUnit::pixel;
  QStringList camera_names_;
  double reach_ = 0;
  bool is_linear_ = false, is_predicted_ = false, is_swapped_ = false;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  QString empty_text_, after_empty_text_;
  bool is_apart_ = false;
  int hovered_pane_ = 0;
  QVariantAnimation animation_;
  QTimer blink_;
};

}  // namespace handsight::widgets
