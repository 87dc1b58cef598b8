// SPDX-License-Identifier: Apache-2.0
// The user's whole story with mouse and keyboard, compared with the command line.
#include <gtest/gtest.h>

#include <QTest>

#include "app/window/pages.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "findings/explain_texts.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/three_numbers.h"
#include "window/rail_button.h"

namespace handsight::test {
namespace {

class Story : public testing::Test {
 protected:
  std::filesystem::path make_copy(const char* name) {
    const auto copy = folder.path / name;
    std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name, copy,
                          std::filesystem::copy_options::recursive);
    return copy;
  }
  void label_three(const std::vector<Vector2>& places) {
    ASSERT_TRUE(label.corners_are_found()) << label.triangle().sentence.toStdString();
    for (const Vector2& px : places) label.click_left(px);
    ASSERT_TRUE(label.triangle().can_use) << label.triangle().sentence.toStdString();
    label.use();
    ASSERT_EQ(desk.window.workspace(), app::Place::calibrate) << "after the first labels the next step is Calibrate";
  }
  Rigid exported(const std::filesystem::path& file) { return read_calibration(file).tcp_from_body.motion; }
  static double difference(const Rigid& a, const Rigid& b) {
    return (matrix_from_rigid(a) - matrix_from_rigid(b)).cwiseAbs().maxCoeff();
  }

  TemporaryFolder folder;
  Desk desk;
  LabelPage label{desk};
  CalibratePage calibrate{desk};
  InspectPage inspect{desk};
  ExportPage exporting{desk};
};

/// One observation shows no error: nothing says that it is good, nor that it can be used.
TEST_F(Story, FromOneObservationNoErrorNoGreenMarkAndNothingReady) {
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("first_steps").string())));
  label_three({{421, 338}, {408, 411}, {473, 378}});
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(desk.document().model() && desk.document().model()->fit);
  EXPECT_FALSE(desk.find<widgets::ThreeNumbers>("three_numbers")->numbers().now) << "no held-out error";
  for (const char* place : {"rail_explain", "rail_export"}) {
    const app::WorkStatus& status = desk.find<app::RailButton>(place)->status();
    EXPECT_NE(status.state, app::WorkState::done) << place;
    EXPECT_FALSE(status.line.contains("ready")) << place << ": " << status.line.toStdString();
  }
  const widgets::SessionVerdict verdict = app::session_verdict(desk.window.workbench(), desk.document().model());
  EXPECT_NE(verdict.state, widgets::SessionState::adequate);
  EXPECT_TRUE(verdict.sentence.contains("alone cannot show an error")) << verdict.sentence.toStdString();
}

TEST_F(Story, FirstStepsFromLabelsToTheExportAndAllTheWayBack) {
  const auto session = make_copy("first_steps");
  const std::string untouched = read_file(session / "session.xml");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  EXPECT_EQ(desk.window.workspace(), app::Place::label) << "nothing is labelled: Label comes first";
  label_three({{421, 338}, {408, 411}, {473, 378}});
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  EXPECT_EQ(calibrate.decisions(), 12);

  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_EQ(desk.window.workspace(), app::Place::inspect);
  inspect.sort_worst_first("px");
  inspect.click_row(0);
  const std::int64_t worst = inspect.id_at(0);
  EXPECT_EQ(desk.window.workbench().selection.current().observation, worst);
  for (const auto& row : desk.window.workbench().inspection()->rows)
    EXPECT_LE(row.rms.value_or(0), desk.window.workbench().row(worst)->rms) << "the worst is on top";
  desk.press_button("exclude");
  EXPECT_EQ(desk.document().find(worst)->decision, Decision::excluded);
  ASSERT_TRUE(desk.settle());
  EXPECT_EQ(desk.document().model()->report->used, 11);

  desk.key(Qt::Key_5, Qt::ControlModifier);
  const auto file = folder.path / "out.xml";
  ASSERT_TRUE(exporting.save_as(file)) << exporting.said().toStdString();
  EXPECT_EQ(read_file(session / "session.xml"), untouched) << "the session changes only by Save";

  desk.key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(desk.document().is_saved());
  const auto by_cli = folder.path / "cli.xml";
  ASSERT_EQ(
      run_cli(folder.path, {"fit", session.string(), "--without-wrong-points", "--export", by_cli.string()}).exit_code,
      0);
  EXPECT_LE(difference(exported(file), exported(by_cli)), 1e-9);

  while (desk.document().undo_stack().canUndo()) desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session_text(desk.document().session()), untouched);
  ASSERT_TRUE(desk.settle());
  for (int click = 0; click < 3; ++click) desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(desk.document().session().observations[0].sightings.empty()) << "three clicks are no labels yet";
  desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(desk.document().session().observations[0].sightings.empty()) << "and forward again";
}

TEST_F(Story, TheWindowAndTheCommandLineTrackTheSameMarkers) {
  const auto session = make_copy("first_steps"), other = folder.path / "other";
  std::filesystem::copy(session, other, std::filesystem::copy_options::recursive);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  label_three({{421, 338}, {408, 411}, {473, 378}});
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  desk.key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_EQ(
      run_cli(folder.path, {"label", other.string(), "--observation", "0", "--left", "421,338", "408,411", "473,378"})
          .exit_code,
      0);
  ASSERT_EQ(run_cli(folder.path, {"online", other.string(), "--save"}).exit_code, 0);
  EXPECT_EQ(read_file(session / "session.xml"), read_file(other / "session.xml"));
}

TEST_F(Story, TheThreeBadPosesOfAHundredAreFoundWithTheRightBlame) {
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("hundred_poses").string())));
  label_three({{519, 98}, {515, 132}, {576, 113}});
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  inspect.table()->set_filter(widgets::RowFilter::rejected);
  const auto shown = inspect.table()->shown();
  EXPECT_EQ(std::set(shown.begin(), shown.end()), (std::set<std::int64_t>{58, 75, 98}));
  const std::map<std::int64_t, ErrorCause> truth = {
      {58, ErrorCause::robot}, {75, ErrorCause::body}, {98, ErrorCause::cameras}};
  for (int row = 0; row < 3; ++row) {
    inspect.click_row(row);
    const std::int64_t id = *desk.window.workbench().selection.current().observation;
    ASSERT_NE(desk.window.workbench().selected_row(), nullptr) << id;
    EXPECT_EQ(desk.window.workbench().selected_row()->attribution.cause, truth.at(id)) << id;
    const auto& bar = desk.find<widgets::AttributionBar>("blame")->attribution();
    ASSERT_TRUE(bar) << id;
    const std::map<ErrorCause, double> shares = {
        {ErrorCause::cameras, bar->cameras}, {ErrorCause::body, bar->body}, {ErrorCause::robot, bar->robot}};
    for (const auto& [cause, share] : shares)
      EXPECT_LE(share, shares.at(truth.at(id)))
          << id << ": the bar blames " << error_cause_name(cause) << " more than the sentence does";
  }
}

TEST_F(Story, OneSelectionEverywhere) {
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("thesis_simulation").string())));
  ASSERT_TRUE(desk.settle());
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  desk.click(strip, strip->cell_rect(4).center().toPoint());
  EXPECT_EQ(desk.window.workbench().selection.current().observation, 4);
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(inspect.table()->selected(), 4);
  inspect.click_row(1);
  EXPECT_EQ(strip->selected(), inspect.id_at(1));
  desk.key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(strip->selected(), 4) << "back to the selection before";
}

TEST_F(Story, WhatCannotBeOpenedIsSaidOnTheStartPage) {
  EXPECT_FALSE(desk.window.open("/nowhere/at/all"));
  auto* refusal = desk.find<QLabel>("start_refusal");
  EXPECT_TRUE(refusal->isVisible());
  EXPECT_GE(refusal->text().size(), 20);
}

TEST_F(Story, ASampleIsOpenedAsTheUsersOwnCopy) {
  desk.press_button("sample_first_steps");
  ASSERT_TRUE(desk.document().is_open());
  const auto file = desk.document().session().file;
  EXPECT_EQ(file.string().find(HANDSIGHT_SOURCE_DIR), std::string::npos) << "the sample itself stays as it is";
  EXPECT_EQ(desk.document().session().observations.size(), 12U);
}

}  // namespace
}  // namespace handsight::test
