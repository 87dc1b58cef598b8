// SPDX-License-Identifier: GPL-3.0-or-later
// One number of the model panel.
#pragma once

#include <QWidget>

#include "widgets/lists/model_parameter.h"

class QLineEdit;
class QPainter;
class QToolButton;

namespace handsight::widgets {

/// One parameter: name, value with sigma and unit, and the bar against what is plausible; a lock where it can be held,
/// and a field to type in where it is.
class ParameterRow : public QWidget {
 public:
  ParameterRow(ModelParameter parameter, bool is_candidate, bool is_selected, QWidget* parent);

  QLineEdit* field() const { return field_; }
  QToolButton* hold() const { return hold_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_bar(QPainter& painter, const QRectF& bar) const;
  /// Left of the lock.
  int text_width() const;
  /// A joint's name takes a line of its own above the parameter's.
  int bar_top() const;
  QString name() const;
  QString value() const;
  QString plausible() const;

  ModelParameter parameter_;
  bool is_candidate_, is_selected_;
  QLineEdit* field_ = nullptr;
  QToolButton* hold_ = nullptr;
};

}  // namespace handsight::widgets
