// SPDX-License-Identifier: Apache-2.0
// Keys and wheel do what they say wherever the focus is; jobs can be seen, stopped and left alone.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QScrollBar>
#include <QThread>
#include <QToolButton>
#include <atomic>

#include "app/window/pages.h"
#include "base/files.h"
#include "temporary_folder.h"
#include "widgets/base/read_out_line.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/lists/model_panel.h"

namespace handsight::test {
namespace {

class Manners : public testing::Test {
 protected:
  void open(const char* name) {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, name).string())));
    ASSERT_TRUE(desk.settle());
  }
  TemporaryFolder folder;
  Desk desk;
};

TEST_F(Manners, UndoReachesTheDocumentFromAnEmptyTextField) {
  open("thesis_simulation");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  desk.window.workbench().exclude({2});
  auto* field = desk.find<QWidget>("inspect_table")->findChild<QLineEdit*>();
  desk.click(field);
  ASSERT_TRUE(field->hasFocus());
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(desk.document().find(2)->decision, Decision::excluded);
  desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(desk.document().find(2)->decision, Decision::excluded);
  // What was typed is undone first.
  QTest::keyClick(desk.window.windowHandle(), 'x');
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(field->text(), "");
  EXPECT_EQ(desk.document().find(2)->decision, Decision::excluded);
}

/// Presses a key and says which observation is chosen then.
std::int64_t chosen_after(Desk& desk, Qt::Key key) {
  desk.key(key);
  return desk.window.workbench().selection.current().observation.value_or(-1);
}

TEST_F(Manners, LeftAndRightStepThroughTheObservationsFromBoxesRowsAndButtons) {
  open("thesis_simulation");
  desk.key(Qt::Key_2, Qt::ControlModifier);
  desk.window.workbench().selection.select_observation(2);
  auto* speed = desk.find<QComboBox>("speed");
  const int before = speed->currentIndex();
  speed->setFocus();
  ASSERT_TRUE(speed->hasFocus());
  EXPECT_EQ(chosen_after(desk, Qt::Key_Right), 3);
  EXPECT_EQ(chosen_after(desk, Qt::Key_Left), 2);
  EXPECT_EQ(speed->currentIndex(), before);
  desk.key(Qt::Key_Up);
  EXPECT_NE(speed->currentIndex(), before) << "the box is chosen from by up and down";
  auto* play = desk.find<QAbstractButton>("play");
  play->setFocus();
  EXPECT_EQ(chosen_after(desk, Qt::Key_Right), 3);
  EXPECT_TRUE(play->hasFocus());

  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  auto* table = desk.find<widgets::ObservationTable>("inspect_table");
  table->view()->setFocus();
  EXPECT_EQ(chosen_after(desk, Qt::Key_Right), 4);
  EXPECT_EQ(table->selected(), 4);
  EXPECT_EQ(chosen_after(desk, Qt::Key_Left), 3);
  auto* field = table->findChild<QLineEdit*>();
  desk.type_into(field, "a");
  EXPECT_EQ(chosen_after(desk, Qt::Key_Left), 3) << "in a text that is typed the arrows move in the text";
  EXPECT_EQ(field->cursorPosition(), 0);
}

TEST_F(Manners, TheWheelOverABoxWithoutFocusChangesNothing) {
  open("thesis_simulation");
  desk.key(Qt::Key_2, Qt::ControlModifier);
  auto* speed = desk.find<QComboBox>("speed");
  const int before = speed->currentIndex();
  desk.find<QWidget>("decisions")->setFocus();
  ASSERT_FALSE(speed->hasFocus());
  const QPoint at = speed->rect().center();
  QWheelEvent turn(at, speed->mapToGlobal(at), {}, QPoint(0, -120), Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(speed, &turn);
  EXPECT_EQ(speed->currentIndex(), before);
}

TEST_F(Manners, ANumberHalfTypedIsNeitherTakenNorLostWhenAFitEnds) {
  open("hidden_3");
  widgets::ModelPanel panel;
  widgets::ModelEffect effect{.id = "payload", .title = "Payload", .is_in_model = true};
  effect.parameters.push_back({.name = "mass", .value = 1.25, .unit = "kg", .can_hold = true, .is_held = true});
  panel.set_effects({effect});
  panel.show();
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  int taken = 0;
  QObject::connect(&panel, &widgets::ModelPanel::value_typed, [&] { ++taken; });
  auto* field = panel.findChild<QLineEdit*>("value_payload_0");
  ASSERT_NE(field, nullptr);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "2.");
  effect.parameters[0].value = 1.26;  // a fit has ended
  panel.set_effects({effect});
  QTest::qWait(20);
  EXPECT_EQ(taken, 0) << "half a number was taken for one";
  field = panel.findChild<QLineEdit*>("value_payload_0");
  EXPECT_EQ(field->text(), "2.");
  EXPECT_TRUE(field->hasFocus());
  QTest::keyClicks(field, "5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(taken, 1);
}

TEST_F(Manners, AFailedJobThatNobodyAnswersForSaysWhy) {
  open("thesis_simulation");
  desk.window.workbench().background.start<int>(
      "test", "Counting", [](app::JobControl&) -> int { throw std::runtime_error("The abacus is broken."); },
      [](int) {});
  auto* line = desk.find<widgets::ReadOutLine>("read_out");
  EXPECT_TRUE(desk.wait([&] { return line->message().contains("The abacus is broken."); }, 5000))
      << line->message().toStdString();
}

TEST_F(Manners, EveryLongJobCanBeStoppedInEveryWorkspace) {
  open("thesis_simulation");
  auto* cancel = desk.find<QToolButton>("cancel");
  for (const auto place : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_6}) {
    desk.key(place, Qt::ControlModifier);
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(desk.wait([&] { return !desk.window.workbench().explaining.is_busy(); }));
    std::atomic<bool> has_seen{false};
    desk.window.workbench().jobs.start<int>(
        "test", "Thinking",
        [&](app::JobControl& control) {
          while (!control.is_cancelled()) QThread::msleep(2);
          has_seen = true;
          return 0;
        },
        [](int) {});
    ASSERT_TRUE(desk.wait([&] { return cancel->isVisible(); }, 5000)) << "a job that does not say how far it is";
    desk.click(cancel);
    EXPECT_TRUE(desk.wait([&] { return has_seen.load(); }, 5000));
    EXPECT_TRUE(desk.wait([&] { return !cancel->isVisible(); }, 5000)) << "workspace " << place - Qt::Key_0;
  }
}

TEST_F(Manners, LeavingExplainAndMinimisingTheWindowStopNothing) {
  open("hidden_3");
  desk.key(Qt::Key_4, Qt::ControlModifier);
  auto& workbench = desk.window.workbench();
  ASSERT_TRUE(desk.wait([&] { return workbench.diagnosing.is_running() || workbench.diagnosing.diagnosis(); }, 20000));
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(desk.wait([&] { return workbench.diagnosing.diagnosis() != nullptr; }, 60000))
      << "what was begun comes to its end, and is there when one comes back";
}

TEST_F(Manners, AnotherSessionsScaleIsNotKept) {
  open("hidden_3");
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  auto* cloud = desk.find<widgets::ResidualCloud>("cloud");
  const double large = cloud->reach();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "thesis_simulation").string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_4, Qt::ControlModifier);
  ASSERT_TRUE(desk.wait([&] { return cloud->reach() > 0; }, 20000));
  EXPECT_LT(cloud->reach(), 0.5 * large) << "the rim of the session before";
}

TEST_F(Manners, AfterUndoTheAxesHoldWhatIsShown) {
  const auto session = copy_of_sample(folder.path, "hidden_3");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  auto* cloud = desk.find<widgets::ResidualCloud>("cloud");
  const double at_first = cloud->reach();
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.document().close();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  const double reopened = cloud->reach();
  ASSERT_LT(reopened, 0.5 * at_first) << "it opens with the effect in the model";
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_GT(cloud->reach(), 0.8 * at_first);
}

TEST_F(Manners, WhatIsOddInASessionIsSaidWhenItIsOpened) {
  open("thesis_simulation");
  auto* warnings = desk.find<QWidget>("doubts");
  EXPECT_FALSE(warnings->isVisible());
  const auto session = copy_of_sample(folder.path, "hidden_3");
  std::string text = read_file(session / "session.xml");
  for (std::size_t at = 0; (at = text.find("width=\"640\" height=\"480\"", at)) != std::string::npos; ++at)
    text.replace(at, 24, "width=\"480\" height=\"640\"");
  replace_file(session / "session.xml", text);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(warnings->isVisible());
  EXPECT_TRUE(desk.find<QLabel>("doubts_text")->text().contains("swapped"))
      << desk.find<QLabel>("doubts_text")->text().toStdString();
  desk.press_button("doubts_away");
  EXPECT_FALSE(warnings->isVisible());
}

TEST_F(Manners, AfterAddTheBestCardStandsOnTop) {
  open("hidden_6");
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  ASSERT_TRUE(explain.can_add_first());
  auto* area = explain.cards()->findChild<QScrollArea*>();
  explain.press_add();
  area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
  ASSERT_TRUE(explain.is_settled());
  QTest::qWait(30);
  EXPECT_EQ(area->verticalScrollBar()->value(), 0);
}

}  // namespace
}  // namespace handsight::test
