// SPDX-License-Identifier: Apache-2.0
#include "session/stereo_calibration.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "session/opencv_storage.h"

namespace handsight {
namespace {

/// The numbers found so far, over all files.
struct Found {
  std::optional<StorageEntry> camera[2], distortion[2], rotation, translation;
  int width = 0, height = 0;
};

using Storage = std::map<std::string, StorageEntry>;

/// The first of these entries; InputError where it is there and is no matrix of numbers.
std::optional<StorageEntry> find_matrix(const Storage& storage, const std::string& file,
                                        std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto found = storage.find(name);
    if (found == storage.end()) continue;
    if (!found->second.fault.empty())
      throw InputError(
          fmt::format("{}: {} is no matrix of finite numbers: {}; expected what OpenCV's stereoCalibrate "
                      "writes.",
                      file, name, shortened(found->second.fault, 200)));
    return found->second;
  }
  return std::nullopt;
}

void take(std::optional<StorageEntry>& known, std::optional<StorageEntry> found) {
  if (!known && found) known = std::move(found);
}

int as_side(double number) { return number >= 1 && number <= 1e6 ? static_cast<int>(number) : 0; }

void read_size(const Storage& storage, Found& found) {
  const auto numbers = [&](const char* name) {
    const auto entry = storage.find(name);
    return entry == storage.end() ? std::vector<double>() : entry->second.numbers;
  };
  const auto set = [&](double width, double height) {
    found.width = as_side(width);
    found.height = as_side(height);
  };
  for (const char* name : {"imageSize", "image_size", "size"})
    if (const auto both = numbers(name); both.size() == 2) set(both[0], both[1]);
  for (const auto& [w, h] : {std::pair{"image_width", "image_height"}, std::pair{"width", "height"}}) {
    const auto width = numbers(w), height = numbers(h);
    if (width.size() == 1 && height.size() == 1) set(width[0], height[0]);
  }
}

void read_one(const std::string& text, const std::string& path, Found& found) {
  const Storage file = parse_opencv_storage(text, path);
  const auto find = [&](std::initializer_list<const char*> names) { return find_matrix(file, path, names); };
  take(found.camera[0], find({"M1", "K1", "cameraMatrix1", "camera_matrix_1", "camera_matrix_left",
                              "left_camera_matrix", "cameraMatrixL", "K_left", "CM1", "mtx_left"}));
  take(found.camera[1], find({"M2", "K2", "cameraMatrix2", "camera_matrix_2", "camera_matrix_right",
                              "right_camera_matrix", "cameraMatrixR", "K_right", "CM2", "mtx_right"}));
  take(found.distortion[0], find({"D1", "distCoeffs1", "dist_coeffs_1", "distortion_coefficients_left",
                                  "left_distortion_coefficients", "distCoeffsL", "D_left", "dist_left"}));
  take(found.distortion[1], find({"D2", "distCoeffs2", "dist_coeffs_2", "distortion_coefficients_right",
                                  "right_distortion_coefficients", "distCoeffsR", "D_right", "dist_right"}));
  take(found.rotation, find({"R", "rotation", "stereo_R"}));
  take(found.translation, find({"T", "translation", "stereo_T"}));
  read_size(file, found);
}

Camera camera_of(const StorageEntry& k, const std::optional<StorageEntry>& distortion, const char* side,
                 const Found& found, const std::string& files) {
  const bool is_square = k.rows == 3 && k.cols == 3;
  if (!is_square || !(k.numbers[0] > 0) || !(k.numbers[4] > 0))
    throw InputError(fmt::format("{}: the {} camera matrix is {} x {}; expected 3 x 3 with positive focal lengths.",
                                 files, side, k.rows, k.cols));
  Camera camera{.width = found.width, .height = found.height};
  camera.fx = k.numbers[0];
  camera.skew = k.numbers[1];
  camera.cx = k.numbers[2];
  camera.fy = k.numbers[4];
  camera.cy = k.numbers[5];
  for (const double focal : {camera.fx, camera.fy})
    if (!bounds::focal_length.hold(focal))
      throw InputError(fmt::format("{}: the {} camera has a focal length of {:g} px; expected one from {:g} to {:g}.",
                                   files, side, focal, bounds::focal_length.lowest, bounds::focal_length.highest));
  for (const double number : {camera.skew, camera.cx, camera.cy})
    if (!bounds::pixel.hold(number))
      throw InputError(fmt::format("{}: the {} camera matrix holds {:g}; expected at most {:g} px.", files, side,
                                   number, bounds::pixel.highest));
  if (!distortion) return camera;
  double* into[] = {&camera.k1, &camera.k2, &camera.p1, &camera.p2, &camera.k3};
  for (std::size_t i = 0; i < distortion->numbers.size(); ++i) {
    const double value = distortion->numbers[i];
    if (i < 5) {
      *into[i] = value;
    } else if (value != 0) {
      throw InputError(
          fmt::format("{}: the {} camera has {} distortion terms (rational, thin prism or tilted); calibrate "
                      "it with five (k1 k2 p1 p2 k3).",
                      files, side, distortion->numbers.size()));
    }
  }
  return camera;
}

Rigid right_from_left_of(const Found& found, const std::string& files, std::vector<std::string>* notes) {
  const StorageEntry &r = *found.rotation, &t = *found.translation;
  Rigid motion;
  if (r.numbers.size() == 3) {  // a rotation vector
    motion.rotation = rotation_from_vector<double>(Vector3(r.numbers.data()));
  } else if (r.rows == 3 && r.cols == 3) {
    motion.rotation = Matrix3(r.numbers.data()).transpose();  // row by row
    const Matrix3 nearest = nearest_rotation(motion.rotation);
    if (!((nearest - motion.rotation).cwiseAbs().maxCoeff() < 1e-3))
      throw InputError(
          fmt::format("{}: R is no rotation (its columns are not of length 1 and square to each other).", files));
    motion.rotation = nearest;
  } else {
    throw InputError(
        fmt::format("{}: R is {} x {}; expected a 3 x 3 rotation or a rotation vector.", files, r.rows, r.cols));
  }
  motion.translation = Vector3(t.numbers.data());
  if (motion.translation.norm() <= 5) return motion;
  motion.translation *= 1e-3;
  if (notes)
    notes->push_back(fmt::format("{}: T is {:.1f} long and is taken for millimetres: the cameras are {:.0f} mm apart.",
                                 files, 1e3 * motion.translation.norm(), 1e3 * motion.translation.norm()));
  return motion;
}

}  // namespace

StereoRig read_stereo_calibration(const std::vector<std::filesystem::path>& files, std::vector<std::string>* notes) {
  std::vector<StereoCalibrationText> texts;
  for (const auto& path : files) texts.push_back({read_file(path), shown_path(path.filename())});
  return parse_stereo_calibration(texts, notes);
}

StereoRig parse_stereo_calibration(const std::vector<StereoCalibrationText>& texts, std::vector<std::string>* notes) {
  Found found;
  std::string names;
  for (const StereoCalibrationText& one : texts) {
    read_one(one.text, one.file, found);
    names += (names.empty() ? "" : ", ") + one.file;
  }
  const auto require = [&](bool there, const char* what) {
    if (!there)
      throw InputError(fmt::format("{}: has no {}; name the file of OpenCV's stereoCalibrate that has it too.",
                                   names.empty() ? "No file" : names, what));
  };
  require(found.camera[0].has_value(), "left camera matrix (M1, K1 or cameraMatrix1)");
  require(found.camera[1].has_value(), "right camera matrix (M2, K2 or cameraMatrix2)");
  require(found.rotation.has_value(), "rotation R between the cameras");
  require(found.translation.has_value() && found.translation->numbers.size() == 3, "translation T between the cameras");
  StereoRig rig;
  rig.left = camera_of(*found.camera[0], found.distortion[0], "left", found, names);
  rig.right = camera_of(*found.camera[1], found.distortion[1], "right", found, names);
  rig.right_from_left = right_from_left_of(found, names, notes);
  return rig;
}

}  // namespace handsight
