// SPDX-License-Identifier: Apache-2.0
// Bags without a robot: where /tf has its flange.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "convert/convert_inputs.h"

namespace handsight {
namespace {

/// As drivers and descriptions call a flange, the usual ones first.
constexpr std::array flange_words{"tool0", "flange", "ee_link", "end_effector", "eef", "ee_pose", "tcp", "hand_link"};

std::string all_frames(const BagContents& bag) {
  std::string all;
  for (const auto& [child, frame] : bag.frames) all += (all.empty() ? "" : " ") + child;
  return all.empty() ? "nothing" : shortened(all, 300);
}

std::string flange_frame_of(const BagContents& bag, const ConvertOptions& o) {
  if (bag.frames.count(o.tcp)) return o.tcp;
  if (!o.tcp.empty())
    throw InputError(message("--tcp {}: no robot is known, and /tf of the bag has no such frame; it has: {}.",
                             in_quotes(o.tcp), all_frames(bag)));
  for (const char* word : flange_words) {
    std::vector<std::string> found;
    for (const auto& [child, frame] : bag.frames)
      if (child != o.target_frame && says(child, {word})) found.push_back(child);
    if (found.size() == 1) return found.front();
    if (found.size() > 1)
      throw InputError(message("The bag has {} frames that sound like the flange ({}); name the one with --tcp.",
                               found.size(), shortened(fmt::format("{}", fmt::join(found, ", ")), 200)));
  }
  throw InputError(
      message("The bag publishes no robot_description, and no frame of its /tf sounds like a flange; name the "
              "robot's URDF with --robot, or the flange's frame with --tcp. /tf has: {}.",
              all_frames(bag)));
}

/// The frames from the flange up to what nothing carries.
std::vector<const BagFrame*> frames_above(const BagContents& bag, std::string child) {
  std::vector<const BagFrame*> frames;
  for (auto at = bag.frames.find(child); at != bag.frames.end() && frames.size() < bag.frames.size();
       at = bag.frames.find(at->second.parent))
    frames.push_back(&at->second);
  return frames;
}

std::optional<Rigid> pose_at(const PoseSeries& series, double time) {
  constexpr double apart = 0.1;                               // s
  if (series.poses.size() == 1) return series.poses.front();  // static
  const auto after = std::lower_bound(series.times.begin(), series.times.end(), time);
  const auto before = after == series.times.begin() ? after : after - 1;
  const auto nearest =
      after == series.times.end() || std::abs(*before - time) < std::abs(*after - time) ? before : after;
  if (std::abs(*nearest - time) > apart) return std::nullopt;
  return series.poses[static_cast<std::size_t>(nearest - series.times.begin())];
}

/// Turns by no more than half a turn from the ones before: what is between two readings is between them.
void unwrap(Eigen::VectorXd& position, const Eigen::VectorXd& last) {
  for (Eigen::Index i = 3; i < 6; ++i) position[i] = last[i] + std::remainder(position[i] - last[i], 2 * M_PI);
}

}  // namespace

JointSeries flange_of_bag(const BagContents& bag, const ConvertOptions& o, std::vector<Message>& notes) {
  const std::string child = flange_frame_of(bag, o);
  const std::vector<const BagFrame*> frames = frames_above(bag, child);
  const BagFrame* fastest = *std::max_element(frames.begin(), frames.end(), [](const BagFrame* a, const BagFrame* b) {
    return a->series.times.size() < b->series.times.size();
  });
  JointSeries flange;
  for (const Joint& joint : poses_robot().joints) flange.names.push_back(joint.name);
  for (const double time : fastest->series.times) {
    std::optional<Rigid> pose = Rigid{};
    for (const BagFrame* frame : frames)
      if (const auto above = pose_at(frame->series, time))
        pose = pose ? std::optional(*above * *pose) : std::nullopt;
      else
        pose.reset();
    if (!pose) continue;
    Eigen::VectorXd position = make_position(*pose);
    if (!flange.positions.empty()) unwrap(position, flange.positions.back());
    flange.times.push_back(time);
    flange.positions.push_back(position);
  }
  if (flange.positions.size() < 2)
    throw InputError(
        message("The frame {} of the bag's /tf is told at {} times together with what carries it; "
                "expected it at many: record /tf while the robot moves.",
                in_quotes(child), flange.positions.size()));
  notes.push_back(
      message("The flange is the frame {} that /tf gives in {}.", in_quotes(child), in_quotes(frames.back()->parent)));
  return flange;
}

}  // namespace handsight
