// SPDX-License-Identifier: Apache-2.0
// check, fit and diagnose name a mistake of a whole kind; convert --fix puts it right beside the old session.
#include <gmock/gmock.h>

#include "cli_runner.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Blunders : public testing::Test {
 protected:
  Blunders() {
    Session s = fixture::stand_session(4);
    s.mount.estimate = true;
    SimulationOptions options;
    options.observations = 30;
    s = simulate_session(s, options).session;
    write(s, "good");
    for (Observation& o : s.observations) o.position[2] *= -1;
    write(s, "wrong");
  }

  void write(Session s, const std::string& name) {
    write_text(folder.path / name / "robot.urdf", fixture::urdf_text(s.robot));
    s.file = folder.path / name / "session.xml";
    save_session(s);
  }

  std::string at(const char* name) { return (folder.path / name).string(); }

  CliResult run(const std::vector<std::string>& arguments) { return run_cli(folder.path, arguments); }

  TemporaryFolder folder;
};

TEST_F(Blunders, OfWhatImproveLeavesAreNamedToo) {
  const auto blunders = run({"improve", at("wrong"), "--names-only", "--json", "-"}).json()["blunders"];
  ASSERT_EQ(blunders.size(), 1u);
  EXPECT_EQ(blunders[0]["id"], "joint_sense");
}

TEST_F(Blunders, AreNamedByThreeCommands) {
  for (const char* command : {"check", "fit", "diagnose"}) {
    const auto blunders = run({command, at("wrong"), "--json", "-"}).json()["blunders"];
    ASSERT_EQ(blunders.size(), 1u) << command;
    EXPECT_EQ(blunders[0]["id"], "joint_sense");
    EXPECT_EQ(blunders[0]["where"], "a3");
    EXPECT_GT(blunders[0]["rms_before_pixel"], 10);
    EXPECT_LT(blunders[0]["rms_after_pixel"], 0.5);
    EXPECT_GT(blunders[0]["ln_bayes_factor"], 10);
    EXPECT_THAT(blunders[0]["together_with"], IsEmpty());
    EXPECT_THAT(run({command, at("wrong")}).output,
                testing::AllOf(HasSubstr("Joint a3 counts the other way"), HasSubstr("--fix joint_sense:a3")))
        << command;
  }
}

TEST_F(Blunders, OfAGoodSessionTheListIsEmpty) {
  for (const char* command : {"check", "fit", "diagnose", "improve"}) {
    const auto json = run({command, at("good"), "--json", "-"}).json();
    ASSERT_TRUE(json.contains("blunders") && json["blunders"].is_array()) << command;
    EXPECT_THAT(json["blunders"], IsEmpty()) << command;
  }
  EXPECT_THAT(run({"fit", at("good")}).output, Not(HasSubstr("mistake")));
}

TEST_F(Blunders, ArePutRightBesideTheOldSession) {
  const std::string before = read_text(folder.path / "wrong/session.xml");
  const CliResult made = run({"convert", at("wrong"), "--fix", "joint_sense:a3", "--out", at("right"), "--json", "-"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_EQ(made.json()["fixed"][0], "joint_sense:a3");
  EXPECT_LT(run({"fit", at("right"), "--json", "-"}).json()["rms_pixel"], 0.5);
  EXPECT_EQ(read_text(folder.path / "wrong/session.xml"), before);
}

TEST_F(Blunders, RefusesWhatIsNotThere) {
  const auto refused = [&](const std::vector<std::string>& arguments, const char* what) {
    const CliResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr(what));
  };
  refused({"convert", at("wrong"), "--fix", "joint_sens:a3", "--out", at("new")}, "joint_sense");
  refused({"convert", at("wrong"), "--fix", "joint_sense:elbow", "--out", at("new")}, "a1 a2 a3");
  refused({"convert", at("wrong"), "--fix", "joint_sense:a3", "--out", at("good")}, "session already");
  refused({"convert", at("wrong"), at("good"), "--fix", "joint_sense:a3", "--out", at("new")}, "one session");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "new"));
}

}  // namespace
}  // namespace handsight::test
