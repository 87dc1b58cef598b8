// SPDX-License-Identifier: GPL-3.0-or-later
// What every plot shares: theme, units, wheel zoom, drag pan, double click to fit, read-out, copy and save.
#pragma once

#include <QWidget>
#include <vector>

class QCustomPlot;
class QCPAxis;
class QCPTextElement;
class QLabel;

namespace handsight::widgets {

/// One column of what a plot shows, for CSV.
struct PlotColumn {
  QString name;  // with the unit: "x (mm)"
  std::vector<double> values;
};

/// A plot with a title; all plots of the window derive from it. Wheel zooms at the pointer (over an axis: that axis
/// alone), dragging pans, double click and F fit. The context menu copies the picture and saves PNG, SVG or CSV.
class PlotWidget : public QWidget {
  Q_OBJECT
 public:
  explicit PlotWidget(QWidget* parent = nullptr);
  void set_title(const QString& title);
  const QString& title() const { return title_; }
  void set_empty_text(const QString& sentence);  // shown while there is nothing to plot
  QImage picture(double scale = 2) const;
  /// Written whole or not at all; returns an empty text, or the sentence that says why not. The ending says the kind:
  /// .png, .svg or .csv.
  QString save(const QString& path) const;
  QString csv() const;
  /// SVG text, for reports.
  QByteArray svg(const QSize& size) const;
  QCustomPlot* plot() const { return plot_; }
  virtual void fit() = 0;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void read_out(const QString& text);     // empty: the pointer left
  void message(const QString& sentence);  // "Saved residuals.svg.", or why not

 protected:
  /// Pens, brushes and texts in the theme's colours; called again when it changes.
  virtual void restyle() = 0;
  virtual std::vector<PlotColumn> columns() const = 0;
  virtual QString text_at(const QPointF& position) = 0;  // the read-out; also where hovering is noticed
  virtual void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers);
  virtual bool is_empty() const = 0;
  /// A rectangle was drawn (with Shift, or always while set_brush_always): in plot coordinates.
  virtual void brushed(const QRectF& in_plot);
  void allow_brush() { has_brush_ = true; }
  void set_brush_always(bool always) { brushes_always_ = always; }
  /// Stands behind the title as far as there is room; empty: nothing.
  void set_title_note(const QString& note) { title_note_ = note; }
  void style_axes();
  void shorten_title();
  /// Draws everything anew, later and once; not before it is shown.
  void replot();
  /// What only marks (what is selected or hovered) draws on: replot_marks() leaves all below as it is.
  static constexpr const char* marks_layer = "overlay";
  void replot_marks();
  bool is_dragging() const { return is_dragging_; }

  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

  QCustomPlot* plot_;

 private:
  void follow_mouse(const QMouseEvent& mouse);
  void show_menu(const QPoint& position);
  void save_as(const QString& ending);
  void wheel_over(const QPointF& position);

  QCPTextElement* title_element_ = nullptr;
  QLabel* empty_label_ = nullptr;
  bool has_brush_ = false, brushes_always_ = false;
  QString title_, title_note_, empty_text_;
  bool is_dragging_ = false, is_stale_ = false, is_drawn_ = false;
  QPointF pressed_at_;
};

}  // namespace handsight::widgets
