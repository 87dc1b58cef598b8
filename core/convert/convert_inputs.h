// SPDX-License-Identifier: Apache-2.0
// The ways from what was brought to a session, by the sensor that measured. Internal to convert.
#pragma once

#include "base/message.h"
#include "convert/brought.h"
#include "convert/conversion.h"
#include "convert/session_parts.h"
#include "readers/bag_contents.h"
#include "readers/bags/bag.h"
#include "readers/field_urdf.h"

namespace handsight {

/// Is one of these words in the name, in capitals or not?
bool says(const std::string& name, std::initializer_list<const char*> words);

/// TCP and mount of the robot into the parts; InputError where the TCP is not named.
void require_links(const FieldUrdf& robot, const ConvertOptions& options, SessionParts& parts,
                   std::vector<Message>& notes);

/// The hand in the mount's frame at the readings of these parts, as if it were a flange.
NamedPoses hand_of(const FieldUrdf& robot, const SessionParts& parts);

/// The way of a flange alone: no robot is known, its pose is.
Conversion from_flange(NamedPoses flange, NamedPoses target, bool eye_in_hand, const ConvertOptions& options,
                       Conversion conversion);

/// The same with points of one marker, which a sensor measured without a turn.
Conversion from_flange_points(NamedPoses flange, const PointSeries& points, bool eye_in_hand,
                              const ConvertOptions& options, Conversion conversion);

/// The same with folders of images of a board or of tags in place of the target's poses.
Conversion from_flange_images(const Brought& brought, const ConvertOptions& options, Conversion conversion);

/// The robot of poses in the parts: its flange carries the target or, eye in hand, the camera.
void set_flange(SessionParts& parts, const PoseSeries& flange, bool eye_in_hand, std::vector<Message>& notes);

/// Of a tracker; `speeds` (m/s) of what it saw, where they are known.
Conversion from_points(const FieldUrdf& robot, const JointSeries& joints, const PointSeries& points,
                       const std::vector<double>& speeds, const ConvertOptions& options, Conversion conversion);

/// Of a sensor that tells the target's pose.
Conversion from_poses(const FieldUrdf& robot, const JointSeries& joints, NamedPoses target,
                      const ConvertOptions& options, Conversion conversion);

/// Folders of images of one to eight cameras.
Conversion from_images(const FieldUrdf& robot, const Brought& brought, const ConvertOptions& options,
                       Conversion conversion);

/// Where a bag's /tf has the flange, as readings of poses_robot's joints: the frame that --tcp names, or the only one
/// that sounds like a flange, with all that carries it. InputError where there is none.
JointSeries flange_of_bag(const BagContents& bag, const ConvertOptions& options, std::vector<Message>& notes);

/// Are there touches of a probe: options that describe fixtures, or a table with a column `fixture`?
bool are_touches(const std::vector<std::filesystem::path>& files, const Robot* robot, const ConvertOptions& options);

/// Tables of touches: joint angles, what was touched, what it read.
Conversion from_touches(const std::optional<FieldUrdf>& robot, const std::vector<std::filesystem::path>& files,
                        const ConvertOptions& options, Conversion conversion);

/// A bag of ROS, with images of two cameras (of one with a target) or with the target's frames; without a robot the
/// flange's frame stands for it.
Conversion from_bag(const std::optional<FieldUrdf>& robot, const Bag& bag, const Brought& brought,
                    const ConvertOptions& options, Conversion conversion);

/// The cameras' sizes as the first of these images of each has them.
void fit_to_first_images(Rig& rig, const std::vector<InstantImages>& images, std::vector<Message>& notes);

/// InputError where nothing can be found in the images of this rig: without a target markers have no names. The
/// sentence says which target the images in these folders show.
void require_target(const Rig& rig, const ConvertOptions& options,
                    const std::vector<std::filesystem::path>& folders = {});

}  // namespace handsight
