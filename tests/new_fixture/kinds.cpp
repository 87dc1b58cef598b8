// SPDX-License-Identifier: Apache-2.0
// The list with one more line: linked in place of core's.
#include "session/fixtures/list.h"

namespace handsight {
namespace fixtures {
extern const FixtureKind post;
}

std::span<const FixtureKind* const> fixture_kinds() {
  static constexpr const FixtureKind* all[] = {
#define HANDSIGHT_FIXTURE(kind) &fixtures::kind,
#include "session/fixtures/list.inc"
      HANDSIGHT_FIXTURE(post)
#undef HANDSIGHT_FIXTURE
  };
  return all;
}

}  // namespace handsight
