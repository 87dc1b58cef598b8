// SPDX-License-Identifier: Apache-2.0
// What a robot's program writes into a session's folder while it moves: joints.csv, and beside it images/ or
// points.csv.
#pragma once

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// Looks into a folder again and again. joints.csv has a header `number, [time,] JOINT ...` and a line a pose; the
/// images of pose 12 are those in images/ whose names hold 12 as their last number and left or right; a tracker's
/// points are the line of that number in points.csv (`number,m0_x,m0_y,m0_z,...`). Only whole lines and whole images
/// are taken; what is half written is looked at again, and set aside with a sentence where it stays so for two seconds.
class Arrivals {
 public:
  /// `session` gives joints, cameras or tracker, and what has arrived already.
  explicit Arrivals(const Session& session);

  struct Look {
    std::vector<Observation> arrived;  // in order of their numbers, without ids
    std::vector<std::string> remarks;  // what is set aside and why, a sentence each, once
  };
  Look look();

 private:
  struct Pose {
    Eigen::VectorXd position;
    double time = 0;
  };
  /// Whole lines of a table that were not seen before.
  struct Lines {
    std::string file;
    std::uintmax_t read = 0;           // bytes, up to a line's end
    std::vector<std::string> columns;  // lower case but for joints; empty: no header yet
  };

  std::vector<std::vector<std::string>> new_lines(Lines& lines, Look& look);
  void take_joints(Look& look);
  void take_points(Look& look);
  void take_images(Look& look);
  void set_aside(const std::string& what, const std::string& why, Look& look);
  bool add_images(std::int64_t number, Observation& observation, Look& look);

  std::filesystem::path folder_;
  std::vector<std::string> joints_;
  bool is_tracker_ = false;
  int markers_ = 0;
  Lines joint_lines_, point_lines_;
  std::map<std::int64_t, Pose> poses_;                    // that wait for what was measured
  std::map<std::int64_t, std::vector<Sighting>> points_;  // that wait for their pose
  std::map<std::int64_t, std::array<std::string, 2>> images_;
  std::map<std::string, std::chrono::steady_clock::time_point> half_since_;
  std::set<std::string> known_files_, said_;
  std::vector<double> known_times_;  // ascending
  double next_time_ = 0;
};

}  // namespace handsight
