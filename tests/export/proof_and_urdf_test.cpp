// SPDX-License-Identifier: Apache-2.0
// What a proof says in words of a joint's frame is what the exported URDF does with the joint's origin.
#include <gtest/gtest.h>

#include <regex>

#include "correct/calibrated_robot.h"
#include "diagnosis/proof/proof.h"
#include "export/rigid/urdf_file.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

/// The six-axis arm with axes along x, y and z, each of them in both directions.
Session with_axes_both_ways() {
  Session s = fixture::stand_session();
  const std::array<Vector3, 6> axes{Vector3::UnitZ(), Vector3::UnitY(),  -Vector3::UnitY(),
                                    Vector3::UnitX(), -Vector3::UnitZ(), -Vector3::UnitX()};
  for (std::size_t j = 0; j < axes.size(); ++j) s.robot.joints[j].axis = axes[j];
  s.robot = parse_urdf(fixture::urdf_text(s.robot), "robot.urdf", nullptr);
  return s;
}

/// "Shift along z at a2: -0.52 +- 0.03 mm in every pose": what moves, by how much (m, rad), how surely.
struct Said {
  bool is_turn = false;
  int axis = 0;
  std::string joint;
  double value = 0, sigma = 0;
};

std::optional<Said> said(const std::string& text) {
  static const std::regex form(
      R"((Shift along|Turn about) ([xyz]) at (\w+): (-?[0-9.]+) \+- ([0-9.]+) ([mu]?)(m|rad) .*)");
  std::smatch m;
  if (!std::regex_match(text, m, form)) return std::nullopt;
  const double unit = m[6] == "m" ? 1e-3 : m[6] == "u" ? 1e-6 : 1;
  return Said{m[1] == "Turn about", m[2].str()[0] - 'x', m[3], unit * std::stod(m[4]), unit * std::stod(m[5])};
}

const Joint& joint_of(const Robot& robot, const std::string& name) {
  return robot.joints.at(static_cast<std::size_t>(find_joint(robot, name)));
}

TEST(ProofAndUrdf, SayTheSameOfAxesInEveryDirection) {
  const Session like = with_axes_both_ways();
  SimulationOptions simulation;
  simulation.observations = 60;
  simulation.noise = 0.1;
  for (int j = 1; j < 5; ++j) simulation.effects.push_back({"link_geometry", j, {9e-4, 7e-4, 3e-3, -4e-3}});
  const Session session = simulate_session(like, simulation).session;
  FitOptions options;
  options.estimated = effect_terms("link_geometry", make_chain(session));
  const Fit fitted = fit(session, options);
  CalibratedRobot robot = calibrated_robot(session, fitted, {}, options, "test");
  robot.urdf_text = fixture::urdf_text(like.robot);
  robot.urdf_file = "robot.urdf";
  const Robot calibrated = parse_urdf(urdf_file(robot).text, "calibrated.urdf", nullptr);
  int compared = 0;
  for (const ProofPlot& plot : make_proof(session, fitted, list_terms(fitted))) {
    const std::string text = proof_text(plot);
    const std::optional<Said> one = said(text);
    ASSERT_TRUE(one) << text;
    const Rigid moved = inverse(joint_of(like.robot, one->joint).parent_from_joint) *
                        joint_of(calibrated, one->joint).parent_from_joint;
    const double by = one->is_turn ? vector_from_rotation(moved.rotation)[one->axis] : moved.translation[one->axis];
    EXPECT_NEAR(one->value, by, 0.06 * one->sigma + 1e-9) << text;
    compared += std::abs(by) > 3 * one->sigma;  // so that its sign is looked at
  }
  EXPECT_GE(compared, 8);
}

}  // namespace
}  // namespace handsight
