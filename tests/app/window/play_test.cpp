// SPDX-License-Identifier: Apache-2.0
// Playing keeps its speed, whatever the window paints meanwhile.
#include <gtest/gtest.h>

#include "app/window/pages.h"
#include "temporary_folder.h"
#include "widgets/base/number_text.h"

namespace handsight::test {
namespace {

class Play : public testing::Test {
 protected:
  void SetUp() override {
    session = copy_of_sample(folder.path, "thesis_simulation");
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    desk.key(Qt::Key_2, Qt::ControlModifier);
  }
  QString decision(int row) {
    const auto* list = desk.find<widgets::DecisionList>("decisions");
    return list->model()->index(row, 0).data(Qt::AccessibleTextRole).toString();
  }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  CalibratePage calibrate{desk};
};

TEST_F(Play, TenASecondTakesTheTimeItSays) {
  QElapsedTimer timer;
  timer.start();
  ASSERT_TRUE(calibrate.play_to_the_end());
  EXPECT_GE(timer.elapsed(), 450) << "six observations, the last half a second after the first";
  EXPECT_EQ(calibrate.decisions(), 6);
}

TEST_F(Play, AsFastAsItGoesShowsEveryDecisionAndIsOneActionToUndo) {
  const int before = desk.document().undo_stack().index();
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  EXPECT_EQ(calibrate.decisions(), 6);
  EXPECT_EQ(desk.document().undo_stack().index(), before + 1);
}

TEST_F(Play, ADecisionsErrorIsThatOfThePresentModel) {
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  auto* list = desk.find<widgets::DecisionList>("decisions");
  const auto shown = [&](int row) { return list->model()->index(row, 0).data(Qt::AccessibleTextRole).toString(); };
  const auto& workbench = desk.window.workbench();
  for (int row = 0; row < 6; ++row) {
    const InspectionRow* r = workbench.row(desk.document().session().observations[static_cast<std::size_t>(row)].id);
    ASSERT_NE(r, nullptr);
    EXPECT_TRUE(shown(row).contains(widgets::size_text(workbench.units.shown(app::measure_size(*r)))))
        << shown(row).toStdString();
  }
}

TEST_F(Play, ASessionThatIsOpenedAgainHasItsDecisions) {
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  QStringList before;
  for (int row = 0; row < 6; ++row) before << decision(row);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_EQ(calibrate.decisions(), 6);
  for (int row = 0; row < 6; ++row) EXPECT_EQ(decision(row), before[row]);
  desk.press_button("step");
  ASSERT_TRUE(desk.wait([this] { return calibrate.decisions() == 1; }, 5000)) << calibrate.decisions();
}

TEST_F(Play, StepDecidesOneAndPlayGoesOnFromThere) {
  desk.key(Qt::Key_Period);
  ASSERT_TRUE(desk.wait([this] { return calibrate.decisions() == 1; }, 5000));
  QTest::qWait(250);
  EXPECT_EQ(calibrate.decisions(), 1);
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  EXPECT_EQ(calibrate.decisions(), 6);
}

}  // namespace
}  // namespace handsight::test
