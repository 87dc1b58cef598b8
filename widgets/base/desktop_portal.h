// SPDX-License-Identifier: GPL-3.0-or-later
// What the desktop says of the user's wishes, by the settings portal of freedesktop.org on the session's D-Bus.
#pragma once

#include <QString>
#include <QVariant>
#include <optional>

class QObject;

namespace handsight::widgets {

/// A setting as it stands, out of its wrappings; nothing where no portal knows it. Waits 0.3 s at most.
std::optional<QVariant> portal_setting(const QString& group, const QString& key);

/// From now on `receiver`'s slot setting_changed(QString group, QString key, QDBusVariant value) hears of changes.
void heed_portal(QObject* receiver);

/// The portal wraps its answers once or twice.
QVariant unwrapped(QVariant answer);

}  // namespace handsight::widgets
