// SPDX-License-Identifier: GPL-3.0-or-later
// A push button that is filled with the accent while it is the main action.
#pragma once

#include <QPushButton>

namespace handsight::widgets {

/// Filled by fill_button; the style itself would make the colour lighter, and its text hard to read.
class FilledButton : public QPushButton {
  Q_OBJECT
 public:
  using QPushButton::QPushButton;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// The one main action: always filled where it can be pressed; a long text is shortened at its end, and whole in the
/// accessible name.
class MainButton : public FilledButton {
  Q_OBJECT
 public:
  explicit MainButton(QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
};

void fill_button(QPushButton& button, bool is_filled);

}  // namespace handsight::widgets
