// SPDX-License-Identifier: GPL-3.0-or-later
// Three numbers side by side: error now (held out) | noise floor | ratio, and the staircase of the versions.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace handsight::widgets {

/// One version of the model; a refused one stays, grey, with its reason.
struct VersionStep {
  QString name;
  std::optional<double> fitted, held_out;  // in the unit of the numbers
  bool is_refused = false;
  QString reason;
};

struct ErrorNumbers {
  std::optional<double> now, noise;  // held out, and what noise alone would make of it
  std::optional<double> ratio;       // absent: now over noise
  std::optional<double> predicted;   // with a candidate that is being tried: shown purple and dashed
  QString unit = "px";
  std::optional<double> predicted_ratio;  // with it
  std::optional<double> elsewhere;        // held out region by region: where the robot has not been measured
  QString noise_note;                     // what the noise mostly is, where that is worth saying: "of the depth"
  QString excluded_note;                  // "with 7 excluded: 8.1 px", shown beside the first number for good
  bool is_stale = false;                  // a fit runs: the numbers belong to what was
  std::vector<VersionStep> versions;      // oldest first
  int current = -1;                       // the version that is shown; -1: the last
};

/// A click on a step says so, and so do left and right arrows when it has the focus; hover reads a step out.
class ThreeNumbers : public QWidget {
  Q_OBJECT
 public:
  explicit ThreeNumbers(QWidget* parent = nullptr);
  void set_numbers(ErrorNumbers numbers);
  const ErrorNumbers& numbers() const { return numbers_; }
  QRectF step_rect(int version) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void version_selected(int version);
  void read_out(const QString& text);  // empty: nothing under the pointer

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF stairs_area() const;
  QString step_text(int version) const;
  int step_at(const QPointF& position) const;
  void paint_stairs(QPainter& painter) const;

  ErrorNumbers numbers_;
  int hovered_ = -1;
};

}  // namespace handsight::widgets
