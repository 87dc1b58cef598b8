// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workspaces.h"

#include <QCoreApplication>
#include <QKeySequence>

#include "calibrate/calibrate_workspace.h"
#include "experiment/experiment_workspace.h"
#include "explain/explain_workspace.h"
#include "export/export_workspace.h"
#include "inspect/inspect_workspace.h"
#include "label/label_workspace.h"

namespace handsight::app {
namespace {

template <class Page>
Workspace* made(Workbench& workbench, QWidget* parent) {
  return new Page(workbench, parent);
}

}  // namespace

QString WorkspaceKind::name() const { return QCoreApplication::translate("workspaces", text); }

QString WorkspaceKind::tool_tip() const {
  return QStringLiteral("%1 (%2)").arg(name(), QKeySequence(Qt::CTRL | key).toString(QKeySequence::NativeText));
}

std::span<const WorkspaceKind> workspace_kinds() {
  static const WorkspaceKind all[] = {
      {Place::label, "label", "label", Qt::Key_1, QT_TRANSLATE_NOOP("workspaces", "Label"), made<LabelWorkspace>},
      {Place::calibrate, "calibrate", "calibrate", Qt::Key_2, QT_TRANSLATE_NOOP("workspaces", "Calibrate"),
       made<CalibrateWorkspace>},
      // It came last, and the keys of the others are in people's fingers.
      {Place::experiment, "experiment", "experiment", Qt::Key_6, QT_TRANSLATE_NOOP("workspaces", "Experiment"),
       made<ExperimentWorkspace>},
      {Place::inspect, "inspect", "inspect", Qt::Key_3, QT_TRANSLATE_NOOP("workspaces", "Inspect"),
       made<InspectWorkspace>},
      {Place::explain, "explain", "explain", Qt::Key_4, QT_TRANSLATE_NOOP("workspaces", "Explain"),
       made<ExplainWorkspace>},
      {Place::write_out, "export", "export", Qt::Key_5, QT_TRANSLATE_NOOP("workspaces", "Export"),
       made<ExportWorkspace>}};
  return all;
}

}  // namespace handsight::app
