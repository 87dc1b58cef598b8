// SPDX-License-Identifier: Apache-2.0
// What a robot's program writes into folders while it moves: joints.csv, and beside it images, points.csv or poses.csv.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"
#include "live/growing_table.h"
#include "live/image_arrival.h"
#include "live/known_again.h"
#include "session/find_images.h"
#include "session/session.h"

namespace handsight {

/// Where images and joint angles arrive.
struct LiveSources {
  std::vector<std::filesystem::path> folders;  // by camera; those of two may be the same
  std::filesystem::path table;
  bool operator==(const LiveSources&) const = default;
};

/// images/ and joints.csv in the session's folder.
LiveSources usual_sources(const Session& session);

/// The same, with the folders in which the session's images are.
LiveSources own_sources(const Session& session);

/// Looks into folders again and again. The table has a header `number, [time,] JOINT ...` and a line a pose (where only
/// the flange is known also `number, [time,] x, y, z, qx, qy, qz, qw`, base_from_flange); the images of pose 12 are
/// those that find_camera_folders finds for 12; a tracker's points are the line of that number in points.csv
/// (`number,m0_x,m0_y,m0_z,...`), poses of a target that in poses.csv (`number,x,y,z,qx,qy,qz,qw`), both in the
/// session's folder. A pose comes in once every camera has its image.
///
/// With cameras `number` may be missing: then line k belongs to the k-th instant of the folders, there must be as many
/// lines as instants, and the lines of those that are in the session must say what it says.
///
/// Only whole lines and whole images of the cameras' sizes are taken; what is half written is looked at again, and said
/// where it stays so (ImageArrival). What is not whole holds up no other. Images from elsewhere are copied into the
/// session's folder.
class Arrivals {
 public:
  /// `session` gives joints, cameras or tracker, and what has arrived already: that does not come twice. `settles_in`
  /// as ImageArrival has it.
  explicit Arrivals(const Session& session) : Arrivals(session, usual_sources(session), std::nullopt) {}
  Arrivals(const Session& session, LiveSources sources, std::optional<std::chrono::milliseconds> settles_in);

  struct Look {
    std::vector<Observation> arrived;  // in order of their numbers, without ids
    std::vector<Message> remarks;      // what waits or is set aside and why, a sentence each, as it begins to
  };
  /// Never throws for what is wrong in the folders: it is said.
  Look look();
  /// All that waits or is set aside at the last look.
  std::vector<Message> standing() const;

  /// The session has changed since: times go on from its last, and line k is compared with what it says now. What has
  /// arrived once and is no longer in it stays away.
  void know(const Session& session);
  /// It has not arrived after all, and is looked for again.
  void forget(const Observation& observation);

 private:
  static constexpr std::size_t no_posture = std::numeric_limits<std::size_t>::max();
  struct Pose {
    Eigen::VectorXd position;
    std::optional<double> time;
  };

  // Tables.
  bool has_all_columns();
  std::optional<Pose> pose_in(const GrowingTable::Cells& cells) const;
  void take_poses();
  void take_points();
  void take_target_poses();
  void pair_measured(Look& look);
  bool add_measured(std::int64_t number, Observation& observation);
  // Images.
  void know_images(const Observation& observation);
  void forget_images(const Observation& observation);
  bool is_known(std::size_t camera, const std::filesystem::path& image) const;
  bool is_known(const InstantImages& instant) const;
  std::size_t place_of_posture(const InstantImages& instant) const;
  void take_images(Look& look);
  void leave_out_known(std::vector<InstantImages>& instants) const;
  bool look_at(const std::vector<InstantImages>& instants);
  Message table_refusal(const std::vector<InstantImages>& instants) const;
  Message counting_refusal(const std::vector<InstantImages>& instants) const;
  const Pose* find_instant_pose(const InstantImages& instant, std::size_t rank) const;
  bool has_every_image(const InstantImages& instant);
  bool are_whole(const InstantImages& instant);
  void take(const InstantImages& instant, std::size_t rank, Look& look);
  std::filesystem::path find_folder(const InstantImages& instant, std::size_t camera) const;

  void arrive(Observation observation, const Pose& pose, Look& look);

  std::filesystem::path folder_;
  LiveSources sources_;
  std::vector<std::string> joints_, names_;  // names_: of the cameras; none: a tracker or a sensor of poses
  std::vector<Camera> cameras_;
  bool tells_poses_ = false, is_of_flange_ = false;
  int markers_ = 0;
  double lever_ = 0;  // m, of a sensor of poses
  GrowingTable table_, measured_;
  ImageArrival files_;
  std::map<std::int64_t, Pose> poses_;                    // that wait for what was measured
  std::vector<std::optional<Pose>> lines_;                // of a table without numbers; nothing where one is set aside
  std::map<std::int64_t, std::vector<Sighting>> points_;  // that wait for their pose
  std::map<std::int64_t, Rigid> target_poses_;            // likewise
  /// By camera: names of images that have arrived, with the place of their posture; `no_posture` where the session has
  /// them no longer.
  std::vector<std::map<std::string, std::size_t>> known_;
  std::vector<Eigen::VectorXd> postures_;
  Ascending known_lines_;               // of tables that tell the time
  Ascending known_measured_, arrived_;  // of sessions without images: what was measured; with numbers what has arrived
  std::vector<Message> waiting_;        // what images wait for
  std::set<std::string> waited_;        // what they did at the look before
  double next_time_ = 0;
};

}  // namespace handsight
