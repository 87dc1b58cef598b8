// SPDX-License-Identifier: Apache-2.0
// Words that once said another thing than what stood beside them: a few odd ones where all are, effects that a robot
// has no place for, a constant that "follows", a dash for what is not known.
#include <gtest/gtest.h>

#include "app/window/explain_fixture.h"
#include "app/window/reported_story.h"
#include "session/session_xml.h"
#include "widgets/images/image_view.h"

namespace handsight::test {
namespace {

class SameWords : public Explain {
 protected:
  Told reported{desk};
  void open_path(const std::filesystem::path& path) {
    desk.window.resize(1366, 768);
    session = path;
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(explain.open());
  }
  /// A copy of a real session; false: it is not here.
  bool open_real(const char* name) {
    const auto real = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / name;
    if (!std::filesystem::exists(real)) return false;
    std::filesystem::copy(real, folder.path / "copy", std::filesystem::copy_options::recursive);
    open_path(folder.path / "copy");
    return true;
  }
};

TEST_F(SameWords, WhereAllAreBeyondTheNoiseAFewOddOnesAreNotTheWord) {
  const auto path = make_copy("hidden_3");
  Session s = read_session(path);
  s.observations[5].decision = Decision::rejected;
  s.observations[5].reason = "a mark that is none";
  replace_session(s);
  open_path(path);
  ASSERT_TRUE(reported.story().many_beyond());
  EXPECT_EQ(reported.rail("rail_inspect").line,
            QString("%1 of %2 beyond 3 σ").arg(reported.story().beyond).arg(reported.story().used));
}

/// The histogram beside it counts them: nothing odd would be another word for the same picture.
TEST_F(SameWords, AFewBeyondTheNoiseAreNotNothing) {
  open_path(make_copy("hidden_6"));
  const Story& story = reported.story();
  ASSERT_GT(story.beyond, 0);
  ASSERT_FALSE(story.many_beyond());
  EXPECT_EQ(reported.rail("rail_inspect").line, QString("%1 of %2 beyond 3 σ").arg(story.beyond).arg(story.used));
}

TEST_F(SameWords, WhatTheRobotHasNoPlaceForIsNotSaidOfThePoses) {
  open("hidden_2");
  EXPECT_TRUE(explain.verdict().sentence.contains("could not show: base tilt"))
      << explain.verdict().sentence.toStdString();
  EXPECT_FALSE(explain.verdict().sentence.contains("mimic")) << "no joint of this robot follows another";
  const std::string printed = run_cli(folder.path, {"diagnose", session.string()}).output;
  EXPECT_NE(printed.find("could not show: base_tilt"), std::string::npos) << printed;
  EXPECT_EQ(printed.find("mimic"), std::string::npos) << printed;
}

TEST_F(SameWords, WhatIsTheSameInEveryPoseFollowsNothing) {
  open("hidden_7");
  ASSERT_EQ(explain.first().id, "link_geometry");
  ASSERT_TRUE(desk.wait([&] { return explain.first().evidence.contains("Its points"); }));
  EXPECT_TRUE(explain.first().evidence.startsWith("Its points say the same in every pose."))
      << explain.first().evidence.toStdString();
  EXPECT_TRUE(desk.find<QLabel>("proof_sentence")->text().contains("in every pose"));
}

TEST_F(SameWords, ACauseThatNoRobotHasIsNoProofAndItsBadgeSaysWhatTheRailSays) {
  if (!open_real("justin_right_even")) GTEST_SKIP() << "the real robot is not here";
  ASSERT_EQ(reported.story().state, StoryState::implausible);
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::implausible);
  EXPECT_EQ(reported.rail("rail_explain").line, "no plausible cause");
  auto* title = desk.find<QLabel>("failing_title");
  ASSERT_TRUE(desk.wait([&] { return desk.find<QAbstractButton>("tab_proof")->isVisible(); }));
  EXPECT_FALSE(title->text().contains("the proof")) << title->text().toStdString();
}

TEST_F(SameWords, WithoutKnownNoiseNothingIsSaidToStandOutOrNot) {
  if (!open_real("fr3_hand_eye_even")) GTEST_SKIP() << "the real robot is not here";
  ASSERT_FALSE(reported.story().error.noise);
  EXPECT_EQ(reported.rail("rail_inspect").line, "noise unknown");
  EXPECT_NE(reported.rail("rail_inspect").state, app::WorkState::done);
  EXPECT_EQ(explain.verdict().why_no_attribution, "whose fault: noise unknown");
  desk.press_button("until_it_stops");
  const auto* button = desk.find<QAbstractButton>("until_it_stops");
  ASSERT_TRUE(desk.wait([&] { return button->text() != "Stop"; }, 400000));
  ASSERT_TRUE(explain.is_settled());
  EXPECT_FALSE(explain.verdict().sentence.contains("against -")) << explain.verdict().sentence.toStdString();
  if (reported.story().state == StoryState::refused) EXPECT_EQ(reported.rail("rail_explain").line, "unexplained");
}

TEST_F(SameWords, OfTouchesLabelShowsWhatWasTouchedAndNoEmptyTriangle) {
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("probe_and_plate").string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_1, Qt::ControlModifier);
  desk.window.workbench().selection.select_observation(20);
  QTest::qWait(50);
  EXPECT_FALSE(desk.find<QWidget>("triangle")->isVisible());
  const auto* left = desk.find<widgets::ImageView>("label_left");
  EXPECT_GT(left->width(), left->parentWidget()->width() - 40) << "all the room is its";
  EXPECT_TRUE(left->accessibleDescription().contains("nothing to label"))
      << left->accessibleDescription().toStdString();
  EXPECT_TRUE(left->accessibleDescription().contains("plate_left"));
}

}  // namespace
}  // namespace handsight::test
