// SPDX-License-Identifier: Apache-2.0
// The catalogue's entries, each in the file of its name. A new effect is one file and one line in list.inc
// (docs/add_an_effect.md).
#pragma once

#include "effects/effect.h"

namespace handsight {

#define HANDSIGHT_EFFECT(effect) Effect effect();
#include "effects/list.inc"
#undef HANDSIGHT_EFFECT

}  // namespace handsight
