// SPDX-License-Identifier: Apache-2.0
// Pictures of a session of touches in every workspace.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"

namespace handsight::test {
namespace {

TEST(Pictures, OfTouches) {
  QCursor::setPos(1, 1);  // over no card
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ASSERT_TRUE(desk.window.open(HANDSIGHT_SOURCE_DIR "/sample_sessions/probe_and_plate"));
  ASSERT_TRUE(desk.settle());
  desk.window.workbench().selection.select_observation(20);
  take_each_workspace(desk, photo, "touch");
}

}  // namespace
}  // namespace handsight::test
