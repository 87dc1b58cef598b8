// SPDX-License-Identifier: Apache-2.0
#include "convert/bags/bag_sessions.h"

#include <algorithm>

#include "base/text.h"
#include "convert/bags/bag_rigs.h"
#include "convert/convert_inputs.h"
#include "convert/frames_by_motion.h"
#include "convert/opened_folders.h"
#include "readers/bags/bag.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// What the names of its topics tell, none of its messages read.
BagContents topics_alone(const Bag& bag) {
  BagContents contents;
  for (const BagTopic& t : bag.topics) {
    if (t.type == "sensor_msgs/Image" || t.type == "sensor_msgs/CompressedImage")
      contents.images.push_back({t.name, {}, {}});
    if (t.type == "sensor_msgs/CameraInfo") contents.cameras[t.name].name = t.name;
  }
  std::sort(contents.images.begin(), contents.images.end(),
            [](const BagImages& a, const BagImages& b) { return a.topic < b.topic; });
  return contents;
}

/// Topics that are one sensor, and what --camera may call them, the shortest first.
struct ImageSensor {
  std::vector<std::string> topics, names;
};

std::vector<ImageSensor> list_sensors(const BagContents& bag, bool has_target) {
  std::vector<ImageSensor> sensors;
  std::vector<std::string> in_pairs;
  for (const auto& [before, pair] : topic_pairs(bag)) {
    if (before.empty() || !camera_beside(bag, pair.left->topic) || !camera_beside(bag, pair.right->topic)) return {};
    const std::string &left = pair.left->topic, &right = pair.right->topic;
    const auto apart = std::mismatch(left.begin(), left.end(), right.begin(), right.end()).first;
    sensors.push_back({{left, right}, {before, std::string(left.begin(), apart)}});  // "/camera/", "/camera/infra"
    in_pairs.push_back(before);
  }
  if (!has_target) return sensors;
  for (const BagImages* images : calibrated_topics(bag)) {
    const std::string& topic = images->topic;
    const bool is_of_pair = std::any_of(in_pairs.begin(), in_pairs.end(), [&](const std::string& before) {
      return topic.starts_with(before) && says(topic.substr(before.size()), {"left", "right", "infra1", "infra2"});
    });
    if (!is_of_pair) sensors.push_back({{topic}, {topic.substr(0, topic.rfind('/') + 1), topic}});
  }
  return sensors;
}

/// What no other sensor's topic has in its name; empty: there is no such word.
std::string telling_name(const ImageSensor& sensor, const std::vector<ImageSensor>& all) {
  for (const std::string& name : sensor.names) {
    const bool is_telling = name.size() > 1 && std::all_of(all.begin(), all.end(), [&](const ImageSensor& other) {
                              return &other == &sensor || std::all_of(other.topics.begin(), other.topics.end(),
                                                                      [&](const std::string& topic) {
                                                                        return topic.find(name) == std::string::npos;
                                                                      });
                            });
    if (is_telling) return name;
  }
  return "";
}

std::vector<std::string> camera_names(const BagContents& bag, bool has_target) {
  const std::vector<ImageSensor> sensors = list_sensors(bag, has_target);
  std::vector<std::string> names;
  for (const ImageSensor& sensor : sensors) names.push_back(telling_name(sensor, sensors));
  const bool are_telling = std::none_of(names.begin(), names.end(), [](const std::string& n) { return n.empty(); });
  return names.size() > 1 && are_telling ? names : std::vector<std::string>();
}

bool is_open_choice(const ConvertOptions& o) { return o.camera.empty() && o.target_frame.empty(); }

/// One for each of these values in place of `session`.
void part_by(const ConvertOptions& session, const std::vector<std::string>& values, std::string ConvertOptions::*which,
             std::vector<ConvertOptions>& parted) {
  for (const std::string& value : values) {
    parted.push_back(session);
    parted.back().*which = value;
    parted.back().title.clear();
  }
}

/// The side that a name says, 'l' or 'r'; 0: none.
char side_of(const std::string& name) {
  const bool left = says(name, {"left"}), right = says(name, {"right"});
  if (left != right) return left ? 'l' : 'r';
  for (const char side : {'l', 'r'})
    if (name.starts_with(std::string{side, '_'}) || name.ends_with(std::string{'_', side})) return side;
  return 0;
}

/// Of the hand's own side; all where the robot has no other hand; none where nothing tells.
std::vector<std::string> frames_of_hand(const ConvertOptions& o, const std::vector<std::string>& frames,
                                        bool has_one_hand) {
  std::vector<std::string> own;
  const char side = side_of(o.tcp);
  for (const std::string& frame : frames)
    if (side != 0 && side_of(frame) == side) own.push_back(frame);
  return own.empty() && has_one_hand ? frames : own;
}

std::vector<ConvertOptions> parted_by_frames(const Bag& bag, const std::vector<ConvertOptions>& sessions,
                                             std::vector<Message>& notes) {
  const BagContents contents = read_bag_contents(bag, Robot{}, [&] { ask_whether_to_go_on(sessions.front()); });
  const std::vector<std::string> frames = target_frames(contents);
  if (frames.size() < 2) return sessions;
  std::vector<ConvertOptions> parted;
  for (const ConvertOptions& o : sessions) {
    const bool has_one_hand = sessions.size() == 1 && side_of(o.tcp) == 0;
    const auto own = is_open_choice(o) ? frames_of_hand(o, frames, has_one_hand) : std::vector<std::string>();
    if (own.size() == 1) {
      parted.push_back(o);
      parted.back().target_frame = own.front();
    } else if (own.empty()) {
      parted.push_back(o);
    } else {
      part_by(o, own, &ConvertOptions::target_frame, parted);
    }
  }
  const bool is_told = std::none_of(parted.begin(), parted.end(), is_open_choice);
  return sessions.size() < 2 || is_told ? parted : frames_by_motion(bag, parted, frames, notes);
}

void note_parted(const std::vector<ConvertOptions>& sessions, std::string ConvertOptions::*which,
                 std::vector<Message>& notes) {
  std::string names;
  for (const ConvertOptions& o : sessions)
    if (const std::string& name = o.*which; !name.empty()) names += (names.empty() ? "" : ", ") + name;
  const std::string all = shortened(names, 200);
  notes.push_back(which == &ConvertOptions::camera
                      ? message("The bag has several cameras ({}); each has a session in the collection. --camera "
                                "chooses one of them.",
                                all)
                      : message("The bag has several targets in /tf ({}); each has a session in the collection. "
                                "--target-frame chooses one of them.",
                                all));
}

}  // namespace

std::vector<ConvertOptions> sessions_of_bag(const std::vector<fs::path>& named, std::vector<ConvertOptions> sessions,
                                            std::vector<Message>& notes) {
  if (std::none_of(sessions.begin(), sessions.end(), is_open_choice)) return sessions;
  const std::vector<fs::path> files = opened_folders(named).files;
  const auto found = std::find_if(files.begin(), files.end(), is_bag);
  if (found == files.end()) return sessions;
  const Bag bag = open_bag(*found);
  const BagContents topics = topics_alone(bag);
  std::vector<ConvertOptions> parted;
  for (const ConvertOptions& o : sessions) {
    const auto names = is_open_choice(o) ? camera_names(topics, o.target.has_value()) : std::vector<std::string>();
    if (names.empty())
      parted.push_back(o);
    else
      part_by(o, names, &ConvertOptions::camera, parted);
  }
  if (parted.size() > sessions.size()) {
    note_parted(parted, &ConvertOptions::camera, notes);
    return parted;
  }
  if (list_sensors(topics, true).empty()) parted = parted_by_frames(bag, sessions, notes);
  if (parted.size() > sessions.size()) note_parted(parted, &ConvertOptions::target_frame, notes);
  return parted;
}

std::vector<std::string> target_frames(const BagContents& bag) {
  std::vector<std::string> frames;
  for (const auto& [child, frame] : bag.frames)
    if (frame.series.poses.size() > 1 && !frame.must_be_named &&
        says(child, {"tag", "marker", "aruco", "target", "board", "charuco"}))
      frames.push_back(child);
  return frames;
}

std::string link_of_frame(const BagContents& bag, const Robot& robot, std::string frame) {
  for (std::size_t steps = 0; !frame.empty() && steps <= bag.frames.size(); ++steps) {
    if (find_link(robot, frame) >= 0) return frame;
    const auto above = bag.frames.find(frame);
    if (above == bag.frames.end()) break;
    frame = above->second.parent;
  }
  return "";
}

}  // namespace handsight
