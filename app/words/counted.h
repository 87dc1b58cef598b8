// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace handsight::app {

/// "1 observation", "7 observations": of a text like "%n observation(s)", in the plural form that the language has for
/// the number.
inline QString counted(qint64 count, const char* text) {
  QString reported = QCoreApplication::translate("counted", text, nullptr, static_cast<int>(count));
  return reported.replace("(s)", count == 1 ? "" : "s");  // English, where nothing translates it
}

}  // namespace handsight::app
