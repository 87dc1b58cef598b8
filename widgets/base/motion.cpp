// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/motion.h"

#include <array>
#include <utility>

#include "widgets/base/desktop_portal.h"

namespace handsight::widgets {
namespace {

const QString kAppearance = QStringLiteral("org.freedesktop.appearance"), kReducedMotion = "reduced-motion";
const QString kGnome = QStringLiteral("org.gnome.desktop.interface"), kAnimations = "enable-animations";

MotionChoice choice_ = MotionChoice::as_desktop;
/// By setting, the portal's own first: a desktop may have one of them or both.
std::array<std::optional<bool>, 2> wishes_;

std::size_t place_of(const QString& group) { return group == kAppearance ? 0 : 1; }

}  // namespace

bool motion_is_reduced() {
  if (choice_ != MotionChoice::as_desktop) return choice_ == MotionChoice::reduced;
  return wishes_[0].value_or(wishes_[1].value_or(false));
}

void set_motion(MotionChoice choice) { choice_ = choice; }
MotionChoice motion() { return choice_; }

std::optional<bool> asks_for_less_motion(const QString& group, const QString& key, QVariant answer) {
  answer = unwrapped(answer);
  if (group == kAppearance && key == kReducedMotion && answer.canConvert<unsigned>()) return answer.toUInt() == 1;
  if (group == kGnome && key == kAnimations && answer.userType() == QMetaType::Bool) return !answer.toBool();
  return std::nullopt;
}

DesktopMotion::DesktopMotion(QObject* parent) : QObject(parent) {
  for (const auto& [group, key] : {std::pair{kAppearance, kReducedMotion}, std::pair{kGnome, kAnimations}})
    if (const auto answer = portal_setting(group, key))
      wishes_[place_of(group)] = asks_for_less_motion(group, key, *answer);
  heed_portal(this);
}

void DesktopMotion::setting_changed(const QString& group, const QString& key, const QDBusVariant& value) {
  if (const auto wish = asks_for_less_motion(group, key, value.variant())) wishes_[place_of(group)] = wish;
}

}  // namespace handsight::widgets
