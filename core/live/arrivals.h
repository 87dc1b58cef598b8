// SPDX-License-Identifier: Apache-2.0
// What a robot's program writes into a session's folder while it moves: joints.csv, and beside it images/, points.csv
// or poses.csv.
#pragma once

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// Looks into a folder again and again. joints.csv has a header `number, [time,] JOINT ...` and a line a pose (where
/// only the flange is known also `number, [time,] x, y, z, qx, qy, qz, qw`, base_from_flange); the images of pose 12
/// are those in images/ whose names hold a camera's name (of one camera, any) and, that apart, 12 as their last number;
/// a tracker's points are the line of that number in points.csv (`number,m0_x,m0_y,m0_z,...`), poses of a target that
/// in poses.csv (`number,x,y,z,qx,qy,qz,qw`). A pose comes in once every camera has its image. Only whole lines and
/// whole images are taken; what is half written is looked at again, and set aside with a sentence where it stays so for
/// two seconds.
class Arrivals {
 public:
  /// `session` gives joints, cameras or tracker, and what has arrived already: that does not come twice.
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

  /// Joint angles and what was measured, to 1e-9: by it an observation of the session is known again.
  using Key = std::vector<std::int64_t>;
  static Key key_of(const Observation& observation);

  std::optional<Eigen::VectorXd> position_in(const std::vector<std::string>& cells) const;
  std::vector<std::vector<std::string>> new_lines(Lines& lines, Look& look);
  void take_joints(Look& look);
  void take_points(Look& look);
  void take_poses(Look& look);
  void take_images();
  void set_aside(const std::string& what, const std::string& why, Look& look);
  std::optional<std::size_t> camera_of(const std::string& lower_stem) const;
  bool add_images(std::int64_t number, Observation& observation, Look& look);
  bool add_measured(std::int64_t number, Observation& observation, Look& look);
  void forget(std::int64_t number, const Observation& observation);

  std::filesystem::path folder_;
  std::vector<std::string> joints_;
  std::vector<std::string> cameras_;  // their names in small letters; empty: a tracker or a sensor of poses
  bool tells_poses_ = false, is_of_flange_ = false;
  int markers_ = 0;
  double lever_ = 0;  // m, of a sensor of poses
  Lines joint_lines_, measured_lines_;
  std::map<std::int64_t, Pose> poses_;                    // that wait for what was measured
  std::map<std::int64_t, std::vector<Sighting>> points_;  // that wait for their pose
  std::map<std::int64_t, Rigid> target_poses_;            // likewise
  std::map<std::int64_t, std::array<std::string, max_cameras>> images_;
  std::map<std::string, std::chrono::steady_clock::time_point> half_since_;
  std::set<std::string> known_files_, said_;
  std::set<Key> known_measured_;     // of sessions without images
  std::vector<double> known_times_;  // ascending
  double next_time_ = 0;
};

}  // namespace handsight
