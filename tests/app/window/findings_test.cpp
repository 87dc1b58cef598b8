// SPDX-License-Identifier: Apache-2.0
// Small things that the findings say and draw: numbers with as many digits as they are worth, names in full, noise that
// looks like noise.
#include <gtest/gtest.h>

#include <random>

#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"
#include "cli/cli_runner.h"
#include "document/effect_words.h"
#include "findings/explain_texts.h"
#include "findings/pattern_plots.h"
#include "findings/proof_plots.h"
#include "fixtures/rare_slip.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"
#include "start/session_places.h"
#include "widgets/lists/attribution_bar.h"
#include "workbench/observation_views.h"

namespace handsight::test {
namespace {

TEST(Findings, OddsHaveTwoDigits) {
  EXPECT_EQ(app::odds_text(std::log(32148)), "about 32000 to one");
  EXPECT_EQ(app::odds_text(std::log(12.4)), "about 12 to one");
  EXPECT_EQ(app::odds_text(-3), "about 1 to one");
  EXPECT_EQ(app::odds_text(20), "more than a million to one");
}

TEST(Findings, AllJointsOfAnArmAreNamed) {
  EXPECT_EQ(app::effect_text("backlash", {"a_1", "a_2", "a_3", "a_4", "a_5", "a_6", "a_7"}),
            "backlash of a_1, a_2, a_3, a_4, a_5, a_6 and a_7");
}

TEST(Findings, SeveralEffectsAreNamedNotTheirIds) {
  EXPECT_EQ(app::list_effects("mount_drift, joint_elasticity"), "mount drift and joint elasticity");
  EXPECT_EQ(app::list_effects("backlash"), "backlash");
}

TEST(Findings, ADriftIsSaidAsOne) {
  ProofPlot plot{.quantity = "turn about x of the mount", .unit = "rad", .against = "time", .against_unit = "s"};
  plot.numbers = {{.name = "rx", .unit = "rad", .value = 0.0018, .sigma = 0.0001}};
  for (const double x : {0.0, 1.0}) plot.points.push_back({.x = x, .share = Eigen::VectorXd::Constant(1, x)});
  plot.hand_m = 2.6e-3;
  EXPECT_EQ(app::proof_sentence(plot), QString::fromUtf8("The mount drifts: 1.80 ± 0.10 mrad over the session (turn "
                                                         "about x of the mount), 2.6 mm at the hand at most."));
}

TEST(Findings, ArrowsOfNoiseStayAsSmallAsNoise) {
  EXPECT_EQ(app::magnification_over_noise(0.01, {}, 0.1), 10) << "where the noise is unknown";
  EXPECT_EQ(app::magnification_over_noise(0.01, 1e-4, 0.1), 10) << "far above the noise";
  EXPECT_EQ(app::magnification_over_noise(2e-4, 1e-4, 0.1), 100) << "6 sigma are as long as what is wanted";
  EXPECT_EQ(app::magnification_over_noise(0, 1e-4, 0.1), 100);
  Inspection inspection;
  inspection.noise_m = 1e-3;
  inspection.rows.resize(20);
  for (InspectionRow& row : inspection.rows) row.is_used = true, row.rms_m = 1.2e-3;
  EXPECT_LT(app::arrow_magnification(inspection) * 1.2e-3, 0.025) << "all is noise: m as drawn";
  inspection.rows.front().rms_m = 0.02;
  EXPECT_EQ(app::arrow_magnification(inspection), 5);
}

QStringList letters_of(QWidget& widget) {
  QStringList letters;
  for (const PaintedText& text : texts_of(widget))
    if (text.text.contains('%')) letters << text.text.left(1);
  return letters;
}

TEST(Findings, BlameOfATrackerHasItsLetter) {
  for (const bool of_tracker : {false, true}) {
    widgets::AttributionBar bar;
    bar.resize(600, 80);
    bar.set_attribution(widgets::ErrorAttribution{0.2, 0.3, 0.5, of_tracker});
    widgets::VerdictLine line;
    line.resize(1056, 72);
    widgets::SessionVerdict verdict;
    verdict.sentence = "It misses.";
    verdict.attribution = widgets::ErrorAttribution{0.2, 0.3, 0.5, of_tracker};
    line.set_verdict(verdict);
    EXPECT_EQ(letters_of(bar), (QStringList{of_tracker ? "T" : "C", "B", "R"}));
    EXPECT_EQ(letters_of(line), (QStringList{of_tracker ? "T" : "C", "B", "R"}));
  }
}

class FindingsIn : public Explain {};

/// All joints repeat to 1.4 mrad: told as one joint's alone the error is more, and that is said beside it.
TEST_F(FindingsIn, ScatterIsNotContradictedByThePlotsBesideIt) {
  session = folder.path / "scatter";
  std::vector<std::string> arguments = {"simulate",
                                        "--like",
                                        std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/hidden_1",
                                        "--observations",
                                        "60",
                                        "--seed",
                                        "4",
                                        "--images",
                                        "none",
                                        "--out",
                                        session.string()};
  std::mt19937 random(3);
  std::normal_distribution<double> angle(0, 1.4e-3);
  for (int i = 0; i < 60; ++i)
    for (int joint = 1; joint <= 6; ++joint) {
      arguments.push_back("--disturb");
      arguments.push_back(fmt::format("{}:joint:axis_{}={:.6f}", i, joint, angle(random)));
    }
  ASSERT_EQ(run_cli(folder.path, arguments).exit_code, 0);
  std::string text = read_text(session / "session.xml");  // else more than robots scatter is reported as unexplained
  text.insert(text.find("<robot ") + 7, "repeatability=\"2e-3\" ");
  write_text(session / "session.xml", text);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  ASSERT_EQ(explain.verdict().state, widgets::SessionState::repeatability) << explain.verdict().sentence.toStdString();
  EXPECT_EQ(desk.find<QLabel>("failing_title")->text(), "What is left") << "nothing fails";
  const Repeatability repeatability{.joints = 1.4e-3};
  const QString beside = app::as_if_alone({"error of axis_5", "angle of axis_2"}, repeatability);
  EXPECT_TRUE(beside.startsWith("Each point: as if axis_5 alone")) << beside.toStdString();
  EXPECT_TRUE(beside.contains("1.4 mrad to which the joints repeat")) << beside.toStdString();
  EXPECT_TRUE(app::as_if_alone({"shift along x of the base", "time"}, repeatability).isEmpty());
  EXPECT_TRUE(app::as_if_alone({"error of axis_5", "time"}, {}).isEmpty()) << "the joints repeat";
}

TEST_F(FindingsIn, ASlipThatIsTooRareToBeNamedIsInTheVerdict) {
  Session slipped = fixture::session_with_rare_slip();
  write_text(folder.path / "arm/robot.urdf", fixture::urdf_text(slipped.robot));
  slipped.file = folder.path / "arm/session.xml";
  save_session(slipped);
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "arm").string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  const QString sentence = explain.verdict().sentence;
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::adequate) << sentence.toStdString();
  EXPECT_TRUE(sentence.contains("May be there, but is too rare to be named on this evidence: mount slip"))
      << sentence.toStdString();
}

TEST_F(FindingsIn, TheStartPageSaysHowASessionStoodThatWasClosedAtOnce) {
  open("hidden_3");
  ASSERT_TRUE(desk.wait([&] { return desk.document().model() && desk.document().model()->fit; }, 30000));
  desk.document().close();
  const auto* row = desk.find<QAbstractButton>("recent_0");
  EXPECT_TRUE(desk.wait([&] { return row->isVisible(); }, 5000));
  EXPECT_TRUE(row->accessibleDescription().simplified().contains("3.4 px, noise 0.20 px"))
      << row->accessibleDescription().toStdString() << "\n"
      << app::recent_sessions().front().state.toStdString();
}

TEST_F(FindingsIn, ATrackersSessionShowsNoPlaceForImages) {
  Session like = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/thesis_simulation");
  like.rig.reset();
  like.sigma_pixel.reset();
  SimulationOptions options;
  options.observations = 20;
  options.noise = 2e-4;
  write_simulated(simulate_session(like, options), options, handsight::folder(like) / like.robot_file, {},
                  folder.path / "tracker");
  ASSERT_TRUE(desk.window.open(QString::fromStdString((folder.path / "tracker").string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_FALSE(desk.find<QWidget>("inspect_left")->isVisible());
  EXPECT_TRUE(desk.find<QWidget>("inspect_scene")->isVisible());
  desk.key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_FALSE(desk.find<QWidget>("calibrate_left")->isVisible());
  EXPECT_TRUE(desk.find<QWidget>("calibrate_scene")->isVisible());
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("hidden_3").string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(desk.find<QWidget>("inspect_left")->isVisible()) << "and of cameras it does again";
}

}  // namespace
}  // namespace handsight::test
