// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what changes may move on its way there. Everything that moves in the window asks here.
#pragma once

#include <QDBusVariant>
#include <QObject>
#include <optional>

namespace handsight::widgets {

/// How long what only changes its form moves (ms).
constexpr int short_motion = 160;

enum class MotionChoice { as_desktop, full, reduced };

/// Is nothing to move: by the user's choice, else because the desktop says so?
bool motion_is_reduced();
void set_motion(MotionChoice choice);
MotionChoice motion();

/// What a setting of the desktop's portal says of motion; nothing where it says nothing of it. Reduced:
/// "reduced-motion" of org.freedesktop.appearance is 1, or "enable-animations" of org.gnome.desktop.interface is false.
std::optional<bool> asks_for_less_motion(const QString& group, const QString& key, QVariant answer);

/// What the desktop prefers, and word of changes, by D-Bus from the portal. Without one: full motion.
class DesktopMotion : public QObject {
  Q_OBJECT
 public:
  explicit DesktopMotion(QObject* parent = nullptr);
 private slots:
  void setting_changed(const QString& group, const QString& key, const QDBusVariant& value);
};

}  // namespace handsight::widgets
