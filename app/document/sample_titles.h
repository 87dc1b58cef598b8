// SPDX-License-Identifier: GPL-3.0-or-later
// Titles of the sample sessions in the user's language. What a user's own session is called stays as it was written.
#pragma once

#include <QString>

namespace handsight::app {

/// The title as it is shown: that of a sample session in the user's language, any other as it is.
QString shown_title(const QString& title);

}  // namespace handsight::app
