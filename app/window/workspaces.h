// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of workspaces: rail, keys, actions and the pages of the centre are made of it.
#pragma once

#include <QString>
#include <Qt>
#include <span>

#include "workbench/workbench.h"

class QWidget;

namespace handsight::app {

class Workspace;

/// What the window knows of a workspace before it is made.
struct WorkspaceKind {
  Place place;
  QString id;        // "label": its button is rail_label, its action workspace_label
  QString icon;      // of resources/icons
  Qt::Key key;       // with Ctrl
  const char* text;  // its name in English
  Workspace* (*make)(Workbench& workbench, QWidget* parent);

  /// The name in the language of the window.
  QString name() const;
  /// "Label (Ctrl+1)"
  QString tool_tip() const;
};

/// All of them, in the order of the work, which is that of Place.
std::span<const WorkspaceKind> workspace_kinds();

}  // namespace handsight::app
