// SPDX-License-Identifier: Apache-2.0
// A window that saves, exports and reports as fast as it can until it is killed, and says what it has done.
#pragma once

#include <QLineEdit>
#include <cstdio>

#include "app/document/killed_writer.h"
#include "app/window/desk.h"

namespace handsight::test {

/// --work-until-killed SESSION OUT: an action and a save, the calibration, both reports into the folder OUT, in turn;
/// after each that has returned prints its name.
inline int work_until_killed(const char* session, const char* out) {
  Desk desk;
  desk.window.open(session);
  if (!desk.settle()) return 3;
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.find<QLineEdit>("export_path")->setText(QString(out) + "/out.xml");
  const auto say = [](const char* what) {
    std::puts(what);
    std::fflush(stdout);
  };
  for (;;) {
    const int n = desk.document().undo_stack().index() + 1;
    desk.document().perform(numbered_action(desk.document(), n));
    say("action");
    desk.document().save();
    say("save");
    if (!desk.settle()) return 3;
    for (const char* button : {"save_xml", "report_html", "report_pdf"}) {
      desk.press_button(button);
      say(button);
    }
  }
}

}  // namespace handsight::test
