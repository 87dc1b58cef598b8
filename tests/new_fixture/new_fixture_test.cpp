// SPDX-License-Identifier: Apache-2.0
// A kind of fixture more is one file and one line (docs/add_a_fixture.md): a round post, of which nothing but its own
// file knows, goes through all that is done with touches. The commands are those of handsight-cli with that line in its
// list.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "chain/sighting.h"
#include "cli/cli_runner.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"
#include "session/touch_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using namespace test;
using testing::HasSubstr;
using Json = nlohmann::json;

const std::filesystem::path samples = HANDSIGHT_SOURCE_DIR "/sample_sessions";
constexpr double hidden_zero = 2e-3, sigma = 2e-5;  // rad, m

class NewFixture : public testing::Test {
 protected:
  /// A robot whose second joint has its zero off, before plates, sockets and two posts, and before the posts alone.
  void SetUp() override {
    const std::string posts =
        "<post id=\"mast\" xyz=\"0.5 0.1 0.3\" axis=\"0 0 1\" estimate=\"yes\"/>"
        "<post id=\"bar\" xyz=\"0.45 -0.1 0.35\" axis=\"0 1 0.2\" estimate=\"yes\" place_sigma=\"1e-3\"/>";
    std::string text = read_text(samples / "rigs" / "six_axis_touch" / "session.xml");
    const std::string robot = "../../robots/six_axis.urdf", begin = "<touch sigma=\"2e-05\">", end = "</touch>";
    text.replace(text.find(robot), robot.size(), "robot.urdf");
    const std::size_t first = text.find(begin) + begin.size(), last = text.find(end);
    simulate("made", text.substr(0, first) + posts + text.substr(first), "140");
    simulate("alone", text.substr(0, first) + posts + text.substr(last), "60");
  }
  void simulate(const std::string& name, const std::string& like, const std::string& observations) {
    write_text(folder.path / ("like_" + name) / "session.xml", like);
    write_text(folder.path / ("like_" + name) / "robot.urdf", read_text(samples / "robots" / "six_axis.urdf"));
    const CliResult r = run({"simulate", "--like", at("like_" + name), "--out", at(name), "--seed", "3",
                             "--observations", observations, "--effect", "joint_offset:axis_2.offset=0.002"});
    ASSERT_EQ(r.exit_code, 0) << r.errors;
  }
  std::string at(const std::string& name) const { return (folder.path / name).string(); }
  CliResult run(const std::vector<std::string>& arguments) { return run_cli(folder.path, arguments); }
  Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const CliResult r = run(arguments);
    EXPECT_EQ(r.exit_code, 0) << arguments.front() << ": " << r.errors;
    return r.exit_code == 0 ? r.json() : Json();
  }
  static Json named(const Json& list, const char* key, const std::string& name) {
    for (const Json& one : list)
      if (one.at(key) == name) return one;
    ADD_FAILURE() << "no " << name << " in " << list.dump();
    return {};
  }

  TemporaryFolder folder;
};

const Observation& first_touch(const Session& s, const std::string& id) {
  for (const Observation& o : s.observations)
    if (s.fixtures[static_cast<std::size_t>(o.part)].id == id) return o;
  throw std::runtime_error("nothing touches " + id);
}

TEST_F(NewFixture, IsReadWrittenAndSimulated) {
  const Session made = read_session(at("made"));
  const std::string text = session_text(made);
  EXPECT_THAT(text, HasSubstr("<post id=\"mast\""));
  EXPECT_EQ(session_text(parse_session(text, "session.xml")), text);
  EXPECT_EQ(touch_value(first_touch(made, "mast").sightings.front()), 0.05);
  EXPECT_THAT(run({"check", at("made")}).output, HasSubstr("Fixture mast on stand, a post: 20 touches"));
}

TEST_F(NewFixture, ItsResidualHasItsDerivative) {
  const Session made = read_session(at("made"));
  const Sighting& s = first_touch(made, "bar").sightings.front();
  const Vector3 tip(0.03, -0.02, 0.4);
  const SightingResidual r = sighting_residual(nullptr, s, tip);
  ASSERT_EQ(r.rows, 1);
  EXPECT_NEAR(r.error[0], 0.05 - std::hypot(0.03, 0.02), 1e-15);
  for (int i = 0; i < 3; ++i) {
    const double step = 1e-7;
    const Vector3 beside = tip + step * Vector3::Unit(i);
    EXPECT_NEAR(r.by_point(0, i), -(sighting_residual(nullptr, s, beside).error[0] - r.error[0]) / step, 1e-6);
  }
}

TEST_F(NewFixture, IsFittedAndItsErrorsAreThoseOfItsNoise) {
  const Json fit = json_of({"fit", at("made"), "--effects", "joint_offset:axis_2"});
  const Json zero = fit.at("effects").at(0).at("parameters").at(0);
  EXPECT_NEAR(zero.at("value"), hidden_zero, 4 * zero.at("sigma").get<double>());
  EXPECT_LT(zero.at("sigma"), 2e-5);
  EXPECT_NEAR(fit.at("chi2_per_dof"), 1, 0.3);
  const Json mast = named(fit.at("fixtures"), "title", "mast");
  EXPECT_NEAR(mast.at("rms_m"), sigma, 0.6 * sigma);
  EXPECT_LT(mast.at("held_out_rms_m"), 2.5 * sigma) << "left out of each fold";
  EXPECT_GT(mast.at("held_out_rms_m"), mast.at("rms_m"));
  EXPECT_LT(mast.at("held_out_session_rms_m"), 10) << "by a robot that was learned from the others";
  const Json place = mast.at("place");
  EXPECT_NEAR(std::abs(place.at("axis").at(2).get<double>()), 1, 1e-3);
  EXPECT_LT(place.at("sigma_m"), 1e-3);
  EXPECT_THAT(run({"fit", at("made")}).output, HasSubstr("mast goes through"));
}

TEST_F(NewFixture, TellsTheHiddenCause) {
  const Json improved = json_of({"improve", at("made"), "--export", at("calibration.xml")});
  ASSERT_EQ(improved.at("effects").size(), 1U) << improved.at("effects").dump();
  EXPECT_EQ(improved.at("effects").at(0).at("id"), "joint_offset");
  EXPECT_EQ(improved.at("effects").at(0).at("parameters").at(0).at("of"), "axis_2");
  EXPECT_EQ(run({"export", at("calibration.xml"), "--robot", at("made/robot.urdf"), "--as", "urdf", "--out",
                 at("exported.urdf")})
                .exit_code,
            0);
  EXPECT_EQ(
      run({"predict", at("calibration.xml"), "--robot", at("made/robot.urdf"), "--position", "0.1 0.4 -0.3 0 0.5 0"})
          .exit_code,
      0);
}

TEST_F(NewFixture, AWrongReadingOfItIsFound) {
  std::string text = read_text(folder.path / "made" / "session.xml");
  const std::string reading = "fixture=\"mast\" value=\"0.05\"";
  text.replace(text.find(reading), reading.size(), "fixture=\"mast\" value=\"0.051\"");
  write_text(folder.path / "made" / "session.xml", text);
  const Session made = read_session(at("made"));
  const Json fit = json_of({"fit", at("made"), "--effects", "joint_offset:axis_2", "--loss", "huber"});
  int outliers = 0;
  for (const Json& o : fit.at("per_observation")) {
    if (o.at("outlier") == false) continue;
    ++outliers;
    EXPECT_EQ(o.at("id"), first_touch(made, "mast").id);
    EXPECT_NEAR(o.at("rms_m"), 1e-3, 2e-4);
  }
  EXPECT_EQ(outliers, 1);
}

TEST_F(NewFixture, IsPlannedComparedConvertedAndSketched) {
  const Json plan = json_of({"plan", at("alone"), "--count", "3"});
  ASSERT_EQ(plan.at("poses").size(), 3U);
  for (const Json& pose : plan.at("poses")) EXPECT_TRUE(pose.at("fixture") == "mast" || pose.at("fixture") == "bar");
  EXPECT_EQ(json_of({"compare", at("made"), at("made")}).at("verdict"), "unchanged");
  std::ofstream table(folder.path / "touches.csv");
  const Session made = read_session(at("made"));
  for (const std::string& joint : made.joints) table << joint << " [rad],";
  table << "fixture,value [mm]\n";
  table.precision(17);
  for (const Observation& o : made.observations) {
    if (!made.fixtures[static_cast<std::size_t>(o.part)].id.starts_with("mast")) continue;
    for (const double q : o.position) table << q << ',';
    table << "post_1,50\n";
  }
  table.close();
  const CliResult none =
      run({"convert", at("touches.csv"), "--robot", at("made/robot.urdf"), "--tcp", "hand", "--out", at("converted")});
  EXPECT_THAT(none.errors, HasSubstr("does not say where it is"));
  const CliResult r = run({"convert", at("touches.csv"), "--robot", at("made/robot.urdf"), "--tcp", "hand", "--fixture",
                           "post post_1 xyz=0.5,0.1,0.3 axis=0,0,1", "--out", at("converted")});
  ASSERT_EQ(r.exit_code, 0) << r.errors;
  EXPECT_EQ(read_session(at("converted")).fixtures.front().kind->tag, std::string("post"));
  ASSERT_EQ(run({"target", "--kind", "touch", "--out", at("touch.pdf")}).exit_code, 0);
  EXPECT_THAT(read_text(folder.path / "touch.pdf"), HasSubstr("A round post."));
}

}  // namespace
}  // namespace handsight
