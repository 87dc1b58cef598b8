// SPDX-License-Identifier: Apache-2.0
// Pictures of a collection of both hands in every workspace, of what is shared, and of a session that is added.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "app/two_hands.h"
#include "collection/share_dialog.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

TEST(Pictures, OfACollection) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(two_hands(folder.path).string())));
  ASSERT_TRUE(desk.settle());
  desk.window.workbench().selection.select_observation(57);
  take_each_workspace(desk, photo, "both");
  if (testing::Test::HasFatalFailure()) return;
  desk.key(Qt::Key_4, Qt::ControlModifier);
  desk.press_button("session_marks");
  photo.take("both_marks");
  desk.press_button("session_0");
  photo.take("both_one_hidden");
  desk.press_button("session_0");
  desk.press_button("what_is_shared");
  ASSERT_TRUE(desk.wait([&] { return desk.window.findChild<app::ShareDialog*>() != nullptr; }));
  auto* shared = desk.window.findChild<app::ShareDialog*>();
  QTest::qWait(200);
  shared->grab().save(folder_of_pictures + "/both_shared" + suffix + ".png");
  shared->reject();
}

}  // namespace
}  // namespace handsight::test
