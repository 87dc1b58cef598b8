// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of workspaces.
#include "calibrate/calibrate_workspace.h"
#include "explain/explain_workspace.h"
#include "export/export_workspace.h"
#include "inspect/inspect_workspace.h"
#include "label/label_workspace.h"

namespace handsight::app {

std::vector<Workspace*> make_workspaces(Workbench& bench, QWidget* parent) {
  return {new LabelWorkspace(bench, parent), new CalibrateWorkspace(bench, parent), new InspectWorkspace(bench, parent),
          new ExplainWorkspace(bench, parent), new ExportWorkspace(bench, parent)};
}

}  // namespace handsight::app
