// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "document/document.h"
#include "widgets/model_panel.h"

namespace handsight::app {

/// What the model panel shows of the shown model: TCP->Body, the mount where it is estimated, the markers.
std::vector<widgets::ModelEffect> model_effects(const Document& document);

}  // namespace handsight::app
