// SPDX-License-Identifier: Apache-2.0
// A collection in the window: opened like a session, shown session by session, what is shared changed, one more added.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTableWidget>
#include <QToolButton>
#include <QUrl>

#include "app/two_hands.h"
#include "app/window/pages.h"
#include "base/files.h"
#include "collection/share_dialog.h"
#include "export/export_workspace.h"
#include "session/calibration_xml.h"
#include "temporary_folder.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/observation_strip.h"
#include "widgets/plots/scatter_plot.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

class CollectionPage : public testing::Test {
 protected:
  void SetUp() override { file = two_hands(folder.path); }
  void open(const std::filesystem::path& path) {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(path.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(desk.document().model() && desk.document().model()->fit);
  }
  void go(int workspace) {
    desk.key(Qt::Key_0 + workspace, Qt::ControlModifier);
    desk.settle();
  }
  widgets::ObservationStrip* strip() { return desk.find<widgets::ObservationStrip>("strip"); }
  QToolButton* toggle(int session) {
    return desk.find<QToolButton>(QString("session_%1").arg(session).toUtf8().constData());
  }
  app::ShareDialog* dialog() {
    EXPECT_TRUE(desk.wait([this] { return desk.window.findChild<app::ShareDialog*>() != nullptr; }));
    return desk.window.findChild<app::ShareDialog*>();
  }
  void drop(const std::filesystem::path& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
    QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&desk.window, &enter);
    QDropEvent dropped(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&desk.window, &dropped);
    QTest::qWait(50);
  }

  TemporaryFolder folder;
  std::filesystem::path file;
  Desk desk;
};

TEST_F(CollectionPage, OpensLikeASessionWithItsSessionsNamed) {
  open(folder.path);
  EXPECT_EQ(desk.window.windowTitle(), "Both hands - Handsight");
  ASSERT_TRUE(desk.find<QWidget>("sessions")->isVisible());
  EXPECT_TRUE(toggle(0)->text().startsWith("right"));
  EXPECT_TRUE(toggle(1)->text().contains("px")) << toggle(1)->text().toStdString();
  ASSERT_EQ(strip()->cells().size(), 80U);
  EXPECT_EQ(strip()->cells().front().session, 0);
  EXPECT_EQ(strip()->cells().back().session, 1);
  desk.document().close();
  EXPECT_TRUE(desk.find<QWidget>("recent_0")->isVisible()) << "the start page offers it again";
}

TEST_F(CollectionPage, ASessionAloneHasNoRowOfSessions) {
  open(folder.path / "right");
  EXPECT_FALSE(desk.find<QWidget>("sessions")->isVisible());
  EXPECT_EQ(strip()->cells().front().session, -1);
}

TEST_F(CollectionPage, WhatIsHiddenIsHiddenInStripTableAndPlots) {
  open(file);
  go(3);
  InspectPage inspect{desk};
  EXPECT_EQ(inspect.table()->shown().size(), 80U);
  desk.click(toggle(0));
  EXPECT_FALSE(toggle(0)->isChecked());
  EXPECT_EQ(strip()->cells().size(), 40U);
  EXPECT_EQ(inspect.table()->shown().size(), 40U);
  desk.click(toggle(1));
  EXPECT_TRUE(toggle(1)->isChecked()) << "one at least is looked at";
  desk.click(toggle(1), toggle(1)->rect().center(), Qt::ShiftModifier);
  EXPECT_EQ(strip()->cells().size(), 80U) << "it was alone: all again";
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  const auto points = [this] {
    std::vector<widgets::ScatterPoint> all;
    for (auto* plot : desk.window.findChildren<widgets::ScatterPlot*>())
      if (plot->isVisible()) all.insert(all.end(), plot->points().begin(), plot->points().end());
    return all;
  };
  const auto all = points().size();
  ASSERT_GT(all, 0U);
  desk.press_button("session_marks");
  for (const widgets::ScatterPoint& p : points()) EXPECT_EQ(p.session, desk.document().find(p.observation)->part);
  desk.click(toggle(1));
  EXPECT_LT(points().size(), all);
  for (const widgets::ScatterPoint& p : points()) EXPECT_EQ(p.session, 0);
}

TEST_F(CollectionPage, EachHandStandsInCalibrateAndInTheModel) {
  open(file);
  go(2);
  auto* hands = desk.find<QTableWidget>("hands_table");
  ASSERT_TRUE(hands->isVisible());
  ASSERT_EQ(hands->columnCount(), 2);
  EXPECT_EQ(hands->horizontalHeaderItem(1)->text(), "left");
  EXPECT_TRUE(hands->item(0, 0)->text().contains("±"));
  EXPECT_NE(hands->item(0, 0)->text(), hands->item(0, 1)->text());
  EXPECT_FALSE(desk.find<QAbstractButton>("play")->isEnabled());
  EXPECT_TRUE(desk.find<QLabel>("play_progress")->text().contains("by itself"));
  desk.window.workbench().selection.select_observation(70);
  const Rigid left = desk.window.workbench().row(70)->root_from_tcp;
  desk.window.workbench().selection.select_observation(3);
  const Rigid right = desk.window.workbench().row(3)->root_from_tcp;
  EXPECT_GT((left.translation - right.translation).norm(), 0.05) << "another hand";
}

TEST_F(CollectionPage, WhatIsSharedIsChangedAndUndone) {
  open(file);
  ASSERT_EQ(desk.document().session().rig->count(), 2);
  desk.press_button("what_is_shared");
  app::ShareDialog* share = dialog();
  ASSERT_NE(share, nullptr);
  auto* rig = share->findChild<QCheckBox*>("share_rig");
  EXPECT_TRUE(rig->isChecked());
  EXPECT_FALSE(share->findChild<QCheckBox*>("share_body")->isChecked());
  EXPECT_FALSE(share->findChild<QCheckBox*>("share_robot")->isEnabled()) << "always";
  rig->click();
  EXPECT_EQ(desk.document().session().rig->count(), 4);
  EXPECT_EQ(desk.document().undo_stack().undoText(), "the cameras of left are not those of right");
  auto* body = share->findChild<QCheckBox*>("share_body");
  body->click();
  EXPECT_FALSE(body->isChecked()) << "two hands are not one";
  EXPECT_TRUE(share->findChild<QLabel*>("share_said")->text().contains("another TCP"))
      << share->findChild<QLabel*>("share_said")->text().toStdString();
  share->reject();
  ASSERT_TRUE(desk.settle());
  EXPECT_NE(desk.document().model()->fit, nullptr);
  desk.press_button("undo");
  EXPECT_EQ(desk.document().session().rig->count(), 2);
  ASSERT_TRUE(desk.settle());
  EXPECT_TRUE(desk.document().is_saved());
}

TEST_F(CollectionPage, ASessionDroppedOnAnOpenOneMakesACollectionWhereTheUserSays) {
  std::filesystem::remove(file);
  open(folder.path / "right");
  drop(folder.path / "left" / "session.xml");
  app::ShareDialog* add = dialog();
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->findChild<QLineEdit*>("collection_file")->text().toStdString(), file.string());
  add->findChild<QCheckBox*>("share_rig")->click();
  auto* body = add->findChild<QCheckBox*>("share_body");
  body->click();
  EXPECT_FALSE(add->findChild<QPushButton*>("add_it")->isEnabled()) << "said before the click";
  body->click();
  const QString where = QString::fromStdString((folder.path / "two.xml").string());
  add->findChild<QLineEdit*>("collection_file")->setText(where);
  add->findChild<QPushButton*>("add_it")->click();
  ASSERT_TRUE(desk.wait([&] { return desk.document().collection() != nullptr; }));
  EXPECT_EQ(desk.document().file(), folder.path / "two.xml");
  EXPECT_EQ(desk.document().session().parts.size(), 2U);
  EXPECT_EQ(desk.document().session().rig->count(), 2) << "one rig";
  ASSERT_TRUE(desk.settle());
}

TEST_F(CollectionPage, ASessionIsAddedToACollectionAndTakenBack) {
  write_hand(of_left_hand(read_session(folder.path / "right")), folder.path / "left_again", 9, 15);
  open(file);
  drop(folder.path / "left_again");
  app::ShareDialog* add = dialog();
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->findChild<QLineEdit*>("collection_file"), nullptr) << "it stands somewhere already";
  add->findChild<QPushButton*>("add_it")->click();
  EXPECT_EQ(desk.document().session().parts.size(), 3U);
  EXPECT_EQ(toggle(2)->accessibleName(), "left_again");
  ASSERT_TRUE(desk.settle());
  desk.press_button("undo");
  EXPECT_EQ(desk.document().session().parts.size(), 2U);
  ASSERT_TRUE(desk.settle());
  EXPECT_TRUE(desk.document().model()->fit);
}

TEST_F(CollectionPage, ExportWritesAllHands) {
  open(file);
  go(5);
  auto* hand = desk.find<QComboBox>("export_hand");
  ASSERT_TRUE(hand->isVisible());
  auto* motion = desk.find<QTableWidget>("motion");
  const QString right = motion->item(0, 1)->text();
  hand->setCurrentIndex(1);
  EXPECT_NE(motion->item(0, 1)->text(), right);
  desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString((folder.path / "both.xml").string()));
  desk.press_button("save_xml");
  const Calibration written = read_calibration(folder.path / "both.xml");
  ASSERT_EQ(written.sessions.size(), 2U);
  EXPECT_EQ(written.sessions[1].session, "left");
  EXPECT_NEAR((written.sessions[1].tcp_from_body.motion.translation -
               desk.document().model()->hands[1].tcp_from_body.translation)
                  .norm(),
              0, 1e-9);
}

TEST_F(CollectionPage, WhatAnotherProgramWroteIntoOneOfItsSessionsIsSeenAndNotWrittenOver) {
  open(file);
  Session left = read_session(folder.path / "left");
  left.observations[4].decision = Decision::excluded;
  left.observations[4].reason = "elsewhere, by somebody";
  save_session(left);
  auto* bar = desk.find<QWidget>("foreign");
  ASSERT_TRUE(desk.wait([&] { return bar->isVisible(); }, 10000));
  desk.window.workbench().exclude({2});
  desk.press_button("foreign_together");
  EXPECT_FALSE(desk.document().is_saved());
  EXPECT_EQ(read_session(folder.path / "left").observations[4].decision, Decision::excluded);
  desk.document().close();
  open(file);
  EXPECT_EQ(desk.document().find(2)->decision, Decision::excluded) << "on top of it";
  EXPECT_EQ(desk.document().find(44)->decision, Decision::excluded);
}

TEST_F(CollectionPage, EverySessionShowsItsOwnImages) {
  for (const auto& [name, grey] : {std::pair{"right", 60}, {"left", 200}}) {
    Session s = read_session(folder.path / name);
    const Camera& camera = s.rig->at(0).camera;
    QImage image(camera.width, camera.height, QImage::Format_Grayscale8);
    image.fill(grey);
    ASSERT_TRUE(image.save(QString::fromStdString((folder.path / name / "one.png").string())));
    for (Observation& o : s.observations) o.images[0] = o.images[1] = "one.png";
    s.source.reset();
    save_session(s);
  }
  std::string apart = read_file(file);
  for (std::size_t at; (at = apart.find(" rig=\"head\"")) != std::string::npos;) apart.erase(at, 11);
  replace_file(file, apart);
  open(file);
  ASSERT_EQ(desk.document().session().rig->count(), 4);
  go(3);
  const auto shown = [&](std::int64_t id) {
    desk.window.workbench().selection.select_observation(id);
    desk.settle();
    return qGray(desk.find<widgets::ImageView>("inspect_left")->image().pixel(5, 5));
  };
  EXPECT_EQ(shown(3), 60);
  EXPECT_EQ(shown(60), 200);
  EXPECT_EQ(desk.find<widgets::ImageView>("inspect_right")->image().isNull(), false);
}

TEST_F(CollectionPage, IsReadBesideTheWindowWhichGoesOn) {
  open(folder.path / "right");
  auto& workbench = desk.window.workbench();
  workbench.background.hold(true);
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(file.string())));
  EXPECT_LT(clock.elapsed(), 50 * patience) << "nothing is read while the window waits";
  EXPECT_TRUE(workbench.background.is_busy("opening"));
  EXPECT_EQ(desk.document().collection(), nullptr) << "what was open stays so long";
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(desk.find<QWidget>("inspect")->isVisible()) << "and can be worked with";
  workbench.background.hold(false);
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().collection(), nullptr);
  EXPECT_EQ(desk.window.windowTitle(), "Both hands - Handsight");
  // Another session that is opened meanwhile is the one that is wanted.
  desk.document().close();
  workbench.background.hold(true);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(file.string())));
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "left").string())));
  workbench.background.hold(false);
  ASSERT_TRUE(desk.settle());
  EXPECT_EQ(desk.document().collection(), nullptr);
}

TEST_F(CollectionPage, ThatCannotBeReadIsSaidOnTheStartPage) {
  std::filesystem::remove_all(folder.path / "left");
  desk.window.open(QString::fromStdString(file.string()));
  ASSERT_TRUE(desk.settle());
  EXPECT_FALSE(desk.document().is_open());
  bool is_said = false;
  for (const QLabel* label : desk.window.findChildren<QLabel*>())
    is_said = is_said || (label->isVisible() && label->text().contains("left"));
  EXPECT_TRUE(is_said) << "which session is missing";
}

}  // namespace
}  // namespace handsight::test
