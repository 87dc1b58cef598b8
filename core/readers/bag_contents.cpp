// SPDX-License-Identifier: Apache-2.0
#include "readers/bag_contents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/cdr.h"
#include "readers/ros_bag.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

bool is_type(const BagTopic& topic, const char* name) {
  return topic.type == std::string("sensor_msgs/msg/") + name || topic.type == std::string("sensor_msgs/") + name;
}

/// When a message was made; when it was recorded where it does not say.
double stamp_of(const ros::Header& header, std::int64_t nanoseconds) {
  return header.stamp != 0 ? header.stamp : 1e-9 * static_cast<double>(nanoseconds);
}

/// Readings as they come in, from one topic or several: a sample whenever all joints that the bag has are known.
class JointTaker {
 public:
  explicit JointTaker(const Robot& robot) : robot_(robot) {}

  void see(const ros::JointState& s, double time) {
    bool any = false;
    for (std::size_t i = 0; i < s.names.size() && i < s.position.size(); ++i) {
      const int j = find_joint(robot_, s.names[i]);
      if (j < 0 || !robot_.joints[static_cast<std::size_t>(j)].moves() ||
          robot_.joints[static_cast<std::size_t>(j)].is_mimic() || !std::isfinite(s.position[i])) {
        ++unknown_[s.names[i]];
        continue;
      }
      values_[j].push_back({time, s.position[i]});
      any = true;
    }
    if (any) times_.push_back(time);
  }

  /// Every joint at every time at which any was told: the last that was told of it by then.
  JointSeries series() {
    JointSeries out;
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
    double begin = -1e300;
    for (auto& [joint, told] : values_) {
      std::stable_sort(told.begin(), told.end(), [](const Told& a, const Told& b) { return a.time < b.time; });
      out.names.push_back(robot_.joints[static_cast<std::size_t>(joint)].name);
      begin = std::max(begin, told.front().time);
    }
    std::vector<std::size_t> at(values_.size(), 0);
    for (const double time : times_) {
      if (time < begin) continue;
      Eigen::VectorXd q(static_cast<Eigen::Index>(values_.size()));
      Eigen::Index row = 0;
      for (const auto& [joint, told] : values_) {
        std::size_t& place = at[static_cast<std::size_t>(row)];
        while (place + 1 < told.size() && told[place + 1].time <= time) ++place;
        q[row++] = told[place].value;
      }
      out.times.push_back(time);
      out.positions.push_back(std::move(q));
    }
    return out;
  }

  std::size_t unknown() const { return unknown_.size(); }

 private:
  struct Told {
    double time, value;
  };
  const Robot& robot_;
  std::map<int, std::vector<Told>> values_;
  std::vector<double> times_;
  std::map<std::string, int> unknown_;
};

void take_transforms(const std::vector<ros::Transform>& all, std::int64_t nanoseconds, BagContents& bag) {
  for (const ros::Transform& t : all) {
    BagFrame& frame = bag.frames[t.child];
    if (frame.series.poses.empty()) frame.parent = t.header.frame;
    if (frame.parent != t.header.frame) continue;
    const double time = stamp_of(t.header, nanoseconds);
    if (!frame.series.times.empty() && time <= frame.series.times.back()) continue;  // said again
    frame.series.times.push_back(time);
    frame.series.poses.push_back(t.parent_from_child);
  }
}

/// Grey or colour as PNM (netpbm): bytes as they are, 16 bit with the high byte first.
std::string pnm_of(const ros::Image& image, const std::string& what) {
  const std::string& e = image.encoding;
  const bool is_16 = e == "mono16" || e == "16UC1";
  const std::size_t channels = e == "mono8" || e == "8UC1" || is_16        ? 1
                               : e == "rgb8" || e == "bgr8" || e == "8UC3" ? 3
                               : e == "rgba8" || e == "bgra8"              ? 4
                                                                           : 0;
  if (channels == 0)
    throw InputError(
        fmt::format("{}: images of the encoding {} cannot be read; publish mono8, mono16, rgb8 or bgr8 "
                    "(image_proc makes them of Bayer patterns).",
                    what, in_quotes(e)));
  const std::size_t bytes = is_16 ? 2 : 1;
  if (image.step < image.width * channels * bytes) throw InputError(what + ": its rows are shorter than its width.");
  std::string out =
      fmt::format("P{}\n{} {}\n{}\n", channels == 1 ? 5 : 6, image.width, image.height, is_16 ? 65535 : 255);
  const bool swap_colours = e[0] == 'b' || e == "8UC3";
  for (std::size_t y = 0; y < image.height; ++y) {
    const char* const row = image.data.data() + y * image.step;
    for (std::size_t x = 0; x < image.width; ++x) {
      const char* const px = row + x * channels * bytes;
      if (is_16) {
        out += image.is_bigendian ? px[0] : px[1];
        out += image.is_bigendian ? px[1] : px[0];
      } else if (channels == 1) {
        out += *px;
      } else {
        for (const int c : {0, 1, 2}) out += px[swap_colours ? 2 - c : c];
      }
    }
  }
  return out;
}

std::string ending_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xFF\xD8")) return ".jpg";
  return "";
}

}  // namespace

std::string robot_description_of(const fs::path& bag) {
  std::string text;
  for (const BagTopic& topic : bag_topics(bag))
    if (topic.type == "std_msgs/msg/String" && topic.name.ends_with("robot_description"))
      read_bag(bag, topic.name,
               [&](std::int64_t, std::string_view bytes) { text = ros::read_string(bytes, topic.name); });
  return text;
}

BagContents read_bag_contents(const fs::path& bag, const Robot& robot, const std::function<void()>& at_each) {
  BagContents contents;
  JointTaker joints(robot);
  for (const BagTopic& topic : bag_topics(bag)) {
    const std::string what = fmt::format("{}, topic {}", shown_path(bag.filename()), topic.name);
    const auto each = [&](const auto& take) {
      read_bag(bag, topic.name, [&](std::int64_t time, std::string_view bytes) {
        if (at_each) at_each();
        take(time, bytes);
      });
    };
    if (is_type(topic, "JointState")) {
      each([&](std::int64_t time, std::string_view bytes) {
        const ros::JointState s = ros::read_joint_state(bytes, what);
        joints.see(s, stamp_of(s.header, time));
      });
    } else if (is_type(topic, "CameraInfo")) {
      each([&](std::int64_t, std::string_view bytes) {
        if (!contents.cameras.count(topic.name))
          contents.cameras.emplace(topic.name, camera_from_message(ros::read_camera_info(bytes, what), what));
      });
    } else if (is_type(topic, "Image") || is_type(topic, "CompressedImage")) {
      BagImages& images = contents.images.emplace_back(BagImages{topic.name, is_type(topic, "CompressedImage"), {}});
      each([&](std::int64_t time, std::string_view bytes) {
        images.times.push_back(images.compressed ? stamp_of(ros::read_compressed_image(bytes, what).header, time)
                                                 : stamp_of(ros::read_image(bytes, what).header, time));
      });
    } else if (topic.type == "tf2_msgs/msg/TFMessage" && topic.name.ends_with("/tf")) {
      each([&](std::int64_t time, std::string_view bytes) {
        take_transforms(ros::read_transforms(bytes, what), time, contents);
      });
    } else if (!topic.name.ends_with("robot_description")) {
      contents.notes.push_back(fmt::format("{}: topic {} ({}, {} messages) is left out.", shown_path(bag.filename()),
                                           topic.name, topic.type, topic.messages));
    }
  }
  contents.joints = joints.series();
  if (joints.unknown() > 0)
    contents.notes.push_back(
        fmt::format("{}: {} joints that were published are no moving joints of the robot and are "
                    "left out.",
                    shown_path(bag.filename()), joints.unknown()));
  return contents;
}

std::vector<std::string> write_bag_images(const fs::path& bag, const BagImages& images,
                                          const std::vector<std::size_t>& wanted, const fs::path& folder,
                                          const std::string& side, const std::function<void()>& at_each) {
  std::vector<std::string> names(wanted.size());
  std::map<std::size_t, std::size_t> place_of;
  for (std::size_t i = 0; i < wanted.size(); ++i) place_of[wanted[i]] = i;
  std::size_t number = 0;
  const std::string what = fmt::format("{}, topic {}", shown_path(bag.filename()), images.topic);
  const auto write = [&](std::int64_t, std::string_view bytes) {
    if (at_each) at_each();
    const auto found = place_of.find(number++);
    if (found == place_of.end()) return;
    std::string content, ending;
    if (images.compressed) {
      const ros::CompressedImage image = ros::read_compressed_image(bytes, what);
      ending = ending_of(image.data);
      if (ending.empty())
        throw InputError(fmt::format("{}: compressed images of the format {} cannot be read; expected PNG or JPEG.",
                                     what, in_quotes(image.format)));
      content = std::string(image.data);
    } else {
      const ros::Image image = ros::read_image(bytes, what);
      content = pnm_of(image, what);
      ending = content[1] == '5' ? ".pgm" : ".ppm";
    }
    names[found->second] = fmt::format("{:04}_{}{}", found->second, side, ending);
    replace_file(folder / names[found->second], content);
  };
  try {
    read_bag(bag, images.topic, write);
  } catch (...) {
    std::error_code error;
    for (const std::string& name : names)
      if (!name.empty()) fs::remove(folder / name, error);
    throw;
  }
  return names;
}

}  // namespace handsight
