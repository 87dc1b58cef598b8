// SPDX-License-Identifier: Apache-2.0
#include "readers/bags/messages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/text.h"

namespace handsight::ros {
namespace {

class Reader {
 public:
  explicit Reader(const Message& message) : bytes_(message.bytes), what_(message.what), is_ros1_(message.is_ros1) {
    if (is_ros1_) return;
    if (bytes_.size() < 4 || bytes_[0] != 0 || (bytes_[1] != 0 && bytes_[1] != 1)) fail("it is not plain CDR");
    swap_ = (bytes_[1] == 1) != (std::endian::native == std::endian::little);
    bytes_.remove_prefix(4);
  }

  /// In CDR numbers stand at multiples of their size, counted from behind the encapsulation.
  template <class T>
  T number() {
    if (!is_ros1_) at_ = (at_ + sizeof(T) - 1) / sizeof(T) * sizeof(T);
    need(sizeof(T));
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

  std::string_view bytes(std::size_t count) {
    need(count);
    const std::string_view view = bytes_.substr(at_, count);
    at_ += count;
    return view;
  }

  /// In CDR its length counts the zero at its end.
  std::string text() {
    const auto length = number<std::uint32_t>();
    std::string text(bytes(length));
    if (!text.empty() && text.back() == '\0') text.pop_back();
    return text;
  }

  std::uint32_t count(std::size_t least_size) {
    const auto n = number<std::uint32_t>();
    if (n > (bytes_.size() - std::min(at_, bytes_.size())) / least_size) fail("a list is longer than the message");
    return n;
  }

  std::vector<double> numbers() {
    std::vector<double> all(count(sizeof(double)));
    for (double& x : all) x = number<double>();
    return all;
  }

  void numbers(double* into, std::size_t how_many) {
    for (std::size_t i = 0; i < how_many; ++i) into[i] = number<double>();
  }

  Header header() {
    Header h;
    if (is_ros1_) number<std::uint32_t>();  // seq
    const auto seconds = number<std::int32_t>();
    h.stamp = seconds + 1e-9 * number<std::uint32_t>();
    h.frame = text();
    return h;
  }

  [[noreturn]] void fail(const handsight::Message& why) const {
    throw InputError(
        message("{}: {}; the bag is damaged, or the message is of another type than it says.", what_, why));
  }

 private:
  void need(std::size_t count) const {
    if (at_ > bytes_.size() || bytes_.size() - at_ < count) fail("the message ends too early");
  }

  std::string_view bytes_;
  const std::string& what_;
  std::size_t at_ = 0;
  bool is_ros1_ = false, swap_ = false;
};

Rigid make_motion(Reader& in, const std::string& of_what) {
  double n[7];
  in.numbers(n, 7);
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  if (!(std::abs(q.norm() - 1) < 1e-2) || !std::isfinite(n[0] + n[1] + n[2]))
    in.fail(message("the {} holds no unit quaternion", of_what));
  return {q.normalized().toRotationMatrix(), Vector3(n[0], n[1], n[2])};
}

Transform transform_of(Reader& in) {
  Transform t;
  t.header = in.header();
  t.child = in.text();
  t.parent_from_child = make_motion(in, "transform of " + in_quotes(t.child));
  return t;
}

}  // namespace

double time_of(const Header& header, std::int64_t recorded_nanoseconds) {
  return header.stamp != 0 ? header.stamp : 1e-9 * static_cast<double>(recorded_nanoseconds);
}

JointState read_joint_state(const Message& message) {
  Reader in(message);
  JointState s;
  s.header = in.header();
  s.names.resize(in.count(4));
  for (std::string& name : s.names) name = in.text();
  s.position = in.numbers();
  s.velocity = in.numbers();
  s.effort = in.numbers();
  return s;
}

Image read_image(const Message& message) {
  Reader in(message);
  Image image;
  image.header = in.header();
  image.height = in.number<std::uint32_t>();
  image.width = in.number<std::uint32_t>();
  image.encoding = in.text();
  image.is_bigendian = in.number<std::uint8_t>() != 0;
  image.step = in.number<std::uint32_t>();
  image.data = in.bytes(in.number<std::uint32_t>());
  if (static_cast<std::uint64_t>(image.step) * image.height > image.data.size()) in.fail("the image ends too early");
  return image;
}

CompressedImage read_compressed_image(const Message& message) {
  Reader in(message);
  CompressedImage image;
  image.header = in.header();
  image.format = in.text();
  image.data = in.bytes(in.number<std::uint32_t>());
  return image;
}

CameraInfo read_camera_info(const Message& message) {
  Reader in(message);
  CameraInfo c;
  c.header = in.header();
  c.height = in.number<std::uint32_t>();
  c.width = in.number<std::uint32_t>();
  c.model = in.text();
  c.d = in.numbers();
  in.numbers(c.k, 9);
  in.numbers(c.r, 9);
  in.numbers(c.p, 12);
  return c;
}

std::vector<Transform> read_transforms(const Message& message) {
  Reader in(message);
  std::vector<Transform> all(in.count(70));
  for (Transform& t : all) t = transform_of(in);
  return all;
}

Transform read_transform(const Message& message) {
  Reader in(message);
  return transform_of(in);
}

Transform read_pose(const Message& message) {
  Reader in(message);
  Transform t;
  t.header = in.header();
  t.parent_from_child = make_motion(in, "pose");
  return t;
}

static std::vector<Rigid> list_poses(Reader& in) {
  std::vector<Rigid> poses(in.count(56));
  for (Rigid& pose : poses) pose = make_motion(in, "pose");
  return poses;
}

Poses read_pose_array(const Message& message) {
  Reader in(message);
  Poses all;
  all.header = in.header();
  all.poses = list_poses(in);
  return all;
}

Poses read_aruco_markers(const Message& message) {
  Reader in(message);
  Poses all;
  all.header = in.header();
  all.names.resize(in.count(8));
  for (std::string& name : all.names) name = std::to_string(in.number<std::int64_t>());
  all.poses = list_poses(in);
  if (all.names.size() != all.poses.size()) in.fail("it has not as many poses as numbers of tags");
  return all;
}

Poses read_aruco_detection(const Message& message) {
  Reader in(message);
  Poses all;
  all.header = in.header();
  const std::uint32_t tags = in.count(58);
  for (std::uint32_t i = 0; i < tags; ++i) {
    all.names.push_back(std::to_string(in.number<std::uint16_t>()));
    all.poses.push_back(make_motion(in, "pose"));
  }
  const std::uint32_t boards = in.count(60);
  for (std::uint32_t i = 0; i < boards; ++i) {
    all.names.push_back(in.text());
    all.poses.push_back(make_motion(in, "pose"));
  }
  return all;
}

std::string read_string(const Message& message) { return Reader(message).text(); }

std::string find_type(std::string_view name) {
  std::string type = shortened(name, 100);
  if (const std::size_t at = type.find("/msg/"); at != std::string::npos) type.erase(at, 4);
  return type;
}

}  // namespace handsight::ros
