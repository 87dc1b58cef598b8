// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDBusVariant>
#include <QPalette>

#include "widgets/base/desktop_portal.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

const QString settings_group = QStringLiteral("org.freedesktop.appearance");
const QString settings_key = QStringLiteral("color-scheme");

ThemeKind kind_of_palette() {
  const QPalette palette = QApplication::palette();
  const bool text_is_lighter =
      palette.color(QPalette::WindowText).lightnessF() > palette.color(QPalette::Window).lightnessF();
  return text_is_lighter ? ThemeKind::dark : ThemeKind::light;
}

/// 1 means dark, 2 light, 0 no preference.
std::optional<ThemeKind> kind_of_answer(const QVariant& answer) {
  bool is_number = false;
  const unsigned scheme = answer.toUInt(&is_number);
  if (!is_number || scheme == 0) return std::nullopt;
  return scheme == 1 ? ThemeKind::dark : ThemeKind::light;
}

}  // namespace

DesktopTheme::DesktopTheme(QObject* parent) : QObject(parent), kind_(kind_of_palette()) {
  // Before show(): a wrong first frame would flash.
  if (const auto answer = portal_setting(settings_group, settings_key)) kind_ = kind_of_answer(*answer).value_or(kind_);
  heed_portal(this);
}

void DesktopTheme::setting_changed(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group != settings_group || key != settings_key) return;
  // Desktops that were dark and are so no longer say "no preference" (GNOME), not "light".
  const ThemeKind kind = kind_of_answer(unwrapped(value.variant())).value_or(ThemeKind::light);
  if (kind == kind_) return;
  kind_ = kind;
  emit changed(kind);
}

}  // namespace handsight::widgets
