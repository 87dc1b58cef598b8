// SPDX-License-Identifier: Apache-2.0
// From a session that misses by pixels down to the noise, with mouse and keyboard, as `handsight-cli improve` does it.
#include <gtest/gtest.h>

#include <QScrollArea>

#include "app/window/explain_fixture.h"
#include "cli/cli_runner.h"
#include "cli/hidden_sessions.h"
#include "diagnosis/simulated_stand.h"
#include "document/effect_words.h"
#include "estimation/fit/fit.h"
#include "explain/truth.h"
#include "export/report.h"
#include "session/calibration_xml.h"
#include "widgets/base/number_text.h"
#include "widgets/explain/staircase.h"
#include "widgets/explain/truth_panel.h"
#include "widgets/lists/three_numbers.h"

namespace handsight::test {
namespace {

class HiddenSession : public Explain, public testing::WithParamInterface<int> {};

TEST_P(HiddenSession, TheFirstCardUntilItSaysStopGivesWhatImproveGives) {
  open("hidden_" + std::to_string(GetParam()));
  explain.take_the_first_until_it_says_stop();
  EXPECT_FALSE(explain.can_add_first());
  const auto improved = run_cli(folder.path, {"improve", session.string(), "--json", "-"}).json();
  EXPECT_EQ(effects_in_the_model(), list_effects(improved));
  if (desk.document().model()->fit->effects.empty()) {
    EXPECT_EQ(desk.document().undo_stack().index(), 0) << "nothing is added where nothing is missing";
  } else {
    EXPECT_NEAR(held_out(), improved["held_out_rms_pixel"].get<double>(), 1e-9);
  }
  desk.choose("reveal");
  auto* truth = desk.find<widgets::TruthPanel>("truth");
  EXPECT_TRUE(truth->isVisible());
  for (const widgets::TruthRow& row : truth->rows())
    EXPECT_EQ(row.verdict, widgets::TruthVerdict::right)
        << row.what.toStdString() << " " << row.parameter.toStdString() << " " << row.remark.toStdString();
}

INSTANTIATE_TEST_SUITE_P(All, HiddenSession, testing::Range(1, 9));

/// They are part of the model of every robot: revealed, none of them is a wrong cause, nor what was hidden.
TEST(RevealedTruth, SmallDeviationsAreNoCauses) {
  const EffectTerm hidden{"joint_elasticity", 1, {2e-4}};
  const Session s = simulated({hidden}, 5, 40);
  FitOptions o;
  o.estimated = {hidden};
  for (int joint = 0; joint < 6; ++joint)
    o.estimated.push_back({.id = "joint_offset", .place = joint, .values = {0}, .size = 0.1});
  const app::TruthComparison c = app::compare_with_truth(s, {{hidden}, {}}, fit(s, o), nullptr);
  ASSERT_EQ(c.rows.size(), 1U);
  EXPECT_EQ(c.rows[0].verdict, widgets::TruthVerdict::right);
  EXPECT_TRUE(c.sentence.contains(" Right. The small deviations")) << c.sentence.toStdString();
  o.estimated = {hidden, {"joint_offset", 0, {0}}};
  EXPECT_TRUE(app::compare_with_truth(s, {{hidden}, {}}, fit(s, o), nullptr).sentence.contains("Wrong"));
}

TEST_F(Explain, WhatIsInTheModelIsNotSaidToBeUnseen) {
  const auto shared = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "examples/sagging";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not here";
  std::filesystem::copy(shared, folder.path / "sagging", std::filesystem::copy_options::recursive);
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "sagging").string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  ASSERT_EQ(effects_in_the_model().count("joint_elasticity axis_2"), 1U);
  const QString reported = explain.verdict().sentence;
  EXPECT_TRUE(reported.contains("These poses could not show: ")) << reported.toStdString();
  EXPECT_FALSE(reported.contains("joint elasticity")) << "of some joints it was seen: " << reported.toStdString();
}

TEST_F(Explain, TheModelPanelDoesTheSameByHand) {
  open("hidden_3");
  auto* box = desk.find<QAbstractButton>("effect_joint_elasticity");
  ASSERT_FALSE(box->isChecked());
  for (auto* area : desk.find<QWidget>("model_panel")->findChildren<QScrollArea*>()) area->ensureWidgetVisible(box);
  QTest::qWait(20);
  box = desk.find<QAbstractButton>("effect_joint_elasticity");
  desk.click(box, QPoint(10, box->height() / 2));
  ASSERT_TRUE(explain.is_settled());
  EXPECT_EQ(effects_in_the_model(),
            (std::set<std::string>{"joint_elasticity right_arm_1", "joint_elasticity right_arm_2",
                                   "joint_elasticity right_arm_4"}));
  EXPECT_LT(held_out(), 0.25);
  const auto reach = [this](const char* name) {
    for (auto* area : desk.find<QWidget>("model_panel")->findChildren<QScrollArea*>())
      area->ensureWidgetVisible(desk.find<QWidget>(name));
    QTest::qWait(20);
    return desk.find<QWidget>(name);  // a diagnosis that arrives fills the panel anew
  };
  // One number, and the others go on being estimated.
  desk.click(reach("hold_joint_elasticity_1"));
  ASSERT_TRUE(explain.is_settled());
  ASSERT_EQ(desk.document().settings().estimated.size(), 3U);
  auto* second = qobject_cast<QLineEdit*>(reach("value_joint_elasticity_1"));
  ASSERT_NE(second, nullptr);
  desk.type_into(second, "200");
  desk.key(Qt::Key_Return);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_DOUBLE_EQ(desk.document().model()->fit->effects[1].term.values[0], 2e-4);
  EXPECT_EQ(desk.document().model()->fit->effects[1].sigmas[0], 0);
  EXPECT_GT(desk.document().model()->fit->effects[0].sigmas[0], 0);
  desk.click(reach("hold_joint_elasticity_1"));
  ASSERT_TRUE(explain.is_settled());
  EXPECT_LT(held_out(), 0.25) << "free again, it comes back";

  desk.click(reach("hold_joint_elasticity"));
  ASSERT_TRUE(explain.is_settled());
  ASSERT_EQ(desk.document().settings().held.size(), 3U);
  auto* field = qobject_cast<QLineEdit*>(reach("value_joint_elasticity_0"));
  ASSERT_NE(field, nullptr);
  desk.type_into(field, "300");
  desk.key(Qt::Key_Return);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_DOUBLE_EQ(desk.document().settings().held[0].values[0], 3e-4);
  EXPECT_GT(held_out(), 0.5) << "another spring than the robot's";
  box = qobject_cast<QAbstractButton*>(reach("effect_joint_elasticity"));
  desk.click(box, QPoint(10, box->height() / 2));
  ASSERT_TRUE(explain.is_settled());
  EXPECT_TRUE(effects_in_the_model().empty());
  while (desk.document().undo_stack().canUndo()) desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(desk.document().settings() == app::ModelSettings{});
}

/// A reading typed wrong: the strip and Inspect show which, the verdict says that it is left out.
TEST_F(Explain, AReadingThatSlippedIsNamedInTheVerdict) {
  session = make_copy("hidden_1");
  std::string text = read_text(session / "session.xml");
  const std::size_t at = text.find("<position>", text.find("<observation id=\"17\"")) + 10;
  text.replace(at, text.find(' ', at) - at, "0.123");
  write_text(session / "session.xml", text);
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  const auto model = desk.document().model();
  ASSERT_EQ(model->lone.size(), 1u);
  EXPECT_EQ(model->lone[0].id, 17);
  EXPECT_TRUE(model->inspection->rows[17].outlier);
  const QString sentence = explain.verdict().sentence;
  EXPECT_TRUE(sentence.startsWith("Observation 17 is left out: alone it is off by")) << sentence.toStdString();
  EXPECT_TRUE(sentence.contains("ncoder eccentricity")) << "what is missing is still found: " << sentence.toStdString();
}

TEST_F(Explain, WhatTheRobotShowsIsHeldAgainstThePredictionAndRemembered) {
  open("hidden_3");
  const auto model = desk.document().model();
  const auto first = [this] { return explain.cards()->card(0); };
  ASSERT_TRUE(first()->state().check_number);
  const QString predicted = first()->state().check_number->prediction;
  EXPECT_TRUE(predicted.contains("Hang 1 kg on the hand: it should sag")) << predicted.toStdString();
  const auto reported = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"}).json()["candidates"][0];
  const double value = reported["check"]["value"].get<double>(), sigma = reported["check"]["sigma"].get<double>();
  EXPECT_TRUE(predicted.contains(widgets::with_sigma_text(1e3 * value, 1e3 * sigma))) << predicted.toStdString();
  explain.measure(QString::number(1e3 * (value + sigma), 'f', 4) + " +- " + QString::number(1e3 * sigma, 'f', 4));
  EXPECT_TRUE(first()->state().check_number->is_inside);
  EXPECT_TRUE(first()->state().check_number->answer.startsWith("Inside: 0.7 sigma"))
      << first()->state().check_number->answer.toStdString();
  EXPECT_EQ(desk.document().undo_stack().index(), 1);
  EXPECT_EQ(desk.document().model(), model) << "nothing is fitted for it";
  explain.measure("0.00");
  EXPECT_TRUE(first()->state().check_number->answer.startsWith("Outside"));
  explain.measure("one");
  EXPECT_TRUE(first()->state().check_number->answer.startsWith("That is no number"));
  EXPECT_EQ(desk.document().undo_stack().index(), 2);

  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(first()->state().check_number->is_inside);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  EXPECT_TRUE(first()->state().check_number->is_inside) << "remembered with the session";
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const QString report =
      app::report_html(desk.document(), *desk.document().model(), {}, {.verdict = "How good it is."});
  EXPECT_TRUE(report.contains("Checked on the robot"));
  EXPECT_TRUE(report.contains("Inside: 0.7 sigma from the prediction"));
}

TEST_F(Explain, TheNumbersAreWithoutWrongPointsFromTheStartAndSaySo) {
  open("hidden_7");
  const auto d = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"}).json();
  const widgets::ErrorNumbers& now = desk.find<widgets::ThreeNumbers>("three_numbers")->numbers();
  EXPECT_NEAR(*now.now, d["held_out_rms_pixel"].get<double>(), 1e-9);
  EXPECT_NEAR(*now.noise, d["noise_pixel"].get<double>(), 1e-9);
  EXPECT_NEAR(*explain.verdict().error_px, *now.now, 1e-12) << "one definition everywhere";
  EXPECT_NEAR(*desk.find<widgets::Staircase>("staircase")->state().versions[0].held_out, *now.now, 1e-12);
  // The second figure stays, and says how much is left out.
  const QString count = QString::number(d["wrong_points"].size());
  EXPECT_TRUE(now.excluded_note.startsWith(count + " points set aside; with all ")) << now.excluded_note.toStdString();
  const double with_them = QString(now.excluded_note).replace(QChar(0x00A0), ' ').section(' ', -2, -2).toDouble();
  EXPECT_GT(with_them, 2 * *now.now);
}

TEST_F(Explain, TheTourLeadsToTheMissingEffect) {
  open("hidden_3");
  desk.press_button("start_tour");
  auto* text = desk.find<QLabel>("tour_text");
  ASSERT_TRUE(text->isVisible());
  for (int i = 0; i < 12 && !text->text().startsWith("Add it"); ++i) desk.press_button("tour_next");
  ASSERT_TRUE(text->text().startsWith("Add it"));
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  EXPECT_TRUE(text->text().startsWith("The step down")) << text->text().toStdString();
  for (int i = 0; i < 12 && text->isVisible(); ++i) desk.press_button("tour_next");
  EXPECT_FALSE(text->isVisible());
}

TEST_F(Explain, TheWholeWishOnAHundredPoses) {
  const auto file = folder.path / "out.xml";
  desk.window.resize(1440, 900);
  session = make_copy("hundred_poses");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  LabelPage label{desk};
  CalibratePage calibrate{desk};
  InspectPage inspect{desk};
  ExportPage exporting{desk};
  ASSERT_TRUE(label.corners_are_found());
  for (const Vector2& px : {Vector2(519, 98), Vector2(515, 132), Vector2(576, 113)}) label.click_left(px);
  label.use();
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  inspect.table()->set_filter(widgets::RowFilter::rejected);
  EXPECT_EQ(inspect.table()->shown().size(), 3U) << "the bad poses are set aside";
  ASSERT_TRUE(explain.open());
  const double before = held_out();
  const int taken = explain.take_the_first_until_it_says_stop();
  if (taken > 0) {
    EXPECT_LT(held_out(), before);
  }
  EXPECT_LT(held_out() / *desk.document().model()->fit->noise, 1.25) << "down at the noise";
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(exporting.save_as(file)) << exporting.said().toStdString();
  EXPECT_EQ(read_calibration(file).effects.size(), app::list_ids(desk.document().settings().estimated).size());
}

}  // namespace
}  // namespace handsight::test
