// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/desktop_portal.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>

namespace handsight::widgets {
namespace {

const QString service_name = QStringLiteral("org.freedesktop.portal.Desktop");
const QString object_path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString interface_name = QStringLiteral("org.freedesktop.portal.Settings");

/// Without a session bus there is nobody to ask; connecting would only print a warning.
std::optional<QDBusConnection> session_bus() {
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return std::nullopt;
  const QDBusConnection bus = QDBusConnection::sessionBus();
  return bus.isConnected() ? std::optional(bus) : std::nullopt;
}

}  // namespace

QVariant unwrapped(QVariant answer) {
  while (answer.userType() == qMetaTypeId<QDBusVariant>()) answer = answer.value<QDBusVariant>().variant();
  return answer;
}

std::optional<QVariant> portal_setting(const QString& group, const QString& key) {
  const auto bus = session_bus();
  if (!bus) return std::nullopt;
  QDBusMessage question =
      QDBusMessage::createMethodCall(service_name, object_path, interface_name, QStringLiteral("Read"));
  question << group << key;
  const QDBusMessage answer = bus->call(question, QDBus::Block, 300);
  if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) return std::nullopt;
  return unwrapped(answer.arguments().constFirst());
}

void heed_portal(QObject* receiver) {
  if (auto bus = session_bus())
    bus->connect(service_name, object_path, interface_name, QStringLiteral("SettingChanged"), receiver,
                 SLOT(setting_changed(QString, QString, QDBusVariant)));
}

}  // namespace handsight::widgets
