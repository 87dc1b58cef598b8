// SPDX-License-Identifier: Apache-2.0
// Which image topics of a bag are one rig. Internal to convert.
#pragma once

#include <map>

#include "convert/brought.h"
#include "convert/conversion.h"
#include "readers/bag_contents.h"

namespace handsight {

/// The bag's image topics, by camera, and their rig.
struct BagRig {
  std::vector<const BagImages*> topics;
  Rig rig;
  std::string frame;  // of the first camera, as its CameraInfo calls it; empty: not told
};

/// A left camera's topic and the right one's.
struct TopicPair {
  const BagImages *left = nullptr, *right = nullptr;
};

/// The pairs whose names agree up to the side, by what stands before it ("/head/"); where none do, the first left one
/// with the first right one.
std::map<std::string, TopicPair> topic_pairs(const BagContents& bag);

/// The calibration in the topic's folder or above it; null where there is none.
const RosCamera* camera_beside(const BagContents& bag, const std::string& topic);

/// One topic for each camera that is calibrated: not its compressed images too, nor depth.
std::vector<const BagImages*> calibrated_topics(const BagContents& bag);

/// Leaves the images whose topics the option names.
void keep_camera(BagContents& bag, const std::string& camera);

/// Two cameras, or with a target the only one whose calibration is known. InputError where there are several, or with a
/// target none.
std::optional<BagRig> find_bag_rig(const BagContents& bag, const Brought& brought, const ConvertOptions& options);

}  // namespace handsight
