// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handsight::app {

/// "1 observation", "7 observations".
inline QString counted(qint64 count, const char* one, const char* many) {
  return QString::number(count) + ' ' + QString::fromUtf8(count == 1 ? one : many);
}

}  // namespace handsight::app
