// SPDX-License-Identifier: Apache-2.0
// A converted session on its way into its folder. Internal to convert.cpp.
#pragma once

#include "base/message.h"
#include "convert/conversion.h"
#include "session/find_images.h"

namespace handsight {

struct SessionParts {
  std::string urdf_text;  // empty: the robot is unknown, its flange's pose stands for it
  std::string tcp, mount;
  JointSeries joints;                                       // one an observation
  std::vector<double> times;                                // s; empty: one second apart
  std::vector<std::vector<std::optional<Vector3>>> points;  // of a tracker
  std::vector<Rigid> target_poses;                          // of a sensor that tells poses: sensor_from_target
};

/// Write the folder, robot.urdf (where there is one) first and session.xml last; the session that is returned was read
/// back.
Session write_measured_session(const SessionParts& parts, const ConvertOptions& options);
Session write_camera_session(const SessionParts& parts, const Rig& rig, const std::vector<InstantImages>& images,
                             const ConvertOptions& options, std::vector<Message>& notes);

}  // namespace handsight
