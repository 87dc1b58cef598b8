// SPDX-License-Identifier: Apache-2.0
// Denavit-Hartenberg tables: the product of their matrices, written here by the textbook, is what is predicted.
#include "export/rigid/dh.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "export/exported.h"
#include "export/rigid/described_robot.h"
#include "fixtures/exported_robots.h"

namespace handsight {
namespace {

/// Craig, Introduction to Robotics, (3.6).
Matrix4 craig(double a, double alpha, double d, double theta) {
  const double c = std::cos(theta), s = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  Matrix4 m;
  m << c, -s, 0, a, s * ca, c * ca, -sa, -sa * d, s * sa, c * sa, ca, ca * d, 0, 0, 0, 1;
  return m;
}

/// Paul, Robot Manipulators, (2.31).
Matrix4 paul(double a, double alpha, double d, double theta) {
  const double c = std::cos(theta), s = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  Matrix4 m;
  m << c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, d, 0, 0, 0, 1;
  return m;
}

Matrix4 make_matrix(const YAML::Node& motion) {
  const auto numbers = motion["matrix"].as<std::vector<double>>();
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
}

template <class Convention>
Matrix4 hand_of(const YAML::Node& table, const std::map<std::string, double>& values, const Convention& convention) {
  Matrix4 hand = make_matrix(table["base"]);
  for (const YAML::Node& row : table["joints"]) {
    const double q = values.at(row["name"].as<std::string>());
    const bool slides = row["type"].as<std::string>() == "prismatic";
    hand = hand * convention(row["a"].as<double>(), row["alpha"].as<double>(), row["d"].as<double>() + (slides ? q : 0),
                             row["theta"].as<double>() + (slides ? 0 : q));
  }
  return hand * make_matrix(table["tool"]);
}

void expect_tables(const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& positions, double rest) {
  const YAML::Node yaml = YAML::Load(exported_file(robot, "dh").text);
  const DescribedRobot d = described_robot(robot);
  for (const Eigen::VectorXd& position : positions) {
    const Matrix4 wanted = matrix_from_rigid(predict_tcp(robot.chain, position, robot.model).root_from_tcp_est);
    const Eigen::VectorXd values = fixture::values_in(d.robot, robot.joint_names, position);
    std::map<std::string, double> by_name;
    for (std::size_t j = 0; j < d.robot.joints.size(); ++j)
      by_name[d.robot.joints[j].name] = values[static_cast<Eigen::Index>(j)];
    const Matrix4 modified = hand_of(yaml["modified"], by_name, craig),
                  classical = hand_of(yaml["classical"], by_name, paul);
    EXPECT_LT((modified - classical).norm(), 1e-9);
    const Vector3 away = modified.topRightCorner<3, 1>() - wanted.topRightCorner<3, 1>();
    EXPECT_LT(away.norm(), rest + 1e-9);
    if (rest == 0) EXPECT_LT((modified - wanted).norm(), 1e-9);
  }
}

std::vector<Eigen::VectorXd> poses(const CalibratedRobot& robot, std::mt19937_64& random) {
  std::vector<Eigen::VectorXd> all;
  for (int i = 0; i < 10; ++i) all.push_back(fixture::random_position(robot.chain, random));
  return all;
}

TEST(Dh, ProductsAreWhatIsPredicted) {
  std::mt19937_64 random(31);
  for (const Session& session : {fixture::rigid_torso(), fixture::stand_session()})
    for (const bool is_nominal : {true, false}) {  // axes that are parallel, and axes nearly so
      const Chain chain = make_chain(session);
      const CalibratedRobot robot = fixture::exported_robot(
          session, is_nominal ? std::vector<EffectTerm>{} : fixture::sayable_terms(chain, random), random, 5);
      expect_tables(robot, poses(robot, random), 0);
    }
}

TEST(Dh, OfRandomChainsAreExact) {
  std::mt19937_64 random(32);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    Robot robot;
    robot.links.resize(1);
    for (int j = 0; j < 6; ++j) {
      Joint joint;
      joint.name = fmt::format("j{}", j);
      joint.kind = random() % 5 == 0 ? JointKind::prismatic : JointKind::revolute;
      joint.parent_link = j;
      joint.child_link = j + 1;
      const double roll = normal(random), pitch = normal(random), yaw = normal(random);
      const double x = normal(random), y = normal(random), z = normal(random);
      const bool is_parallel = random() % 3 == 0;
      joint.parent_from_joint = {is_parallel ? Matrix3(Matrix3::Identity()) : rotation_from_rpy({roll, pitch, yaw}),
                                 {x, y, z}};
      joint.axis = is_parallel && j > 0 ? robot.joints.back().axis : Vector3(y, z, x).normalized();
      robot.joints.push_back(joint);
      robot.links.push_back({.name = fmt::format("l{}", j), .parent_joint = j});
    }
    Eigen::VectorXd values(6);
    for (double& q : values) q = normal(random);
    const Rigid wanted = fixture::look_up_link(robot, values, "l5");
    for (const bool is_modified : {true, false}) {
      const DhChain chain = is_modified ? modified_dh(robot, 6) : classical_dh(robot, 6);
      ASSERT_EQ(chain.rows.size(), 6u);
      Rigid hand = chain.base;
      for (const DhRow& row : chain.rows) {
        const bool slides = robot.joints[static_cast<std::size_t>(row.joint)].kind == JointKind::prismatic;
        hand = hand * (is_modified ? modified_motion(row, values[row.joint], slides)
                                   : classical_motion(row, values[row.joint], slides));
      }
      EXPECT_LT(small_motion_between(wanted, hand * chain.tool).norm(), 1e-9) << i;
    }
    EXPECT_EQ(modified_dh(robot, 6).rows[0].a, 0);
    EXPECT_EQ(modified_dh(robot, 6).rows[0].alpha, 0);
  }
}

TEST(Dh, OfWhatNoTableHoldsSaysWhatItMisses) {
  std::mt19937_64 random(33);
  const Session session = fixture::seven_axis_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 30);
  const ExportedFile file = exported_file(robot, "dh");
  expect_tables(robot, robot.positions, *file.largest_left);
  EXPECT_NE(file.text.find(fmt::format("{:.3f} mm rms", 1e3 * *file.left)), std::string::npos);
}

/// The table of a file that ends in .csv has the same numbers.
TEST(Dh, AsCsvIsTheSameTable) {
  std::mt19937_64 random(34);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::sayable_terms(make_chain(session), random), random, 5);
  const YAML::Node yaml = YAML::Load(exported_file(robot, "dh").text);
  std::istringstream lines(exported_file(robot, "dh", {"arm.csv", ""}).text);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("modified,a")) continue;
    const YAML::Node row = yaml["modified"]["joints"][rows++];
    EXPECT_EQ(line, fmt::format("modified,{},revolute,{},{},{},{},,,,,,", row["name"].as<std::string>(),
                                row["a"].as<std::string>(), row["alpha"].as<std::string>(), row["d"].as<std::string>(),
                                row["theta"].as<std::string>()));
  }
  EXPECT_EQ(rows, 6u);
}

}  // namespace
}  // namespace handsight
