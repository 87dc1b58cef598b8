// SPDX-License-Identifier: GPL-3.0-or-later
// The honest staircase: fitted and held-out error over the versions of the model, down to the noise floor.
#pragma once

#include <QVariantAnimation>
#include <QWidget>
#include <optional>

#include "widgets/explain/staircase_state.h"

namespace handsight::widgets {

struct StaircaseScene;

/// Log axis with unit. A click (or left, right, Home, End) takes a step; Ctrl and click (or A and B) marks two for a
/// comparison; hover reads it out. The gap between the two lines is filled: over-fitting has a width.
class Staircase : public QWidget {
  Q_OBJECT
 public:
  explicit Staircase(QWidget* parent = nullptr);
  void set_state(StaircaseState state);
  void set_preview(std::optional<VersionStep> step);
  void set_empty_text(const QString& sentence);
  const StaircaseState& state() const { return state_; }
  QRectF step_rect(int version) const;  // widget coordinates; empty where there is none
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void version_selected(int version);
  void compared(int a, int b);  // -1: not marked (yet)
  void read_out(const QString& text);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  StaircaseScene scene() const;
  QRectF area() const;
  int current() const;
  int step_at(const QPointF& position) const;
  QString step_text(int version) const;
  void mark(int version, bool as_b);

  StaircaseState state_;
  QString empty_text_;
  int hovered_ = -1;
  int falling_ = -1;   // the step that has just come and is drawn on its way down
  double fallen_ = 1;  // 0 to 1
  QVariantAnimation animation_;
};

}  // namespace handsight::widgets
