// SPDX-License-Identifier: GPL-3.0-or-later
// What the user chose for the window itself, remembered from start to start.
#pragma once

#include <QString>

namespace handsight::app {

/// The choice of this name; empty where none was made.
QString preference(const QString& name);
void remember_preference(const QString& name, const QString& choice);

}  // namespace handsight::app
