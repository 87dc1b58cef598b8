// SPDX-License-Identifier: Apache-2.0
// A sensor that tells poses has no markers: the points that stand for a pose are an affair of the fit.
#include <gtest/gtest.h>

#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

class PoseSensorInWindow : public Explain {
 protected:
  /// A hobby arm whose zeros were set by eye; a fixed camera tells the tag on its hand.
  bool make() {
    const auto files = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/robots/five_axis_zero_errors";
    if (!std::filesystem::exists(files)) return false;
    session = folder.path / "arm";
    const auto file = [&](const char* name) { return (files / name).string(); };
    const auto made = run_cli(folder.path, {"convert", file("arm.urdf"), file("joints.csv"), file("target.csv"),
                                            "--tcp", "tool", "--out", session.string()});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return made.exit_code == 0;
  }
  void expect_no_markers(const char* where) {
    for (const QString& line : painted(desk.window))
      EXPECT_FALSE(line.contains("marker", Qt::CaseInsensitive)) << where << ": " << line.toStdString();
  }
};

TEST_F(PoseSensorInWindow, SaysAndShowsNothingOfMarkers) {
  if (!make()) GTEST_SKIP() << "the files of the field are not here";
  desk.window.resize(1366, 768);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  EXPECT_TRUE(explain.verdict().sentence.contains("noise is not known")) << explain.verdict().sentence.toStdString();
  EXPECT_TRUE(explain.verdict().sentence.contains("sigma")) << "how it would be known";
  expect_no_markers("Explain");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  InspectPage inspect{desk};
  constexpr int worst = 4;
  EXPECT_TRUE(inspect.table()->view()->isColumnHidden(worst));
  QTest::qWait(50);
  expect_no_markers("Inspect");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  for (auto* label : desk.window.findChildren<QLabel*>())
    if (label->isVisible()) EXPECT_FALSE(label->text().contains("tracker")) << label->text().toStdString();
}

}  // namespace
}  // namespace handsight::test
