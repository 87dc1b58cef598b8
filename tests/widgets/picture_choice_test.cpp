// SPDX-License-Identifier: Apache-2.0
#include "widgets/base/picture_choice.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QSignalSpy>

#include "widgets/base/icons.h"
#include "widgets/mouse.h"

namespace handsight::widgets {
namespace {

const std::vector<PictureOption> places = {{"camera_on_stand", "On a stand", "It does not move."},
                                           {"camera_on_link", "On the robot", "On its head."},
                                           {"camera_on_hand", "On the hand", "It moves with it."}};

/// One is chosen at any time, by mouse or arrow keys; each choice is reported once.
TEST(PictureChoice, OneIsChosenByMouseOrKeys) {
  PictureChoice choice("place", places, 3);
  QSignalSpy chosen(&choice, &PictureChoice::chosen);
  test::show(choice, {400, 100});
  EXPECT_EQ(choice.current(), 0);
  auto* third = choice.findChild<QAbstractButton*>("place_2");
  ASSERT_NE(third, nullptr);
  test::click(third, third->rect().center());
  EXPECT_EQ(choice.current(), 2);
  choice.activateWindow();  // no window manager does it on a bare X server
  ASSERT_TRUE(QTest::qWaitForWindowActive(&choice));
  third->setFocus();
  QTest::keyClick(third, Qt::Key_Left);
  EXPECT_EQ(choice.current(), 1);
  choice.choose(1);  // it is already
  ASSERT_EQ(chosen.size(), 2);
  EXPECT_EQ(chosen[0][0].toInt(), 2);
  EXPECT_EQ(chosen[1][0].toInt(), 1);
}

TEST(PictureChoice, EachHasADrawingAndSaysWhatItIs) {
  PictureChoice choice("place", places, 3);
  for (int i = 0; i < 3; ++i) {
    const auto& option = places[static_cast<std::size_t>(i)];
    EXPECT_TRUE(has_icon(option.icon)) << option.icon.toStdString();
    auto* tile = choice.findChild<QAbstractButton*>(QString("place_%1").arg(i));
    ASSERT_NE(tile, nullptr);
    EXPECT_EQ(tile->accessibleName(), option.words);
    EXPECT_EQ(tile->accessibleDescription(), option.hint);
  }
}

}  // namespace
}  // namespace handsight::widgets
