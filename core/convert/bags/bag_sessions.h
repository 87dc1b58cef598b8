// SPDX-License-Identifier: Apache-2.0
// A bag that holds several sensors or two hands, and nobody has said which is which: what each session is made of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "convert/conversion.h"
#include "readers/bag_contents.h"
#include "robot/robot.h"

namespace handsight {

/// Each session that names neither --camera nor --target-frame becomes one for each pair of cameras and, where a target
/// is known, each other camera of the bag among the files; where there are no such cameras, each hand gets the frame
/// of /tf that has its side's name, and a robot's only hand one session a frame. `notes` says so. As they came where
/// there is no bag, or nothing to part. InputError where the bag cannot be read; ConversionStopped.
std::vector<ConvertOptions> sessions_of_bag(const std::vector<std::filesystem::path>& files,
                                            std::vector<ConvertOptions> sessions, std::vector<Message>& notes);

/// Frames of /tf, and topics of poses, that sound like targets by what they are called.
std::vector<std::string> target_frames(const BagContents& bag);

/// The link that carries a camera whose frame the bag tells: the robot's link of that name, or the one that the frame
/// hangs from in /tf. Empty: none does.
std::string link_of_frame(const BagContents& bag, const Robot& robot, std::string frame);

}  // namespace handsight
