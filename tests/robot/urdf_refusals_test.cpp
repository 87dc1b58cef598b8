// SPDX-License-Identifier: Apache-2.0
// What a URDF is refused for.
#include <gmock/gmock.h>

#include "base/error.h"
#include "robot/urdf.h"
#include "urdf_texts.h"

namespace handsight {
namespace {

using testing::HasSubstr;

std::string urdf_refusal(const std::string& text) {
  try {
    parse_urdf(text, "robot.urdf", nullptr);
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_GE(sentence.size(), 20u);
    EXPECT_LE(sentence.size(), 600u);
    EXPECT_TRUE(sentence.starts_with("robot.urdf")) << sentence;
    return sentence;
  }
  return "nothing was refused";
}

TEST(UrdfRefuses, WhatIsNoTree) {
  EXPECT_EQ(urdf_refusal("<robot name='r'/>"), "robot.urdf, line 1: <robot> has no <link>, expected at least one.");
  EXPECT_THAT(urdf_refusal("<robot name='r'><link name='a'/>\n<link name='b'/></robot>"),
              HasSubstr("line 2: <link> \"b\" has no parent joint, nor has \"a\""));
  EXPECT_THAT(urdf_refusal(R"(<robot><link name="a"/><link name="b"/>
    <joint name="i" type="fixed"><parent link="a"/><child link="b"/></joint>
    <joint name="j" type="fixed"><parent link="b"/><child link="a"/></joint></robot>)"),
              HasSubstr("a cycle"));
  EXPECT_THAT(urdf_refusal(R"(<robot><link name="root"/><link name="a"/><link name="b"/>
    <joint name="i" type="fixed"><parent link="a"/><child link="b"/></joint>
    <joint name="j" type="fixed"><parent link="b"/><child link="a"/></joint></robot>)"),
              HasSubstr("line 2: <joint> \"i\" is part of a cycle"));
  EXPECT_THAT(urdf_refusal("<robot><link name='a'/><joint name='j' type='fixed'><parent link='a'/><child "
                           "link='a'/></joint></robot>"),
              HasSubstr("a cycle"));
  EXPECT_THAT(urdf_refusal(R"(<robot><link name="a"/><link name="b"/><link name="c"/>
    <joint name="i" type="fixed"><parent link="a"/><child link="c"/></joint>
    <joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint></robot>)"),
              HasSubstr("line 3: <joint> \"j\" carries link \"c\", which joint \"i\" carries already"));
}

TEST(UrdfRefuses, NumbersBeyondAllMeasure) {
  for (const char* content :
       {"<dh a='1e160'/>", "<dh alpha='-1e160'/>", "<dh d='1e160'/>", "<dh theta='1e160'/>",
        "<origin xyz='0 1e160 0'/>", "<origin rpy='0 0 1e160'/>", "<stiffness value='1e160'/>",
        "<stiffness value='1e-160'/>", "<mimic joint='j' multiplier='1e160'/>", "<mimic joint='j' offset='-1e160'/>"})
    EXPECT_THAT(urdf_refusal(one_joint(content)), HasSubstr("expected a number from")) << content;
  EXPECT_THAT(urdf_refusal("<robot><link name='a'><inertial><mass value='1e160'/></inertial></link></robot>"),
              HasSubstr("expected a number from"));
  EXPECT_THAT(urdf_refusal(
                  "<robot><link name='a'><visual><geometry><box size='1 1e160 1'/></geometry></visual></link></robot>"),
              HasSubstr("expected a number from"));
  // Some programs write limits that are none.
  EXPECT_EQ(urdf_refusal(one_joint("<limit lower='-1e16' upper='1e16'/>")), "nothing was refused");
}

TEST(UrdfRefuses, UnknownAndDoubleNames) {
  const auto joint = [](const char* parent, const char* child) {
    return two_links + "<joint name='j' type='fixed'><parent link='" + parent + "'/><child link='" + child +
           "'/></joint></robot>";
  };
  EXPECT_THAT(urdf_refusal(joint("x", "b")), HasSubstr("has the parent link \"x\", expected the name of a link"));
  EXPECT_THAT(urdf_refusal(joint("a", "x")), HasSubstr("has the child link \"x\""));
  EXPECT_THAT(urdf_refusal("<robot><link name='a'/>\n<link name='a'/></robot>"),
              HasSubstr("line 2: <link> has the name \"a\", which line 1"));
  EXPECT_THAT(urdf_refusal(R"(<robot><link name="a"/><link name="b"/><link name="c"/>
    <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
    <joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint></robot>)"),
              HasSubstr("line 3: <joint> has the name \"j\""));
  EXPECT_THAT(urdf_refusal("<robot><link/></robot>"), HasSubstr("no attribute name"));
  EXPECT_THAT(urdf_refusal("<robot><link name=' '/></robot>"), HasSubstr("expected a name"));
  EXPECT_THAT(urdf_refusal(two_links + "<joint name='j' type='fixed'><parent link='a'/></joint></robot>"),
              HasSubstr("no element <child>"));
}

TEST(UrdfRefuses, TypesThatItDoesNotKnow) {
  EXPECT_THAT(urdf_refusal(one_joint("", "planar")), HasSubstr("is of type planar"));
  EXPECT_THAT(urdf_refusal(one_joint("", "floating")), HasSubstr("is of type floating"));
  EXPECT_THAT(urdf_refusal(one_joint("", "screw")),
              HasSubstr("has type=\"screw\", expected one of: fixed, revolute, continuous, prismatic"));
  EXPECT_THAT(urdf_refusal(two_links + "<joint name='j'><parent link='a'/><child link='b'/></joint></robot>"),
              HasSubstr("no attribute type"));
}

TEST(UrdfRefuses, Mimics) {
  EXPECT_THAT(urdf_refusal(one_joint("<mimic joint='x'/>")),
              HasSubstr("follows joint \"x\", expected the name of a joint"));
  EXPECT_THAT(urdf_refusal(one_joint("<mimic joint='j'/>")), HasSubstr("follows itself"));
  EXPECT_THAT(urdf_refusal(one_joint("<mimic/>")), HasSubstr("no attribute joint"));
  const auto three = [](const char* first, const char* second, const char* type) {
    return fmt::format(R"(<robot><link name="a"/><link name="b"/><link name="c"/>
      <joint name="i" type="{}"><parent link="a"/><child link="b"/>{}</joint>
      <joint name="j" type="revolute"><parent link="b"/><child link="c"/>{}</joint></robot>)",
                       type, first, second);
  };
  EXPECT_THAT(urdf_refusal(three("<mimic joint='j'/>", "<mimic joint='i'/>", "revolute")), HasSubstr("follows itself"));
  EXPECT_THAT(urdf_refusal(three("", "<mimic joint='i'/>", "fixed")), HasSubstr("which is fixed"));
}

TEST(UrdfRefuses, BadNumbers) {
  EXPECT_THAT(urdf_refusal("<robot><link name='a'><inertial><mass value='-1'/></inertial></link></robot>"),
              HasSubstr("negative mass"));
  EXPECT_THAT(urdf_refusal("<robot><link name='a'><inertial/></link></robot>"), HasSubstr("no element <mass>"));
  EXPECT_THAT(urdf_refusal("<robot><link name='a'><inertial><mass value='nan'/></inertial></link></robot>"),
              HasSubstr("\"nan\""));
  EXPECT_THAT(urdf_refusal(one_joint("<stiffness value='-5'/>")), HasSubstr("expected a positive number"));
  EXPECT_THAT(urdf_refusal(one_joint("<stiffness value='0'/>")), HasSubstr("expected a positive number"));
  EXPECT_THAT(urdf_refusal(one_joint("<stiffness/>")), HasSubstr("no attribute value"));
  EXPECT_THAT(urdf_refusal(one_joint("<axis xyz='0 0 0'/>")), HasSubstr("zero vector"));
  EXPECT_THAT(urdf_refusal(one_joint("<axis xyz='0 inf 0'/>")), HasSubstr("\"inf\""));
  EXPECT_THAT(urdf_refusal(one_joint("<origin xyz='0 0'/>")), HasSubstr("has 2 numbers in xyz, expected 3"));
  EXPECT_THAT(urdf_refusal(one_joint("<origin rpy='0 0 1e999'/>")), HasSubstr("\"1e999\""));
  EXPECT_THAT(urdf_refusal(one_joint("<limit lower='1' upper='-1'/>")), HasSubstr("lower=1 above upper=-1"));
  EXPECT_THAT(urdf_refusal(one_joint("<limit lower='x' upper='-1'/>")), HasSubstr("lower=\"x\""));
  EXPECT_THAT(urdf_refusal(one_joint("<dh a='nan'/>")), HasSubstr("nan"));
  EXPECT_THAT(urdf_refusal(one_joint("<dh/>")), HasSubstr("no attributes"));
  EXPECT_THAT(urdf_refusal(one_joint("<origin xyz='0 0 ${length}'/>")), HasSubstr("xacro"));
  EXPECT_THAT(
      urdf_refusal("<robot><link name='a'><visual><geometry><sphere radius='-1'/></geometry></visual></link></robot>"),
      HasSubstr("at least 0 m"));
}

TEST(UrdfRefuses, WhatIsNoUrdf) {
  EXPECT_THAT(urdf_refusal("<sdf/>"), HasSubstr("the outermost element is <sdf>, expected <robot>"));
  EXPECT_THAT(urdf_refusal(""), HasSubstr("empty"));
}

TEST(UrdfRefuses, AbsurdNamesStayShort) {
  const std::string name(1000000, 'n');
  EXPECT_THAT(urdf_refusal("<robot><link name='" + name + "'/><link name='" + name + "'/></robot>"), HasSubstr("..."));
}

}  // namespace
}  // namespace handsight
