// SPDX-License-Identifier: Apache-2.0
#include "robot/urdf.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <numbers>

#include "base/error.h"
#include "urdf_texts.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double pi = std::numbers::pi;

Robot parse(const std::string& text, std::vector<Message>* notes = nullptr) {
  return parse_urdf(text, "robot.urdf", notes);
}

TEST(Urdf, LinksJointsAndMasses) {
  const Robot robot = parse(R"(<robot name="arm">
    <link name="base"/>
    <link name="tip"><inertial><origin xyz="0.1 0.2 0.3" rpy="1 2 3"/><mass value="4.5"/></inertial></link>
    <joint name="j" type="prismatic">
      <limit upper="0.4" lower="-0.3" effort="1" velocity="1"/><axis xyz="0 3 4"/>
      <child link="tip"/><parent link="base"/><origin rpy="0 0 1.5707963267948966" xyz="1 2 3"/>
    </joint></robot>)");
  EXPECT_EQ(robot.name, "arm");
  ASSERT_EQ(robot.links.size(), 2u);
  EXPECT_EQ(robot.links[0].name, "base");
  EXPECT_EQ(robot.links[0].parent_joint, -1);
  EXPECT_EQ(robot.links[1].parent_joint, 0);
  EXPECT_EQ(robot.links[1].mass, 4.5);
  EXPECT_EQ(robot.links[1].center_of_mass, Vector3(0.1, 0.2, 0.3));
  const Joint& joint = robot.joints.at(0);
  EXPECT_EQ(joint.kind, JointKind::prismatic);
  EXPECT_TRUE(joint.axis.isApprox(Vector3(0, 0.6, 0.8), 1e-15));
  EXPECT_EQ(joint.parent_from_joint.translation, Vector3(1, 2, 3));
  EXPECT_TRUE(joint.parent_from_joint.rotation.isApprox(rotation_about(Vector3::UnitZ(), pi / 2), 1e-15));
  EXPECT_TRUE(joint.joint_from_child.rotation.isIdentity());
  EXPECT_EQ(joint.lower, -0.3);
  EXPECT_EQ(joint.upper, 0.4);
  EXPECT_EQ(joint.stiffness, 0);
}

TEST(Urdf, RpyTurnsRollFirstAboutFixedAxes) {
  const Robot robot = parse(one_joint("<origin rpy='0.1 0.2 0.3'/>"));
  const Matrix3 expected = rotation_about(Vector3::UnitZ(), 0.3) * rotation_about(Vector3::UnitY(), 0.2) *
                           rotation_about(Vector3::UnitX(), 0.1);
  EXPECT_TRUE(robot.joints[0].parent_from_joint.rotation.isApprox(expected, 1e-15));
}

TEST(Urdf, Defaults) {
  const Joint joint = parse(one_joint("")).joints[0];
  EXPECT_EQ(joint.axis, Vector3::UnitX());
  EXPECT_TRUE(joint.parent_from_joint.rotation.isIdentity());
  EXPECT_LT(joint.lower, -1e20);
  EXPECT_GT(joint.upper, 1e20);
  EXPECT_GT(parse(one_joint("<limit effort='1' velocity='1'/>")).joints[0].upper, 1e20);
  EXPECT_EQ(parse(one_joint("<limit upper='2'/>")).joints[0].lower, 0) << "URDF's default";
  EXPECT_GT(parse(one_joint("<limit lower='-1' upper='1'/>", "continuous")).joints[0].upper, 1e20);
}

TEST(Urdf, ExtremeAxesAreNormalised) {
  EXPECT_TRUE(parse(one_joint("<axis xyz='0 1e-200 0'/>")).joints[0].axis.isApprox(Vector3::UnitY()));
  EXPECT_TRUE(parse(one_joint("<axis xyz='1e300 0 1e300'/>")).joints[0].axis.isApprox(Vector3(1, 0, 1).normalized()));
}

TEST(Urdf, FixedJointsMayHaveAZeroAxis) {  // as exporters of CAD programs write it
  EXPECT_EQ(parse(one_joint("<axis xyz='0 0 0'/>", "fixed")).joints[0].kind, JointKind::fixed);
}

TEST(Urdf, DenavitHartenbergIsCraigsModified) {
  const double a = 0.3, alpha = -pi / 2, d = 0.2, theta = 0.7, q = 0.4;
  const Joint joint = parse(one_joint("<dh a='0.3' alpha='-1.5707963267948966' d='0.2' theta='0.7'/>")).joints[0];
  EXPECT_EQ(joint.axis, Vector3::UnitZ());
  const Rigid motion{rotation_about(joint.axis, q), Vector3::Zero()};
  const Rigid child = joint.parent_from_joint * motion * joint.joint_from_child;
  // Craig, Introduction to Robotics, eq. (3.6), written out.
  Matrix4 expected;
  const double c = std::cos(theta + q), s = std::sin(theta + q), ca = std::cos(alpha), sa = std::sin(alpha);
  expected << c, -s, 0, a, s * ca, c * ca, -sa, -sa * d, s * sa, c * sa, ca, ca * d, 0, 0, 0, 1;
  EXPECT_TRUE(matrix_from_rigid(child).isApprox(expected, 1e-14)) << matrix_from_rigid(child);
}

TEST(Urdf, DenavitHartenbergTakesPrecedenceAndSaysSo) {
  std::vector<Message> notes;
  const Joint joint = parse(one_joint("<dh a='1'/><origin xyz='5 5 5'/>"), &notes).joints[0];
  EXPECT_EQ(joint.parent_from_joint.translation, Vector3(1, 0, 0));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("<dh>")));
}

TEST(Urdf, StiffnessAndSeveralMimics) {
  const Robot robot = parse(R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
    <joint name="one" type="revolute"><parent link="a"/><child link="b"/><stiffness value="9000"/></joint>
    <joint name="two" type="continuous"><parent link="b"/><child link="c"/></joint>
    <joint name="sum" type="revolute"><parent link="c"/><child link="d"/>
      <mimic joint="one" multiplier="-1"/><mimic joint="two" offset="0.5"/></joint></robot>)");
  EXPECT_EQ(robot.joints[0].stiffness, 9000);
  EXPECT_FALSE(robot.joints[0].is_mimic());
  const auto& mimics = robot.joints[2].mimics;
  ASSERT_EQ(mimics.size(), 2u);
  EXPECT_EQ(mimics[0].joint, 0);
  EXPECT_EQ(mimics[0].multiplier, -1);
  EXPECT_EQ(mimics[0].offset, 0);
  EXPECT_EQ(mimics[1].joint, 1);
  EXPECT_EQ(mimics[1].multiplier, 1);
  EXPECT_EQ(mimics[1].offset, 0.5);
}

TEST(Urdf, AMimicOfAMimicIsKept) {
  const std::string text = R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
    <joint name="j3" type="revolute"><parent link="c"/><child link="d"/><mimic joint="j2" multiplier="2"/></joint>
    <joint name="j2" type="revolute"><parent link="b"/><child link="c"/><mimic joint="j1" multiplier="3"/></joint>
    <joint name="j1" type="revolute"><parent link="a"/><child link="b"/></joint></robot>)";
  const Robot robot = parse(text);
  EXPECT_EQ(robot.joints[2].name, "j3");
  EXPECT_EQ(robot.joints[2].mimics.at(0).joint, 1);
  EXPECT_EQ(robot.joints[1].mimics.at(0).joint, 0);
}

TEST(Urdf, ParentsComeBeforeTheirChildren) {
  const Robot robot = parse(R"(<robot name="r">
    <joint name="j_d" type="fixed"><parent link="c"/><child link="d"/></joint>
    <joint name="j_b" type="fixed"><parent link="root"/><child link="b"/></joint>
    <joint name="j_c" type="revolute"><parent link="root"/><child link="c"/></joint>
    <link name="d"/><link name="c"/><link name="b"/><link name="root"/></robot>)");
  std::vector<std::string> joints, links;
  for (const Joint& joint : robot.joints) joints.push_back(joint.name);
  for (const Link& link : robot.links) links.push_back(link.name);
  EXPECT_THAT(joints, ElementsAre("j_b", "j_c", "j_d"));
  EXPECT_THAT(links, ElementsAre("root", "b", "c", "d"));
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    EXPECT_LT(robot.joints[j].parent_link, robot.joints[j].child_link);
    EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.joints[j].child_link)].parent_joint, static_cast<int>(j));
  }
  EXPECT_THAT(joints_to(robot, find_link(robot, "d")), ElementsAre(1, 2));
  EXPECT_THAT(joints_to(robot, 0), IsEmpty());
  EXPECT_TRUE(is_distal(robot, find_joint(robot, "j_c"), find_link(robot, "d")));
  EXPECT_TRUE(is_distal(robot, find_joint(robot, "j_d"), find_link(robot, "d")));
  EXPECT_FALSE(is_distal(robot, find_joint(robot, "j_b"), find_link(robot, "d")));
  EXPECT_FALSE(is_distal(robot, find_joint(robot, "j_d"), find_link(robot, "c")));
  EXPECT_EQ(find_link(robot, "nowhere"), -1);
  EXPECT_EQ(find_joint(robot, "nowhere"), -1);
}

TEST(Urdf, ALongChainIsRead) {
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int i = 1; i <= 20000; ++i)
    text += fmt::format(
        "<link name='l{0}'/><joint name='j{0}' type='revolute'><parent link='l{1}'/><child link='l{0}'/>"
        "</joint>",
        i, i - 1);
  EXPECT_EQ(parse(text + "</robot>").joints.size(), 20000u);
}

TEST(Urdf, Shapes) {
  const Robot robot = parse(R"(<robot name="r"><material name="blue"><color rgba="0 0 1 1"/></material>
    <link name="a">
      <visual><origin xyz="1 2 3"/><geometry><box size="0.1 0.2 0.3"/></geometry><material name="blue"/></visual>
      <visual><geometry><cylinder radius="0.1" length="0.5"/></geometry></visual>
      <visual><geometry><sphere radius="0.2"/></geometry><material name=""><color rgba="2 0 -1 0.5"/></material></visual>
      <visual><geometry><mesh filename="package://x/y.stl" scale="0.001 -0.001 0.001"/></geometry></visual>
      <visual><geometry><capsule radius="1"/></geometry></visual>
    </link></robot>)");
  const auto& shapes = robot.links[0].shapes;
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_EQ(shapes[0].kind, ShapeKind::box);
  EXPECT_EQ(shapes[0].size, Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(shapes[0].link_from_shape.translation, Vector3(1, 2, 3));
  EXPECT_EQ(shapes[0].color.value(), Eigen::Vector4d(0, 0, 1, 1));
  EXPECT_EQ(shapes[1].kind, ShapeKind::cylinder);
  EXPECT_EQ(shapes[1].size, Vector3(0.1, 0.5, 0));
  EXPECT_FALSE(shapes[1].color);
  EXPECT_EQ(shapes[2].size, Vector3(0.2, 0, 0));
  EXPECT_EQ(shapes[2].color.value(), Eigen::Vector4d(1, 0, 0, 0.5)) << "clipped to 0 to 1";
  EXPECT_EQ(shapes[3].mesh_file, "package://x/y.stl");
  EXPECT_EQ(shapes[3].size, Vector3(0.001, -0.001, 0.001));
}

TEST(Urdf, ShapesThatAreNotDrawnAreNoted) {
  std::vector<Message> notes;
  parse("<robot name='r'><link name='a'><visual><geometry><capsule/></geometry></visual></link></robot>", &notes);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("robot.urdf, line 1: the <visual> is not drawn")));
}

TEST(Urdf, UnknownElementsAreNormal) {
  std::vector<Message> notes;
  parse(one_joint("<dynamics damping='1'/><calibration rising='0'/>"), &notes);
  parse("<robot name='r'><gazebo/><transmission name='t'/><link name='a'><collision/></link></robot>", &notes);
  EXPECT_THAT(notes, IsEmpty());
}

TEST(Urdf, AFarCentreOfMassIsNotedNotRefused) {
  std::vector<Message> notes;
  const Robot robot = parse(
      "<robot name='r'><link name='a'><inertial><mass value='1'/><origin xyz='0 500 "
      "0'/></inertial></link></robot>",
      &notes);
  EXPECT_EQ(robot.links[0].center_of_mass.y(), 500);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("500 m")));
}

TEST(Urdf, NamesInAnyScript) {
  const Robot robot = parse(
      "<robot name='r'><link name='Schulter_\xC3\xBC'/><link name='\xE6\x89\x8B'/>"
      "<joint name='j' type='fixed'><parent link='Schulter_\xC3\xBC'/><child "
      "link='\xE6\x89\x8B'/></joint></robot>");
  EXPECT_EQ(find_link(robot, "\xE6\x89\x8B"), 1);
  std::vector<Message> notes;
  EXPECT_EQ(
      parse("<?xml version='1.0' encoding='ISO-8859-1'?><robot><link name='\xFC'/></robot>", &notes).links[0].name,
      "\xC3\xBC");
  EXPECT_THAT(notes, ElementsAre(HasSubstr("Latin-1")));
}

TEST(UrdfFiles, SharedRobotsAreRead) {
  const std::filesystem::path shared = HANDSIGHT_SHARED_DIR;
  if (!std::filesystem::exists(shared / "examples")) GTEST_SKIP() << "no shared examples on this machine";
  std::vector<Message> notes;
  EXPECT_EQ(read_urdf(shared / "examples/sagging/robot.urdf", &notes).joints.size(), 5u);
  EXPECT_THAT(notes, IsEmpty());
  if (!std::filesystem::exists(shared / "real/justin_right_even")) GTEST_SKIP() << "no real sets on this machine";
  const Robot justin = read_urdf(shared / "real/justin_right_even/robot.urdf", &notes);
  EXPECT_EQ(justin.joints.at(static_cast<std::size_t>(find_joint(justin, "torso_4"))).mimics.size(), 2u);
  EXPECT_THAT(notes, IsEmpty());
}

}  // namespace
}  // namespace handsight
