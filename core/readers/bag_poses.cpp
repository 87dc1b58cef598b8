// SPDX-License-Identifier: Apache-2.0
#include "readers/bag_poses.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/rigid.h"

namespace handsight {
namespace {

bool has_numbered_tags(const BagTopic& topic) { return topic.type.ends_with("/ArucoMarkers"); }
bool has_tags_and_boards(const BagTopic& topic) { return topic.type == "aruco_opencv_msgs/ArucoDetection"; }
bool is_array(const BagTopic& topic) { return topic.type == "geometry_msgs/PoseArray"; }

void add_pose(BagFrame& frame, const std::string& parent, double time, const Rigid& pose) {
  if (frame.series.poses.empty()) frame.parent = parent;
  if (frame.parent != parent) return;
  frame.series.times.push_back(time);
  frame.series.poses.push_back(pose);
}

/// Does the frame have this pose at this time?
bool tells(const BagFrame& frame, const std::string& parent, double time, const Rigid& pose) {
  constexpr double same = 1e-6;  // m and rad; times in s
  if (frame.parent != parent) return false;
  for (std::size_t i = 0; i < frame.series.times.size(); ++i)
    if (std::abs(frame.series.times[i] - time) < same)
      return small_motion_between(frame.series.poses[i], pose).norm() < same;
  return false;
}

/// Detectors publish what they see in more ways than one.
bool is_told_already(const BagFrame& frame, const BagFrames& frames) {
  return !frame.series.poses.empty() && std::any_of(frames.begin(), frames.end(), [&](const auto& other) {
    return tells(other.second, frame.parent, frame.series.times.front(), frame.series.poses.front());
  });
}

void add_frame(const std::string& name, BagFrame frame, BagFrames& frames) {
  if (!frame.series.poses.empty() && !is_told_already(frame, frames)) frames[name] = std::move(frame);
}

}  // namespace

bool PosesTaker::wants(const BagTopic& topic) {
  return has_numbered_tags(topic) || has_tags_and_boards(topic) || is_array(topic);
}

void PosesTaker::take(const BagTopic& topic, const ros::Message& message, std::int64_t nanoseconds) {
  Instant one;
  one.poses = is_array(topic)            ? ros::read_pose_array(message)
              : has_numbered_tags(topic) ? ros::read_aruco_markers(message)
                                         : ros::read_aruco_detection(message);
  one.time = ros::time_of(one.poses.header, nanoseconds);
  (is_array(topic) ? arrays_ : named_)[topic.name].push_back(std::move(one));
}

void PosesTaker::finish(const std::string& bag, BagFrames& frames, std::vector<Message>& ambiguous,
                        std::vector<Message>& notes) {
  for (const auto& [topic, instants] : named_) add_named(topic, instants, frames);
  for (const auto& [topic, instants] : arrays_)
    if (Message note = add_array(bag, topic, instants, frames, ambiguous); !note.empty())
      notes.push_back(std::move(note));
}

void PosesTaker::add_named(const std::string& topic, const std::vector<Instant>& instants, BagFrames& frames) {
  BagFrames named;
  for (const Instant& one : instants)
    for (std::size_t i = 0; i < one.poses.poses.size(); ++i)
      add_pose(named[topic + "/" + one.poses.names[i]], one.poses.header.frame, one.time, one.poses.poses[i]);
  for (auto& [name, frame] : named) add_frame(name, std::move(frame), frames);
}

Message PosesTaker::add_array(const std::string& bag, const std::string& topic, const std::vector<Instant>& instants,
                              BagFrames& frames, std::vector<Message>& ambiguous) {
  std::size_t fewest = 0, most = 0;  // of messages that hold any
  std::vector<BagFrame> places;
  for (const Instant& one : instants) {
    const std::size_t count = one.poses.poses.size();
    if (count == 0) continue;  // nothing was seen
    fewest = most == 0 ? count : std::min(fewest, count);
    most = std::max(most, count);
    places.resize(most);
    for (std::size_t i = 0; i < count; ++i) add_pose(places[i], one.poses.header.frame, one.time, one.poses.poses[i]);
  }
  if (most == 0 || is_told_already(places.front(), frames)) return {};
  if (fewest < most) {
    ambiguous.push_back(
        message("{}: topic {} (PoseArray) holds {} to {} poses a message, which have no names, so that nothing tells "
                "which is which; it is left out. Record a topic that names them (/tf, or tags with their numbers), or "
                "with one target in view.",
                bag, topic, fewest, most));
    return ambiguous.back();
  }
  if (most == 1) {
    add_frame(topic, std::move(places.front()), frames);
    return {};
  }
  for (std::size_t i = 0; i < most; ++i) {
    places[i].must_be_named = true;
    frames[topic + "[" + std::to_string(i) + "]"] = std::move(places[i]);
  }
  return message(
      "{}: topic {} (PoseArray) holds {} poses a message, which have no names; with --target-frame \"{}[0]\" (or [1] "
      "...) one of them is taken, as if their order were the same in every message.",
      bag, topic, most, topic);
}

}  // namespace handsight
