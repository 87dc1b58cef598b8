// SPDX-License-Identifier: Apache-2.0
// What ROS's own rosbag writes.
#include <cstdlib>

#include "readers/bags/small_bag.h"

namespace handsight {
namespace {

TEST(Rosbag, WhatItWritesIsRead) {
  const TemporaryFolder folder;
  const std::string script = HANDSIGHT_SOURCE_DIR "/tests/readers/bags/write_with_rosbag.py";
  const int status = std::system(("/usr/bin/python3 " + script + " " + folder.path.string()).c_str());
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "python3-rosbag, python3-sensor-msgs, python3-tf2-msgs: not installed";
  ASSERT_EQ(status, 0);
  for (const char* compression : {"none", "bz2", "lz4"})
    expect_whole(folder.path / (std::string(compression) + ".bag"));
}

}  // namespace
}  // namespace handsight
