// SPDX-License-Identifier: GPL-3.0-or-later
// px | mm | σ: the unit of all sizes in the window.
#pragma once

#include <QWidget>
#include <array>

#include "widgets/base/cells.h"

class QToolButton;

namespace handsight::widgets {

class UnitSwitch : public QWidget {
  Q_OBJECT
 public:
  explicit UnitSwitch(QWidget* parent = nullptr);
  void set_unit(SizeUnit unit);
  /// A unit that cannot be had says why; empty: it can be had.
  void set_why_not(SizeUnit unit, const QString& sentence);

 signals:
  void chosen(handsight::widgets::SizeUnit unit);

 private:
  std::array<QToolButton*, 3> buttons_{};
};

}  // namespace handsight::widgets
