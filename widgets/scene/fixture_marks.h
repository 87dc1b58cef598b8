// SPDX-License-Identifier: GPL-3.0-or-later
// What a probe touches, drawn: planes as patches, sockets as rings, edges and lengths as lines, gauges as arrows.
#pragma once

#include "widgets/scene/marks.h"

namespace handsight::widgets {

void show_fixture(vtkRenderer& renderer, ActorGroup& group, const SceneFixture& fixture);

/// Where it is looked for, m, root frame.
Vector3 find_middle(const SceneFixture& fixture);

}  // namespace handsight::widgets
