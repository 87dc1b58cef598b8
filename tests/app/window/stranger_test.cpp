// SPDX-License-Identifier: Apache-2.0
// The check by a stranger on a laptop: opened with one click, without help, the window says how far off the model is,
// who is to blame, what is missing, and what to click. How long it takes is measured by benchmark_stranger.
#include "app/window/stranger.h"

#include <gtest/gtest.h>

namespace handsight::test {
namespace {

class StrangersCheck : public testing::TestWithParam<const char*> {};

TEST_P(StrangersCheck, FourAnswersStandOnTheScreenAndTheButtonKeepsItsWord) {
  Desk desk;
  Stranger stranger{desk};
  stranger.sit_down();
  stranger.click_sample(GetParam());
  ASSERT_EQ(desk.window.workspace(), app::Place::explain) << "nothing is to be labelled or played";
  ASSERT_TRUE(stranger.explain.is_settled());
  QTest::qWait(50);
  EXPECT_TRUE(stranger.reads_how_far_off()) << Stranger::painted(stranger.verdict_line()).toStdString();
  EXPECT_TRUE(stranger.reads_whose_fault()) << Stranger::painted(stranger.verdict_line()).toStdString();
  const QString missing = stranger.reads_what_is_missing();
  EXPECT_FALSE(missing.isEmpty()) << stranger.explain.first().title.toStdString();
  QPushButton* add = stranger.finds_the_button();
  ASSERT_NE(add, nullptr);
  const double before = *desk.document().model()->report->held_out.rms_pixel;
  desk.click(add);
  ASSERT_TRUE(stranger.explain.is_settled());
  const double after = *desk.document().model()->report->held_out.rms_pixel;
  EXPECT_LT(after, before) << missing.toStdString();
  EXPECT_TRUE(desk.document().model()->settings.has_effects());
}

INSTANTIATE_TEST_SUITE_P(OnALaptop, StrangersCheck,
                         testing::Values("sample_hidden_3", "sample_hidden_6", "sample_hidden_8"),
                         [](const auto& session) { return std::string(session.param).substr(7); });

}  // namespace
}  // namespace handsight::test
