// SPDX-License-Identifier: Apache-2.0
// Inspect: what is chosen is what is acted on, and a drag is one action.
#include <gtest/gtest.h>

#include "app/window/pages.h"
#include "base/files.h"
#include "document/journal.h"
#include "temporary_folder.h"
#include "widgets/plots/histogram_plot.h"

namespace handsight::test {
namespace {

class InspectTest : public testing::Test {
 protected:
  void open(const char* name) {
    session = copy_of_sample(folder.path, name);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    desk.key(Qt::Key_3, Qt::ControlModifier);
  }
  void click_row(int row, Qt::KeyboardModifiers keys = {}) {
    QTableView* view = inspect.table()->view();
    desk.click(view->viewport(), view->visualRect(view->model()->index(row, 1)).center(), keys);
  }
  std::size_t excluded() {
    const auto& all = desk.document().session().observations;
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](const Observation& o) { return o.decision == Decision::excluded; }));
  }
  std::uintmax_t journal_size() {
    std::uintmax_t sum = 0;
    for (const auto& file : std::filesystem::directory_iterator(app::state_folder() / "journals"))
      sum += std::filesystem::file_size(file);
    return sum;
  }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  InspectPage inspect{desk};
};

TEST_F(InspectTest, SeveralChosenRowsStayChosenAndDeleteTakesThemAll) {
  open("hidden_3");
  click_row(2);
  click_row(4, Qt::ShiftModifier);
  ASSERT_EQ(inspect.table()->selected_many().size(), 3U);
  EXPECT_EQ(desk.window.workbench().selection.many().size(), 3U);
  QTest::qWait(50);
  EXPECT_EQ(inspect.table()->selected_many().size(), 3U) << "what the selection tells back must not take them away";
  desk.key(Qt::Key_Delete);
  EXPECT_EQ(excluded(), 3U);
  ASSERT_TRUE(desk.settle());
  EXPECT_EQ(inspect.table()->selected_many().size(), 3U) << "they stay chosen when the fit has followed";
  desk.key(Qt::Key_Insert);
  EXPECT_EQ(excluded(), 0U);
}

TEST_F(InspectTest, NoRowIsCutWhateverTheHeight) {
  open("hundred_poses");
  for (const int height : {728, 735, 741, 760}) {
    desk.window.resize(1366, height);
    QTest::qWait(30);
    QTableView* view = inspect.table()->view();
    ASSERT_TRUE(view->isVisible());
    EXPECT_EQ(view->viewport()->height() % view->rowHeight(0), 0) << height;
  }
}

TEST_F(InspectTest, WhyAnObservationIsNotUsedStandsThereWhole) {
  desk.window.resize(1366, 768);
  open("hidden_3");
  auto* reason = desk.find<QLabel>("row_reason_line");
  EXPECT_FALSE(reason->isVisible()) << "all are used: no line is kept for it";
  const int why = 6;
  EXPECT_TRUE(inspect.table()->view()->isColumnHidden(why)) << "nor a column";
  click_row(2);
  desk.key(Qt::Key_Delete);
  ASSERT_TRUE(desk.settle());
  const std::string said =
      app::translated(desk.document().session().observations[2].reason).toStdString();  // of who excluded it
  ASSERT_FALSE(said.empty());
  EXPECT_NE(reason->text().toStdString().find(said), std::string::npos) << reason->text().toStdString();
  EXPECT_GE(reason->height(), reason->heightForWidth(reason->width()));
}

TEST_F(InspectTest, OneOfSeveralCanBeChosenAlone) {
  open("hidden_3");
  click_row(2);
  click_row(4, Qt::ShiftModifier);
  click_row(2);
  EXPECT_LE(desk.window.workbench().selection.many().size(), 1U);
  desk.key(Qt::Key_Delete);
  EXPECT_EQ(excluded(), 1U);
}

TEST_F(InspectTest, ADragIsWrittenDownAndFittedOnce) {
  open("hundred_poses");
  const auto& observations = desk.document().session().observations;
  std::size_t index = 0;
  while (observations[index].sightings.empty()) ++index;
  const std::int64_t id = observations[index].id;
  desk.window.workbench().selection.select_observation(id);
  QTest::qWait(50);  // the sentence of this observation has another height
  auto* view = desk.find<widgets::ImageView>("inspect_left");
  const Vector2 before = seen_by(observations[index].sightings[0], 0)->pixel;
  const QPoint from = view->to_screen(before).toPoint();
  const int revisions = static_cast<int>(desk.document().undo_stack().count());
  const std::uintmax_t written = journal_size();
  QWindow* top = view->window()->windowHandle();
  const QPoint a = view->mapTo(view->window(), from);
  QTest::mousePress(top, Qt::LeftButton, {}, a);
  for (int i = 1; i <= 6; ++i) {
    QTest::mouseMove(top, a + QPoint(4 * i, 2 * i));
    QTest::qWait(5);
    EXPECT_EQ(journal_size(), written) << "nothing is written while it is dragged";
    EXPECT_EQ(seen_by(desk.document().find(id)->sightings[0], 0)->pixel, before);
  }
  for (const auto& mark : view->marks())
    if (mark.marker == observations[index].sightings[0].marker && mark.role == widgets::MarkRole::measured) {
      EXPECT_GT((mark.position - before).norm(), 1) << "but the mark moves along";
    }
  QTest::mouseRelease(top, Qt::LeftButton, Qt::AltModifier, a + QPoint(24, 12));
  QTest::qWait(5);
  EXPECT_EQ(desk.document().undo_stack().count(), revisions + 1);
  EXPECT_GT((seen_by(desk.document().find(id)->sightings[0], 0)->pixel - before).norm(), 1);
}

TEST_F(InspectTest, KeysOnAMarkerDoWhatTheMenuSays) {
  open("hundred_poses");
  const auto& observations = desk.document().session().observations;
  std::size_t index = 0;
  while (observations[index].sightings.size() < 3) ++index;
  const std::int64_t id = observations[index].id;
  desk.window.workbench().selection.select_observation(id);
  auto* view = desk.find<widgets::ImageView>("inspect_left");
  const Vector2 first = seen_by(observations[index].sightings[0], 0)->pixel;
  desk.click(view, view->to_screen(first).toPoint());
  ASSERT_EQ(desk.window.workbench().selection.current().marker, 0);
  desk.key(Qt::Key_2);
  EXPECT_EQ(seen_by(desk.document().find(id)->sightings[2], 0)->pixel, first) << "2 makes it marker 2";
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  desk.click(view, view->to_screen(first).toPoint());
  desk.key(Qt::Key_Delete);
  EXPECT_EQ(desk.document().find(id)->sightings.size(), 2U);
}

TEST_F(InspectTest, TheThresholdOfOneSessionIsNotThatOfTheNext) {
  open("hidden_3");
  auto* histogram = desk.find<widgets::HistogramPlot>("histogram");
  ASSERT_TRUE(histogram->threshold());
  histogram->set_threshold(123.0);
  const auto other = copy_of_sample(folder.path, "thesis_simulation");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(other.string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_NE(histogram->threshold(), 123.0);
}

}  // namespace
}  // namespace handsight::test
