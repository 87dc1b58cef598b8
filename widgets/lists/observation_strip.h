// SPDX-License-Identifier: GPL-3.0-or-later
// The observation strip: one cell per observation on the absolute residual scale. Quick with 10,000.
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "widgets/base/cells.h"

namespace handsight::widgets {

/// 74 px high: 34 of cells, which fill the width, a line of ids and a line of the legend. A cell's colour and (on a
/// logarithmic scale) its height say the residual over the noise; where the noise is not known the height is the size
/// beside the largest, without a colour. Rejected and excluded cells are struck through. Above one cell a
/// pixel a column shows the worst of its bin; the wheel zooms, dragging with the middle button pans, a lens shows
/// single cells. Click selects, left and right arrows step, Home and End, PageUp and PageDown by ten; Shift+click or
/// dragging selects many.
class ObservationStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ObservationStrip(QWidget* parent = nullptr);

  void set_cells(std::vector<ObservationCell> cells);
  /// Replaces the cell with that id, or appends it.
  void set_cell(const ObservationCell& cell);
  void set_selected(ObservationId id);  // no_observation: none; scrolls it into view
  void set_hovered(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);  // a ring round each: brushed, or beyond a threshold
  /// The names of a collection's sessions: cells of one session stand together, its mark and name under them.
  void set_session_names(const QStringList& names);
  /// The sentence where there are no cells.
  void set_empty_text(const QString& sentence);

  const std::vector<ObservationCell>& cells() const { return cells_; }
  ObservationId selected() const { return selected_; }
  /// Where a cell is drawn; empty where it is scrolled out. For tests and tool tips.
  QRectF cell_rect(ObservationId id) const;
  ObservationId cell_at(const QPointF& position) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);  // no_observation: the pointer left
  void observations_selected(const std::vector<qint64>& ids);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  int find_index(ObservationId id) const;
  int index_at(double x) const;
  double cell_width() const;
  double find_left(int index) const;
  QRectF cells_area() const;
  void show_index(int index);
  void clamp_view();
  void invalidate();
  void paint_cells();
  void paint_cell(QPainter& painter, const ObservationCell& cell, const QRectF& slot) const;
  void paint_marks(QPainter& painter) const;
  /// The first cell of each session that is shown, in order.
  std::vector<int> session_starts() const;
  void paint_sessions(QPainter& painter) const;
  void paint_ids(QPainter& painter) const;
  void paint_legend(QPainter& painter) const;
  /// The largest size of a used cell; without a value where the noise is known or nothing has a size.
  ShownSize largest_without_noise() const;
  void paint_lens(QPainter& painter) const;
  void take(int index);

  std::vector<ObservationCell> cells_;
  std::vector<ObservationId> highlighted_;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  QString empty_text_;
  QStringList session_names_;
  double first_ = 0;   // index at the left edge, in cells
  double zoom_ = 1;    // 1: all cells fit
  ShownSize largest_;  // of the cells as they were painted, where the noise is not known
  QPixmap picture_;    // the cells, painted anew only when they change
  bool is_stale_ = true;
  bool is_brushing_ = false;
  int brush_from_ = -1, brush_to_ = -1;
  double pan_x_ = 0, pan_first_ = 0;
};

}  // namespace handsight::widgets
