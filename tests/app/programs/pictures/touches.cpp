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
  desk.window.bench().selection.select_observation(20);
  const char* names[] = {"", "touch_label", "touch_calibrate", "touch_inspect", "touch_explain", "touch_export"};
  for (int i = 1; i <= 5; ++i) {
    if (i == 4) {
      ASSERT_TRUE(ExplainPage{desk}.open());
    } else {
      desk.key(Qt::Key_0 + i, Qt::ControlModifier);
    }
    ASSERT_TRUE(desk.settle());
    photo.take(names[i]);
  }
}

}  // namespace
}  // namespace handsight::test
