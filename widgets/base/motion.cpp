// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/motion.h"

#include <array>
#include <utility>

#include "widgets/base/desktop_portal.h"

namespace handsight::widgets {
namespace {

const QString appearance_name = QStringLiteral("org.freedesktop.appearance"), reduced_motion = "reduced-motion";
const QString gnome_interface = QStringLiteral("org.gnome.desktop.interface"), animations_key = "enable-animations";

MotionChoice choice_ = MotionChoice::as_desktop;
/// By setting, the portal's own first: a desktop may have one of them or both.
std::array<std::optional<bool>, 2> wishes_;

std::size_t locate(const QString& group) { return group == appearance_name ? 0 : 1; }

}  // namespace

bool motion_is_reduced() {
  if (choice_ != MotionChoice::as_desktop) return choice_ == MotionChoice::reduced;
  return wishes_[0].value_or(wishes_[1].value_or(false));
}

void set_motion(MotionChoice choice) { choice_ = choice; }
MotionChoice motion() { return choice_; }

std::optional<bool> asks_for_less_motion(const QString& group, const QString& key, QVariant answer) {
  answer = unwrapped(answer);
  if (group == appearance_name && key == reduced_motion && answer.canConvert<unsigned>()) return answer.toUInt() == 1;
  if (group == gnome_interface && key == animations_key && answer.userType() == QMetaType::Bool)
    return !answer.toBool();
  return std::nullopt;
}

DesktopMotion::DesktopMotion(QObject* parent) : QObject(parent) {
  for (const auto& [group, key] :
       {std::pair{appearance_name, reduced_motion}, std::pair{gnome_interface, animations_key}})
    if (const auto answer = portal_setting(group, key))
      wishes_[locate(group)] = asks_for_less_motion(group, key, *answer);
  heed_portal(this);
}

void DesktopMotion::setting_changed(const QString& group, const QString& key, const QDBusVariant& value) {
  if (const auto wish = asks_for_less_motion(group, key, value.variant())) wishes_[locate(group)] = wish;
}

}  // namespace handsight::widgets
