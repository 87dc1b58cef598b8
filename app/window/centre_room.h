// SPDX-License-Identifier: GPL-3.0-or-later
// The room of the workspaces: scrolled where the window is smaller than what the one that is shown needs at least.
#pragma once

#include <QScrollArea>

class QStackedWidget;

namespace handsight::app {

class CentreRoom : public QScrollArea {
  Q_OBJECT

 public:
  /// Takes the pages in. Other pages than the one that is shown need no room.
  CentreRoom(QStackedWidget* pages, QWidget* parent);
  QSize minimumSizeHint() const override { return {200, 120}; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QStackedWidget* pages_;
  bool is_fitting_ = false;
};

}  // namespace handsight::app
