// SPDX-License-Identifier: GPL-3.0-or-later
// Theme, motion and language: as the desktop has them, or as the user chose, which is remembered.
#pragma once

#include <QObject>
#include <array>

#include "widgets/base/motion.h"
#include "widgets/base/theme.h"

class QAction;
class QApplication;
class QMenu;

namespace handsight::app {

class Appearance : public QObject {
  Q_OBJECT

 public:
  enum class ThemeChoice { as_desktop, light, dark };

  /// Before the first window is shown. `named`: a theme for this start alone ("light", "dark"), empty: what was chosen.
  Appearance(QApplication& application, const QString& named);

  /// The choices as entries of a menu, each with a mark at the one in force.
  void add_to(QMenu& menu, QAction* before);
  void choose(ThemeChoice theme);
  void choose(widgets::MotionChoice motion);
  /// From the next start on: "en", "de"; empty: the desktop's.
  void choose_language(const QString& language);
  ThemeChoice theme() const { return theme_; }

 private:
  void apply();

  QApplication& application_;
  widgets::DesktopTheme desktop_theme_;
  widgets::DesktopMotion desktop_motion_;
  ThemeChoice theme_ = ThemeChoice::as_desktop;
};

}  // namespace handsight::app
