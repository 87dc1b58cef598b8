// SPDX-License-Identifier: Apache-2.0
// A window that measures with a simulated robot until it is killed, and says what it has taken.
#pragma once

#include <cstdio>

#include "app/window/measure_page.h"

namespace handsight::test {

/// --measure-until-killed SESSION: an experiment that ends by itself after a thousand poses; after each observation
/// that was taken and written down prints "observation".
inline int measure_until_killed(const char* session) {
  Desk desk;
  MeasurePage page{desk};
  desk.window.resize(1366, 728);
  desk.window.open(session);
  if (!desk.settle()) return 3;
  page.open();
  QObject::connect(&page.workspace()->run(), &app::ExperimentRun::measured, &desk.window, [] {
    std::puts("observation");
    std::fflush(stdout);
  });
  page.type_simulated("--in-real-time");
  if (!page.connect()) return 4;
  page.set_count(1000);
  page.set_speed(5);
  page.start();
  std::puts("begun");
  std::fflush(stdout);
  for (;;) QTest::qWait(1000);
}

}  // namespace handsight::test
