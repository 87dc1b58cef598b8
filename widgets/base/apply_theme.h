// SPDX-License-Identifier: GPL-3.0-or-later
// The theme for the whole application: style, palette and fonts.
#pragma once

#include "widgets/base/theme.h"

class QApplication;

namespace handsight::widgets {

/// Fusion style, palette and fonts for the whole application; before the first show(), and again to change the theme.
/// Every widget gets a PaletteChange.
void apply_theme(QApplication& application, ThemeKind kind);

}  // namespace handsight::widgets
