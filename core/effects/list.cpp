// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> effects = {
#define HANDSIGHT_EFFECT(effect) effect(),
#include "effects/list.inc"
#undef HANDSIGHT_EFFECT
  };
  return effects;
}

}  // namespace handsight
