// SPDX-License-Identifier: Apache-2.0
// xacro, UR's calibration, ros2_control and lerobot: read back by others where they are there, and by their own rules.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "base/xml.h"
#include "export/exported.h"
#include "export/rigid/described_robot.h"
#include "fixtures/exported_robots.h"

namespace handsight {
namespace {

using testing::HasSubstr;

Rigid predicted(const CalibratedRobot& robot, const Eigen::VectorXd& position) {
  return predict_tcp(robot.chain, position, robot.model).root_from_tcp_est;
}

/// What xacro makes of the macro for these parameters: names are put before, the mounting stands where there is a
/// parent.
std::string expanded(std::string text, const std::string& name, const std::string& parent) {
  const auto document = parse_xml(text, "arm.xacro");
  const tinyxml2::XMLElement* macro = document->RootElement()->FirstChildElement("xacro:macro");
  EXPECT_STREQ(macro->Attribute("name"), "calibrated_robot");
  tinyxml2::XMLDocument made;
  tinyxml2::XMLElement* robot = made.NewElement("robot");
  made.InsertEndChild(robot);
  robot->SetAttribute("name", "cell");
  if (!parent.empty()) robot->InsertNewChildElement("link")->SetAttribute("name", parent.c_str());
  for (const tinyxml2::XMLElement* e = macro->FirstChildElement(); e; e = e->NextSiblingElement()) {
    const std::string tag = e->Name();
    if (tag == "xacro:property") continue;
    if (tag != "xacro:if")
      robot->InsertEndChild(e->DeepClone(&made));
    else if (!parent.empty())
      robot->InsertEndChild(e->FirstChildElement()->DeepClone(&made));
  }
  text = xml_text(made);
  text = std::regex_replace(text, std::regex("\\$\\{prefix\\}"), name.empty() ? "" : name + "_");
  text = std::regex_replace(text, std::regex("\\$\\{parent\\}"), parent);
  return std::regex_replace(text, std::regex("\\$\\$\\{"), "$${");
}

/// By the program xacro where it is installed.
std::string by_xacro(const std::string& text, const std::string& name, const std::string& parent) {
  if (std::system("command -v xacro > /dev/null") != 0) return "";
  const TemporaryFolder folder;
  std::ofstream(folder.path / "arm.xacro") << text;
  std::ofstream(folder.path / "cell.xacro")
      << "<robot name=\"cell\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:include filename=\""
      << (folder.path / "arm.xacro").string() << "\"/>" << (parent.empty() ? "" : "<link name=\"" + parent + "\"/>")
      << "<xacro:calibrated_robot name=\"" << name << "\" parent=\"" << parent << "\"/></robot>";
  const std::string command =
      "xacro '" + (folder.path / "cell.xacro").string() + "' > '" + (folder.path / "cell.urdf").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return fixture::text_of_file(folder.path / "cell.urdf");
}

TEST(Xacro, IsAMacroWithNameAndParent) {
  std::mt19937_64 random(41);
  const Session session = fixture::rigid_torso();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::sayable_terms(make_chain(session), random), random, 5);
  const DescribedRobot d = described_robot(robot);
  const std::string text = exported_file(robot, "xacro").text;
  for (const auto& [name, parent] : {std::pair("left", "table"), std::pair("", ""), std::pair("right", "")}) {
    std::vector<std::string> texts{expanded(text, name, parent)};
    if (const std::string made = by_xacro(text, name, parent); !made.empty()) texts.push_back(made);
    const std::string prefix = *name ? name + std::string("_") : "";
    for (const std::string& urdf : texts) {
      const Robot read = parse_urdf(urdf, "cell.urdf", nullptr);
      EXPECT_EQ(read.links[0].name, *parent ? parent : prefix + "base");
      std::vector<std::string> joints;
      for (const std::string& joint : robot.joint_names) joints.push_back(prefix + joint);
      const Eigen::VectorXd position = fixture::random_position(robot.chain, random);
      const Rigid hand =
          fixture::look_up_link(read, fixture::values_in(read, joints, position), prefix + d.urdf.hand_link);
      EXPECT_LT(small_motion_between(predicted(robot, position), hand).norm(), 1e-9);
    }
  }
}

/// A robot with the joints of ur_description (names and axes), two fixed links and UR5's lengths.
Session ur_session() {
  Session s = fixture::stand_session();
  Robot r;
  r.name = "ur5";
  const double h = M_PI / 2;
  const char* links[] = {"base_link",    "base_link_inertia", "shoulder_link", "upper_arm_link", "forearm_link",
                         "wrist_1_link", "wrist_2_link",      "wrist_3_link",  "flange"};
  for (int i = 0; i < 9; ++i)
    r.links.push_back(fixture::make_link(links[i], i > 1 && i < 8 ? 2 : 0, {0, 0, 0.05}, i - 1));
  const auto add = [&](const char* name, const Vector3& xyz, const Vector3& rpy) {
    const int n = static_cast<int>(r.joints.size());
    r.joints.push_back(fixture::make_joint(name, n, n + 1, xyz, rpy, {0, 0, 1}, 3));
  };
  add("base_link-base_link_inertia", {0, 0, 0}, {0, 0, M_PI});
  r.joints[0].kind = JointKind::fixed;
  add("shoulder_pan_joint", {0, 0, 0.089159}, {0, 0, 0});
  add("shoulder_lift_joint", {0, 0, 0}, {h, 0, 0});
  add("elbow_joint", {-0.425, 0, 0}, {0, 0, 0});
  add("wrist_1_joint", {-0.39225, 0, 0.10915}, {0, 0, 0});
  add("wrist_2_joint", {0, -0.09465, 0}, {h, 0, 0});
  add("wrist_3_joint", {0, 0.0823, 0}, {h, M_PI, M_PI});
  add("wrist_3-flange", {0, 0, 0}, {0, -h, -h});
  r.joints[7].kind = JointKind::fixed;
  s.robot = r;
  s.tcp = "flange";
  s.mount.link = "base_link";
  s.joints.clear();
  for (int j = 1; j < 7; ++j) s.joints.push_back(r.joints[static_cast<std::size_t>(j)].name);
  return s;
}

/// ur_description's own product: base_link_inertia, then the six origins, then what follows wrist 3 unchanged.
Rigid ur_hand(const YAML::Node& kinematics, const Session& session, const Eigen::VectorXd& position) {
  Rigid hand = session.robot.joints[0].parent_from_joint;
  const char* names[] = {"shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"};
  for (int i = 0; i < 6; ++i) {
    const YAML::Node n = kinematics[names[i]];
    hand = hand * Rigid{rotation_from_rpy({n["roll"].as<double>(), n["pitch"].as<double>(), n["yaw"].as<double>()}),
                        {n["x"].as<double>(), n["y"].as<double>(), n["z"].as<double>()}};
    hand.rotation = hand.rotation * Eigen::AngleAxisd(position[i], Vector3::UnitZ()).toRotationMatrix();
  }
  return hand * session.robot.joints[7].parent_from_joint;
}

TEST(UrCalibration, IsTheKinematicsThatUrsDriversRead) {
  std::mt19937_64 random(42);
  const Session session = ur_session();
  const Chain chain = make_chain(session);
  std::vector<EffectTerm> terms;
  for (const int j : chain.joints) {
    terms.push_back({"joint_offset", j, {3e-3}});
    terms.push_back({"link_geometry", j, {4e-4, -3e-4, 1e-3, 2e-3}});
  }
  const CalibratedRobot robot = fixture::exported_robot(session, terms, random, 10);
  const ExportedFile file = exported_file(robot, "ur_calibration");
  EXPECT_LT(*file.largest_left, 1e-12);
  const YAML::Node kinematics = YAML::Load(file.text)["kinematics"];
  EXPECT_THAT(kinematics["hash"].as<std::string>(), HasSubstr("handsight_"));
  for (const Eigen::VectorXd& p : robot.positions)
    EXPECT_LT(small_motion_between(predicted(robot, p), ur_hand(kinematics, session, p)).norm(), 1e-9);
}

TEST(UrCalibration, FitsAgainWhatItCannotHoldAndTellsIt) {
  std::mt19937_64 random(43);
  const Session session = ur_session();
  const Chain chain = make_chain(session);
  const CalibratedRobot robot = fixture::exported_robot(
      session, {{"joint_elasticity", chain.joints[1], {1e-4}}, {"joint_elasticity", chain.joints[2], {1e-4}}}, random,
      40);
  const ExportedFile file = exported_file(robot, "ur_calibration");
  const YAML::Node kinematics = YAML::Load(file.text)["kinematics"];
  double squares = 0;
  for (const Eigen::VectorXd& p : robot.positions)
    squares += (predicted(robot, p).translation - ur_hand(kinematics, session, p).translation).squaredNorm() / 40;
  EXPECT_NEAR(*file.left, std::sqrt(squares), 1e-9);
  EXPECT_LT(*file.left, 0.5 * *file.nominal);
}

TEST(UrCalibration, IsRefusedForOtherRobots) {
  std::mt19937_64 random(44);
  EXPECT_THROW(exported_file(fixture::exported_robot(fixture::stand_session(), {}, random), "ur_calibration"),
               InputError);
  Session old = ur_session();  // as older descriptions have it
  old.robot.joints[2].axis = Vector3::UnitY();
  EXPECT_THROW(exported_file(fixture::exported_robot(old, {}, random), "ur_calibration"), InputError);
}

/// How far the nominal robot's hand is with these offsets added to its readings, m, rms.
double missed_with_offsets(const CalibratedRobot& robot, const std::vector<double>& offsets) {
  double squares = 0;
  for (const Eigen::VectorXd& p : robot.positions) {
    Eigen::VectorXd read = p;
    for (Eigen::Index i = 0; i < read.size(); ++i) read[i] += offsets[static_cast<std::size_t>(i)];
    squares +=
        (predicted(robot, p).translation - chain_ends(robot.chain, read).root_from_tcp.translation).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(robot.positions.size()));
}

TEST(Ros2Control, HoldsTheBestOffsets) {
  std::mt19937_64 random(45);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 40);
  const ExportedFile file = exported_file(robot, "ros2_control");
  const auto document = parse_xml(file.text, "arm.xml");
  std::vector<double> offsets;
  for (const XmlNode& joint : children(require_root(*document, "arm.xml", "ros2_control"), "joint")) {
    EXPECT_EQ(required_name(joint, "name"), robot.joint_names[offsets.size()]);
    const XmlNode param = required_child(joint, "param");
    EXPECT_EQ(required_name(param, "name"), "offset");
    offsets.push_back(std::stod(inner_text(param)));
  }
  ASSERT_EQ(offsets.size(), 6u);
  EXPECT_NEAR(missed_with_offsets(robot, offsets), *file.left, 1e-9);
  EXPECT_LT(*file.left, *file.nominal);
}

TEST(Lerobot, TurnsTheReadingByTheOffsetInTicks) {
  std::mt19937_64 random(46);
  const Session session = fixture::stand_session();
  const Chain chain = make_chain(session);
  std::vector<EffectTerm> terms;
  std::vector<double> wanted;
  for (int i = 0; i < 6; ++i) {
    wanted.push_back((i % 2 ? -1 : 1) * 2 * M_PI / 4096 * (10 + i));
    terms.push_back({"joint_offset", chain.joints[static_cast<std::size_t>(i)], {wanted.back()}});
  }
  const CalibratedRobot robot = fixture::exported_robot(session, terms, random, 20);
  nlohmann::json before;
  for (int i = 0; i < 6; ++i)
    before[robot.joint_names[static_cast<std::size_t>(i)]] = {{"id", 11 + i},
                                                              {"drive_mode", i == 3 ? 1 : 0},
                                                              {"homing_offset", 100 * i},
                                                              {"range_min", 800},
                                                              {"range_max", 3200}};
  before["gripper"] = {{"id", 17}, {"drive_mode", 0}, {"homing_offset", 5}, {"range_min", 1}, {"range_max", 2}};
  const ExportedFile file = exported_file(robot, "lerobot", {{}, before.dump()});
  const auto after = nlohmann::json::parse(file.text);
  for (int i = 0; i < 6; ++i) {
    const auto& motor = after[robot.joint_names[static_cast<std::size_t>(i)]];
    // Present = actual - homing_offset: the reading grows by the offset where homing_offset shrinks by it; where the
    // motor runs the other way, the other way round.
    EXPECT_EQ(motor["homing_offset"].get<int>(), 100 * i - (i == 3 ? -1 : 1) * (i % 2 ? -1 : 1) * (10 + i));
    EXPECT_EQ(motor["range_min"], 800);
    EXPECT_EQ(motor["id"], 11 + i);
  }
  EXPECT_EQ(after["gripper"], before["gripper"]);
  EXPECT_LT(*file.left, 1e-6);
}

TEST(Lerobot, TellsWhatWholeTicksMiss) {
  std::mt19937_64 random(47);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot = fixture::exported_robot(
      session, {{"joint_offset", make_chain(session).joints[0], {0.4 * 2 * M_PI / 4096}}}, random, 20);
  const ExportedFile file = exported_file(robot, "lerobot");
  EXPECT_EQ(nlohmann::json::parse(file.text)["a1"]["homing_offset"], 0);
  EXPECT_GT(*file.left, 1e-5);
  EXPECT_NEAR(*file.left, *file.nominal, 1e-9);
  EXPECT_THROW(exported_file(robot, "lerobot", {{}, "[1, 2]"}), InputError);
  EXPECT_THROW(exported_file(robot, "lerobot", {{}, R"({"other": {"id": 1}})"}), InputError);
  EXPECT_THROW(exported_file(fixture::exported_robot(fixture::rigid_torso(), {}, random), "lerobot"), InputError);
}

}  // namespace
}  // namespace handsight
