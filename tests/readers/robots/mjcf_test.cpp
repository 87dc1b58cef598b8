// SPDX-License-Identifier: Apache-2.0
// Robots of MuJoCo: where MuJoCo itself puts their bodies, and how heavy it has them.
#include "readers/robots/mjcf.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "readers/robots/robot_file.h"
#include "robot/posture.h"
#include "session/session_texts.h"
#include "temporary_folder.h"
#ifdef HANDSIGHT_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

class Mjcf : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_.path / name).parent_path());
    std::ofstream(folder_.path / name) << text;
    return folder_.path / name;
  }
  FieldUrdf read(const std::string& text) { return robot_of_file(write("model.xml", text)); }
  std::string refusal(const std::string& text) {
    return find_refusal([&] { read(text); });
  }
  TemporaryFolder folder_;
};

double draw(std::mt19937& random, double most = 1) {
  return std::uniform_real_distribution<double>(-most, most)(random);
}

std::string drawn(std::mt19937& random, int count, double most = 1) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format("{}{:.6f}", i ? " " : "", draw(random, most));
  return text;
}

/// One of the ways in which MJCF says a turn.
std::string turn(std::mt19937& random, bool degrees) {
  const double angle = degrees ? 170 : 3;
  switch (random() % 6) {
    case 0:
      return "quat=\"" + drawn(random, 4) + "\"";
    case 1:
      return "euler=\"" + drawn(random, 3, angle) + "\"";
    case 2:
      return "axisangle=\"" + drawn(random, 3) + " " + drawn(random, 1, angle) + "\"";
    case 3:
      return "xyaxes=\"" + drawn(random, 6) + "\"";
    case 4:
      return "zaxis=\"" + drawn(random, 3) + "\"";
    default:
      return degrees ? "euler=\"0 90 0\"" : "euler=\"0 1.5707963267948966 0\"";  // pitch of a quarter turn
  }
}

struct RandomModel {
  std::string text;
  std::vector<std::string> bodies, joints, sites;
};

std::string random_joint(std::mt19937& random, bool degrees, const std::string& name) {
  std::string joint = fmt::format("<joint name=\"{}\"", name);
  const unsigned kind = random() % 4;
  if (kind == 0) joint += " type=\"slide\"";
  if (kind == 1) joint += " class=\"sliding\"";
  if (random() % 2) joint += " pos=\"" + drawn(random, 3, 0.2) + "\"";
  if (random() % 2) joint += " axis=\"" + drawn(random, 3) + "\"";
  if (random() % 3 == 0) joint += " ref=\"" + drawn(random, 1, degrees && kind > 1 ? 60 : 0.5) + "\"";
  if (random() % 2)
    joint += degrees && kind > 1 ? " limited=\"true\" range=\"-90 60\"" : " limited=\"true\" range=\"-1 0.6\"";
  return joint + "/>";
}

std::string random_geom(std::mt19937& random, bool degrees) {
  static const char* const shapes[] = {"type=\"box\" size=\"0.03 0.04 0.05\"",
                                       "size=\"0.04\"",
                                       "type=\"capsule\" size=\"0.02 0.08\"",
                                       "type=\"cylinder\" size=\"0.03 0.05\"",
                                       "type=\"ellipsoid\" size=\"0.02 0.03 0.04\"",
                                       "type=\"capsule\" size=\"0.02\" fromto=\"0 0 0 0.1 0.05 -0.2\"",
                                       "class=\"heavy\""};
  std::string geom = fmt::format("<geom {}", shapes[random() % std::size(shapes)]);
  const unsigned weight = random() % 3;
  if (weight == 1) geom += " mass=\"0.7\"";
  if (weight == 2) geom += " density=\"2700\"";
  if (geom.find("fromto") == std::string::npos)
    geom += " pos=\"" + drawn(random, 3, 0.1) + "\" " + turn(random, degrees);
  return geom + "/>";
}

RandomModel random_model(std::mt19937& random) {
  RandomModel m;
  const bool degrees = random() % 2;
  static const char* const orders[] = {"xyz", "zyx", "XYZ", "zxz", "XyZ", "yXz"};
  const unsigned order = random() % std::size(orders);
  m.text = fmt::format(
      "<mujoco model=\"m\"><compiler angle=\"{}\" eulerseq=\"{}\"/>"
      "<default><joint axis=\"0 1 0\"/><geom density=\"500\"/>"
      "<default class=\"arm\"><joint pos=\"0.01 0 0.02\"/>"
      "<default class=\"sliding\"><joint type=\"slide\" axis=\"1 0 1\"/></default></default>"
      "<default class=\"heavy\"><geom type=\"box\" size=\"0.02 0.02 0.02\" density=\"7800\"/></default></default>"
      "<worldbody>",
      degrees ? "degree" : "radian", orders[order]);
  int open = 0;
  for (int b = 0; b < 9; ++b) {
    m.bodies.push_back(fmt::format("b{}", b));
    m.text += fmt::format("<body name=\"b{}\" pos=\"{}\" ", b, drawn(random, 3, 0.5)) + turn(random, degrees);
    m.text += random() % 3 == 0 ? " childclass=\"arm\">" : ">";
    if (random() % 2) m.text += "<inertial pos=\"" + drawn(random, 3, 0.1) + "\" mass=\"1.5\" diaginertia=\"1 1 1\"/>";
    for (unsigned joints = random() % 3; joints > 0; --joints) {
      m.joints.push_back(fmt::format("j{}", m.joints.size()));
      m.text += random_joint(random, degrees, m.joints.back());
    }
    for (unsigned geoms = 1 + random() % 2; geoms > 0; --geoms) m.text += random_geom(random, degrees);
    m.sites.push_back(fmt::format("s{}", b));
    m.text += fmt::format("<site name=\"s{}\" pos=\"{}\" ", b, drawn(random, 3, 0.2)) + turn(random, degrees) + "/>";
    ++open;
    for (unsigned closed = random() % 3; closed > 0 && open > 0; --closed, --open) m.text += "</body>";
  }
  for (; open > 0; --open) m.text += "</body>";
  m.text += "</worldbody></mujoco>";
  return m;
}

#ifdef HANDSIGHT_MUJOCO
struct Free {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

Matrix3 by_rows(const mjtNum* numbers) { return Matrix3(Eigen::Map<const Matrix3>(numbers)).transpose(); }

TEST_F(Mjcf, BodiesAndSitesStandWhereMuJoCoPutsThem) {
  std::mt19937 random(3);
  double worst = 0, worst_mass = 0;
  for (int run = 0; run < 60; ++run) {
    const RandomModel made = random_model(random);
    const auto path = write("model.xml", made.text);
    char error[1000] = "";
    const std::unique_ptr<mjModel, Free> model(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
    ASSERT_TRUE(model) << error << made.text;
    const std::unique_ptr<mjData, Free> data(mj_makeData(model.get()));
    const Robot robot = robot_of_file(path).robot;
    std::vector<std::string> moving = joint_names(robot);
    std::sort(moving.begin(), moving.end());
    std::vector<std::string> wanted = made.joints;
    std::sort(wanted.begin(), wanted.end());
    ASSERT_EQ(moving, wanted) << made.text;
    Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
    for (const std::string& name : made.joints) {
      const int j = find_joint(robot, name), id = mj_name2id(model.get(), mjOBJ_JOINT, name.c_str());
      q[j] = draw(random, 2);
      data->qpos[model->jnt_qposadr[id]] = q[j];
      const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
      if (model->jnt_limited[id]) {
        EXPECT_NEAR(joint.lower, model->jnt_range[2 * id], 1e-12);
        EXPECT_NEAR(joint.upper, model->jnt_range[2 * id + 1], 1e-12);
      } else {
        EXPECT_LT(joint.lower, -1e29);
      }
    }
    mj_kinematics(model.get(), data.get());
    const Posture posture = solve_posture(robot, q, Vector3::Zero());
    const auto compare = [&](const std::string& name, const mjtNum* place, const mjtNum* rotation) {
      const Rigid& ours = posture.root_from_link[static_cast<std::size_t>(find_link(robot, name))];
      worst = std::max({worst, (ours.translation - Vector3(place)).cwiseAbs().maxCoeff(),
                        (ours.rotation - by_rows(rotation)).cwiseAbs().maxCoeff()});
    };
    for (const std::string& name : made.bodies) {
      const int id = mj_name2id(model.get(), mjOBJ_BODY, name.c_str());
      compare(name, data->xpos + 3 * id, data->xmat + 9 * id);
      const Link& link = robot.links[static_cast<std::size_t>(find_link(robot, name))];
      worst_mass = std::max({worst_mass, std::abs(link.mass - model->body_mass[id]),
                             (link.center_of_mass - Vector3(model->body_ipos + 3 * id)).cwiseAbs().maxCoeff()});
    }
    for (const std::string& name : made.sites) {
      const int id = mj_name2id(model.get(), mjOBJ_SITE, name.c_str());
      compare(name, data->site_xpos + 3 * id, data->site_xmat + 9 * id);
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(worst_mass, 1e-9);
}
#else
TEST_F(Mjcf, BodiesAndSitesStandWhereMuJoCoPutsThem) { GTEST_SKIP() << "libmujoco-dev is not installed"; }
#endif

TEST_F(Mjcf, IncludedFilesAndMimicsAreRead) {
  write("parts/arm.xml",
        "<mujocoinclude><body name=\"upper\" pos=\"0 0 1\"><joint name=\"a\" axis=\"0 1 0\" range=\"-90 90\"/>"
        "<geom type=\"box\" size=\".1 .1 .1\"/><body name=\"finger\"><joint name=\"f\" type=\"slide\"/>"
        "<joint name=\"g\" type=\"slide\" axis=\"0 1 0\"/><geom size=\".01\"/></body></body></mujocoinclude>");
  const FieldUrdf field = read(
      "<mujoco model=\"two fingers\"><worldbody><include file=\"parts/arm.xml\"/></worldbody>"
      "<equality><joint joint1=\"g\" joint2=\"f\" polycoef=\"0.001 -1 0 0 0\"/></equality></mujoco>");
  EXPECT_EQ(field.robot.name, "two fingers");
  EXPECT_EQ(joint_names(field.robot), (std::vector<std::string>{"a", "f"}));
  const Joint& follower = field.robot.joints[static_cast<std::size_t>(find_joint(field.robot, "g"))];
  ASSERT_EQ(follower.mimics.size(), 1u);
  EXPECT_EQ(follower.mimics[0].multiplier, -1);
  EXPECT_EQ(follower.mimics[0].offset, 0.001);
  EXPECT_NEAR(field.robot.joints[static_cast<std::size_t>(find_joint(field.robot, "a"))].upper, 1.5707963267948966,
              1e-15);
  EXPECT_NEAR(field.robot.links[static_cast<std::size_t>(find_link(field.robot, "upper"))].mass, 8, 1e-12);
}

TEST_F(Mjcf, WhatHasSeveralCoordinatesStandsStillAndIsTold) {
  const FieldUrdf field = read(
      "<mujoco><worldbody><body name=\"base\" pos=\"0 0 2\"><freejoint/><geom size=\"1\"/>"
      "<body name=\"leg\"><joint type=\"ball\" name=\"hip\"/><joint name=\"knee\"/><geom size=\"1\"/></body></body>"
      "</worldbody></mujoco>");
  EXPECT_EQ(joint_names(field.robot), std::vector<std::string>{"knee"});
  EXPECT_THAT(field.notes, Contains(HasSubstr("base (free), hip (ball) stand still")));
}

TEST_F(Mjcf, WhatIsWrongIsRefusedWithItsLine) {
  EXPECT_THAT(refusal("<mujoco><worldbody><include file=\"gone.xml\"/></worldbody></mujoco>"),
              HasSubstr("\"gone.xml\", which is not there"));
  EXPECT_THAT(refusal("<mujoco>\n<worldbody>\n<body><joint axis=\"0 0 0\"/></body></worldbody></mujoco>"),
              HasSubstr("line 3"));
  EXPECT_THAT(refusal("<mujoco><worldbody><body pos=\"1 2\"/></worldbody></mujoco>"),
              HasSubstr("expected 3 finite numbers"));
  EXPECT_THAT(refusal("<mujoco><worldbody><body childclass=\"x\"><geom/></body></worldbody></mujoco>"),
              HasSubstr("which no <default> describes"));
  EXPECT_THAT(refusal("<mujoco><compiler coordinate=\"global\"/><worldbody/></mujoco>"), HasSubstr("global"));
  EXPECT_THAT(refusal("<mujoco><worldbody><replicate count=\"3\"/></worldbody></mujoco>"), HasSubstr("mj_saveLastXML"));
  write("model2.xml", "<mujoco><worldbody><include file=\"model2.xml\"/></worldbody></mujoco>");
  EXPECT_THAT(find_refusal([&] { robot_of_file(folder_.path / "model2.xml"); }), HasSubstr("a second time"));
}

}  // namespace
}  // namespace handsight
