// SPDX-License-Identifier: Apache-2.0
// Places that once told different stories: the sentence and the cards, the error and the tick, Explain's blame and
// Inspect's, a proof of something else, units within one breath.
#include <gtest/gtest.h>

#include "app/window/explain_fixture.h"
#include "app/window/reported_story.h"
#include "inspect/inspect_workspace.h"
#include "widgets/explain/staircase.h"

namespace handsight::test {
namespace {

class Contradictions : public Explain {
 protected:
  Told reported{desk};
  void open_path(const std::filesystem::path& path) {
    desk.window.resize(1440, 900);
    session = path;
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(explain.open());
  }
  bool open_simulated(std::vector<std::string> extra) {
    if (!simulate(std::move(extra))) return false;
    open_path(session);
    return true;
  }
  static std::filesystem::path real(const char* name) {
    return std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / name;
  }
  void open_copy(const std::filesystem::path& from) {
    std::filesystem::copy(from, folder.path / "copy", std::filesystem::copy_options::recursive);
    open_path(folder.path / "copy");
  }
};

/// 1: what the sentence names has its card, the first; the command names the same.
TEST_F(Contradictions, TheSentenceNamesTheFirstCardAndSoDoesTheCommand) {
  if (!std::filesystem::exists(real("justin_right_even"))) GTEST_SKIP() << "the real robot is not here";
  open_copy(real("justin_right_even"));
  reported.expect_one_story("the real Justin");
  ASSERT_FALSE(reported.story().causes.empty());
  const auto cli = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"}).json();
  EXPECT_EQ(cli["story"]["causes"][0]["id"].get<std::string>(), reported.story().causes[0].id);
  EXPECT_EQ(cli["story"]["state"].get<std::string>(), story_state_text(reported.story().state));
  const std::string title = find_effect(reported.story().causes[0].id)->title;
  EXPECT_NE(cli["story"]["text"].get<std::string>().find(title), std::string::npos) << cli["story"]["text"];
  if (reported.story().lead()) EXPECT_EQ(explain.first().id.toStdString(), reported.story().lead()->id);
  EXPECT_NEAR(1e3 * cli["story"]["error"].get<double>(), *reported.header().now, 1e-6) << "one figure: the rms";
  EXPECT_NEAR(1e3 * cli["story"]["noise"].get<double>(), *reported.header().noise, 1e-6);
}

/// 2: while causes are added, and at the end, nothing is said to agree that is more than 1.5 times the noise.
TEST_F(Contradictions, OnTheWayDownNothingAgreesThatDoesNot) {
  if (!std::filesystem::exists(real("justin_right_even"))) GTEST_SKIP() << "the real robot is not here";
  open_copy(real("justin_right_even"));
  QStringList said;
  QObject::connect(&desk.document(), &app::Document::noticed, &desk.window, [&](const QString& s) { said << s; });
  desk.press_button("until_it_stops");
  const auto* button = desk.find<QAbstractButton>("until_it_stops");
  int looks = 0;
  ASSERT_TRUE(desk.wait(
      [&] {
        const double ratio = reported.story().error.ratio().value_or(0);
        if (ratio > most_that_agrees && ++looks > 0) {
          EXPECT_FALSE(Told::says_that_it_agrees(explain.verdict().sentence))
              << explain.verdict().sentence.toStdString();
          EXPECT_NE(reported.rail("rail_explain").line, "nothing is missing");
        }
        return button->text() != "Stop";
      },
      400000));
  ASSERT_TRUE(explain.is_settled());
  EXPECT_GT(looks, 0);
  reported.expect_one_story("at the end");
  const double ratio = reported.story().error.ratio().value_or(0);
  if (ratio > most_that_agrees) EXPECT_FALSE(said.join('\n').contains("nothing is missing any more"));
  for (const StandIn& one : reported.story().stands_in)
    EXPECT_TRUE(explain.verdict().sentence.contains(app::effect_text(one.id, one.where)))
        << "what stands in is said in the sentence: " << explain.verdict().sentence.toStdString();
}

/// 3: one unit in one breath, and the ratio is that of the numbers beside it.
TEST_F(Contradictions, InMillimetresEverythingIsInMillimetres) {
  open("hidden_6");
  desk.window.workbench().units.choose(widgets::SizeUnit::millimetre);
  QTest::qWait(60);
  const auto& n = reported.header();
  ASSERT_TRUE(n.now && n.noise);
  EXPECT_EQ(n.unit, "mm");
  EXPECT_NEAR(n.ratio.value_or(*n.now / *n.noise), *n.now / *n.noise, 1e-9) << "the ratio follows the unit";
  const FitReport& r = *desk.document().model()->report;
  EXPECT_NEAR(*n.now, 1e3 * *r.held_out.hand_m, 1e-9) << "of the hand, all markers together";
  EXPECT_NEAR(*n.noise, 1e3 * *r.noise_of_hand_m, 1e-9);
  if (*n.now / *n.noise < 0.7 * *reported.story().error.ratio()) EXPECT_EQ(n.noise_note, "mostly of the depth");
  EXPECT_EQ(explain.first().error.unit, "mm");
  EXPECT_EQ(widgets::with_unit_text(explain.first().error.now, "mm"), widgets::with_unit_text(n.now, "mm"));
  ASSERT_TRUE(explain.first().error.left);
  EXPECT_LT(*explain.first().error.left, *n.now);
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return desk.window.workbench().predicted_error().has_value(); }));
  EXPECT_FALSE(reported.header().predicted) << "what is not known in this unit is left out";
  EXPECT_FALSE(explain.verdict().predicted.value && explain.verdict().predicted.unit != widgets::SizeUnit::millimetre);
  desk.window.workbench().units.choose(widgets::SizeUnit::pixel);  // it is remembered
}

/// 4: the same observations, the same fault.
TEST_F(Contradictions, InspectBlamesWhatExplainBlames) {
  ASSERT_TRUE(open_simulated({"--effect", "mount_drift:rz=0.006", "--observations", "60", "--images", "none"}));
  ASSERT_FALSE(reported.story().causes.empty());
  const auto& whole = explain.verdict().attribution;
  ASSERT_TRUE(whole);
  ASSERT_GT(whole->cameras, whole->robot) << "what is missing moves the cameras: " << reported.story().causes[0].id;
  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  InspectPage inspect{desk};
  inspect.sort_worst_first("px");  // a drift begins with nothing
  int cameras = 0, all = 0;
  for (int row = 0; row < 8; ++row) {
    inspect.click_row(row);
    const InspectionRow* shown = desk.window.workbench().selected_row();
    ASSERT_NE(shown, nullptr);
    if (shown->attribution.cause != ErrorCause::robot) continue;
    const auto& bar = desk.find<widgets::AttributionBar>("blame")->attribution();
    ASSERT_TRUE(bar);
    ++all;
    cameras += bar->cameras > bar->robot ? 1 : 0;
    EXPECT_FALSE(desk.find<widgets::AttributionBar>("blame")->sentence().startsWith("The robot:"))
        << desk.find<widgets::AttributionBar>("blame")->sentence().toStdString();
  }
  EXPECT_GT(all, 0);
  EXPECT_EQ(cameras, all);
}

/// 4: with one marker nobody is to blame, and yet what is beyond the noise does not agree.
TEST_F(Contradictions, InspectSaysOfNothingBeyondTheNoiseThatItAgrees) {
  if (!std::filesystem::exists(real("justin_left_even"))) GTEST_SKIP() << "the real robot is not here";
  std::filesystem::copy(real("justin_left_even"), folder.path / "copy", std::filesystem::copy_options::recursive);
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "copy").string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  int beyond = 0;
  for (const std::int64_t id : {0, 1, 2, 3, 100, 200}) {
    desk.window.workbench().selection.select_observation(id);
    QTest::qWait(20);
    const InspectionRow* row = desk.window.workbench().selected_row();
    ASSERT_TRUE(row && row->ratio);
    const QString sentence = desk.find<widgets::AttributionBar>("blame")->sentence();
    const bool agrees = *row->ratio < widgets::noise_limit(row->coordinates);
    beyond += agrees ? 0 : 1;
    EXPECT_EQ(sentence.contains("Agrees with the model"), agrees) << sentence.toStdString();
  }
  EXPECT_GT(beyond, 0);
}

/// Labels that came with the session can be played, whether they have images or not: both places say so.
TEST_F(Contradictions, TheRailOffersToPlayWhatTheTransportPlays) {
  open("hidden_3");
  desk.key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(desk.find<QAbstractButton>("play")->isEnabled());
  EXPECT_EQ(reported.rail("rail_calibrate").line, "ready to play");
}

/// Header and bill in mm: with the mount given, what a cause is worth at the hand is what the error loses by it.
TEST_F(Contradictions, TheBillIsWhatTheErrorLoses) {
  open("hidden_3");
  const double before = *desk.document().model()->report->held_out.hand_m;
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const app::ModelVersionPointer now = desk.document().model();
  const std::vector<BillRow> bill = desk.window.workbench().make_bill(now);
  ASSERT_EQ(bill.size(), 1U);
  EXPECT_NEAR(std::hypot(bill[0].hand_m, *now->report->held_out.hand_m), before, 0.1 * before);
}

/// A target of another size does not move the hand.
TEST_F(Contradictions, NothingIsMissedByNothing) {
  const auto session_of_target =
      std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/print_scale/declared_two_percent_small";
  if (!std::filesystem::exists(session_of_target)) GTEST_SKIP() << "the sessions of the field are not here";
  open_copy(session_of_target);
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  QStringList said;
  for (const QLabel* label : desk.find<QWidget>("export_remarks")->findChildren<QLabel*>()) said << label->text();
  EXPECT_TRUE(said.join(' ').contains("size of the target")) << said.join(' ').toStdString();
  EXPECT_FALSE(said.join(' ').contains("misses by 0")) << said.join(' ').toStdString();
}

TEST_F(Contradictions, NothingIsOddIsNotSaidWhereAllAreBeyondTheThreshold) {
  open("hidden_3");
  EXPECT_GT(reported.story().beyond, 40);
  EXPECT_TRUE(reported.rail("rail_inspect").line.contains(QString("%1 of 80").arg(reported.story().beyond)))
      << reported.rail("rail_inspect").line.toStdString();
  EXPECT_EQ(reported.rail("rail_inspect").state, app::WorkState::care);
}

/// 5: what speaks for a cause is what its own points follow; "the proof" stands over the proof alone.
TEST_F(Contradictions, TheEvidenceOfACauseIsItsOwn) {
  open("hidden_3");
  ASSERT_TRUE(desk.wait([&] { return explain.first().evidence.contains("follow"); }));
  EXPECT_TRUE(explain.first().evidence.contains("gravity torque")) << explain.first().evidence.toStdString();
  for (int i = 0; i < explain.cards()->count(); ++i)
    EXPECT_FALSE(explain.cards()->card(i)->state().evidence.contains("million"))
        << "right and wrong ones alike: " << explain.cards()->card(i)->state().evidence.toStdString();
  auto* title = desk.find<QLabel>("failing_title");
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return title->text() == "Where it fails: the proof"; })) << title->text().toStdString();
  ASSERT_GT(explain.cards()->count(), 1);
  auto* second = explain.cards()->card(1);
  second->setFocus(Qt::TabFocusReason);
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  ASSERT_TRUE(desk.wait([&] { return title->text() != "Where it fails: the proof"; }));
}

/// 7: what other programs read is written by the window, too.
TEST_F(Contradictions, ThePageThatNamesFilesWritesThem) {
  open("hidden_3");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString((folder.path / "out.xml").string()));
  auto* kinds = desk.find<QComboBox>("other_kind");
  const std::map<QString, std::pair<const char*, const char*>> files = {
      {"urdf", {"out.urdf", "<robot"}},
      {"yaml", {"out.yaml", "tcp_from_body"}},
      {"static_tf", {"out.launch.py", "static_transform_publisher"}},
      {"opencv", {"out.opencv.yaml", "%YAML"}},
      {"cpp", {"out.cpp", "hand_pose"}},
      {"python", {"out.py", "def hand_pose"}},
      {"csv", {"out.csv", "quantity"}},
      {"xacro", {"out.xacro", "xacro:macro"}},
      {"mjcf", {"out.mjcf.xml", "<mujoco"}},
      {"sdf", {"out.sdf", "<sdf"}},
      {"dh", {"out.dh.yaml", "modified"}},
      {"ros2_control", {"out.ros2_control.xml", "offset"}},
      {"lerobot", {"out.lerobot.json", "homing_offset"}}};
  ASSERT_EQ(kinds->count(), static_cast<int>(files.size()) + 1);  // ur_calibration is refused for this robot
  for (int i = 0; i < kinds->count(); ++i) {
    kinds->setCurrentIndex(i);
    if (kinds->currentData().toString() == "ur_calibration") continue;
    desk.press_button("save_other");
    const auto& [name, holds] = files.at(kinds->currentData().toString());
    ASSERT_TRUE(std::filesystem::exists(folder.path / name))
        << name << ": " << desk.find<QLabel>("export_said")->text().toStdString();
    EXPECT_NE(read_file(folder.path / name).find(holds), std::string::npos) << name;
  }
}

/// 8: the truth is no daily button; the row of actions says what it does.
TEST_F(Contradictions, TheTruthStandsInTheSessionsMenu) {
  open("hidden_3");
  EXPECT_EQ(desk.window.findChild<QAbstractButton*>("reveal"), nullptr);
  auto* menu = desk.find<QMenu>("menu");
  emit menu->aboutToShow();
  auto* entry = desk.find<QAction>("reveal");
  EXPECT_TRUE(entry->isVisible());
  EXPECT_EQ(QString(entry->text()).remove('&'), "Reveal the truth");
  std::filesystem::remove(session / "truth.xml");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  emit menu->aboutToShow();
  EXPECT_FALSE(entry->isVisible()) << "which knows no truth";
}

/// 9: Space plays, whatever had the focus when the session came.
TEST_F(Contradictions, SpacePlaysAfterAButtonOfTheHeaderHadTheFocus) {
  session = make_copy("thesis_simulation");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  desk.find<QWidget>("session_menu")->setFocus(Qt::TabFocusReason);
  desk.key(Qt::Key_2, Qt::ControlModifier);
  QTest::qWait(20);
  const QString before = desk.find<QAbstractButton>("play")->text();
  bool is_menu_open = false;
  QTimer::singleShot(300, &desk.window, [&] {
    auto* menu = desk.find<QMenu>("menu");
    is_menu_open = menu->isVisible();
    if (is_menu_open) menu->close();
  });
  desk.key(Qt::Key_Space);
  QTest::qWait(400);
  EXPECT_FALSE(is_menu_open);
  EXPECT_NE(desk.find<QAbstractButton>("play")->text(), before);
  ASSERT_TRUE(desk.settle());
}

}  // namespace
}  // namespace handsight::test
