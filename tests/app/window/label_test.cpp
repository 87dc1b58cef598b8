// SPDX-License-Identifier: Apache-2.0
// Labels: what was begun stays, whatever happens meanwhile, and whoever clicks need not know the order.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/window/pages.h"
#include "document/journal.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

const std::vector<Vector2> corners_of_first_steps = {{421, 338}, {408, 411}, {473, 378}};

class Label : public testing::Test {
 protected:
  void open(const char* name) {
    session = copy_of_sample(folder.path, name);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    desk.key(Qt::Key_1, Qt::ControlModifier);
    ASSERT_TRUE(label.corners_are_found()) << label.triangle().sentence.toStdString();
  }
  std::size_t placed() { return label.triangle().markers.size(); }
  /// The strip's cell of an observation.
  void choose(int index) {
    auto* strip = desk.find<widgets::ObservationStrip>("strip");
    desk.click(strip, strip->cell_rect(index).center().toPoint());
  }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  LabelPage label{desk};
  CalibratePage calibrate{desk};
};

TEST_F(Label, WhatIsHalfDoneOutlivesOtherActionsAndTheWindow) {
  open("first_steps");
  label.click_left(corners_of_first_steps[0]);
  label.click_left(corners_of_first_steps[1]);
  ASSERT_EQ(placed(), 2U);
  // Something else becomes of the document: another observation is left out, and that is undone.
  desk.window.workbench().exclude({5});
  EXPECT_EQ(placed(), 2U) << "an action elsewhere";
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(placed(), 2U) << "its undo";
  choose(3);
  EXPECT_EQ(placed(), 0U);
  choose(0);
  EXPECT_EQ(placed(), 2U) << "another observation and back";
  desk.document().close();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  desk.key(Qt::Key_1, Qt::ControlModifier);
  EXPECT_EQ(placed(), 2U) << "the journal";
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(placed(), 1U) << "each is undone by itself";
  EXPECT_TRUE(desk.document().session().observations[0].sightings.empty()) << "none of it is a label yet";
}

TEST_F(Label, CornersAreSoughtAgainAfterAnObservationWithoutImages) {
  open("hundred_poses");
  const auto& observations = desk.document().session().observations;
  ASSERT_FALSE(observations[0].images[0].empty());
  const auto without =
      std::find_if(observations.begin(), observations.end(), [](const Observation& o) { return o.images[0].empty(); });
  ASSERT_NE(without, observations.end());
  const int other = static_cast<int>(without - observations.begin());
  choose(other);
  desk.key(Qt::Key_2, Qt::ControlModifier);
  choose(0);
  desk.key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(label.corners_are_found());
  label.click_left({519, 98});
  EXPECT_EQ(placed(), 1U) << label.triangle().sentence.toStdString();
}

TEST_F(Label, ACorrectionMadeInInspectIsWhatLabelShows) {
  open("first_steps");
  for (const Vector2& px : corners_of_first_steps) label.click_left(px);
  label.use();
  // As Inspect moves a marker of the observation that Label shows.
  const Observation& o = desk.document().session().observations[0];
  EditableState after = read_state(o);
  seen_by(after.sightings[1], 0)->pixel += Vector2(3, 0);
  const Vector2 moved = seen_by(after.sightings[1], 0)->pixel;
  desk.document().perform(desk.document().make_edit("moved marker 1 of observation 0", {{0, after}}));
  desk.key(Qt::Key_1, Qt::ControlModifier);
  const auto& marks = label.left()->marks();
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_NEAR((marks[1].position - moved).norm(), 0, 1e-9);
}

TEST_F(Label, AGapInTheNumbersIsFilledAndTheNewMarkerIsChosen) {
  open("first_steps");
  for (const Vector2& px : corners_of_first_steps) label.click_left(px);
  desk.click(label.left(), label.left()->to_screen(corners_of_first_steps[0]).toPoint());
  desk.key(Qt::Key_Delete);
  ASSERT_EQ(placed(), 2U);
  label.click_left(corners_of_first_steps[0]);
  EXPECT_EQ(placed(), 3U);
  EXPECT_EQ(label.triangle().selected_marker, 0);
}

TEST_F(Label, ASecondClickOnTheSpotAndClicksBesideTheImagePlaceNothing) {
  open("first_steps");
  const QPoint at = label.left()->to_screen(corners_of_first_steps[0]).toPoint();
  QTest::mouseDClick(label.left(), Qt::LeftButton, {}, at);
  QTest::qWait(10);
  const QString said = label.triangle().sentence;
  EXPECT_LE(placed(), 1U);
  EXPECT_FALSE(said.contains("already")) << said.toStdString();
  const std::size_t before = placed();
  label.click_left({-20, 100}, Qt::AltModifier);
  label.click_left({700, 100}, Qt::AltModifier);
  EXPECT_EQ(placed(), before) << "outside the image there is nothing to see";
}

/// Whoever labels the first observation cannot know how the other observations number the markers.
class LabelOrder : public Label, public testing::WithParamInterface<int> {};

TEST_P(LabelOrder, TheMarkersAreNumberedByTheirSides) {
  open("hundred_poses");
  std::vector<Vector2> places = {{519, 98}, {515, 132}, {576, 113}};
  std::vector<int> order = {0, 1, 2};
  for (int i = 0; i < GetParam(); ++i) std::next_permutation(order.begin(), order.end());
  for (const int marker : order) label.click_left(places[static_cast<std::size_t>(marker)]);
  ASSERT_TRUE(label.triangle().can_use) << label.triangle().sentence.toStdString();
  EXPECT_EQ(label.triangle().sentence.contains("renumbered"), GetParam() != 0)
      << label.triangle().sentence.toStdString();
  if (GetParam() == 1) {  // it can be taken back
    const auto numbers = [this] {
      std::vector<double> at;
      for (const auto& mark : label.left()->marks()) at.push_back(mark.position.x());
      return at;
    };
    const auto renumbered = numbers();
    desk.press_button("triangle_action");
    EXPECT_NE(numbers(), renumbered);
    desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(numbers(), renumbered);
  }
  label.use();
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  std::vector<std::int64_t> rejected;
  for (const Observation& o : desk.document().session().observations)
    if (o.decision == Decision::rejected) rejected.push_back(o.id);
  EXPECT_EQ(rejected, (std::vector<std::int64_t>{58, 75, 98}));
}

INSTANTIATE_TEST_SUITE_P(AllSix, LabelOrder, testing::Range(0, 6));

}  // namespace
}  // namespace handsight::test
