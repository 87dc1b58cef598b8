// SPDX-License-Identifier: Apache-2.0
// Effects as part of the document's model: fitted, undone, remembered, exported.
#include <gtest/gtest.h>

#include <QCoreApplication>

#include "base/files.h"
#include "diagnosis/verdict/diagnosis.h"
#include "document/curve_words.h"
#include "document/document.h"
#include "document/model_edits.h"
#include "effects/own_effect.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::app {
namespace {

class EffectsTest : public testing::Test {
 protected:
  EffectsTest() {
    std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "hidden_3", session,
                          std::filesystem::copy_options::recursive);
    document.open(session);
  }
  /// Springs in two joints, one held at a number that takes all digits of a double.
  ModelSettings with_springs() const {
    const Robot& robot = document.session().robot;
    ModelSettings settings = document.settings();
    settings.estimated = {{"joint_elasticity", find_joint(robot, "right_arm_2"), {1e-4}}};
    settings.held = {{"joint_elasticity", find_joint(robot, "right_arm_1"), {1.0 / 3.0 * 3.7e-4}}};
    return settings;
  }
  void perform(const ModelSettings& after) {
    document.perform({.sentence = "added joint elasticity", .settings = SettingsEdit{document.settings(), after}});
  }
  ModelVersionPointer fitted() const {
    return make_version(document.session(), document.settings(), document.revision(), "");
  }
  TemporaryFolder folder;
  std::filesystem::path session = folder.path / "session";
  Document document;
};

TEST_F(EffectsTest, AreFittedAndHeld) {
  perform(with_springs());
  const auto version = fitted();
  ASSERT_TRUE(version->fit) << version->refusal.toStdString();
  ASSERT_EQ(version->fit->effects.size(), 2U);
  EXPECT_EQ(version->fit->effects[0].term.values, with_springs().held[0].values) << "held where it was put";
  EXPECT_NEAR(version->fit->effects[1].term.values[0], 1.5e-4, 0.5e-4);
  EXPECT_GT(version->fit->effects[1].sigmas[0], 0);
  const ModelSettings now = with_fitted_values(*version->fit, document.settings());
  EXPECT_EQ(now.estimated[0].values, version->fit->effects[1].term.values);
  EXPECT_EQ(now.held[0].values, with_springs().held[0].values);
}

TEST_F(EffectsTest, AnObservationIsInspectedWithThem) {
  perform(with_springs());
  const auto version = fitted();
  double squares = 0;
  int coordinates = 0;
  for (const InspectionRow& row : version->inspection->rows) {
    squares += *row.rms * *row.rms * row.coordinates;
    coordinates += row.coordinates;
  }
  EXPECT_NEAR(std::sqrt(squares / coordinates), version->fit->residual_rms, 1e-9);
}

TEST_F(EffectsTest, AreWrittenIntoTheCalibration) {
  perform(with_springs());
  const auto version = fitted();
  const auto file = folder.path / "out.xml";
  write_calibration(file, *version->calibration);
  const Calibration read = read_calibration(file);
  ASSERT_EQ(read.effects.size(), 1U);
  EXPECT_EQ(read.effects[0].id, "joint_elasticity");
  ASSERT_EQ(read.effects[0].parameters.size(), 2U);
  EXPECT_EQ(read.effects[0].parameters[0].of, "right_arm_1");
}

TEST_F(EffectsTest, TheJournalHoldsThemBitForBit) {
  const ModelSettings wanted = with_springs();
  perform(wanted);
  const Edit edit{.sentence = "x", .settings = SettingsEdit{{}, wanted}};
  EXPECT_EQ(parse_edit(edit_text(edit)).settings->after, wanted);
  document.save();
  document.close();
  document.open(session);
  EXPECT_EQ(document.settings(), wanted) << "a save and a close do not lose the model";
  EXPECT_TRUE(document.is_saved());
  document.undo();
  EXPECT_EQ(document.settings(), ModelSettings{});
  document.redo();
  EXPECT_EQ(document.settings(), wanted);
}

TEST_F(EffectsTest, TheJournalHoldsTheSizeOfSmallDeviations) {
  ModelSettings wanted = with_springs();
  wanted.estimated[0].size = 0.1;
  EXPECT_FALSE(wanted == with_springs());
  Edit edit{.sentence = "x", .settings = SettingsEdit{{}, wanted}};
  EXPECT_EQ(parse_edit(edit_text(edit)).settings->after, wanted);
  edit.settings->after.estimated[0].size = -0.5;
  EXPECT_THROW(parse_edit(edit_text(edit)), InputError);
}

/// A curve without a name: its definition goes along in the journal, and it is made again for the session's robot.
TEST_F(EffectsTest, CurvesComeBackFromTheJournal) {
  EffectDefinition definition;
  definition.id = "curve_1", definition.title = "Curve of the angle of right_arm_4", definition.scope = "session";
  definition.unnamed = true;
  definition.parameters = {{"y_sine", "m", 1e-3}, {"y_cosine", "m", 1e-3}};
  definition.moves = {{"hand_y", "y_sine*sin(3.3*q_right_arm_4) + y_cosine*cos(3.3*q_right_arm_4)", 0}};
  const auto own = own_effect(definition, document.session().robot);
  ModelSettings wanted = with_springs();
  wanted.estimated.push_back(term_of(*own, -1, own));
  wanted.estimated.back().values = {1.0 / 3.0 * 1e-3, -2e-4};
  EXPECT_EQ(display_name({wanted.estimated.back()}, document.session()),
            "the hand shifts along y with sin(3.3 q) of right_arm_4");
  perform(wanted);
  const auto before = fitted();
  ASSERT_TRUE(before->fit) << before->refusal.toStdString();
  EXPECT_EQ(list_curves(*before->fit).size(), 1U);
  document.close();
  document.open(session);
  ASSERT_EQ(document.settings(), wanted);
  ASSERT_TRUE(document.settings().estimated.back().own);
  EXPECT_TRUE(document.settings().estimated.back().own->is_unnamed());
  const auto after = fitted();
  EXPECT_EQ(*after->report->held_out.rms_pixel, *before->report->held_out.rms_pixel);
  ModelSettings other = wanted;
  EffectDefinition changed = definition;
  changed.moves[0].formula = "y_sine*sin(2*q_right_arm_4) + y_cosine*cos(2*q_right_arm_4)";
  other.estimated.back().own = own_effect(changed, document.session().robot);
  EXPECT_FALSE(other == wanted) << "the same id and numbers, another formula";
  document.undo();
  EXPECT_EQ(document.settings(), ModelSettings{});
  document.redo();
  EXPECT_EQ(document.settings(), wanted);
  const Edit edit{.sentence = "x", .settings = SettingsEdit{{}, wanted}};
  EXPECT_THROW(parse_edit(edit_text(edit)), InputError) << "no robot to make it for";
  document.perform(without_effect(document, "curve_1"));
  EXPECT_EQ(document.undo_stack().undoText(), "took out: the hand shifts along y with sin(3.3 q) of right_arm_4");
}

TEST_F(EffectsTest, UndoSaysWhatItDidToTheError) {
  document.take_version(fitted());
  perform(with_springs());
  document.take_version(fitted());
  QString said;
  QObject::connect(&document, &Document::noticed, [&](const QString& sentence) { said = sentence; });
  document.undo();
  EXPECT_TRUE(said.startsWith("Undone: added joint elasticity (")) << said.toStdString();
  EXPECT_TRUE(said.contains("→ 3.4 px")) << said.toStdString();
}

TEST_F(EffectsTest, AVersionMadeOfADiagnosisIsTheOneThatWouldBeFitted) {
  ModelSettings settings = with_springs();
  settings.held.clear();
  perform(settings);
  const Diagnosis d = diagnose(document.session(), {.estimated = settings.estimated, .refitted = 0});
  const auto of_diagnosis = build_version(document.session(), d, settings, 0, "");
  const auto made = fitted();
  EXPECT_NEAR(*of_diagnosis->report->held_out.rms_pixel, *made->report->held_out.rms_pixel, 1e-7);
  EXPECT_EQ(of_diagnosis->wrong_points.size(), made->wrong_points.size());
}

TEST_F(EffectsTest, SingleNumbersAreHeldTypedAndFreed) {
  ModelSettings settings = with_springs();
  settings.estimated.insert(settings.estimated.begin(), settings.held.begin(), settings.held.end());
  settings.held.clear();
  perform(settings);
  document.take_version(fitted());
  const double arm_2 = document.model()->fit->effects[1].term.values[0];

  document.perform(with_number_held(document, "joint_elasticity", 0, true));
  EXPECT_EQ(document.undo_stack().undoText(), "held the compliance of joint elasticity of right_arm_1");
  document.perform(with_value(document, "joint_elasticity", 0, 3e-4));
  const ModelSettings now = document.settings();
  ASSERT_EQ(now.estimated.size(), 2U) << "the other is still estimated, and the order is kept";
  EXPECT_EQ(now.by_hand, 2);
  EXPECT_EQ(now.estimated[0].values[0], 3e-4);
  EXPECT_TRUE(with_value(document, "joint_elasticity", 1, 3e-4).is_empty()) << "what is estimated cannot be typed";
  const auto version = fitted();
  EXPECT_EQ(version->fit->effects[0].term.values[0], 3e-4);
  EXPECT_EQ(version->fit->effects[0].sigmas[0], 0);
  EXPECT_GT(version->fit->effects[1].sigmas[0], 0);
  EXPECT_GT(std::abs(version->fit->effects[1].term.values[0] - arm_2), 1e-7) << "it makes up for it";
  const Edit edit{.sentence = "x", .settings = SettingsEdit{{}, now}};
  EXPECT_EQ(parse_edit(edit_text(edit)).settings->after, now);

  // The last one too: the whole effect is held, as by its button; one freed again leaves the others.
  document.perform(with_number_held(document, "joint_elasticity", 1, true));
  EXPECT_EQ(document.settings().held.size(), 2U);
  EXPECT_TRUE(document.settings().estimated.empty());
  document.perform(with_number_held(document, "joint_elasticity", 1, false));
  EXPECT_TRUE(document.settings().held.empty());
  ASSERT_EQ(document.settings().estimated.size(), 2U);
  EXPECT_EQ(document.settings().estimated[0].values[0], 3e-4);
  EXPECT_FALSE(with_value(document, "joint_elasticity", 0, 1e-4).is_empty());
  document.undo_all();
  EXPECT_EQ(document.settings(), ModelSettings{});
}

TEST_F(EffectsTest, AStateThatComesBackHasItsModelAgain) {
  const auto first = fitted();
  document.take_version(first);
  const std::int64_t before = document.revision();
  perform(with_springs());
  EXPECT_EQ(document.model(), nullptr);
  const auto second = fitted();
  document.take_version(second);
  document.undo();
  EXPECT_EQ(document.revision(), before);
  EXPECT_EQ(document.model(), first) << "to the last digit";
  document.redo();
  EXPECT_EQ(document.model(), second);
  // Another action in its place is another state.
  document.undo();
  ModelSettings other = with_springs();
  other.held.clear();
  perform(other);
  EXPECT_EQ(document.model(), nullptr);
  EXPECT_NE(document.revision(), second->revision);
  // A fit of a state that is gone is not taken.
  document.take_version(second);
  EXPECT_EQ(document.model(), nullptr);
}

TEST_F(EffectsTest, ASecondLookKeepsTheFit) {
  const auto first = fitted();
  document.take_version(first);
  document.take_second_looks({{document.session().observations.front().id, {}}});
  EXPECT_EQ(document.model(), nullptr);
  ASSERT_EQ(document.model_before_second_looks(), first);
  const auto again = inspected_again(document.session(), *first, document.revision(), document.second_looks());
  EXPECT_TRUE(same_fit(*first, *again));
  document.take_version(again);
  EXPECT_EQ(document.model(), again);
}

TEST(VersionsWithWrongPoints, AreWhatADiagnosisFitsFromTheFirstOn) {
  const Session session = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "hidden_7");
  const Diagnosis d = diagnose(session, {.refitted = 0});
  ASSERT_GT(d.model.wrong.size(), 20U);
  const auto made = make_version(session, {}, 0, "");
  EXPECT_EQ(made->wrong_points.size(), d.model.wrong.size());
  EXPECT_EQ(*made->report->held_out.rms_pixel, *d.report.held_out.rms_pixel);
  EXPECT_EQ(made->fit->tcp_from_body.translation, d.model.fit.tcp_from_body.translation);
  for (const WrongPoint& w : made->wrong_points)
    EXPECT_TRUE(made->inspection->rows[static_cast<std::size_t>(w.index)].outlier) << "odd for Inspect: " << w.id;
  // Inspect still shows how far they are off.
  double worst = 0;
  for (const InspectionRow& row : made->inspection->rows) worst = std::max(worst, row.worst_size);
  EXPECT_GT(worst, 5);
}

TEST_F(EffectsTest, AnEffectAtAPlaceThatTheRobotDoesNotHaveIsSaid) {
  ModelSettings settings;
  settings.estimated = {{"joint_elasticity", 4000, {0}}};
  perform(settings);
  const auto version = fitted();
  EXPECT_FALSE(version->fit);
  EXPECT_GE(version->refusal.size(), 20);
}

}  // namespace
}  // namespace handsight::app
