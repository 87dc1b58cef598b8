// SPDX-License-Identifier: Apache-2.0
// The check by a stranger on a laptop: opened with one click, without help, the window says how far off the model is,
// who is to blame, what is missing, and what to click; once each, and alike everywhere. How long it takes is measured
// by benchmark_stranger.
#include "app/window/stranger.h"

#include <gtest/gtest.h>

#include "app/window/reported_story.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

struct Seen {
  const char* name;
  std::string session;  // a sample, or the folder of a session below the shared ones
};

std::ostream& operator<<(std::ostream& out, const Seen& seen) { return out << seen.name; }

class StrangersCheck : public testing::TestWithParam<Seen> {
 protected:
  static std::filesystem::path shared() { return std::filesystem::path(HANDSIGHT_SHARED_DIR) / GetParam().session; }
  static bool is_sample() { return GetParam().session.find('/') == std::string::npos; }
  /// By a click on the start page; what is no sample as a session of one's own.
  void open() {
    if (is_sample()) return stranger.click_sample(("sample_" + GetParam().session).c_str());
    std::filesystem::copy(shared(), folder.path / "own", std::filesystem::copy_options::recursive);
    ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "own").string())));
    ASSERT_TRUE(desk.wait([&] { return desk.document().model() != nullptr; }, 120000));
  }
  double error() { return *app::error_and_noise(*desk.document().model()).error; }

  TemporaryFolder folder;
  Desk desk;
  Stranger stranger{desk};
  Told reported{desk};
};

TEST_P(StrangersCheck, FourAnswersStandOnTheScreenAndTheButtonKeepsItsWord) {
  if (!is_sample() && !std::filesystem::exists(shared())) GTEST_SKIP() << "the session is not here";
  stranger.sit_down();
  open();
  if (GetParam().session.starts_with("hidden"))
    ASSERT_EQ(desk.window.workspace(), app::Place::explain) << "nothing is to be labelled or played";
  ASSERT_TRUE(stranger.explain.open());
  reported.expect_one_story(GetParam().name);
  EXPECT_TRUE(stranger.reads_how_far_off()) << Stranger::painted(stranger.header()).toStdString() << "\n"
                                            << stranger.explain.verdict().sentence.toStdString();
  EXPECT_EQ(stranger.repeated_figures(), QStringList()) << "the header says it";
  EXPECT_TRUE(stranger.reads_whose_fault()) << Stranger::painted(stranger.verdict_line()).toStdString();
  const QString missing = stranger.reads_what_is_missing();
  EXPECT_FALSE(missing.isEmpty()) << stranger.explain.first().title.toStdString();
  QPushButton* add = stranger.finds_the_button();
  ASSERT_NE(add, nullptr);
  const double before = error();
  desk.click(add);
  ASSERT_TRUE(stranger.explain.is_settled());
  EXPECT_LT(error(), before) << missing.toStdString();
  EXPECT_TRUE(desk.document().model()->settings.has_effects());
  reported.expect_one_story("added");
}

INSTANTIATE_TEST_SUITE_P(OnALaptop, StrangersCheck,
                         testing::Values(Seen{"hidden_3", "hidden_3"}, Seen{"hidden_6", "hidden_6"},
                                         Seen{"hidden_8", "hidden_8"}, Seen{"hundred_poses", "hundred_poses"},
                                         Seen{"real_justin", "real/justin_right_even"},
                                         Seen{"print_scale", "field/cameras/print_scale/declared_two_percent_small"},
                                         Seen{"square_size", "field/cameras/real_square_size"}),
                         [](const auto& session) { return std::string(session.param.name); });

}  // namespace
}  // namespace handsight::test
