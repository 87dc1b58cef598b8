// SPDX-License-Identifier: Apache-2.0
// Small sessions as text, to be changed in one place.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "session/session_xml.h"

namespace handsight {

inline const std::string small_robot = R"(<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/><link name="one"/><link name="two"/><link name="three"/><link name="hand"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="one"/><axis xyz="0 0 1"/></joint>
  <joint name="j2" type="revolute"><parent link="one"/><child link="two"/><axis xyz="0 1 0"/></joint>
  <joint name="follower" type="revolute"><parent link="two"/><child link="three"/><mimic joint="j2"/></joint>
  <joint name="welded" type="fixed"><parent link="three"/><child link="hand"/></joint>
</robot>
)";

/// Line numbers matter to the tests: the first observation starts in line 15.
inline const std::string small_session = R"(<?xml version="1.0"?>
<handsight_session version="1" title="Small">
  <robot file="robot.urdf" tcp="hand"/>
  <gravity xyz="0 0.5 -9.8"/>
  <stereo mount="base">
    <mount_from_left xyz="1 2 3" rpy="0.1 0.2 0.3" estimate="no"/>
    <right_from_left xyz="-0.2 0 0" rpy="0 0.1 0"/>
    <camera name="left" width="640" height="480" fx="500" fy="501" skew="0.5" cx="320" cy="240" k1="-0.1" k2="0.2" p1="0.01" p2="0.02" k3="0.3"/>
    <camera name="right" width="800" height="600" fx="510" fy="511" cx="400" cy="300"/>
  </stereo>
  <markers count="3" sigma_pixel="0.2"/>

  <joints>j1 j2</joints>
  <observations>
    <observation id="7" time="1.5">
      <position>0.1 -0.2</position>
      <velocity>1 2</velocity>
      <torque>3 4</torque>
      <images left="images/7_left.png" right="images/7_right.png"/>
      <marker index="2" left="100.5 200" right="110 210" by="hand"/>
      <marker index="0" left="10 20"/>
      <decision state="rejected" reason="too far"/>
    </observation>
    <observation id="3" time="1.5"><position>0 0</position></observation>
    <observation id="9" time="4"><position>1 1</position><marker index="1" right="1 2" by="tracker"/></observation>
  </observations>
</handsight_session>
)";

inline const std::string small_tracker_session = R"(<handsight_session version="1">
  <robot file="robot.urdf" tcp="hand"/>
  <tracker mount="base" sigma="0.0002"><mount_from_tracker estimate="yes"/></tracker>
  <markers count="1"/>
  <joints>j1</joints>
  <observations><observation id="0" time="0"><position>0.5</position><marker index="0" point="1 2 3"/></observation></observations>
</handsight_session>
)";

/// The text with one piece, which must be there, replaced.
inline std::string changed(std::string text, const std::string& piece, const std::string& by) {
  const std::size_t position = text.find(piece);
  EXPECT_NE(position, std::string::npos) << piece << " is not in the text";
  return position == std::string::npos ? text : text.replace(position, piece.size(), by);
}

/// What `action` refuses; also that the sentence has the length that people can read.
std::string find_refusal(auto&& action) {
  try {
    action();
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_GE(sentence.size(), 20u) << sentence;
    EXPECT_LE(sentence.size(), 600u) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    return sentence;
  }
  return "nothing was refused";
}

}  // namespace handsight
