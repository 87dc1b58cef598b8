// SPDX-License-Identifier: Apache-2.0
// What is painted against what the story knows: its figures stand everywhere the same, and nothing is said to agree
// that is more than 1.5 times the noise.
#include "app/window/painted_story.h"

#include <gtest/gtest.h>

#include "app/two_hands.h"
#include "app/window/explain_fixture.h"
#include "app/window/rig_sessions.h"

namespace handsight::test {
namespace {

struct State {
  const char* name;
  std::string session;  // a sample; "both" the collection of two hands, "three" three cameras
};

class PaintedStory : public Explain, public testing::WithParamInterface<State> {
 protected:
  std::filesystem::path made() {
    const std::string& name = GetParam().session;
    if (name == "both") return two_hands(folder.path);
    if (name == "three") return sample_with_cameras(folder.path, "hidden_4", 3);
    if (const auto real = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / name; std::filesystem::exists(real)) {
      std::filesystem::copy(real, folder.path / name, std::filesystem::copy_options::recursive);
      return folder.path / name;
    }
    return copy_of_sample(folder.path, name);
  }
  Told reported{desk};
};

TEST_P(PaintedStory, IsToldAlikeEverywhere) {
  desk.window.resize(1440, 900);
  if (GetParam().session.starts_with("justin") &&
      !std::filesystem::exists(std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / GetParam().session))
    GTEST_SKIP() << "the real robot is not here";
  ASSERT_TRUE(desk.window.open(QString::fromStdString(made().string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  const auto look = [&](const char* where) {
    QTest::qWait(60);
    ASSERT_GT(painted(desk.window).size(), 20);
    ASSERT_TRUE(reported.story().error.error);
    expect_painted_story(desk, std::string(where) + ", " + GetParam().name);
  };
  look("Explain");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.settle();
  look("Export");
  desk.key(Qt::Key_4, Qt::ControlModifier);
  if (reported.story().lead()) {
    explain.press_add();
    ASSERT_TRUE(explain.is_settled());
    look("Explain, added");
    desk.press_button("tab_versions");
    look("Versions");
    desk.press_button("tab_stairs");
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(explain.is_settled());
    look("Explain, undone");
  }
}

INSTANTIATE_TEST_SUITE_P(Sessions, PaintedStory,
                         testing::Values(State{"springs", "hidden_3"}, State{"scatter", "hidden_6"},
                                         State{"offset", "hidden_2"}, State{"a_curve", "hidden_8"},
                                         State{"link_geometry", "hidden_7"}, State{"real_robot", "justin_right_even"},
                                         State{"three_cameras", "three"}, State{"both_hands", "both"}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace handsight::test
