// SPDX-License-Identifier: Apache-2.0
// What a desktop's settings say of motion, in the wrappings in which its portal sends them.
#include "widgets/base/motion.h"

#include <gtest/gtest.h>

namespace handsight::widgets {
namespace {

QVariant wrapped(const QVariant& value) { return QVariant::fromValue(QDBusVariant(value)); }

TEST(Motion, TheDesktopsWordsAreUnderstood) {
  const QString portal = "org.freedesktop.appearance", gnome = "org.gnome.desktop.interface";
  EXPECT_EQ(asks_for_less_motion(portal, "reduced-motion", wrapped(wrapped(1U))), true);
  EXPECT_EQ(asks_for_less_motion(portal, "reduced-motion", wrapped(0U)), false);
  EXPECT_EQ(asks_for_less_motion(gnome, "enable-animations", wrapped(false)), true);
  EXPECT_EQ(asks_for_less_motion(gnome, "enable-animations", true), false);
  EXPECT_EQ(asks_for_less_motion(gnome, "enable-animations", wrapped("no")), std::nullopt);
  EXPECT_EQ(asks_for_less_motion(portal, "color-scheme", wrapped(1U)), std::nullopt) << "that is the theme";
}

TEST(Motion, TheUsersChoiceStandsOverTheDesktops) {
  set_motion(MotionChoice::reduced);
  EXPECT_TRUE(motion_is_reduced());
  set_motion(MotionChoice::full);
  EXPECT_FALSE(motion_is_reduced());
  set_motion(MotionChoice::as_desktop);
  EXPECT_FALSE(motion_is_reduced()) << "no desktop, no wish";
}

}  // namespace
}  // namespace handsight::widgets
