// SPDX-License-Identifier: Apache-2.0
#include "ways/convert.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "estimation/session_doubts.h"
#include "session/new_session.h"
#include "session/session_xml.h"
#include "vision/image_header.h"
#include "ways/field_urdf.h"
#include "ways/flange_robot.h"
#include "ways/ros_bag.h"
#include "ways/session_parts.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool says(const std::string& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* w) { return lower(name).find(w) != std::string::npos; });
}

bool is_urdf(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string::npos && text[begin] == '<' && text.find("<robot") != std::string::npos;
}

/// The robot of --robot, among the files, or in the bag; takes it out of the files.
std::optional<FieldUrdf> find_robot(std::vector<fs::path>& files, const ConvertOptions& o, Conversion& c) {
  if (!o.robot.empty()) return field_urdf(read_file(o.robot), o.robot.filename().string());
  for (auto f = files.begin(); f != files.end(); ++f)
    if (fs::is_regular_file(*f) && !is_bag(*f) && is_urdf(read_file(*f))) {
      const std::string name = f->filename().string();
      FieldUrdf robot = field_urdf(read_file(*f), name);
      c.took.push_back(name + ": " + kind_text(FileKind::robot));
      files.erase(f);
      return robot;
    }
  for (const fs::path& f : files)
    if (is_bag(f))
      if (const std::string text = robot_description_of(f); !text.empty()) {
        c.notes.push_back("The robot is the one that the bag publishes as robot_description.");
        return field_urdf(text, "robot_description");
      }
  return std::nullopt;
}

/// Is the file likely of the robot's flange, by its name?
bool is_of_flange(const std::string& file) {
  return says(file, {"flange", "robot", "ee", "tool", "hand", "gripper", "arm"});
}
bool is_of_target(const std::string& file) {
  return says(file, {"target", "marker", "tag", "board", "cam", "track", "mocap", "object"});
}

/// Which of two series is the flange's: by their names.
std::pair<PoseSeries, PoseSeries> flange_and_target(const std::vector<NamedPoses>& poses) {
  const bool first = is_of_flange(poses[0].file) && !is_of_flange(poses[1].file),
             second = is_of_flange(poses[1].file) && !is_of_flange(poses[0].file);
  if (first || (is_of_target(poses[1].file) && !is_of_target(poses[0].file))) return {poses[0].series, poses[1].series};
  if (second || (is_of_target(poses[0].file) && !is_of_target(poses[1].file)))
    return {poses[1].series, poses[0].series};
  throw InputError(
      fmt::format("{} and {} are both tables of poses: which is the robot's flange, which the target that "
                  "the sensor sees? Name the files so: flange.csv and target.csv.",
                  poses[0].file, poses[1].file));
}

/// The way of a flange alone: no robot is known, its pose is.
Conversion from_flange(const PoseSeries& flange, const PoseSeries& target, bool eye_in_hand, const ConvertOptions& o,
                       Conversion c) {
  if (flange.poses.size() != target.poses.size())
    throw InputError(
        fmt::format("There are {} poses of the flange and {} of the target; expected one of each an instant, "
                    "in the same order.",
                    flange.poses.size(), target.poses.size()));
  SessionParts parts;
  parts.urdf_text = flange_robot_urdf();
  parts.joints = flange_joints(flange);
  parts.tcp = eye_in_hand ? "base" : "flange";
  parts.mount = eye_in_hand ? "flange" : "base";
  parts.times = target.times;
  parts.points = points_of_poses(target);
  c.notes.push_back(
      "No robot is known, only where its flange is: a made-up robot of three slides and three turns stands for it. "
      "What "
      "is said of its joints means nothing for the real one's.");
  c.notes.push_back(poses_note);
  c.session = write_tracker_session(parts, o);
  return c;
}

/// Joints for these events: row by row, or paired by time.
struct Paired {
  std::vector<std::size_t> events;
  std::vector<Eigen::VectorXd> positions;
};

Paired pair_events(const JointSeries& joints, const std::vector<double>& times, std::size_t count,
                   const std::vector<double>& speeds, const ConvertOptions& o, std::vector<std::string>& notes) {
  Paired p;
  constexpr double same = 0.1;  // s: rows of two tables that were written together
  bool row_by_row = joints.positions.size() == count;
  for (std::size_t i = 0; row_by_row && i < count && !times.empty() && !joints.times.empty(); ++i)
    row_by_row = std::abs(times[i] - joints.times[i]) <= same;
  if (row_by_row) {
    p.events.resize(count);
    std::iota(p.events.begin(), p.events.end(), std::size_t{0});
    p.positions = joints.positions;
    return p;
  }
  if (times.empty() || joints.times.empty())
    throw InputError(
        fmt::format("There are {} lines of joint readings and {} measurements, and {} no times to pair them "
                    "by; expected one line for each, or a column `time` in both.",
                    joints.positions.size(), count, times.empty() ? "the measurements have" : "the joints have"));
  PairingOptions options = o.pairing;
  if (o.estimate_lag) {
    const auto lag = estimated_lag(joints, times, speeds);
    if (lag) options.lag = *lag;
    notes.push_back(
        lag ? fmt::format("The measurements come {:.3f} s after the joint readings; that was taken out.", *lag)
            : "The lag between measurements and joint readings cannot be told: both must show the same "
              "movements. It is taken as " +
                  fmt::format("{:g} s.", options.lag));
  }
  const double median_step =
      (joints.times.back() - joints.times.front()) / std::max<std::size_t>(1, joints.times.size() - 1);
  if (median_step > options.still_for) options.still_for = 0;  // nobody could say whether it stood
  options.widest_gap = std::max(options.widest_gap, 2.5 * median_step);
  const Pairing pairing = paired(joints, times, options);
  const auto told = [&](std::size_t n, const char* why) {
    if (n > 0) notes.push_back(fmt::format("{} of {} measurements are left out: {}.", n, count, why));
  };
  told(pairing.outside, "there are no joint readings at their times");
  told(pairing.gaps, "the joint readings have a gap there");
  told(pairing.moving, "the robot was moving");
  told(pairing.repeated, "they show a standstill that another one shows");
  if (pairing.events.empty())
    throw InputError(fmt::format(
        "None of the {} measurements has joint readings to it: they are from {:.3f} to {:.3f} s, the joints from "
        "{:.3f} to "
        "{:.3f} s, and {} were left out because the robot moved. Do the clocks agree (--lag)? Did the robot stand "
        "(--still 0 allows moving)?",
        count, times.front(), times.back(), joints.times.front(), joints.times.back(), pairing.moving));
  p.events = pairing.events;
  p.positions = pairing.positions;
  return p;
}

template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& places) {
  std::vector<T> some;
  for (const std::size_t i : places)
    if (i < all.size()) some.push_back(all[i]);
  return some;
}

void require_links(const FieldUrdf& robot, const ConvertOptions& o, SessionParts& parts,
                   std::vector<std::string>& notes) {
  if (o.tcp.empty())
    throw InputError(fmt::format("--tcp is missing: the link that is the hand. At the ends of this robot are: {}.",
                                 shortened(fmt::format("{}", fmt::join(end_links(robot.robot), " ")), 300)));
  parts.urdf_text = robot.text;
  parts.tcp = o.tcp;
  parts.mount = o.mount.empty() ? robot.robot.links.front().name : o.mount;
  if (o.mount.empty())
    notes.push_back(fmt::format("--mount is not given: the sensor is taken to stand beside the robot (link {}).",
                                in_quotes(parts.mount)));
}

Conversion from_points(const FieldUrdf& robot, const JointSeries& joints, const PointSeries& points,
                       const std::vector<double>& speeds, const ConvertOptions& o, Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const Paired p = pair_events(joints, points.times, points.points.size(), speeds, o, c.notes);
  parts.joints = {joints.names, {}, p.positions};
  parts.times = chosen(points.times, p.events);
  parts.points = chosen(points.points, p.events);
  std::size_t unseen = 0;
  for (const auto& row : parts.points)
    for (const auto& point : row) unseen += !point.has_value();
  if (unseen > 0) c.notes.push_back(fmt::format("{} points were not seen by the device; they are left out.", unseen));
  c.session = write_tracker_session(parts, o);
  return c;
}

/// The size of the first image of a folder.
std::optional<ImageSize> size_of_images(const std::vector<ImageFiles>& pairs) {
  for (const ImageFiles& pair : pairs)
    if (!pair.left.empty()) return image_size(read_file(pair.left));
  return std::nullopt;
}

/// Pairs and joint lines, by count or by the images' numbers.
void match_images(std::vector<ImageFiles>& pairs, const JointSeries& joints) {
  if (pairs.size() == joints.positions.size()) return;
  throw InputError(
      fmt::format("There are {} pairs of images and {} lines of joint readings; expected one line for each "
                  "pair, in the order of the images' numbers. The first pair has the number {}, the last {}.",
                  pairs.size(), joints.positions.size(), pairs.front().number, pairs.back().number));
}

StereoRig rig_of_brought(const Brought& b) {
  if (b.rig) return *b.rig;
  if (b.cameras.size() == 2) {
    const bool swapped = says(b.cameras[0].name + b.cameras[0].file, {"right"});
    return rig_of(b.cameras[swapped ? 1 : 0], b.cameras[swapped ? 0 : 1]);
  }
  throw InputError(
      b.cameras.empty()
          ? "There are images, and no calibration of the two cameras; name OpenCV's, Kalibr's or two of ROS."
          : "There is a calibration of one camera alone; a session with images needs two cameras and the way "
            "from one to the other.");
}

Conversion from_images(const FieldUrdf& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (b.image_folders.size() > 2)
    throw InputError("There are more than two folders of images; name the left one and the right one.");
  if (!b.joints)
    throw InputError("There are images, and no table of joint readings; name a CSV with a line for each pair.");
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const bool swapped = b.image_folders.size() == 2 && says(b.image_folders[0].filename().string(), {"right"});
  std::vector<ImageFiles> pairs =
      find_image_pairs(b.image_folders[swapped ? 1 : 0],
                       b.image_folders.size() == 2 ? b.image_folders[swapped ? 0 : 1] : b.image_folders[0]);
  match_images(pairs, *b.joints);
  StereoRig rig = rig_of_brought(b);
  if (const auto size = size_of_images(pairs))
    fit_to_images(rig, static_cast<int>(size->width), static_cast<int>(size->height), c.notes);
  parts.joints = *b.joints;
  parts.times = b.joints->times;
  c.session = write_stereo_session(parts, rig, pairs, o, c.notes);
  return c;
}

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

Conversion from_bag_images(const FieldUrdf& robot, const BagContents& bag, const BagRig& rig, const fs::path& file,
                           const ConvertOptions& o, Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const Together pairs = taken_together(*rig.left, *rig.right);
  if (pairs.times.size() < rig.left->times.size())
    c.notes.push_back(fmt::format("{} of {} left images have no right image within 10 ms and are left out.",
                                  rig.left->times.size() - pairs.times.size(), rig.left->times.size()));
  const Paired p = pair_events(bag.joints, pairs.times, pairs.times.size(), {}, o, c.notes);
  fs::create_directories(o.out / "images");
  const auto left = write_bag_images(file, *rig.left, chosen(pairs.left, p.events), o.out / "images", "left"),
             right = write_bag_images(file, *rig.right, chosen(pairs.right, p.events), o.out / "images", "right");
  std::vector<ImageFiles> images;
  for (std::size_t i = 0; i < left.size(); ++i)
    images.push_back({static_cast<std::int64_t>(i), o.out / "images" / left[i], o.out / "images" / right[i]});
  parts.joints = {bag.joints.names, {}, p.positions};
  parts.times = chosen(pairs.times, p.events);
  StereoRig cameras = rig.rig;
  if (const auto size = size_of_images(images))
    fit_to_images(cameras, static_cast<int>(size->width), static_cast<int>(size->height), c.notes);
  c.session = write_stereo_session(parts, cameras, images, o, c.notes);
  return c;
}

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

Conversion assemble(const std::optional<FieldUrdf>& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (!b.bag.empty()) return from_bag(robot, b, o, std::move(c));
  if (b.samples) {
    const bool in_hand = b.samples->kind_is_known ? b.samples->eye_in_hand : !o.eye_on_base;
    PoseSeries flange{{}, b.samples->base_from_effector};
    if (!b.samples->kind_is_known && o.eye_on_base)
      for (Rigid& pose : flange.poses) pose = inverse(pose);
    return from_flange(flange, {{}, b.samples->camera_from_target}, in_hand, o, std::move(c));
  }
  if (!b.joints && b.poses.size() == 2) {
    const auto [flange, target] = flange_and_target(b.poses);
    return from_flange(flange, target, !o.eye_on_base, o, std::move(c));
  }
  if (!robot) throw InputError("There is no robot; name its URDF with --robot.");
  if (!b.image_folders.empty()) return from_images(*robot, b, o, std::move(c));
  if (!b.joints) throw InputError("There are no joint readings; name a table (CSV) of them, a column a joint.");
  if (b.points) return from_points(*robot, *b.joints, *b.points, {}, o, std::move(c));
  if (b.poses.size() == 1) {
    c.notes.push_back(poses_note);
    const PoseSeries& target = b.poses[0].series;
    return from_points(*robot, *b.joints, {target.times, points_of_poses(target)},
                       target.times.empty() ? std::vector<double>() : speeds_of(target), o, std::move(c));
  }
  throw InputError(
      "There is nothing that a sensor measured: no images, no points, no poses of a target. Name their folder "
      "or file too.");
}

}  // namespace

Conversion convert(const std::vector<fs::path>& given, const ConvertOptions& o) {
  if (fs::exists(o.out / "session.xml"))
    throw InputError(fmt::format("{}: there is a session already; take another folder.", shown_path(o.out)));
  Conversion c;
  std::vector<fs::path> files = given;
  const std::optional<FieldUrdf> robot = find_robot(files, o, c);
  if (robot) c.notes.insert(c.notes.end(), robot->notes.begin(), robot->notes.end());
  const Brought b = bring(files, robot ? &robot->robot : nullptr, o.degrees);
  c.took.insert(c.took.end(), b.took.begin(), b.took.end());
  c.notes.insert(c.notes.end(), b.notes.begin(), b.notes.end());
  c = assemble(robot, b, o, std::move(c));
  for (const std::string& doubt : session_doubts(c.session)) c.notes.push_back(doubt);
  return c;
}

std::vector<Vector3> virtual_points() {
  return {Vector3::Zero(), 0.1 * Vector3::UnitX(), 0.1 * Vector3::UnitY(), 0.1 * Vector3::UnitZ()};
}

}  // namespace handsight
