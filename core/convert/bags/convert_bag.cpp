// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "convert/bags/bag_rigs.h"
#include "convert/bags/bag_sessions.h"
#include "convert/convert_inputs.h"
#include "convert/convert_pairing.h"

namespace handsight {
namespace {

/// The child frame that a detector publishes: the one that is named, or the only one that sounds like one.
std::string target_frame_of(const BagContents& bag, const Bag& file, const ConvertOptions& o) {
  const std::string& wanted = o.target_frame;
  std::string topics;
  for (const BagTopic& t : file.topics) topics += fmt::format("{}{} ({})", topics.empty() ? "" : ", ", t.name, t.type);
  const std::vector<std::string> likely = target_frames(bag);
  std::vector<std::string> all;
  for (const auto& [child, frame] : bag.frames) all.push_back(child);
  if (!wanted.empty() && bag.frames.count(wanted)) return wanted;
  if (!wanted.empty())
    throw InputError(message("--target-frame {}: /tf of the bag has no such child; it has: {}.", in_quotes(wanted),
                             shortened(fmt::format("{}", fmt::join(all, " ")), 300)));
  if (likely.size() == 1) return likely.front();
  if (likely.empty() && !bag.ambiguous.empty()) throw InputError(bag.ambiguous.front());
  if (all.empty())
    throw InputError(
        message("The bag has no pair of camera images with calibration, no frames in /tf and no topic of poses that is "
                "read (PoseStamped, TransformStamped, PoseArray, ArucoMarkers); one camera needs --target, what its "
                "images show. It has: {}.",
                shortened(topics, 300)));
  throw InputError(
      message("The bag has no pair of camera images with calibration, and its /tf {} frames that sound like a "
              "target; name it with "
              "--target-frame{}. /tf has: {}.",
              likely.empty() ? "no" : "several", o.title.empty() ? "" : ", once for each --tcp",
              shortened(fmt::format("{}", fmt::join(all, " ")), 300)));
}

std::string named_topics(const BagRig& rig) {
  std::string names;
  for (const BagImages* images : rig.topics) names += (names.empty() ? "" : ", ") + images->topic;
  return names;
}

/// Cameras that no session is made of are told; depth is no image that is looked at.
void say_other_cameras(const BagContents& bag, const BagRig& rig, std::vector<Message>& notes) {
  std::string others;
  for (const BagImages* images : calibrated_topics(bag)) {
    const RosCamera* camera = camera_beside(bag, images->topic);
    const bool is_taken = std::any_of(rig.topics.begin(), rig.topics.end(), [&](const BagImages* taken) {
      return camera_beside(bag, taken->topic) == camera;
    });
    if (!is_taken) others += (others.empty() ? "" : ", ") + images->topic;
  }
  if (!others.empty())
    notes.push_back(
        message("Images of other cameras are left out: {}. With --target, what the images show, each camera "
                "has a session.",
                shortened(others, 200)));
}

/// Places of images of all topics that were taken together: by topic, one a time.
struct Together {
  std::vector<std::vector<std::size_t>> places;
  std::vector<double> times;
};

std::optional<std::size_t> nearest_within(const std::vector<double>& times, double wanted, double apart) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (std::abs(times[k] - wanted) <= apart &&
        (!best || std::abs(times[k] - wanted) < std::abs(times[*best] - wanted)))
      best = k;
  return best;
}

Together taken_together(const std::vector<const BagImages*>& topics) {
  constexpr double apart = 0.01;  // s
  Together t;
  t.places.resize(topics.size());
  for (const double time : topics.front()->times) {
    std::vector<std::size_t> found;
    for (const BagImages* topic : topics)
      if (const auto place = nearest_within(topic->times, time, apart)) found.push_back(*place);
    if (found.size() < topics.size()) continue;
    for (std::size_t c = 0; c < topics.size(); ++c) t.places[c].push_back(found[c]);
    t.times.push_back(time);
  }
  return t;
}

/// The images of all topics for these events, written into `folder`; none of them stays where that ends in an
/// exception.
std::vector<InstantImages> write_images(const Bag& file, const BagRig& found, const Together& together,
                                        const std::vector<std::size_t>& events, const std::filesystem::path& folder,
                                        const ConvertOptions& o) {
  std::vector<InstantImages> images(events.size());
  try {
    for (std::size_t camera = 0; camera < found.topics.size(); ++camera) {
      const auto written = write_bag_images(file, *found.topics[camera], chosen(together.places[camera], events),
                                            folder, found.rig.cameras[camera].name, [&] { ask_whether_to_go_on(o); });
      for (std::size_t i = 0; i < written.size(); ++i) {
        images[i].number = static_cast<std::int64_t>(i);
        images[i].files.push_back(folder / written[i]);
      }
    }
  } catch (...) {
    std::error_code error;
    for (const InstantImages& instant : images)
      for (const auto& written : instant.files) std::filesystem::remove(written, error);
    std::filesystem::remove(folder, error);  // where nothing else is in it
    std::filesystem::remove(o.out, error);
    throw;
  }
  return images;
}

Conversion from_bag_images(SessionParts parts, const BagContents& bag, const BagRig& found, const Bag& file,
                           const ConvertOptions& o, Conversion c) {
  const Together together = taken_together(found.topics);
  const std::size_t all = found.topics.front()->times.size();
  if (o.camera.empty()) say_other_cameras(bag, found, c.notes);
  if (together.times.size() < all)
    c.notes.push_back(message("{} of {} left images have no right image within 10 ms and are left out.",
                              all - together.times.size(), all));
  const Paired p = pair_events(bag.joints, together.times, together.times.size(), {}, o, c.notes);
  std::filesystem::create_directories(o.out / "images");
  const std::vector<InstantImages> images = write_images(file, found, together, p.events, o.out / "images", o);
  parts.joints = {bag.joints.names, {}, p.positions};
  parts.times = chosen(together.times, p.events);
  Rig rig = found.rig;
  fit_to_first_images(rig, images, c.notes);
  c.sensor = named_topics(found);
  if (o.target) c.target = describe_target(*o.target);
  c.session = write_camera_session(parts, rig, images, o, c.notes);
  return c;
}

}  // namespace

namespace {

/// Where nobody says what carries the cameras, their frame may: a frame of the robot's, or one that /tf hangs from it.
/// A camera on the hand sees what stands beside the robot.
ConvertOptions with_mount_of_frame(const BagContents& bag, const Robot& robot, const BagRig& rig, ConvertOptions o,
                                   std::vector<Message>& notes) {
  if (!o.mount.empty() || o.tcp.empty()) return o;
  const std::string link = link_of_frame(bag, robot, rig.frame);
  if (link.empty() || link == robot.links.front().name) return o;
  o.mount = link;
  notes.push_back(
      message("The cameras' frame {} is on the link {}, which is taken for what carries them (--mount says "
              "otherwise).",
              in_quotes(rig.frame), in_quotes(link)));
  const std::vector<int> above = joints_to(robot, find_link(robot, link));
  const int hand = find_link(robot, o.tcp);
  const bool is_on_hand = link == o.tcp || std::any_of(above.begin(), above.end(), [&](int joint) {
                            return robot.joints[static_cast<std::size_t>(joint)].child_link == hand;
                          });
  if (!is_on_hand) return o;
  notes.push_back(message("That is on the hand {}: the target is taken to stand beside the robot (link {}).",
                          in_quotes(o.tcp), in_quotes(robot.links.front().name)));
  o.tcp = robot.links.front().name;
  return o;
}

Rigid find_instant_pose(const Eigen::VectorXd& position) {
  return {rotation_from_rpy({position[5], position[4], position[3]}), position.head<3>()};
}

/// No robot is known: /tf says where its flange is, the images or /tf where the target is.
Conversion from_bag_of_poses(const Bag& file, const Brought& b, const ConvertOptions& o, Conversion c) {
  BagContents bag = read_bag_contents(file, Robot{}, [&] { ask_whether_to_go_on(o); });
  for (const Message& note : bag.notes)
    if (note.form().find("moving joints of the robot") == std::string::npos) c.notes.push_back(note);
  keep_camera(bag, o.camera);
  bag.joints = flange_of_bag(bag, o, c.notes);
  if (const auto rig = o.target_frame.empty() ? find_bag_rig(bag, b, o) : std::nullopt) {
    require_target(rig->rig, o);
    SessionParts parts;
    set_flange(parts, {}, !o.eye_on_base, c.notes);
    c.notes.emplace_back(o.eye_on_base ? "The camera is taken to be on a stand and the target on the flange."
                                       : "The camera is taken to be on the flange and the target beside the robot "
                                         "(--eye-on-base: the camera stands, the flange carries the target).");
    return from_bag_images(std::move(parts), bag, *rig, file, o, std::move(c));
  }
  const std::string child = target_frame_of(bag, file, o);
  const BagFrame& frame = bag.frames.at(child);
  const Paired p = pair_events(bag.joints, frame.series.times, frame.series.poses.size(), {}, o, c.notes);
  NamedPoses flange{"the flange", "", {}}, target{child, "", {}};
  for (const Eigen::VectorXd& position : p.positions) flange.series.poses.push_back(find_instant_pose(position));
  target.series.poses = chosen(frame.series.poses, p.events);
  c.notes.push_back(
      message("The target is the frame {} that /tf gives in {}.", in_quotes(child), in_quotes(frame.parent)));
  c.sensor = frame.parent, c.target = child;
  return from_flange(std::move(flange), std::move(target), !o.eye_on_base, o, std::move(c));
}

}  // namespace

Conversion from_bag(const std::optional<FieldUrdf>& robot, const Bag& file, const Brought& b, const ConvertOptions& o,
                    Conversion c) {
  if (!o.camera.empty() && !o.target_frame.empty())
    throw InputError(message("--camera {} and --target-frame {} are two sensors; name one of them for a session.",
                             in_quotes(o.camera), in_quotes(o.target_frame)));
  if (!robot) return from_bag_of_poses(file, b, o, std::move(c));
  BagContents bag = read_bag_contents(file, robot->robot, [&] { ask_whether_to_go_on(o); });
  c.notes.insert(c.notes.end(), bag.notes.begin(), bag.notes.end());
  keep_camera(bag, o.camera);
  if (b.joints) bag.joints = *b.joints;
  if (bag.joints.positions.empty())
    throw InputError(
        "The bag has no sensor_msgs/JointState with joints of this robot; record /joint_states too, or name "
        "the robot that it was recorded with.");
  if (const auto rig = o.target_frame.empty() ? find_bag_rig(bag, b, o) : std::nullopt) {
    SessionParts parts;
    require_links(*robot, with_mount_of_frame(bag, robot->robot, *rig, o, c.notes), parts, c.notes);
    return from_bag_images(std::move(parts), bag, *rig, file, o, std::move(c));
  }
  const std::string child = target_frame_of(bag, file, o);
  const BagFrame& frame = bag.frames.at(child);
  c.notes.push_back(
      message("The target is the frame {} that /tf gives in {}.", in_quotes(child), in_quotes(frame.parent)));
  c.sensor = frame.parent, c.target = child;
  return from_poses(*robot, bag.joints, {child, "", frame.series}, o, std::move(c));
}

}  // namespace handsight
