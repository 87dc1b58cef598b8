// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "ways/convert_pairing.h"
#include "ways/convert_ways.h"
#include "ways/ros_bag.h"

namespace handsight {
namespace {

/// The child frame that a detector publishes: the one that is named, or the only one that sounds like one.
std::string target_frame_of(const BagContents& bag, const std::string& wanted) {
  std::vector<std::string> likely, all;
  for (const auto& [child, frame] : bag.frames) {
    all.push_back(child);
    if (says(child, {"tag", "marker", "aruco", "target", "board", "charuco"})) likely.push_back(child);
  }
  if (!wanted.empty() && bag.frames.count(wanted)) return wanted;
  if (!wanted.empty())
    throw InputError(fmt::format("--target-frame {}: /tf of the bag has no such child; it has: {}.", in_quotes(wanted),
                                 shortened(fmt::format("{}", fmt::join(all, " ")), 300)));
  if (likely.size() == 1) return likely.front();
  throw InputError(
      fmt::format("The bag has no pair of camera images with calibration, and its /tf {} frames that sound like a "
                  "target; name it with "
                  "--target-frame. /tf has: {}.",
                  likely.empty() ? "no" : "several", shortened(fmt::format("{}", fmt::join(all, " ")), 300)));
}

/// Left and right of the bag's image topics, and their cameras; nothing where there are none.
struct BagRig {
  const BagImages *left, *right;
  StereoRig rig;
};

const RosCamera* camera_beside(const BagContents& bag, const std::string& topic) {
  const auto folder = [](const std::string& name) { return name.substr(0, name.rfind('/')); };
  for (const auto& [name, camera] : bag.cameras)
    for (std::string above = folder(topic); above.size() > 1; above = folder(above)) {
      if (folder(name) == above) return &camera;
      if (above.rfind('/') == std::string::npos || above.rfind('/') == 0) break;
    }
  return nullptr;
}

std::optional<BagRig> find_bag_rig(const BagContents& bag, const Brought& b) {
  const BagImages *left = nullptr, *right = nullptr;
  for (const BagImages& images : bag.images) {
    if (says(images.topic, {"left", "infra1"}) && !left) left = &images;
    if (says(images.topic, {"right", "infra2"}) && !right) right = &images;
  }
  if (!left || !right) return std::nullopt;
  if (b.rig) return BagRig{left, right, *b.rig};
  const RosCamera *l = camera_beside(bag, left->topic), *r = camera_beside(bag, right->topic);
  if (!l || !r) return std::nullopt;
  return BagRig{left, right, rig_of(*l, *r)};
}

/// Places of images of both sides that were taken together.
struct Together {
  std::vector<std::size_t> left, right;
  std::vector<double> times;
};
Together taken_together(const BagImages& left, const BagImages& right) {
  constexpr double apart = 0.01;  // s
  Together t;
  for (std::size_t i = 0; i < left.times.size(); ++i) {
    std::size_t best = right.times.size();
    for (std::size_t k = 0; k < right.times.size(); ++k)
      if (std::abs(right.times[k] - left.times[i]) <= apart &&
          (best == right.times.size() ||
           std::abs(right.times[k] - left.times[i]) < std::abs(right.times[best] - left.times[i])))
        best = k;
    if (best == right.times.size()) continue;
    t.left.push_back(i);
    t.right.push_back(best);
    t.times.push_back(left.times[i]);
  }
  return t;
}

Conversion from_bag_images(const FieldUrdf& robot, const BagContents& bag, const BagRig& rig,
                           const std::filesystem::path& file, const ConvertOptions& o, Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const Together pairs = taken_together(*rig.left, *rig.right);
  if (pairs.times.size() < rig.left->times.size())
    c.notes.push_back(fmt::format("{} of {} left images have no right image within 10 ms and are left out.",
                                  rig.left->times.size() - pairs.times.size(), rig.left->times.size()));
  const Paired p = pair_events(bag.joints, pairs.times, pairs.times.size(), {}, o, c.notes);
  std::filesystem::create_directories(o.out / "images");
  const auto left = write_bag_images(file, *rig.left, chosen(pairs.left, p.events), o.out / "images", "left"),
             right = write_bag_images(file, *rig.right, chosen(pairs.right, p.events), o.out / "images", "right");
  std::vector<ImageFiles> images;
  for (std::size_t i = 0; i < left.size(); ++i)
    images.push_back({static_cast<std::int64_t>(i), o.out / "images" / left[i], o.out / "images" / right[i]});
  parts.joints = {bag.joints.names, {}, p.positions};
  parts.times = chosen(pairs.times, p.events);
  StereoRig cameras = rig.rig;
  fit_to_first_image(cameras, images, c.notes);
  c.session = write_stereo_session(parts, cameras, images, o, c.notes);
  return c;
}

}  // namespace

Conversion from_bag(const std::optional<FieldUrdf>& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (!robot) throw InputError("The bag publishes no robot_description; name the robot's URDF with --robot.");
  BagContents bag = read_bag_contents(b.bag, robot->robot);
  c.notes.insert(c.notes.end(), bag.notes.begin(), bag.notes.end());
  if (b.joints) bag.joints = *b.joints;
  if (bag.joints.positions.empty())
    throw InputError(
        "The bag has no sensor_msgs/JointState with joints of this robot; record /joint_states too, or name "
        "the robot that it was recorded with.");
  if (const auto rig = o.target_frame.empty() ? find_bag_rig(bag, b) : std::nullopt)
    return from_bag_images(*robot, bag, *rig, b.bag, o, std::move(c));
  const std::string child = target_frame_of(bag, o.target_frame);
  const BagFrame& frame = bag.frames.at(child);
  c.notes.push_back(
      fmt::format("The target is the frame {} that /tf gives in {}.", in_quotes(child), in_quotes(frame.parent)));
  c.notes.push_back(poses_note);
  return from_points(*robot, bag.joints, {frame.series.times, points_of_poses(frame.series)}, speeds_of(frame.series),
                     o, std::move(c));
}

}  // namespace handsight
