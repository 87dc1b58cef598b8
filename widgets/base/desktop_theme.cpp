// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDBusConnection>
#include <QDBusConnectionInterface>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QPalette>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kKey = QStringLiteral("color-scheme");

ThemeKind kind_of_palette() {
  const QPalette palette = QApplication::palette();
  const bool text_is_lighter =
      palette.color(QPalette::WindowText).lightnessF() > palette.color(QPalette::Window).lightnessF();
  return text_is_lighter ? ThemeKind::dark : ThemeKind::light;
}

/// The portal wraps its answer once or twice; 1 means dark, 2 light, 0 no preference.
std::optional<ThemeKind> kind_of_answer(QVariant answer) {
  while (answer.canConvert<QDBusVariant>() && answer.userType() == qMetaTypeId<QDBusVariant>())
    answer = answer.value<QDBusVariant>().variant();
  bool is_number = false;
  const unsigned scheme = answer.toUInt(&is_number);
  if (!is_number || scheme == 0) return std::nullopt;
  return scheme == 1 ? ThemeKind::dark : ThemeKind::light;
}

}  // namespace

DesktopTheme::DesktopTheme(QObject* parent) : QObject(parent), kind_(kind_of_palette()) {
  // Without a session bus there is nobody to ask; connecting would only print a warning.
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  QDBusMessage question = QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
  question << kGroup << kKey;
  const QDBusMessage answer = bus.call(question, QDBus::Block, 300);  // before show(): a wrong first frame would flash
  if (answer.type() == QDBusMessage::ReplyMessage && !answer.arguments().isEmpty())
    kind_ = kind_of_answer(answer.arguments().constFirst()).value_or(kind_);
  bus.connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(setting_changed(QString, QString, QDBusVariant)));
}

void DesktopTheme::setting_changed(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group != kGroup || key != kKey) return;
  // Desktops that were dark and are so no longer say "no preference" (GNOME), not "light".
  const ThemeKind kind = kind_of_answer(value.variant()).value_or(ThemeKind::light);
  if (kind == kind_) return;
  kind_ = kind;
  emit changed(kind);
}

}  // namespace handsight::widgets
