// SPDX-License-Identifier: Apache-2.0
// In every state of the window badge, sentence, header, cards, actions, blame, Inspect and rail tell one story.
#include <gtest/gtest.h>

#include "app/two_hands.h"
#include "app/window/explain_fixture.h"
#include "app/window/reported_story.h"
#include "diagnosis/verdict/finding.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"

namespace handsight::test {
namespace {

class OneStory : public Explain {
 protected:
  Told reported{desk};
  void open_simulated() {
    desk.window.resize(1440, 900);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(explain.open());
  }
  /// A session of the sample's poses with other eyes; its noise is 0.2 px or mm.
  void write(const char* name, const std::function<void(Session&)>& change, bool is_tracker = false) {
    Session like = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/thesis_simulation");
    change(like);
    SimulationOptions options;
    options.observations = 40;
    options.noise = is_tracker ? 2e-4 : 0.2;
    options.declare_noise = false;
    options.effects = {
        term_of(*find_effect("joint_offset"), find_joint(like.robot, like.joints[like.joints.size() - 6]))};
    options.effects[0].values = {0.01};
    session = folder.path / name;
    write_simulated(simulate_session(like, options), options, handsight::folder(like) / like.robot_file, {}, session);
  }
};

TEST_F(OneStory, FromTheFirstLookToTheEndAndBack) {
  open("hidden_3");
  reported.expect_one_story("nothing chosen");
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return desk.window.workbench().predicted_error().has_value(); }));
  EXPECT_TRUE(reported.header().predicted && reported.header().predicted_ratio)
      << "a preview changes the ratio with the error";
  reported.expect_one_story("hover");
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  desk.click(strip, strip->cell_rect(7).center().toPoint());
  reported.expect_one_story("chosen");

  QPushButton *add = explain.cards()->add_button(), *why_not = explain.cards()->why_not_button();
  const QRect where_add = add->geometry(), where_why_not = why_not->geometry();
  EXPECT_EQ(add->text(), "Add joint elasticity");
  desk.click(add);
  QTest::qWait(20);
  EXPECT_EQ(add->geometry(), where_add);
  EXPECT_EQ(why_not->geometry(), where_why_not) << "nothing comes under the pointer";
  ASSERT_TRUE(explain.is_settled());
  ASSERT_EQ(desk.document().undo_stack().index(), 1);
  reported.expect_one_story("added");
  EXPECT_EQ(reported.story().state, StoryState::at_the_noise);
  EXPECT_EQ(add->geometry(), where_add);
  EXPECT_EQ(why_not->geometry(), where_why_not);

  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  reported.expect_one_story("reopened");
  EXPECT_EQ(reported.story().state, StoryState::at_the_noise);
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("undone");
  EXPECT_EQ(reported.story().state, StoryState::missing);
  desk.window.workbench().explaining.hold(true);
  desk.click(add);
  ASSERT_TRUE(explain.workspace()->adding().is_running());
  desk.window.workbench().explaining.stop();
  desk.window.workbench().explaining.hold(false);
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("stopped");
}

TEST_F(OneStory, ACurveAddedIsNotGreenAndNobodyIsToBlameForNoise) {
  open("hidden_8");
  reported.expect_one_story("a curve without a name");
  desk.click(explain.cards()->add_button());
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("added");
  EXPECT_EQ(reported.story().state, StoryState::unnamed_at_the_noise);
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::unnamed);
  EXPECT_NE(explain.first().kind, widgets::CardKind::adequate);
  EXPECT_NE(reported.rail("rail_explain").state, app::WorkState::done);
}

/// Everything that the search names was tried and did not lower the error on what the fit has not seen.
TEST_F(OneStory, WhereEverythingWasRefusedNothingLeads) {
  open("hidden_3");
  app::Workbench& workbench = desk.window.workbench();
  const auto diagnosis = workbench.diagnosing.diagnosis();
  ASSERT_TRUE(diagnosis);
  for (const DiagnosisCandidate& c : diagnosis->candidates)
    workbench.refused.push_back({find_id(c), c.where, "It would fit noise.", "", desk.document().undo_stack().index(),
                                 desk.document().revision()});
  for (const auto unit : {widgets::SizeUnit::millimetre, widgets::SizeUnit::pixel}) workbench.units.choose(unit);
  EXPECT_EQ(reported.story().state, StoryState::refused);
  EXPECT_EQ(reported.story().lead(), nullptr);
  reported.expect_one_story("refused");
  EXPECT_FALSE(explain.cards()->add_button()->isEnabled()) << "what was refused is not added by a second click";
}

TEST_F(OneStory, WithACollection) {
  session = two_hands(folder.path);
  open_simulated();
  reported.expect_one_story("collection");
  desk.click(explain.cards()->add_button());
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("collection, added");
}

TEST_F(OneStory, WithATracker) {
  write(
      "tracker",
      [](Session& s) {
        s.rig.reset();
        s.sigma_pixel.reset();
      },
      true);
  open_simulated();
  reported.expect_one_story("tracker");
  ASSERT_TRUE(reported.story().error.ratio());
  const auto cli = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"}).json()["story"];
  EXPECT_NEAR(1e3 * cli["error"].get<double>(), *reported.header().now, 1e-6) << "one figure in window and command";
  EXPECT_NEAR(1e3 * cli["noise"].get<double>(), *reported.header().noise, 1e-6);
  ASSERT_FALSE(reported.story().causes.empty());
  EXPECT_EQ(cli["causes"][0]["id"].get<std::string>(), reported.story().causes[0].id);
}

TEST_F(OneStory, WithOneMarkerWhoseNoiseNobodyKnows) {
  write("one_marker", [](Session& s) {
    s.marker_count = 1;
    s.sigma_pixel.reset();
    for (Observation& o : s.observations)
      std::erase_if(o.sightings, [](const Sighting& one) { return one.marker > 0; });
  });
  open_simulated();
  reported.expect_one_story("one marker, no noise known");
  EXPECT_FALSE(explain.verdict().state == widgets::SessionState::adequate && !reported.story().error.noise)
      << "nobody can say that it agrees";
}

}  // namespace
}  // namespace handsight::test
