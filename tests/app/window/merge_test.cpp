// SPDX-License-Identifier: Apache-2.0
// Another program writes the session that is open: what collides is shown, both sides, and one chooses.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "app/window/pages.h"
#include "base/files.h"
#include "merge/merge_page.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

class MergeInTheWindow : public testing::Test {
 protected:
  void SetUp() override {
    session = copy_of_sample(folder.path, "hidden_2");
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
  }
  void exclude_here(std::vector<std::int64_t> ids) {
    desk.window.workbench().exclude(ids);
    ASSERT_TRUE(desk.settle());
  }
  void write_there(const std::function<void(Session&)>& change) {
    Session s = read_session(session);
    change(s);
    replace_session(s);
  }
  static void exclude(Session& s, std::size_t index) {
    s.observations[index].decision = Decision::excluded;
    s.observations[index].reason = "there";
  }
  QTableWidget* table() { return desk.find<QTableWidget>("merge_table"); }
  void click_cell(int row, int column) {
    desk.click(table()->viewport(), table()->visualRect(table()->model()->index(row, column)).center());
  }
  bool is_asking() { return desk.find<app::MergePage>("merge")->isVisible(); }

  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
};

TEST_F(MergeInTheWindow, WhatAnotherProgramWritesIsSaidSoonAndPutTogetherAtAPress) {
  auto* bar = desk.find<QWidget>("foreign");
  QTest::qWait(300);
  EXPECT_FALSE(bar->isVisible()) << "nobody has written";
  exclude_here({3});
  desk.key(Qt::Key_S, Qt::ControlModifier);
  QTest::qWait(2500);
  EXPECT_FALSE(bar->isVisible()) << "what is saved here is no news";
  exclude_here({4});
  write_there([](Session& s) { exclude(s, 7); });
  ASSERT_TRUE(desk.wait([&] { return bar->isVisible(); }));
  EXPECT_EQ(desk.document().session().observations[7].decision, Decision::none) << "nothing is taken over unasked";
  desk.press_button("foreign_together");
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(is_asking());
  EXPECT_EQ(desk.document().session().observations[7].reason, "there");
  const Session s = read_session(session);
  EXPECT_EQ(s.observations[4].reason, "by the user");
  EXPECT_EQ(s.observations[7].reason, "there");
}

TEST_F(MergeInTheWindow, WhatIsPutOffIsNotSaidAgainUntilASave) {
  auto* bar = desk.find<QWidget>("foreign");
  write_there([](Session& s) { exclude(s, 7); });
  ASSERT_TRUE(desk.wait([&] { return bar->isVisible(); }));
  desk.press_button("foreign_later");
  EXPECT_FALSE(bar->isVisible());
  write_there([](Session& s) { exclude(s, 8); });
  QTest::qWait(2500);
  EXPECT_FALSE(bar->isVisible());
  exclude_here({3});
  desk.key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(desk.document().session().observations[8].reason, "there");
  write_there([](Session& s) { exclude(s, 9); });
  EXPECT_TRUE(desk.wait([&] { return bar->isVisible(); }));
}

TEST_F(MergeInTheWindow, WhatCollidesIsAskedOnItsPageAndNotTwice) {
  exclude_here({1});
  write_there([](Session& s) { exclude(s, 1); });
  auto* bar = desk.find<QWidget>("foreign");
  ASSERT_TRUE(desk.wait([&] { return bar->isVisible(); }));
  desk.press_button("foreign_together");
  EXPECT_TRUE(is_asking());
  EXPECT_FALSE(bar->isVisible());
}

TEST_F(MergeInTheWindow, BothSidesAreShownAndOneChoosesRowByRow) {
  const app::Place place = desk.window.workspace();
  exclude_here({1, 2, 3});
  write_there([](Session& s) {
    exclude(s, 1);
    exclude(s, 2);
    exclude(s, 7);
  });
  desk.key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(is_asking());
  ASSERT_EQ(table()->rowCount(), 2);
  EXPECT_EQ(table()->item(0, 0)->text(), "1");
  EXPECT_EQ(table()->item(0, 2)->text(), "excluded: by the user");
  EXPECT_EQ(table()->item(0, 3)->text(), "excluded: there");
  click_cell(1, 3);
  EXPECT_EQ(table()->item(1, 3)->checkState(), Qt::Checked);
  EXPECT_EQ(table()->item(1, 2)->checkState(), Qt::Unchecked);
  EXPECT_EQ(desk.window.workbench().selection.current().observation, 2) << "what is looked at is selected everywhere";
  desk.press_button("merge_decide");
  EXPECT_FALSE(is_asking());
  EXPECT_EQ(desk.window.workspace(), place);
  const Session s = read_session(session);
  EXPECT_EQ(s.observations[1].reason, "by the user");
  EXPECT_EQ(s.observations[2].reason, "there");
  EXPECT_EQ(s.observations[3].reason, "by the user");
  EXPECT_EQ(s.observations[7].reason, "there");
  EXPECT_TRUE(desk.document().is_saved());
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(desk.document().session().observations[7].decision, Decision::none);
  EXPECT_EQ(desk.document().session().observations[2].reason, "by the user");
}

TEST_F(MergeInTheWindow, AllAtOnceOrNotNow) {
  exclude_here({1, 2});
  write_there([](Session& s) {
    exclude(s, 1);
    exclude(s, 2);
  });
  const std::string theirs = read_file(session / "session.xml");
  desk.key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(is_asking());
  desk.press_button("merge_later");
  EXPECT_FALSE(is_asking());
  EXPECT_EQ(read_file(session / "session.xml"), theirs);
  desk.key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(is_asking());
  desk.press_button("merge_all_theirs");
  desk.press_button("merge_decide");
  EXPECT_EQ(desk.document().session().observations[1].reason, "there");
  EXPECT_EQ(desk.document().session().observations[2].reason, "there");
  EXPECT_TRUE(desk.document().is_saved());
}

TEST_F(MergeInTheWindow, WhatDoesNotCollideIsTakenInWithoutAsking) {
  exclude_here({1});
  write_there([](Session& s) { exclude(s, 7); });
  desk.key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(is_asking());
  EXPECT_EQ(read_session(session).observations[1].reason, "by the user");
  EXPECT_EQ(read_session(session).observations[7].reason, "there");
  ASSERT_TRUE(desk.settle());
  EXPECT_EQ(desk.document().model()->revision, desk.document().revision()) << "and fitted with it";
}

TEST_F(MergeInTheWindow, OnALaptopNothingIsCut) {
  desk.window.resize(1366, 728);
  std::vector<std::int64_t> all;
  for (std::int64_t id = 0; id < 40; ++id) all.push_back(id);
  exclude_here(all);
  write_there([](Session& s) {
    for (std::size_t i = 0; i < 40; ++i) exclude(s, i);
  });
  desk.key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(is_asking());
  QTest::qWait(30);
  EXPECT_EQ(desk.window.size(), QSize(1366, 728));
  for (const char* name : {"merge_table", "merge_all_mine", "merge_all_theirs", "merge_later", "merge_decide"}) {
    auto* widget = desk.find<QWidget>(name);
    EXPECT_EQ(widget->visibleRegion().boundingRect(), widget->rect()) << name;
  }
}

}  // namespace
}  // namespace handsight::test
