// SPDX-License-Identifier: Apache-2.0
// A laptop's screen is enough: what stands round the centre is always on the screen.
#include <gtest/gtest.h>

#include <QScreen>

#include "app/window/pages.h"
#include "temporary_folder.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/three_numbers.h"
#include "workbench/preferences.h"

namespace handsight::test {
namespace {

class Screen : public testing::Test {
 protected:
  void open(const char* name = "hidden_3") {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, name).string())));
    ASSERT_TRUE(desk.settle());
  }
  bool is_inside(QWidget* widget) {
    const QRect there(widget->mapTo(&desk.window, QPoint()), widget->size());
    return widget->isVisible() && desk.window.rect().contains(there);
  }
  TemporaryFolder folder;
  Desk desk;
};

TEST_F(Screen, TheWindowOpensNoLargerThanItsScreen) {
  const QRect room = desk.window.screen()->availableGeometry();
  EXPECT_LE(desk.window.width(), room.width());
  EXPECT_LE(desk.window.height(), room.height());
  app::remember_preference("window size", "9000x7000");
  app::MainWindow other;
  EXPECT_LE(other.width(), room.width());
  EXPECT_LE(other.height(), room.height());
  app::remember_preference("window size", "1200x700");
  app::MainWindow remembered;
  EXPECT_EQ(remembered.size().boundedTo(QSize(1200, 700)), remembered.size());
  app::remember_preference("window size", "");
}

TEST_F(Screen, NumbersPanelAndStripStandOnEveryScreen) {
  open();
  // 1366 x 768 with a desktop's bars; half of 1920 x 1080, which is that screen at scale 2.
  for (const QSize size : {QSize(1366, 728), QSize(960, 508)}) {
    desk.window.resize(size);
    QTest::qWait(30);
    for (int workspace = 0; workspace < 6; ++workspace) {
      desk.key(Qt::Key_1 + workspace, Qt::ControlModifier);
      QTest::qWait(30);
      EXPECT_EQ(desk.window.size(), size) << "workspace " << workspace << " makes the window grow";
      EXPECT_TRUE(is_inside(desk.find<QWidget>("three_numbers"))) << workspace << " at " << size.width();
      EXPECT_TRUE(is_inside(desk.find<QWidget>("strip"))) << workspace << " at " << size.width();
      EXPECT_TRUE(is_inside(desk.find<QWidget>("rail_export"))) << workspace << " at " << size.width();
      auto* panel = desk.find<QWidget>("model_panel");
      EXPECT_TRUE(panel->isHidden() || is_inside(panel)) << workspace << " at " << size.width();
    }
  }
}

TEST_F(Screen, TheStartPageFillsALargeScreen) {
  auto* page = desk.find<QScrollArea>("start_page");
  // Sessions that were opened lately stand above the samples.
  const auto high = [&] {
    QRect all;
    for (auto* button : page->findChildren<QAbstractButton*>())
      if (button->objectName().startsWith("sample_")) all |= QRect(button->mapTo(page, QPoint()), button->size());
    return all.height();
  };
  desk.window.resize(1366, 768);
  QTest::qWait(30);
  EXPECT_LE(high(), 768 * 2 / 3) << "all samples on a laptop";
  desk.window.resize(1920, 1080);
  QTest::qWait(30);
  EXPECT_GT(high(), 1080 * 3 / 5) << "a third of the page is empty";
  EXPECT_LE(high(), 1080 * 3 / 4);
}

TEST_F(Screen, OnALaptopTheFirstCandidateCanBeAddedWithoutScrolling) {
  open();
  desk.window.resize(1366, 728);
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  ASSERT_TRUE(explain.can_add_first());
  QTest::qWait(30);
  QPushButton* own = explain.cards()->card(0)->add_button();
  QPushButton* add = own->visibleRegion().boundingRect() == own->rect() ? own : explain.cards()->add_button();
  EXPECT_FALSE(add->visibleRegion().isEmpty());
  EXPECT_EQ(add->visibleRegion().boundingRect(), add->rect()) << "the whole button is in sight";
  EXPECT_TRUE(is_inside(add));
  desk.click(add);
  EXPECT_TRUE(explain.workspace()->adding().is_running());
}

TEST_F(Screen, OnALaptopEveryWorkspacesMainButtonsAreInSight) {
  open("hundred_poses");
  desk.window.resize(1366, 728);
  LabelPage label{desk};
  desk.key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(label.corners_are_found());
  for (const Vector2& px : {Vector2(519, 98), Vector2(515, 132), Vector2(576, 113)}) label.click_left(px);
  const auto is_in_sight = [this](QWidget* widget) {
    QTest::qWait(30);
    return is_inside(widget) && widget->visibleRegion().boundingRect() == widget->rect();
  };
  for (auto* button : desk.find<QWidget>("triangle")->findChildren<QPushButton*>())
    if (button->text().contains("Use") || button->text().contains("Next")) {
      EXPECT_TRUE(is_in_sight(button)) << button->text().toStdString();
    }
  label.use();
  EXPECT_TRUE(is_in_sight(desk.find<QWidget>("play")));
  EXPECT_TRUE(is_in_sight(desk.find<QWidget>("ghost")));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  for (const char* name : {"exclude", "include", "look", "relabel", "exclude_beyond"})
    EXPECT_TRUE(is_in_sight(desk.find<QWidget>(name))) << name;
  desk.key(Qt::Key_6, Qt::ControlModifier);
  for (const char* name : {"experiment_driver", "experiment_try", "experiment_begin", "experiment_stop"})
    EXPECT_TRUE(is_in_sight(desk.find<QWidget>(name))) << name;
  desk.key(Qt::Key_5, Qt::ControlModifier);
  for (const char* name : {"export_path", "save_xml", "report_html", "report_pdf", "copy"})
    EXPECT_TRUE(is_in_sight(desk.find<QWidget>(name))) << name;
}

TEST_F(Screen, WhatAPlayWaitsForIsWholeOnASmallScreen) {
  open("hundred_poses");
  desk.key(Qt::Key_2, Qt::ControlModifier);
  desk.window.resize(1200, 700);
  QTest::qWait(30);
  const auto* progress = desk.find<QLabel>("play_progress");
  const QRect lines(0, 0, progress->width(), 1000);
  const int flags = progress->wordWrap() ? Qt::TextWordWrap : Qt::TextSingleLine;
  const QRect needed = progress->fontMetrics().boundingRect(lines, flags, progress->text());
  EXPECT_LE(needed.width(), progress->width()) << progress->text().toStdString();
  EXPECT_LE(needed.height(), progress->height() + 1) << progress->text().toStdString();
}

TEST_F(Screen, TheModelPanelIsFoldedWhereThereIsLittleRoom) {
  open();
  auto* panel = desk.find<widgets::ModelPanel>("model_panel");
  desk.key(Qt::Key_4, Qt::ControlModifier);
  desk.window.resize(1366, 728);
  QTest::qWait(30);
  EXPECT_TRUE(panel->is_folded());
  desk.key(Qt::Key_M);
  EXPECT_FALSE(panel->is_folded()) << "who wants it has it";
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_FALSE(panel->is_folded());
}

}  // namespace
}  // namespace handsight::test
