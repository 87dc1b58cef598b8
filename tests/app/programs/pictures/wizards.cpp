// SPDX-License-Identifier: Apache-2.0
// Pictures of the wizards that make sessions.
#include <gtest/gtest.h>

#include <QDialog>
#include <QScrollBar>

#include "app/programs/pictures/photographer.h"
#include "wizard/files_wizard.h"

namespace handsight::test {
namespace {

/// Its fields are below each other: those that are filled in are scrolled to.
TEST(Pictures, OfTheWizard) {
  Desk desk;
  desk.press_button("start_new");
  auto* wizard = desk.window.findChild<QDialog*>("wizard");
  ASSERT_NE(wizard, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  auto* scroll = desk.find<QScrollArea>("wizard_scroll");
  const auto take = [&](const char* name) { take_dialog(*wizard, name); };
  const auto fill = [&](const char* name, const QString& with) {
    auto* field = desk.find<QLineEdit>(name);
    scroll->ensureWidgetVisible(field);
    QTest::qWait(10);
    desk.type_into(field, with);
  };
  take("wizard_empty");
  const auto samples = QString(HANDSIGHT_SOURCE_DIR) + "/sample_sessions";
  fill("wizard_robot", samples + "/robots/six_axis.urdf");
  const auto answer = [&](const char* tile) {
    scroll->ensureWidgetVisible(desk.find<QAbstractButton>(tile));
    desk.press_button(tile);
  };
  answer("camera_place_0");
  answer("known_2");
  desk.find<QComboBox>("wizard_tcp")->setCurrentText("hand");
  take("wizard");
  fill("wizard_angles", samples + "/nowhere.csv");
  scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
  take("wizard_files");
  answer("camera_place_2");
  answer("known_6");
  scroll->verticalScrollBar()->setValue(0);
  take("wizard_on_hand");
  static_cast<QDialog*>(wizard)->reject();
}

TEST(Pictures, OfTheWizardOfFiles) {
  Desk desk;
  desk.window.resize(window_size());
  const auto samples = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions";
  auto* wizard = desk.window.bring_files({});
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  const auto take = [&](const char* name) { take_dialog(*wizard, name); };
  take("files_empty");
  wizard->add({samples / "robots/six_axis.urdf", samples / "first_steps/images", samples / "README.md"});
  take("files");
  static_cast<QDialog*>(wizard)->reject();
}

}  // namespace
}  // namespace handsight::test
