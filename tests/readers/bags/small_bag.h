// SPDX-License-Identifier: Apache-2.0
// What tests ask of the small recording once it has been read.
#pragma once

#include <gmock/gmock.h>

#include "readers/bag_contents.h"
#include "readers/bags/recordings.h"
#include "robot/urdf.h"
#include "temporary_folder.h"

namespace handsight {

inline Robot two_joints() {
  return parse_urdf(R"(<robot name="r"><link name="l0"/><link name="l1"/><link name="l2"/>
    <joint name="a" type="continuous"><parent link="l0"/><child link="l1"/></joint>
    <joint name="bb" type="continuous"><parent link="l1"/><child link="l2"/></joint></robot>)",
                    "robot.urdf", nullptr);
}

inline BagContents contents_of(const std::filesystem::path& path) {
  return read_bag_contents(open_bag(path), two_joints());
}

/// The same numbers as in fixture::small_recording, bit for bit.
inline void expect_small_recording(const BagContents& c) {
  ASSERT_EQ(c.joints.positions.size(), 40u);
  ASSERT_EQ(c.joints.names, (std::vector<std::string>{"a", "bb"}));
  EXPECT_EQ(c.joints.positions[7][0], 0.01 * 7);
  EXPECT_EQ(c.joints.positions[39][1], -0.5);
  EXPECT_NEAR(c.joints.times[7], 1000.7, 1e-6);
  ASSERT_TRUE(c.frames.contains("tag_7"));
  ASSERT_TRUE(c.frames.contains("/board"));
  EXPECT_EQ(c.frames.at("tag_7").parent, "camera");
  ASSERT_EQ(c.frames.at("tag_7").series.poses.size(), 40u);
  for (const int i : {0, 11, 39}) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_LT(small_motion_between(c.frames.at("tag_7").series.poses[k], fixture::tag_at(i)).norm(), 1e-12);
    EXPECT_LT(small_motion_between(c.frames.at("/board").series.poses[k], fixture::tag_at(40 - i)).norm(), 1e-12);
  }
  ASSERT_EQ(c.cameras.size(), 1u);
  EXPECT_EQ(c.cameras.begin()->second.camera.fy, 11);
  EXPECT_EQ(c.cameras.begin()->second.camera.k1, -0.1);
  ASSERT_EQ(c.images.size(), 1u);
  EXPECT_EQ(c.images[0].times.size(), 4u);
  EXPECT_THAT(c.notes, testing::Contains(testing::HasSubstr("/chatter (std_msgs/Int8, 40 messages) is left out")));
}

/// Nothing was lost.
inline void expect_whole(const std::filesystem::path& path) {
  SCOPED_TRACE(path.filename().string());
  const Bag bag = open_bag(path);
  const BagContents c = read_bag_contents(bag, two_joints());
  expect_small_recording(c);
  EXPECT_EQ(c.notes.size(), 1u) << testing::PrintToString(c.notes);
  EXPECT_EQ(find_robot_description(bag), "<robot/>");
  const TemporaryFolder folder;
  const auto names = write_bag_images(bag, c.images.at(0), {3, 1}, folder.path, "left");
  ASSERT_EQ(names, (std::vector<std::string>{"0000_left.pgm", "0001_left.pgm"}));
  std::ifstream stream(folder.path / names[0], std::ios::binary);
  const std::string image{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(image, "P5\n8 6\n255\n" + std::string(48, 'd'));
}

}  // namespace handsight
