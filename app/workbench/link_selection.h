// SPDX-License-Identifier: GPL-3.0-or-later
// What a view of observations or joints says, told to the one selection of the window: the same everywhere.
#pragma once

#include "workbench/workbench.h"

namespace handsight::app {

/// Links whichever of these signals the view has: observation_selected, observation_hovered, observations_selected,
/// joint_selected, read_out, message. For as long as both live.
template <class View>
void link_selection(View* view, Workbench& workbench) {
  Selection& selection = workbench.selection;
  if constexpr (requires { &View::observation_selected; })
    QObject::connect(view, &View::observation_selected, &selection,
                     [&selection](qint64 id) { selection.select_observation(id); });
  if constexpr (requires { &View::observation_hovered; })
    QObject::connect(view, &View::observation_hovered, &selection,
                     [&selection](qint64 id) { selection.hover(id < 0 ? Selected{} : Selected{.observation = id}); });
  if constexpr (requires { &View::observations_selected; })
    QObject::connect(view, &View::observations_selected, &selection, [&selection](const std::vector<qint64>& ids) {
      selection.select_many({ids.begin(), ids.end()});
    });
  if constexpr (requires { &View::joint_selected; })
    QObject::connect(view, &View::joint_selected, &selection, [&selection](const QString& joint) {
      Selected selected = selection.current();
      selected.joint = joint.toStdString();
      selection.select(selected);
    });
  if constexpr (requires { &View::read_out; })
    QObject::connect(view, &View::read_out, &workbench, &Workbench::pointed_at);
  if constexpr (requires { &View::message; })
    QObject::connect(view, &View::message, &workbench.document, &Document::noticed);
}

}  // namespace handsight::app
