// SPDX-License-Identifier: Apache-2.0
// The main of a program that measures the window.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>

#include "temporary_folder.h"
#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {

/// Runs its tests in the light theme, with a state folder of their own: the user's journals are not touched.
inline int run_window_program(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const TemporaryFolder state;
  ::setenv("XDG_STATE_HOME", state.path.c_str(), 1);
  widgets::set_surface_format();
  QApplication application(argc, argv);
  widgets::apply_theme(application, widgets::ThemeKind::light);
  return RUN_ALL_TESTS();
}

}  // namespace handsight::test
