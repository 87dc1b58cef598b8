// SPDX-License-Identifier: GPL-3.0-or-later
// One of the six pages of the window's centre.
#pragma once

#include <QWidget>

#include "workbench/actions.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// Where a workspace stands, for the rail.
enum class WorkState { waiting, open, done, care };

struct WorkStatus {
  WorkState state = WorkState::waiting;
  QString line;  // "waits for 3 markers", two short lines at most
};

class Workspace : public QWidget {
  Q_OBJECT

 public:
  explicit Workspace(Workbench& workbench, QWidget* parent = nullptr) : QWidget(parent), workbench_(workbench) {}

  virtual WorkStatus status() const = 0;
  /// The model panel beside it: shown, folded, or absent because the page has a panel of its own.
  enum class Panel { shown, folded, absent };
  virtual Panel panel() const { return Panel::shown; }
  /// It comes to the front: brings itself up to date. Before, it need not.
  virtual void activate() = 0;
  /// Keys that the window does not want for itself; true where it was one of this page's.
  virtual bool key(QKeyEvent*) { return false; }
  /// What its keys and gestures do, for the registry.
  virtual std::vector<Action> own_actions() const { return {}; }
  bool is_active() const { return isVisible(); }

 signals:
  void status_changed();

 protected:
  Workbench& workbench_;
};

}  // namespace handsight::app
