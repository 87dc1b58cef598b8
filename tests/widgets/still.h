// SPDX-License-Identifier: Apache-2.0
// Widgets without motion, so that a test need not wait for it.
#pragma once

#include "widgets/base/motion.h"

namespace handsight::test {

/// Nothing moves on its way.
struct Still {
  Still() { widgets::set_motion(widgets::MotionChoice::reduced); }
  ~Still() { widgets::set_motion(widgets::MotionChoice::as_desktop); }
};

}  // namespace handsight::test
