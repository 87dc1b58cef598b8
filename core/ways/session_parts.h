// SPDX-License-Identifier: Apache-2.0
// A converted session on its way into its folder. Internal to convert.cpp.
#pragma once

#include "session/new_session.h"
#include "ways/convert.h"

namespace handsight {

struct SessionParts {
  std::string urdf_text;
  std::string tcp, mount;
  JointSeries joints;         // one an observation
  std::vector<double> times;  // s; empty: one second apart
  std::vector<std::vector<std::optional<Vector3>>> points;
};

inline constexpr char poses_note[] =
    "The target's pose is held as four points of a tracker: its frame's origin and 0.1 m along each axis. They share "
    "their errors, so that the sigmas are a little too small.";

/// The virtual points of each pose in the sensor's frame.
std::vector<std::vector<std::optional<Vector3>>> points_of_poses(const PoseSeries& sensor_from_target);

/// Write the folder, robot.urdf first and session.xml last; the session that is returned was read back.
Session write_tracker_session(const SessionParts& parts, const ConvertOptions& options);
Session write_stereo_session(const SessionParts& parts, const StereoRig& rig, const std::vector<ImageFiles>& images,
                             const ConvertOptions& options, std::vector<std::string>& notes);

}  // namespace handsight
