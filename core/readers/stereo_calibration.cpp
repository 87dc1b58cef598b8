// SPDX-License-Identifier: Apache-2.0
#include "readers/stereo_calibration.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <optional>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/opencv_storage.h"

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
          message("{}: {} is no matrix of finite numbers: {}; expected what OpenCV's stereoCalibrate "
                  "writes.",
                  file, name, at_most(found->second.fault, 200)));
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
  for (const auto& [w, h] : {std::pair{"image_width", "image_height"}, std::pair{"image_Width", "image_Height"},
                             std::pair{"width", "height"}}) {
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

/// k1 k2 p1 p2 k3 k4 k5 k6, as many as there are. False where one beyond `most` is not zero.
bool take_distortion(Camera& camera, const std::vector<double>& numbers, std::size_t most) {
  double* into[] = {&camera.k1, &camera.k2, &camera.p1, &camera.p2, &camera.k3, &camera.k4, &camera.k5, &camera.k6};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i >= most && numbers[i] != 0) return false;
    if (i < most) *into[i] = numbers[i];
  }
  return true;
}

Camera look_up_camera(const StorageEntry& k, const std::optional<StorageEntry>& distortion, const char* side,
                      const Found& found, const std::string& files) {
  const bool is_square = (k.rows == 3 && k.cols == 3) || k.numbers.size() == 9;  // or its numbers row by row
  if (!is_square || !(k.numbers[0] > 0) || !(k.numbers[4] > 0))
    throw InputError(message("{}: the {} camera matrix is {} x {}; expected 3 x 3 with positive focal lengths.", files,
                             side, k.rows, k.cols));
  Camera camera{.width = found.width, .height = found.height};
  camera.fx = k.numbers[0];
  camera.skew = k.numbers[1];
  camera.cx = k.numbers[2];
  camera.fy = k.numbers[4];
  camera.cy = k.numbers[5];
  for (const double focal : {camera.fx, camera.fy})
    if (!bounds::focal_length.hold(focal))
      throw InputError(message("{}: the {} camera has a focal length of {:g} px; expected one from {:g} to {:g}.",
                               files, side, focal, bounds::focal_length.lowest, bounds::focal_length.highest));
  for (const double number : {camera.skew, camera.cx, camera.cy})
    if (!bounds::pixel.hold(number))
      throw InputError(message("{}: the {} camera matrix holds {:g}; expected at most {:g} px.", files, side, number,
                               bounds::pixel.highest));
  if (!distortion) return camera;
  if (!take_distortion(camera, distortion->numbers, 5))
    throw InputError(
        message("{}: the {} camera has {} distortion terms (rational, thin prism or tilted); calibrate "
                "it with five (k1 k2 p1 p2 k3).",
                files, side, distortion->numbers.size()));
  return camera;
}

Rigid right_from_left_of(const Found& found, const std::string& files, std::vector<Message>* notes) {
  const StorageEntry &r = *found.rotation, &t = *found.translation;
  Rigid motion;
  if (r.numbers.size() == 3) {  // a rotation vector
    motion.rotation = rotation_from_vector<double>(Vector3(r.numbers.data()));
  } else if (r.rows == 3 && r.cols == 3) {
    motion.rotation = Matrix3(r.numbers.data()).transpose();  // row by row
    const Matrix3 nearest = nearest_rotation(motion.rotation);
    if (!((nearest - motion.rotation).cwiseAbs().maxCoeff() < 1e-3))
      throw InputError(
          message("{}: R is no rotation (its columns are not of length 1 and square to each other).", files));
    motion.rotation = nearest;
  } else {
    throw InputError(
        message("{}: R is {} x {}; expected a 3 x 3 rotation or a rotation vector.", files, r.rows, r.cols));
  }
  motion.translation = Vector3(t.numbers.data());
  if (motion.translation.norm() <= 5) return motion;
  motion.translation *= 1e-3;
  if (notes)
    notes->push_back(message("{}: T is {:.1f} long and is taken for millimetres: the cameras are {:.0f} mm apart.",
                             files, 1e3 * motion.translation.norm(), 1e3 * motion.translation.norm()));
  return motion;
}

constexpr std::initializer_list<const char*>
    one_matrix = {"camera_matrix",     "cameraMatrix",     "K",         "mtx",       "Camera_Matrix",
                  "camera_intrinsics", "intrinsic_matrix", "intrinsic", "intrinsics"},
    one_distortion = {"distortion_coefficients", "distCoeffs", "D",           "dist",      "Distortion_Coefficients",
                      "distortion_coeffs",       "dist_coeff", "dist_coeffs", "distortion"};

/// `name: "value"` of any of the texts; empty where there is none.
std::string text_entry(const std::vector<StereoCalibrationText>& texts, const std::string& name) {
  for (const StereoCalibrationText& one : texts) {
    const std::size_t at = one.text.find(name + ": \"");
    if (at == std::string::npos) continue;
    const std::size_t begin = at + name.size() + 3;
    return one.text.substr(begin, std::min(one.text.find('"', begin), one.text.size()) - begin);
  }
  return {};
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= 100 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

/// Everything of camera k (1, 2, ...) of a rig but where it is.
Camera numbered_camera(const Storage& all, int k, const std::string& model, const std::string& files) {
  constexpr const char* places[max_cameras] = {"first", "second", "third",   "fourth",
                                               "fifth", "sixth",  "seventh", "eighth"};
  const std::string number = std::to_string(k);
  const char* const which = places[k - 1];
  auto matrix = find_matrix(all, files, {("M" + number).c_str()});
  auto distortion = find_matrix(all, files, {("D" + number).c_str()});
  if (k == 1) {
    take(matrix, find_matrix(all, files, one_matrix));
    take(distortion, find_matrix(all, files, one_distortion));
  }
  Found found;
  read_size(all, found);
  const auto own = [&](const std::string& name, int& into) {
    const auto entry = all.find(name + number);
    if (entry != all.end() && entry->second.numbers.size() == 1) into = as_side(entry->second.numbers[0]);
  };
  own("image_width_", found.width);
  own("image_height_", found.height);
  Camera camera = look_up_camera(*matrix, std::nullopt, which, found, files);
  const std::vector<double> numbers = distortion ? distortion->numbers : std::vector<double>();
  camera.is_fisheye = model == "fisheye";
  if (camera.is_fisheye && numbers.size() == 4) {
    camera.k1 = numbers[0], camera.k2 = numbers[1], camera.k3 = numbers[2], camera.k4 = numbers[3];
  } else if (camera.is_fisheye || !take_distortion(camera, numbers, 8)) {
    throw InputError(message("{}: the {} camera has {} distortion terms; expected {}.", files, which, numbers.size(),
                             camera.is_fisheye ? "the four of a fisheye (k1 k2 k3 k4)"
                                               : "five (k1 k2 p1 p2 k3) or eight with the rational ones"));
  }
  return camera;
}

Rigid motion_of_camera(const Storage& all, int k, const std::string& files, std::vector<Message>* notes) {
  const std::string ending = k == 2 ? "" : "_" + std::to_string(k);
  Found found;
  found.rotation = find_matrix(all, files, {("R" + ending).c_str()});
  found.translation = find_matrix(all, files, {("T" + ending).c_str()});
  if (!found.rotation || !found.translation || found.translation->numbers.size() != 3)
    throw InputError(message("{}: has no R{} and T{} of camera {}; name the file that says where it is to the first.",
                             files, ending, ending, k));
  return right_from_left_of(found, files, notes);
}

}  // namespace

Rig read_rig_calibration(const std::vector<std::filesystem::path>& files, std::vector<Message>* notes) {
  std::vector<StereoCalibrationText> texts;
  for (const auto& path : files) texts.push_back({read_file(path), shown_path(path.filename())});
  return parse_rig_calibration(texts, notes);
}

Rig parse_rig_calibration(const std::vector<StereoCalibrationText>& texts, std::vector<Message>* notes) {
  Storage all;
  std::string files;
  for (const StereoCalibrationText& one : texts) {
    all.merge(parse_opencv_storage(one.text, one.file));
    files += (files.empty() ? "" : ", ") + one.file;
  }
  int count = 0;
  while (count < max_cameras && all.contains("M" + std::to_string(count + 1))) ++count;
  if (count == 0 && find_matrix(all, files, one_matrix)) count = 1;
  if (count == 0) return make_rig(parse_stereo_calibration(texts, notes));
  Rig rig;
  for (int k = 1; k <= count; ++k) {
    const std::string number = std::to_string(k);
    const std::string given = text_entry(texts, "camera_name_" + number);
    RigCamera camera{count == 1 ? "camera" : "camera_" + number,
                     numbered_camera(all, k, text_entry(texts, "lens_model_" + number), files),
                     {}};
    if (count == 2)
      camera.name = k == 1 ? "left" : "right";
    else if (is_name(given) && find_camera(rig, given) < 0)
      camera.name = given;
    if (k > 1) camera.camera_from_first = motion_of_camera(all, k, files, notes);
    rig.cameras.push_back(std::move(camera));
  }
  return rig;
}

StereoRig read_stereo_calibration(const std::vector<std::filesystem::path>& files, std::vector<Message>* notes) {
  std::vector<StereoCalibrationText> texts;
  for (const auto& path : files) texts.push_back({read_file(path), shown_path(path.filename())});
  return parse_stereo_calibration(texts, notes);
}

StereoRig parse_stereo_calibration(const std::vector<StereoCalibrationText>& texts, std::vector<Message>* notes) {
  Found found;
  std::string names;
  for (const StereoCalibrationText& one : texts) {
    read_one(one.text, one.file, found);
    names += (names.empty() ? "" : ", ") + one.file;
  }
  if (!names.empty() && !found.camera[0] && !found.camera[1] && !found.rotation && !found.translation)
    throw InputError(message(
        "{}: holds neither a camera (M1, K1 or cameraMatrix1) nor numbered poses (4x4, or R_1 and t_1); write poses as "
        "a table, in each row x y z and a turn.",
        names));
  const auto require = [&](bool there, const char* what) {
    if (!there)
      throw InputError(message("{}: has no {}; name the file of OpenCV's stereoCalibrate that has it too.",
                               names.empty() ? Message("No file") : verbatim(names), what));
  };
  require(found.camera[0].has_value(), "left camera matrix (M1, K1 or cameraMatrix1)");
  require(found.camera[1].has_value(), "right camera matrix (M2, K2 or cameraMatrix2)");
  require(found.rotation.has_value(), "rotation R between the cameras");
  require(found.translation.has_value() && found.translation->numbers.size() == 3, "translation T between the cameras");
  StereoRig rig;
  rig.left = look_up_camera(*found.camera[0], found.distortion[0], "left", found, names);
  rig.right = look_up_camera(*found.camera[1], found.distortion[1], "right", found, names);
  rig.right_from_left = right_from_left_of(found, names, notes);
  return rig;
}

}  // namespace handsight
