// SPDX-License-Identifier: Apache-2.0
// Exported C++ and Python files, compiled and run: the hand where predict has it.
#include <gtest/gtest.h>

#include "export/cpp_file.h"
#include "export/exported.h"
#include "export/hand_program.h"
#include "export/python_file.h"
#include "fixtures/robots_with_everything.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

void expect_hands(const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& positions,
                  const std::vector<fixture::Answer>& found, const std::string& what) {
  ASSERT_EQ(found.size(), positions.size()) << what;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const TcpPrediction p = predict_tcp(robot.chain, positions[i], robot.model);
    const Matrix4 wanted = matrix_from_rigid(p.root_from_tcp_est);
    ASSERT_EQ(found[i].numbers.size(), 12u) << what;
    EXPECT_EQ(found[i].word, "good") << what;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(found[i].numbers[static_cast<std::size_t>(4 * r + c)], wanted(r, c), 1e-9) << what << " " << i;
  }
}

/// Compiled as a user would, and run by python3 alone.
void expect_programs_agree_at(const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& positions,
                              const std::string& what) {
  const TemporaryFolder folder;
  write(folder.path / "hand.cpp", exported_file(robot, "cpp").text);
  write(folder.path / "hand.py", exported_file(robot, "python").text);
  ASSERT_EQ(fixture::compiled(folder.path / "hand.cpp", folder.path / "hand"), "") << what;
  ASSERT_EQ(fixture::compiled(folder.path / "hand.cpp", folder.path / "hand.o", "-c"), "") << what << ", alone";
  expect_hands(robot, positions, fixture::answers(folder.path, "'" + (folder.path / "hand").string() + "'", positions),
               what + ", C++");
  expect_hands(
      robot, positions,
      fixture::answers(folder.path, "env -i python3 -I '" + (folder.path / "hand.py").string() + "'", positions),
      what + ", Python");
}

void expect_programs_agree(const CalibratedRobot& robot, std::mt19937_64& random, const std::string& what) {
  std::vector<Eigen::VectorXd> positions;
  for (int i = 0; i < 12; ++i) positions.push_back(fixture::random_position(robot.chain, random));
  expect_programs_agree_at(robot, positions, what);
}

/// How far the effects move the hand: what the files would miss without them.
double moved_by_effects(const CalibratedRobot& robot, std::mt19937_64& random) {
  const TcpPrediction p = predict_tcp(robot.chain, fixture::random_position(robot.chain, random), robot.model);
  return (p.root_from_tcp_est.translation - p.root_from_tcp.translation).norm();
}

TEST(Programs, HoldEveryEffectOfTheCatalogueOwnEffectsAndCurves) {
  std::mt19937_64 random(3);
  const Session session = fixture::torso_with_all_kinds();
  for (int draw = 0; draw < 3; ++draw) {
    const Chain chain = make_chain(session);
    const CalibratedRobot robot = fixture::robot_with(session, fixture::everything_wrong(chain, random), random);
    EXPECT_GT(moved_by_effects(robot, random), 1e-4);
    expect_programs_agree(robot, random, "torso " + std::to_string(draw));
  }
}

TEST(Programs, HoldEachEffectAlone) {
  std::mt19937_64 random(31);
  const Session session = fixture::torso_with_all_kinds();
  const Chain chain = make_chain(session);
  const std::vector<EffectTerm> all = fixture::everything_wrong(chain, random);
  const TemporaryFolder folder;
  std::vector<Eigen::VectorXd> positions;
  for (int i = 0; i < 3; ++i) positions.push_back(fixture::random_position(chain, random));
  for (const EffectTerm& term : all) {
    const CalibratedRobot robot = fixture::robot_with(session, {term}, random);
    write(folder.path / "hand.py", exported_file(robot, "python").text);
    expect_hands(robot, positions,
                 fixture::answers(folder.path, "python3 -I '" + (folder.path / "hand.py").string() + "'", positions),
                 term.id);
  }
}

TEST(Programs, AreRightForRobotsOfManyKinds) {
  std::mt19937_64 random(5);
  std::vector<Session> sessions{fixture::stand_session(), fixture::seven_axis_session(3),
                                read_session(HANDSIGHT_SOURCE_DIR "/sample_sessions/rigs/justin_head")};
  for (int i = 0; i < 2; ++i) sessions.push_back(fixture::random_session(random));
  for (const Session& session : sessions) {
    const CalibratedRobot robot =
        fixture::robot_with(session, fixture::everything_wrong(make_chain(session), random), random);
    expect_programs_agree(robot, random, session.robot.name);
    expect_programs_agree(fixture::robot_with(session, {}, random), random, session.robot.name + ", nominal");
  }
}

TEST(Programs, AreRightWhereTheHandIsTheRootOrTheJointIsElsewhere) {
  std::mt19937_64 random(6);
  Session session = fixture::torso_with_all_kinds();
  session.tcp = "box";  // fixed to the root: only a spring of the root moves it
  expect_programs_agree(fixture::robot_with(session, {{"base_elasticity", -1, {1e-5, 2e-6, 3e-5}}}, random), random,
                        "fixed to the root");
  session.tcp = "base";
  expect_programs_agree(fixture::robot_with(session, {}, random), random, "the root");
  // A curve of the hand may follow a joint that does not carry it.
  session = fixture::torso_with_all_kinds();
  for (Joint& j : session.robot.joints) j.stiffness = 0;
  for (Link& l : session.robot.links) l.mass = 0;
  session.tcp = "chest";
  EffectDefinition d;
  d.id = "curve_1";
  d.scope = "session";
  d.parameters = {{"a", "m", 1e-3}};
  d.moves = {{"hand_z", "a*sin(q_arm_2)", 1}};
  const auto own = own_effect(d, session.robot);
  EffectTerm term = term_of(*own, -1, own);
  term.values = {2e-3};
  expect_programs_agree(fixture::robot_with(session, {term}, random), random, "a curve of another joint");
}

/// Velocity, the pose before, time and order, through the functions that a user calls.
/// Postures in which play throws plain passes from one flank to the other.
TEST(Programs, FindTheEquilibriumBetweenTheFlanksOfPlay) {
  std::mt19937_64 random(9);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot = fixture::robot_with(session, {{"backlash", 2, {0.03}}}, random);
  RobotChange change;
  change.joints.resize(robot.chain.robot.joints.size());
  change.joints[static_cast<std::size_t>(robot.chain.joints[2])].gap = 0.03;
  std::vector<Eigen::VectorXd> positions;
  for (int i = 0; i < 20000 && positions.size() < 6; ++i) {
    const Eigen::VectorXd position = fixture::random_position(robot.chain, random);
    const Eigen::VectorXd sensor = joint_values(robot.chain.robot, robot.chain.joints, position);
    if (!solve_posture<double>(robot.chain.robot, sensor, change, robot.chain.gravity).converged)
      positions.push_back(position);
  }
  ASSERT_EQ(positions.size(), 6U);
  expect_programs_agree_at(robot, positions, "play");
}

TEST(Programs, KnowHowTheRobotComesThere) {
  std::mt19937_64 random(8);
  const Session session = fixture::torso_with_all_kinds();
  const CalibratedRobot robot =
      fixture::robot_with(session, fixture::everything_wrong(make_chain(session), random), random);
  DrivenPose before{fixture::random_position(robot.chain, random), {}, 12.0}, there = before;
  there.position = fixture::random_position(robot.chain, random);
  there.velocity = fixture::random_position(robot.chain, random);
  there.velocity[1] = 0;  // there the way from the pose before decides
  there.time = 25.0;
  std::vector<double> times;
  for (int i = 0; i < 12; ++i) times.push_back(10 + 3 * i);
  const TcpPrediction wanted = predict_tcp(states_at(robot.chain, {before, there}, times)[1], robot.model);
  const TemporaryFolder folder;
  write(folder.path / "hand.cpp", cpp_file(hand_program(robot)));
  write(folder.path / "hand.py", python_file(hand_program(robot)));
  std::ostringstream main_cpp, main_python;
  const Eigen::IOFormat list(17, Eigen::DontAlignCols, ",", ",", "", "", "", "");
  main_cpp
      << "#include <cstdio>\n#include \"hand.cpp\"\nint main() { using namespace handsight_hand; double q[] = {"
      << there.position.transpose().format(list) << "}, v[] = {" << there.velocity.transpose().format(list)
      << "}, before[] = {" << before.position.transpose().format(list)
      << "}; Drive d; d.velocity = v; d.from = before; d.share = 15.0 / 33; d.seconds = 15; d.order = 5; Motion m; "
         "hand_pose(q, m, d); std::printf(\"%.17g %.17g %.17g \", m.shift[0], m.shift[1], m.shift[2]); "
         "body_pose(q, m, d); std::printf(\"%.17g %.17g %.17g\\n\", m.shift[0], m.shift[1], m.shift[2]); }\n";
  main_python << "import hand\ndrive = dict(velocity=[" << there.velocity.transpose().format(list) << "], before=["
              << before.position.transpose().format(list) << "], share=15.0/33, seconds=15, order=5)\nq = ["
              << there.position.transpose().format(list)
              << "]\nprint(*[repr(hand.hand_pose(q, **drive)[i][3]) for i in range(3)], "
                 "*[repr(hand.body_pose(q, **drive)[i][3]) for i in range(3)])\n";
  write(folder.path / "main.cpp", main_cpp.str());
  write(folder.path / "main.py", main_python.str());
  ASSERT_EQ(fixture::compiled(folder.path / "main.cpp", folder.path / "main", ""), "");
  for (const std::string& command :
       {"'" + (folder.path / "main").string() + "'", "python3 '" + (folder.path / "main.py").string() + "'"}) {
    const auto found = fixture::answers(folder.path, command, {});
    ASSERT_EQ(found.size(), 1u) << command << fixture::text_of_file(folder.path / "errors.txt");
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(found[0].numbers.at(i), wanted.root_from_tcp_est.translation[k], 1e-9) << command;
      EXPECT_NEAR(found[0].numbers.at(3 + i), wanted.root_from_body_est.translation[k], 1e-9) << command;
    }
  }
}

TEST(Programs, SayWhatDoesNotMoveTheHand) {
  std::mt19937_64 random(9);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::robot_with(session, {{"camera_mount", -1, {0, 0, 0.01, 0, 0, 0}}, {"joint_offset", 2, {0.01}}}, random);
  const ExportedFile file = exported_file(robot, "cpp");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("camera_mount"), std::string::npos);
  EXPECT_NE(file.text.find("camera_mount does not move the hand"), std::string::npos);
}

}  // namespace
}  // namespace handsight
