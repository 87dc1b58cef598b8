// SPDX-License-Identifier: Apache-2.0
// Sessions of touches: fixtures and residuals in 3D, sizes in mm along what was read, and words that speak of touches.
#include <gtest/gtest.h>

#include <QTableWidget>
#include <QToolButton>
#include <set>

#include "app/window/explain_fixture.h"
#include "session/session_xml.h"
#include "widgets/lists/three_numbers.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

using widgets::SceneFixture;

class Touches : public testing::Test {
 protected:
  void open(const std::filesystem::path& session) {
    desk.window.resize(1440, 900);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(desk.document().model() && desk.document().model()->fit)
        << (desk.document().model() ? desk.document().model()->refusal.toStdString() : "no model");
  }
  /// Sixty touches of a fixture of every kind, by a robot without errors.
  std::filesystem::path every_kind() {
    const std::filesystem::path samples = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions";
    std::string text = read_file(samples / "rigs/six_axis_touch/session.xml");
    const std::string robot = "../../robots/six_axis.urdf", end = "<apart ";
    text.replace(text.find(robot), robot.size(), "robot.urdf");
    text.insert(text.find(end),
                "<line id=\"edge\" xyz=\"0.5 0 0.3\" direction=\"0 1 0\" estimate=\"yes\"/>"
                "<gauge id=\"dial\" xyz=\"0.5 0 0.35\" axis=\"0 0 1\" estimate=\"yes\"/>"
                "<length id=\"bar\" to=\"0.5 0 0.1\" estimate=\"yes\"/>");
    write_text(folder.path / "like/session.xml", text);
    write_text(folder.path / "like/robot.urdf", read_file(samples / "robots/six_axis.urdf"));
    const CliResult made =
        run_cli(folder.path, {"simulate", "--like", (folder.path / "like").string(), "--out",
                              (folder.path / "made").string(), "--observations", "120", "--seed", "3"});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return folder.path / "made";
  }
  void go(int workspace) {
    desk.key(Qt::Key_0 + workspace, Qt::ControlModifier);
    desk.settle();
  }
  void select(std::int64_t id) {
    desk.window.workbench().selection.select_observation(id);
    QTest::qWait(20);
  }
  const widgets::RobotView& scene() { return *desk.find<widgets::RobotView>("inspect_scene"); }
  QString panel() { return desk.find<widgets::ImageView>("inspect_left")->accessibleDescription(); }
  const SceneFixture* touched() {
    const SceneFixture* found = nullptr;
    for (const SceneFixture& f : scene().fixtures())
      if (f.is_touched) found = &f;
    return found;
  }
  Vector3 find_arrow(std::int64_t id) {
    for (const widgets::SceneArrow& a : scene().arrows())
      if (a.observation == id) return a.residual;
    ADD_FAILURE() << "observation " << id << " has no arrow";
    return Vector3::Zero();
  }

  TemporaryFolder folder;
  Desk desk;
};

TEST_F(Touches, OfAPlateAndSocketsAreShownInMmAtTheirFixtures) {
  open(copy_of_sample(folder.path, "probe_and_plate"));
  auto* px = desk.find<QToolButton>("unit_px");
  EXPECT_FALSE(px->isEnabled());
  EXPECT_TRUE(px->toolTip().contains("probe")) << px->toolTip().toStdString();
  go(3);
  select(0);
  EXPECT_TRUE(desk.find<QWidget>("inspect_left")->isVisible());
  EXPECT_FALSE(desk.find<QWidget>("inspect_right")->isVisible());
  EXPECT_TRUE(panel().startsWith("Plane plate_front: the tip touched it.")) << panel().toStdString();
  EXPECT_TRUE(panel().contains("mm along what was read")) << panel().toStdString();
  ASSERT_EQ(scene().fixtures().size(), 5U);
  ASSERT_NE(touched(), nullptr);
  EXPECT_EQ(touched()->name, "plate_front");
  // Along the plane's normal, and as large as the report has it.
  const Vector3 normal = touched()->root_from_fixture.rotation.col(2), off = find_arrow(0);
  EXPECT_NEAR(std::abs(off.dot(normal)), off.norm(), 1e-12);
  EXPECT_NEAR(off.norm(), *desk.window.workbench().row(0)->rms_m, 1e-12);
  auto* table = InspectPage{desk}.table();
  EXPECT_EQ(table->view()->model()->headerData(4, Qt::Horizontal).toString(), "fixture");
  EXPECT_EQ(table->view()->model()->index(0, 4).data().toString(), "plate_front");
}

TEST_F(Touches, ARowIsOffByWhatTheReportSays) {
  open(every_kind());
  const auto& report = *desk.document().model()->report;
  ASSERT_GT(report.per_observation.size(), 100U);
  for (const ObservationReport& o : report.per_observation) {
    const InspectionRow* row = desk.window.workbench().row(o.id);
    ASSERT_NE(row, nullptr) << o.id;
    EXPECT_NEAR(*row->rms_m, *o.rms_m, 1e-9) << o.id;
  }
}

TEST_F(Touches, OfEveryKindAreDrawnAndExplained) {
  open(every_kind());
  go(3);
  std::set<FixtureShape> shapes;
  for (const SceneFixture& f : scene().fixtures()) shapes.insert(f.shape);
  EXPECT_EQ(shapes.size(), 5U);
  std::set<QString> words;
  for (const Observation& o : desk.document().session().observations) {
    select(o.id);
    words.insert(panel().section(' ', 0, 0));
    ASSERT_NE(touched(), nullptr);
    if (touched()->shape != FixtureShape::bar) continue;
    // From its end to the tip, as long as was read.
    EXPECT_NEAR(touched()->to.norm(), o.sightings.front().point->x(), 1e-3);
  }
  EXPECT_EQ(words, (std::set<QString>{"Plane", "Socket", "Edge", "Dial", "Length"}));
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  EXPECT_NE(explain.verdict().state, widgets::SessionState::waiting);
}

/// Where a plane stands is a long text: on a small screen it takes two lines.
TEST_F(Touches, WhereTheFixturesStandIsWholeOnASmallScreen) {
  open(copy_of_sample(folder.path, "probe_and_plate"));
  desk.window.resize(1200, 700);
  go(2);
  const auto* table = desk.find<QTableWidget>("fixtures_table");
  QTest::qWait(50);
  const QFontMetrics metrics(table->item(0, 4)->font());
  for (int row = 0; row < table->rowCount(); ++row) {
    const QRect cell = table->visualItemRect(table->item(row, 4));
    const QRect text =
        metrics.boundingRect(QRect(0, 0, cell.width() - 8, 1000), Qt::TextWordWrap, table->item(row, 4)->text());
    EXPECT_LE(text.height(), cell.height()) << table->item(row, 4)->text().toStdString();
  }
}

TEST_F(Touches, NothingIsLabelledOrPlayed) {
  open(copy_of_sample(folder.path, "probe_and_plate"));
  go(1);
  select(0);
  LabelPage label{desk};
  EXPECT_TRUE(label.left()->accessibleDescription().startsWith("Touches have no images"))
      << label.left()->accessibleDescription().toStdString();
  EXPECT_FALSE(desk.find<QWidget>("triangle")->isVisible());
  go(2);
  EXPECT_FALSE(desk.find<QAbstractButton>("play")->isEnabled());
  EXPECT_TRUE(desk.find<widgets::ImageView>("calibrate_left")->isVisible());
  EXPECT_TRUE(desk.find<widgets::ImageView>("calibrate_left")->accessibleDescription().startsWith("Plane plate_front"));
}

TEST_F(Touches, AnExcludedReadingIsOneStillWhenItIsTakenBack) {
  const auto session = copy_of_sample(folder.path, "probe_and_plate");
  open(session);
  const double before = *desk.document().model()->report->fitted.rms_m;
  desk.window.workbench().exclude({0});
  ASSERT_TRUE(desk.settle());
  EXPECT_NE(*desk.document().model()->report->fitted.rms_m, before);
  desk.document().undo();
  ASSERT_TRUE(desk.settle());
  EXPECT_NEAR(*desk.document().model()->report->fitted.rms_m, before, 1e-9);
}

}  // namespace
}  // namespace handsight::test
