// SPDX-License-Identifier: Apache-2.0
// The same story in badge, sentence, header, cards, blame, rail, report and command line over more than thirty
// sessions: as they are opened, with what leads added, and taken back.
#include <gtest/gtest.h>

#include "app/two_hands.h"
#include "app/window/explain_fixture.h"
#include "app/window/reported_story.h"
#include "app/window/rig_sessions.h"
#include "export/report_story.h"

namespace handsight::test {
namespace {

/// A session to be told: a sample, one below the shared ones, or simulated like one of the rigs.
struct Made {
  std::string name;
  std::string from;                    // sample, "real/...", "field/..." or a rig's name
  std::vector<std::string> simulated;  // what `simulate` is asked for beside it; empty: `from` as it is
};

std::ostream& operator<<(std::ostream& out, const Made& made) { return out << made.name; }

std::vector<Made> all_made() {
  std::vector<Made> list;
  for (int i = 1; i <= 8; ++i) list.push_back({"hidden_" + std::to_string(i), "hidden_" + std::to_string(i), {}});
  for (const char* sample : {"hundred_poses", "panda_sockets", "probe_and_plate", "thesis_simulation"})
    list.push_back({sample, sample, {}});
  for (const char* made : {"both_hands", "one_camera", "three_cameras"}) list.push_back({made, "", {}});
  const std::pair<const char*, std::string> effects[] = {{"offset", "joint_offset:axis_2.offset=0.01"},
                                                         {"scale", "joint_scale:axis_1.scale=0.005"},
                                                         {"spring", "joint_elasticity:axis_2.compliance=2e-4"},
                                                         {"geometry", "link_geometry:axis_3.tu=0.005"},
                                                         {"play", "backlash:axis_2.gap=0.005"},
                                                         {"hysteresis", "friction_hysteresis:axis_2.gap=0.01"},
                                                         {"eccentric", "encoder_eccentricity:axis_3.sine=0.004"},
                                                         {"ripple", "transmission_ripple:axis_4.sine=0.004"},
                                                         {"drift", "mount_drift:rz=0.006"},
                                                         {"mount", "camera_mount:rx=0.004"}};
  for (const auto& [name, effect] : effects) list.push_back({name, "six_axis_stand", {"--effect", effect}});
  list.push_back({"nothing", "six_axis_stand", {"--observations", "40"}});
  list.push_back({"few", "six_axis_stand", {"--effect", effects[0].second, "--observations", "9"}});
  list.push_back({"noisy", "six_axis_stand", {"--effect", effects[2].second, "--noise", "2"}});
  for (const char* rig : {"seven_axis_stand", "justin_head", "camera_on_hand", "one_camera_board", "six_axis_touch"})
    list.push_back({rig, rig, {"--observations", "40"}});
  list.push_back({"tracker", "six_axis_tracker", {"--effect", effects[0].second, "--noise", "2e-4"}});
  for (const char* real : {"fr3_hand_eye_even", "irb120_some", "justin_left_even", "justin_right_even",
                           "motoman_left_even", "mukca_kuka_14", "mukca_panda_2_sockets", "positioner_even"})
    list.push_back({std::string("real_") + real, std::string("real/") + real, {}});
  for (const char* field : {"real_square_size", "print_scale/right", "print_scale/declared_two_percent_small"})
    list.push_back({"field_" + std::string(field).substr(std::string(field).find('/') + 1),
                    std::string("field/cameras/") + field,
                    {}});
  return list;
}

class ThirtySessions : public Explain, public testing::WithParamInterface<Made> {
 protected:
  static bool is_shared() { return GetParam().from.find('/') != std::string::npos; }
  /// Nothing where it is a shared one that is not here.
  std::optional<std::filesystem::path> make() {
    const auto& [name, from, simulated] = GetParam();
    if (name == "both_hands") return two_hands(folder.path);
    if (name == "one_camera") return sample_with_cameras(folder.path, "hidden_3", 1);
    if (name == "three_cameras") return sample_with_cameras(folder.path, "hidden_4", 3);
    if (is_shared()) {
      const auto shared = std::filesystem::path(HANDSIGHT_SHARED_DIR) / from;
      if (!std::filesystem::exists(shared)) return std::nullopt;
      std::filesystem::copy(shared, folder.path / "copy", std::filesystem::copy_options::recursive);
      return folder.path / "copy";
    }
    if (simulated.empty()) return make_copy(from);
    std::vector<std::string> arguments{"simulate",
                                       "--like",
                                       std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/" + from,
                                       "--out",
                                       (folder.path / "made").string(),
                                       "--seed",
                                       "7",
                                       "--images",
                                       "none"};
    arguments.insert(arguments.end(), simulated.begin(), simulated.end());
    EXPECT_EQ(run_cli(folder.path, arguments).exit_code, 0);
    return folder.path / "made";
  }
  void expect_in_the_report() {
    const app::ModelVersionPointer model = desk.document().model();
    ASSERT_TRUE(model && model->fit);
    const app::ReportStory report = app::report_story(desk.window.workbench(), model);
    EXPECT_EQ(report.verdict, explain.verdict().sentence);
    if (reported.story().error.error && desk.window.workbench().blunders().empty())
      EXPECT_TRUE(report.figures.contains(widgets::with_unit_text(reported.header().now, reported.header().unit)))
          << report.figures.toStdString();
  }
  void expect_from_the_command() {
    const auto cli = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"});
    ASSERT_LE(cli.exit_code, 1) << cli.output;  // 1: something is left
    const auto story = cli.json()["story"];
    EXPECT_EQ(story["state"].get<std::string>(), story_state_text(reported.story().state));
    std::vector<std::string> command, window;
    for (const auto& cause : story["causes"]) command.push_back(cause["id"].get<std::string>());
    for (const StoryCause& cause : reported.story().causes) window.push_back(cause.id);
    EXPECT_EQ(command, window);
    if (!reported.header().now) return;
    // Of a flange's poses the robot's own error is weighed, as `fit` does it; the search has a fit without that.
    const bool as_fit = desk.document().session().robot.is_of_poses;
    const double scale = reported.story().error.in_pixels ? 1 : 1e3;
    const auto fitted = as_fit
                            ? run_cli(folder.path, {"fit", session.string(), "--without-wrong-points", "--json", "-"})
                                  .json()[reported.story().error.in_pixels ? "held_out_rms_pixel" : "held_out_rms_m"]
                            : story["error"];
    EXPECT_NEAR(scale * fitted.get<double>(), *reported.header().now, 1e-6);
  }
  Told reported{desk};
};

TEST_P(ThirtySessions, TellOneStoryEach) {
  const auto made = make();
  if (!made) GTEST_SKIP() << "the session is not here";
  session = *made;
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.wait([&] { return desk.document().model() != nullptr; }, 120000));
  desk.key(Qt::Key_4, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled(300000));
  reported.expect_one_story("opened");
  expect_in_the_report();
  if (GetParam().name != "both_hands") expect_from_the_command();
  if (is_shared() || !explain.can_add_first()) return;
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("added");
  expect_in_the_report();
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  reported.expect_one_story("undone");
}

INSTANTIATE_TEST_SUITE_P(Of, ThirtySessions, testing::ValuesIn(all_made()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace handsight::test
