// SPDX-License-Identifier: Apache-2.0
#include "convert/bags/bag_rigs.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/letters.h"
#include "base/text.h"
#include "convert/convert_inputs.h"

namespace handsight {
namespace {

/// What stands in a topic's name before the word that says the side: "/head/" of "/head/left/image_raw".
std::string before_side(const std::string& topic, std::initializer_list<const char*> sides) {
  const std::string small = lower_case(topic);
  std::size_t at = std::string::npos;
  for (const char* side : sides) at = std::min(at, small.find(side));
  return topic.substr(0, at);
}

std::optional<BagRig> find_bag_pair(const BagContents& bag, const Brought& b) {
  const std::map<std::string, TopicPair> pairs = topic_pairs(bag);
  if (pairs.empty()) return std::nullopt;
  if (pairs.size() > 1) {
    std::string names;
    for (const auto& [name, pair] : pairs) names += (names.empty() ? "" : ", ") + name;
    throw InputError(
        message("The bag has {} pairs of cameras ({}); say with --camera which to take, or name each with a --camera "
                "of its own for a collection.",
                pairs.size(), shortened(names, 200)));
  }
  const auto [left, right] = pairs.begin()->second;
  const RosCamera *l = camera_beside(bag, left->topic), *r = camera_beside(bag, right->topic);
  const std::string frame = l ? l->frame : "";
  if (b.rig && is_pair(*b.rig)) return BagRig{{left, right}, *b.rig, frame};
  if (!l || !r) return std::nullopt;
  return BagRig{{left, right}, make_rig(make_rig(*l, *r)), frame};
}

}  // namespace

std::map<std::string, TopicPair> topic_pairs(const BagContents& bag) {
  std::map<std::string, TopicPair> pairs;
  TopicPair first;
  const auto see = [&](const BagImages& images, std::initializer_list<const char*> sides,
                       const BagImages* TopicPair::*side) {
    if (!says(images.topic, sides)) return;
    TopicPair& pair = pairs[before_side(images.topic, sides)];
    if (!(pair.*side)) pair.*side = &images;
    if (!(first.*side)) first.*side = &images;
  };
  for (const BagImages& images : bag.images) {
    see(images, {"left", "infra1"}, &TopicPair::left);
    see(images, {"right", "infra2"}, &TopicPair::right);
  }
  std::erase_if(pairs, [](const auto& named) { return !named.second.left || !named.second.right; });
  if (pairs.empty() && first.left && first.right) pairs[""] = first;
  return pairs;
}

const RosCamera* camera_beside(const BagContents& bag, const std::string& topic) {
  const auto folder = [](const std::string& name) { return name.substr(0, name.rfind('/')); };
  for (const auto& [name, camera] : bag.cameras)
    for (std::string above = folder(topic); above.size() > 1; above = folder(above)) {
      if (folder(name) == above) return &camera;
      if (above.rfind('/') == std::string::npos || above.rfind('/') == 0) break;
    }
  return nullptr;
}

std::vector<const BagImages*> calibrated_topics(const BagContents& bag) {
  std::vector<const BagImages*> topics;
  std::set<const RosCamera*> seen;
  for (const BagImages& images : bag.images) {
    const RosCamera* camera = camera_beside(bag, images.topic);
    if (camera && !says(images.topic, {"depth"}) && seen.insert(camera).second) topics.push_back(&images);
  }
  return topics;
}

void keep_camera(BagContents& bag, const std::string& camera) {
  if (camera.empty()) return;
  std::string topics;
  for (const BagImages& images : bag.images) topics += (topics.empty() ? "" : ", ") + images.topic;
  std::erase_if(bag.images, [&](const BagImages& images) { return images.topic.find(camera) == std::string::npos; });
  if (bag.images.empty())
    throw InputError(message("--camera {}: no image topic of the bag has this in its name; it has: {}.",
                             in_quotes(camera), topics.empty() ? Message("none") : verbatim(shortened(topics, 300))));
}

std::optional<BagRig> find_bag_rig(const BagContents& bag, const Brought& b, const ConvertOptions& o) {
  if (auto pair = find_bag_pair(bag, b)) return pair;
  if (!o.target) return std::nullopt;
  if (b.rig && b.rig->count() == 1 && bag.images.size() == 1) return BagRig{{&bag.images.front()}, *b.rig, ""};
  const std::vector<const BagImages*> single = calibrated_topics(bag);
  if (single.size() == 1) {
    const RosCamera& camera = *camera_beside(bag, single.front()->topic);
    return BagRig{single, make_rig(camera), camera.frame};
  }
  std::string topics;
  for (const BagImages& images : bag.images) topics += (topics.empty() ? "" : ", ") + images.topic;
  throw InputError(
      message("The bag has {} image topics with a calibration beside them where one is expected{}; record one "
              "camera with its CameraInfo, or a left and a right one, or say with --camera which to take.",
              single.size(), topics.empty() ? std::string() : " (" + shortened(topics, 200) + ")"));
}

}  // namespace handsight
