// SPDX-License-Identifier: Apache-2.0
#include "blunders/blunder_kinds.h"

#include <algorithm>

namespace handsight {

const std::vector<BlunderKind>& blunder_kinds() {
  static const std::vector<BlunderKind> all = [] {
    std::vector<BlunderKind> kinds;
    for (const auto& some :
         {joint_blunders(), pairing_blunders(), pose_blunders(), image_blunders(), picture_blunders(), size_blunders(),
          link_blunders(), gravity_blunders(), order_blunders(), stray_blunders()})
      kinds.insert(kinds.end(), some.begin(), some.end());
    return kinds;
  }();
  return all;
}

const BlunderKind* find_blunder_kind(const std::string& id) {
  const auto& all = blunder_kinds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const BlunderKind& k) { return k.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace handsight
