// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include "workbench/workspace.h"

namespace handsight::app {

/// One workspace of the rail: icon, mark, name, a line of state.
class RailButton : public QAbstractButton {
  Q_OBJECT

 public:
  RailButton(const QString& name, const QString& icon, const QString& tip, QWidget* parent);
  void set_status(const WorkStatus& status);
  const WorkStatus& status() const { return status_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {104, 58}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paint_mark(QPainter& painter, const QRectF& area) const;

  WorkStatus status_;
  QString icon_;
};

}  // namespace handsight::app
