// SPDX-License-Identifier: GPL-3.0-or-later
// Small manners of fields and boxes that hold for the whole window.
#pragma once

#include <QObject>

namespace handsight::app {

/// Listens to all events of the application while it lives. Undo and redo go to the document where the text field
/// that has the focus has nothing of its own to undo; left and right go to the window, which steps through the
/// observations, from boxes, rows and buttons that have no use for them; the wheel turns boxes and sliders only where
/// they have the focus, else it scrolls what they stand in. Tool tips are wrapped, stand beside what they explain, and
/// do not say again what can be read there.
class InputManners : public QObject {
  Q_OBJECT

 public:
  explicit InputManners(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handsight::app
