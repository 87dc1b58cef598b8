// SPDX-License-Identifier: Apache-2.0
// What all parts of take_pictures share: of every picture of the window the texts are held against the story.
#pragma once

#include "app/window/painted_story.h"

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
    // Of what is looked for the end is shown, not a moment on the way.
    desk.wait([this] { return !desk.window.workbench().explaining.is_busy(); });
    take_now(name);
  }
  void take_now(const std::string& name) {
    QTest::qWait(250);
    expect_painted_story(desk, name);
    desk.window.grab().save(folder_of_pictures + "/" + QString::fromStdString(name) + suffix + ".png");
  }
};

/// Of what is open, from Label to Export: PREFIX_label and so on.
inline void take_each_workspace(Desk& desk, Photographer& photo, const std::string& prefix) {
  const char* names[] = {"label", "calibrate", "inspect", "explain", "export"};
  for (int i = 0; i < 5; ++i) {
    if (names[i] == std::string("explain"))
      ASSERT_TRUE(ExplainPage{desk}.open());
    else
      desk.key(Qt::Key_1 + i, Qt::ControlModifier);
    ASSERT_TRUE(desk.settle());
    photo.take(prefix + "_" + names[i]);
  }
}

/// Of a window of its own.
inline void take_dialog(QWidget& dialog, const std::string& name) {
  QTest::qWait(250);
  dialog.grab().save(folder_of_pictures + "/" + QString::fromStdString(name) + suffix + ".png");
}

}  // namespace handsight::test
