// SPDX-License-Identifier: Apache-2.0
// What all parts of take_pictures share.
#pragma once

#include "app/window/pages.h"

namespace handsight::test {

/// Where pictures are kept, and what their names end with; set by take_pictures.
extern QString folder_of_pictures, suffix;

/// HANDSIGHT_WINDOW=1366x728, else 1440 x 900.
inline QSize window_size() {
  const QStringList wanted = qEnvironmentVariable("HANDSIGHT_WINDOW", "1440x900").split('x');
  return {wanted.value(0).toInt(), wanted.value(1).toInt()};
}

struct Photographer {
  Desk& desk;
  void take(const std::string& name) {
    desk.settle();
    take_now(name);
  }
  void take_now(const std::string& name) {
    QTest::qWait(250);
    desk.window.grab().save(folder_of_pictures + "/" + QString::fromStdString(name) + suffix + ".png");
  }
};

/// Of a window of its own.
inline void take_dialog(QWidget& dialog, const std::string& name) {
  QTest::qWait(250);
  dialog.grab().save(folder_of_pictures + "/" + QString::fromStdString(name) + suffix + ".png");
}

}  // namespace handsight::test
