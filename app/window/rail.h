// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of workspaces on the left: name, mark and one line of state each.
#pragma once

#include <QWidget>
#include <map>
#include <span>

#include "window/workspaces.h"
#include "workbench/workspace.h"

namespace handsight::app {

class RailButton;

class Rail : public QWidget {
  Q_OBJECT

 public:
  /// A button for each.
  explicit Rail(std::span<const WorkspaceKind> kinds, QWidget* parent = nullptr);
  void set_status(Place place, const WorkStatus& status);
  void set_current(Place place);
  /// Another page than a workspace is in front.
  void set_none();

 signals:
  void chosen(handsight::app::Place place);

 private:
  std::map<Place, RailButton*> buttons_;
};

}  // namespace handsight::app
