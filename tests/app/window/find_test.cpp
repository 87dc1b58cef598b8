// SPDX-License-Identifier: Apache-2.0
// The box that finds everything, and panels that fill the centre.
#include <gtest/gtest.h>

#include <QListWidget>

#include "app/window/pages.h"
#include "temporary_folder.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/scene/robot_view.h"
#include "window/find_box.h"

namespace handsight::test {
namespace {

using app::FindEntry;

TEST(Found, WholeWordsComeFirstAndEveryWordCounts) {
  std::vector<FindEntry> entries = {{"action", "Save", "Ctrl+S", {}}};
  for (const int id : {1, 5, 15, 58, 158})
    entries.push_back({"observation", QString("observation %1").arg(id), {}, {}});
  ASSERT_EQ(app::found(entries, {}, 10).size(), 1U) << "without words only the actions";
  const auto five = app::found(entries, "5", 10);
  ASSERT_EQ(five.size(), 4U);
  EXPECT_EQ(five[0]->text, "observation 5");
  EXPECT_EQ(app::found(entries, "obs 58", 10)[0]->text, "observation 58");
  EXPECT_TRUE(app::found(entries, "58 save", 10).empty());
  EXPECT_EQ(app::found(entries, "ctrl+s", 10)[0]->text, "Save");
}

class Find : public testing::Test {
 protected:
  void SetUp() override {
    const auto session = copy_of_sample(folder.path, "thesis_simulation");
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
  }
  void find(const char* words) {
    desk.key(Qt::Key_K, Qt::ControlModifier);
    ASSERT_NE(desk.window.findChild<app::FindBox*>(), nullptr);
    for (const char* c = words; *c; ++c) QTest::keyClick(desk.window.windowHandle(), *c);
    desk.key(Qt::Key_Return);
    QTest::qWait(20);
    EXPECT_EQ(desk.window.findChild<app::FindBox*>(), nullptr) << "it goes with a choice";
  }
  TemporaryFolder folder;
  Desk desk;
};

TEST_F(Find, ActionsObservationsJointsAndEffects) {
  find("export");
  EXPECT_EQ(desk.window.workspace(), app::Place::write_out);
  find("observation 4");
  EXPECT_EQ(desk.window.workbench().selection.current().observation, 4);
  const std::string joint = desk.document().session().joints[1];
  find(joint.c_str());
  EXPECT_EQ(desk.window.workbench().selection.current().joint, joint);
  find("joint_elasticity");
  EXPECT_EQ(desk.window.workspace(), app::Place::explain);
  desk.key(Qt::Key_K, Qt::ControlModifier);
  desk.key(Qt::Key_Escape);
  EXPECT_EQ(desk.window.findChild<app::FindBox*>(), nullptr);
  EXPECT_EQ(desk.window.workspace(), app::Place::explain) << "Esc chooses nothing";
}

/// What stands on a button is found by its words.
TEST_F(Find, WhatStandsOnButtonsElsewhere) {
  const std::pair<const char*, const char*> words[] = {{"until", "Add until it stops"},
                                                       {"report", "Report as HTML"},
                                                       {"tour", "Tour: find the missing effect"},
                                                       {"urdf", "Save as URDF"},
                                                       {"mistake", "Look for mistakes of a whole kind"}};
  for (const auto& [word, text] : words) {
    desk.key(Qt::Key_K, Qt::ControlModifier);
    for (const char* c = word; *c; ++c) QTest::keyClick(desk.window.windowHandle(), *c);
    auto* list = desk.find<QListWidget>("find_list");
    ASSERT_GT(list->count(), 0);
    EXPECT_EQ(list->item(0)->text(), text) << word;
    desk.key(Qt::Key_Escape);
  }
  find("tour");
  EXPECT_EQ(desk.window.workspace(), app::Place::explain);
  EXPECT_TRUE(desk.find<QWidget>("tour")->isVisible());
}

TEST_F(Find, AnArrowKeyChoosesTheNextOne) {
  desk.key(Qt::Key_K, Qt::ControlModifier);
  auto* list = desk.find<QListWidget>("find_list");
  EXPECT_EQ(list->currentRow(), 0);
  desk.key(Qt::Key_Down);
  desk.key(Qt::Key_Down);
  EXPECT_EQ(list->item(list->currentRow())->text(), "Experiment");
  desk.key(Qt::Key_Return);
  QTest::qWait(20);
  EXPECT_EQ(desk.window.workspace(), app::Place::experiment);
}

TEST_F(Find, APanelFillsTheCentreAndEscPutsItBack) {
  desk.key(Qt::Key_2, Qt::ControlModifier);
  auto* scene = desk.find<widgets::RobotView>("calibrate_scene");
  auto* left = desk.find<widgets::ImageView>("calibrate_left");
  const QSize before = scene->size();
  desk.click(scene, {60, scene->height() / 2});
  scene->setFocus();
  desk.key(Qt::Key_Space, Qt::ShiftModifier);
  QTest::qWait(50);
  EXPECT_FALSE(left->isVisible());
  EXPECT_GT(scene->width(), 2 * before.width());
  EXPECT_GT(scene->height(), 1.5 * before.height());
  desk.key(Qt::Key_Escape);
  QTest::qWait(50);
  EXPECT_TRUE(left->isVisible());
  EXPECT_NEAR(scene->width(), before.width(), 2);
  EXPECT_TRUE(desk.window.workbench().selection.current().observation) << "Esc put back, and selected nothing else";

  QWindow* top = desk.window.windowHandle();
  QTest::mouseDClick(top, Qt::LeftButton, {}, left->mapTo(&desk.window, QPoint(40, 8)));
  QTest::qWait(50);
  EXPECT_FALSE(scene->isVisible());
  EXPECT_TRUE(left->isVisible());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  desk.key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(scene->isVisible()) << "another workspace ends it";
}

}  // namespace
}  // namespace handsight::test
