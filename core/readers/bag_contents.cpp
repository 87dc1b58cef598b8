// SPDX-License-Identifier: Apache-2.0
#include "readers/bag_contents.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "base/text.h"
#include "readers/bag_joints.h"

namespace handsight {
namespace {

/// The topic's messages, and those of them that are damaged.
struct TopicCount {
  std::size_t all = 0, damaged = 0;
  Message first_fault;
};

/// What a bag's messages tell, as they come in.
class ContentsTaker {
 public:
  ContentsTaker(const Bag& bag, const Robot& robot, BagContents& contents)
      : bag_(bag), joints_(robot), contents_(contents) {}

  /// Is something read from it?
  static bool wants(const BagTopic& t) {
    if (t.encoding != "cdr" && t.encoding != "ros1") return false;
    static const char* const types[] = {"sensor_msgs/JointState",
                                        "sensor_msgs/CameraInfo",
                                        "sensor_msgs/Image",
                                        "sensor_msgs/CompressedImage",
                                        "geometry_msgs/PoseStamped",
                                        "geometry_msgs/TransformStamped",
                                        "geometry_msgs/PoseWithCovarianceStamped"};
    if (PosesTaker::wants(t) || std::find(std::begin(types), std::end(types), t.type) != std::end(types)) return true;
    return (t.type == "tf2_msgs/TFMessage" || t.type == "tf/tfMessage") &&
           (t.name.ends_with("tf") || t.name.ends_with("tf_static"));
  }

  void take(const BagTopic& topic, std::int64_t nanoseconds, std::string_view bytes) {
    TopicCount& count = counts_[topic.name];
    const std::string what = message("{}, topic {}", bag_.name, topic.name);
    try {
      take_message(topic, {bytes, topic.encoding == "ros1", what}, nanoseconds, count.all);
    } catch (const InputError& error) {
      if (count.damaged++ == 0) count.first_fault = error.sentence();
    }
    ++count.all;
  }

  void finish() {
    for (const auto& [topic, count] : counts_) {
      if (count.damaged == 0) continue;
      if (count.damaged == count.all) throw InputError(count.first_fault);
      contents_.notes.push_back(message("{}, topic {}: {} of {} messages are damaged and are left out.", bag_.name,
                                        topic, count.damaged, count.all));
    }
    contents_.joints = joints_.series();
    for (auto& [topic, images] : images_) contents_.images.push_back(in_order(std::move(images)));
    poses_.finish(bag_.name, contents_.frames, contents_.ambiguous, contents_.notes);
    for (auto& [child, frame] : contents_.frames) put_in_order(frame.series);
    if (joints_.unknown() > 0)
      contents_.notes.push_back(
          message("{}: {} joints that were published are no moving joints of the robot and are "
                  "left out.",
                  bag_.name, joints_.unknown()));
  }

 private:
  void take_message(const BagTopic& topic, const ros::Message& message, std::int64_t nanoseconds, std::size_t place) {
    const std::string kind = topic.type.substr(topic.type.find('/') + 1);
    if (kind == "JointState") {
      const ros::JointState s = ros::read_joint_state(message);
      joints_.see(s, ros::time_of(s.header, nanoseconds));
    } else if (kind == "CameraInfo") {
      if (!contents_.cameras.contains(topic.name))
        contents_.cameras.emplace(topic.name, camera_from_message(ros::read_camera_info(message), message.what));
    } else if (kind == "Image") {
      take_image(topic.name, ros::time_of(ros::read_image(message).header, nanoseconds), place);
    } else if (kind == "CompressedImage") {
      take_image(topic.name, ros::time_of(ros::read_compressed_image(message).header, nanoseconds), place);
    } else if (PosesTaker::wants(topic)) {
      poses_.take(topic, message, nanoseconds);
    } else if (kind == "PoseStamped" || kind == "PoseWithCovarianceStamped") {
      take_frame(topic.name, ros::read_pose(message), nanoseconds);
    } else if (kind == "TransformStamped") {
      const ros::Transform t = ros::read_transform(message);
      take_frame(t.child.empty() ? topic.name : t.child, t, nanoseconds);
    } else {
      for (const ros::Transform& t : ros::read_transforms(message)) take_frame(t.child, t, nanoseconds);
    }
  }

  void take_image(const std::string& topic, double time, std::size_t place) {
    BagImages& images = images_[topic];
    images.topic = topic;
    images.times.push_back(time);
    images.places.push_back(place);
  }

  void take_frame(const std::string& child, const ros::Transform& t, std::int64_t nanoseconds) {
    BagFrame& frame = contents_.frames[child];
    if (frame.series.poses.empty()) frame.parent = t.header.frame;
    if (frame.parent != t.header.frame) return;
    frame.series.times.push_back(ros::time_of(t.header, nanoseconds));
    frame.series.poses.push_back(t.parent_from_child);
  }

  static std::vector<std::size_t> order_of(const std::vector<double>& times) {
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    return order;
  }

  static BagImages in_order(BagImages images) {
    BagImages sorted{images.topic, {}, {}};
    for (const std::size_t i : order_of(images.times)) {
      sorted.times.push_back(images.times[i]);
      sorted.places.push_back(images.places[i]);
    }
    return sorted;
  }

  /// What is said again is left out.
  static void put_in_order(PoseSeries& series) {
    PoseSeries sorted;
    for (const std::size_t i : order_of(series.times)) {
      if (!sorted.times.empty() && series.times[i] <= sorted.times.back()) continue;
      sorted.times.push_back(series.times[i]);
      sorted.poses.push_back(series.poses[i]);
    }
    series = std::move(sorted);
  }

  const Bag& bag_;
  JointTaker joints_;
  PosesTaker poses_;
  BagContents& contents_;
  std::map<std::string, BagImages> images_;
  std::map<std::string, TopicCount> counts_;
};

bool is_description(const BagTopic& topic) {
  return topic.type == "std_msgs/String" && topic.name.ends_with("robot_description");
}

void note_left_out(const Bag& bag, std::vector<Message>& notes) {
  for (const BagTopic& t : bag.topics)
    if (!ContentsTaker::wants(t) && !is_description(t))
      notes.push_back(message("{}: topic {} ({}{}, {} messages) is left out.", bag.name, t.name,
                              t.type.empty() ? "of a type that is not told" : t.type,
                              t.encoding == "cdr" || t.encoding == "ros1" ? "" : " as " + t.encoding, t.messages));
}

}  // namespace

std::string find_robot_description(const Bag& bag) {
  std::string text;
  if (std::none_of(bag.topics.begin(), bag.topics.end(), is_description)) return text;
  read_bag(bag, is_description, [&](const BagTopic& topic, std::int64_t, std::string_view bytes) {
    text = ros::read_string({bytes, topic.encoding == "ros1", topic.name});
  });
  return text;
}

BagContents read_bag_contents(const Bag& bag, const Robot& robot, const std::function<void()>& at_each) {
  BagContents contents;
  note_left_out(bag, contents.notes);
  ContentsTaker taker(bag, robot, contents);
  const auto lost =
      read_bag(bag, ContentsTaker::wants, [&](const BagTopic& topic, std::int64_t time, std::string_view bytes) {
        if (at_each) at_each();
        taker.take(topic, time, bytes);
      });
  contents.notes.insert(contents.notes.end(), lost.begin(), lost.end());
  taker.finish();
  return contents;
}

}  // namespace handsight
