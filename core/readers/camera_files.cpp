// SPDX-License-Identifier: Apache-2.0
#include "readers/camera_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

#include "base/bounds.h"
#include "base/error.h"
#include "base/text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

std::vector<double> required(const YAML::Node& yaml, const char* key, std::size_t count, const std::string& file) {
  const auto numbers = yaml_numbers(yaml[key]);
  if (!numbers || numbers->size() < count)
    throw InputError(
        message("{}: has no {} of {} finite numbers; expected a calibration that is whole.", file, key, count));
  return *numbers;
}

void set_rectification(RosCamera& c, const double* r, const double* p) {
  const Matrix3 rotation = Matrix3(Eigen::Map<const Matrix3>(r)).transpose();
  if (!((rotation * rotation.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-3) || !(p[0] > 0)) return;
  c.rectified_from_camera = nearest_rotation(rotation);
  c.baseline = -p[3] / p[0];
  c.has_rectification = true;
}

Camera from_matrix(const std::vector<double>& k) {
  Camera c;
  c.fx = k[0];
  c.skew = k[1];
  c.cx = k[2];
  c.fy = k[4];
  c.cy = k[5];
  return c;
}

Camera kalibr_camera(const YAML::Node& yaml, const std::string& file) {
  const std::string model = yaml_word(yaml, "camera_model");
  if (model != "pinhole")
    throw InputError(
        message("{}: a camera is of the model {}, which sessions do not have; calibrate it as "
                "pinhole-radtan.",
                file, in_quotes(model)));
  const std::vector<double> n = required(yaml, "intrinsics", 4, file), size = required(yaml, "resolution", 2, file);
  Camera c;
  c.fx = n[0];
  c.fy = n[1];
  c.cx = n[2];
  c.cy = n[3];
  c.width = static_cast<int>(std::clamp(size[0], 0.0, 1e6));
  c.height = static_cast<int>(std::clamp(size[1], 0.0, 1e6));
  set_distortion(c, yaml_numbers(yaml["distortion_coeffs"]).value_or(std::vector<double>()),
                 yaml_word(yaml, "distortion_model"), file);
  check_camera(c, file);
  return c;
}

}  // namespace

void check_camera(const Camera& c, const std::string& file) {
  if (c.fx == 0)
    throw InputError(
        message("{}: the camera's matrix holds zeros: the driver publishes no calibration; calibrate it, or name a "
                "file that has one.",
                file));
  for (const double f : {c.fx, c.fy})
    if (!bounds::focal_length.hold(f))
      throw InputError(message("{}: has a focal length of {:g} px; expected one from {:g} to {:g}.", file, f,
                               bounds::focal_length.lowest, bounds::focal_length.highest));
  for (const double p : {c.cx, c.cy, c.skew})
    if (!bounds::pixel.hold(p)) throw InputError(message("{}: holds {:g}, no place in an image.", file, p));
  for (const double d : {c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6})
    if (!bounds::distortion.hold(d)) throw InputError(message("{}: holds {:g}, no lens bends so.", file, d));
  if (c.width <= 0 || c.height <= 0 || c.width > 100000 || c.height > 100000)
    throw InputError(
        message("{}: does not say how large the images are; expected image_width and image_height.", file));
}

void set_distortion(Camera& c, const std::vector<double>& d, const std::string& model, const std::string& file) {
  c.is_fisheye = model == "equidistant" || model == "fisheye";
  const bool is_rational = model == "rational_polynomial" || (model.empty() && d.size() == 8);
  const bool is_plain = model.empty() || model == "plumb_bob" || model == "radtan" || model == "none";
  if (!c.is_fisheye && !is_rational && !is_plain)
    throw InputError(
        message("{}: the lens is of the model {}, which sessions do not have; calibrate with plumb_bob "
                "(k1 k2 p1 p2 k3), rational_polynomial or equidistant.",
                file, in_quotes(model)));
  double* const plain[] = {&c.k1, &c.k2, &c.p1, &c.p2, &c.k3, &c.k4, &c.k5, &c.k6};
  double* const fisheye[] = {&c.k1, &c.k2, &c.k3, &c.k4};
  const std::span<double* const> into = c.is_fisheye  ? std::span<double* const>(fisheye)
                                        : is_rational ? std::span<double* const>(plain)
                                                      : std::span<double* const>(plain, 5);
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (i < into.size())
      *into[i] = d[i];
    else if (d[i] != 0)
      throw InputError(message("{}: the lens has {} distortion terms; calibrate it with {}.", file, d.size(),
                               c.is_fisheye  ? "the four of a fisheye"
                               : is_rational ? "eight (k1 k2 p1 p2 k3 k4 k5 k6)"
                                             : "five (k1 k2 p1 p2 k3)"));
  }
}

bool is_camera_info(const YAML::Node& yaml) {
  return yaml.IsMap() && yaml["camera_matrix"] && yaml["image_width"] && !yaml["cam0"];
}

bool is_camchain(const YAML::Node& yaml) {
  return yaml.IsMap() && yaml["cam0"] && yaml["cam0"].IsMap() && yaml["cam0"]["intrinsics"];
}

RosCamera read_camera_info(const YAML::Node& yaml, const std::string& file) {
  RosCamera c;
  c.file = file;
  c.name = yaml_word(yaml, "camera_name");
  c.camera = from_matrix(required(yaml, "camera_matrix", 9, file));
  c.camera.width = static_cast<int>(std::clamp(yaml_number(yaml, "image_width").value_or(0), 0.0, 1e6));
  c.camera.height = static_cast<int>(std::clamp(yaml_number(yaml, "image_height").value_or(0), 0.0, 1e6));
  set_distortion(c.camera, yaml_numbers(yaml["distortion_coefficients"]).value_or(std::vector<double>()),
                 yaml_word(yaml, "distortion_model"), file);
  check_camera(c.camera, file);
  const auto r = yaml_numbers(yaml["rectification_matrix"]), p = yaml_numbers(yaml["projection_matrix"]);
  if (r && r->size() == 9 && p && p->size() == 12) set_rectification(c, r->data(), p->data());
  return c;
}

RosCamera camera_from_message(const ros::CameraInfo& message, const std::string& file) {
  RosCamera c;
  c.file = c.name = file;
  c.frame = message.header.frame;
  c.camera = from_matrix({message.k, message.k + 9});
  c.camera.width = static_cast<int>(std::min(message.width, 1000000u));
  c.camera.height = static_cast<int>(std::min(message.height, 1000000u));
  set_distortion(c.camera, message.d, message.model, file);
  check_camera(c.camera, file);
  set_rectification(c, message.r, message.p);
  return c;
}

StereoRig make_rig(const RosCamera& left, const RosCamera& right) {
  const RosCamera &l = right.baseline >= left.baseline ? left : right, &r = &l == &left ? right : left;
  if (!l.has_rectification || !r.has_rectification || !(r.baseline > 1e-4))
    throw InputError(
        message("{} and {}: neither names the distance of the cameras (projection_matrix[3] is 0); "
                "calibrate them as a stereo pair, or name OpenCV's or Kalibr's stereo file too.",
                left.file, right.file));
  StereoRig rig;
  rig.left = l.camera;
  rig.right = r.camera;
  const Matrix3 to_right = r.rectified_from_camera.transpose();
  rig.right_from_left = {to_right * l.rectified_from_camera, to_right * Vector3(-r.baseline, 0, 0)};
  return rig;
}

namespace {

/// T_cn_cnm1: from the camera before to this one.
Rigid motion_from_before(const YAML::Node& camera, const std::string& file) {
  const std::vector<double> t = required(camera, "T_cn_cnm1", 16, file);
  Matrix3 rotation;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) rotation(i, k) = t[static_cast<std::size_t>(4 * i + k)];
  if (!((rotation * rotation.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-2))
    throw InputError(message("{}: T_cn_cnm1 holds no rotation; expected the motion from the camera before.", file));
  return {nearest_rotation(rotation), Vector3(t[3], t[7], t[11])};
}

}  // namespace

Rig read_camchain(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes) {
  Rig rig;
  for (int k = 0; yaml[fmt::format("cam{}", k)]; ++k) {
    if (k == max_cameras) {
      notes.push_back(message("{}: of its cameras the first {} are taken, the others are left out.", file, k));
      break;
    }
    const std::string name = fmt::format("cam{}", k);
    const std::string where = fmt::format("{}, {}", file, name);
    RigCamera camera{name, kalibr_camera(yaml[name], where), {}};
    if (k > 0) camera.camera_from_first = motion_from_before(yaml[name], where) * rig.cameras.back().camera_from_first;
    rig.cameras.push_back(std::move(camera));
  }
  if (rig.count() == 2) rig.at(0).name = "left", rig.at(1).name = "right";
  return rig;
}

Rig make_rig(const RosCamera& camera) {
  std::string name;
  for (const char c : camera.name)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') name += c;
  return {{{name.empty() || name.size() > 60 ? "camera" : name, camera.camera, {}}}};
}

void fit_to_images(RigCamera& camera, int width, int height, std::vector<Message>& notes) {
  Camera& c = camera.camera;
  if (c.width == width && c.height == height) return;
  if (c.width <= 0) {
    c.width = width;
    c.height = height;
    return;
  }
  if (c.width != height || c.height != width)
    throw InputError(
        message("The images are {} x {} px, the calibration of the {} camera is of {} x {} px: name "
                "the calibration of these images, or images of this size.",
                width, height, camera.name, c.width, c.height));
  if (c.cx > width || c.cy > height ||
      std::abs(c.cx - height / 2.0) + std::abs(c.cy - width / 2.0) <
          std::abs(c.cx - width / 2.0) + std::abs(c.cy - height / 2.0))
    throw InputError(
        message("The images are {} x {} px and the calibration of the {} camera is of {} x {} px, its "
                "centre at {:.0f}, {:.0f}: the images were turned by a quarter after it was "
                "calibrated; turn them back.",
                width, height, camera.name, c.width, c.height, c.cx, c.cy));
  std::swap(c.width, c.height);
  notes.push_back(
      message("The calibration of the {} camera has width and height swapped; {} x {} px of the images "
              "is taken.",
              camera.name, width, height));
}

}  // namespace handsight
