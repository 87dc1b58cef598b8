// SPDX-License-Identifier: Apache-2.0
#include "session/stereo_calibration.h"

#include <algorithm>
#include <initializer_list>
#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace handsight {
namespace {

/// OpenCV's messages have no place on standard error: what is wrong becomes a sentence.
class QuietOpenCv {
 public:
  QuietOpenCv() {
    cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
  }
  ~QuietOpenCv() { cv::redirectError(nullptr); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;
};

/// The numbers found so far, over all files.
struct Found {
  std::optional<cv::Mat> camera[2], distortion[2], rotation, translation;
  int width = 0, height = 0;
};

/// OpenCV makes room for as many numbers as a file says that it has.
bool is_small(const cv::FileNode& node) {
  constexpr int most = 64;
  const auto side_is_small = [&](const char* side) {
    const cv::FileNode number = node[side];
    return number.isInt() && static_cast<int>(number) >= 0 && static_cast<int>(number) <= most;
  };
  return node.isMap() ? side_is_small("rows") && side_is_small("cols") : node.size() <= most * most;
}

std::optional<cv::Mat> find_matrix(const cv::FileStorage& file, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const cv::FileNode node = file[name];
    if (node.empty()) continue;
    if (!is_small(node)) throw std::length_error("a matrix that is none of a camera's");
    cv::Mat matrix;
    node >> matrix;
    if (matrix.empty() && node.isSeq()) {  // a plain list of numbers
      std::vector<double> numbers;
      node >> numbers;
      matrix = cv::Mat(numbers, true);
    }
    if (matrix.empty()) continue;
    matrix.convertTo(matrix, CV_64F);
    if (matrix.channels() != 1) matrix = matrix.reshape(1);
    if (!cv::checkRange(matrix, true, nullptr, bounds::distortion.lowest, bounds::distortion.highest))
      throw std::out_of_range("a number that is not finite or beyond what a camera has");
    return matrix;
  }
  return std::nullopt;
}

void take(std::optional<cv::Mat>& known, std::optional<cv::Mat> found) {
  if (!known && found) known = std::move(found);
}

void read_size(const cv::FileStorage& file, Found& found) {
  for (const char* name : {"imageSize", "image_size", "size"}) {
    const cv::FileNode node = file[name];
    if (!node.isSeq() || node.size() != 2) continue;
    found.width = static_cast<int>(node[0]);
    found.height = static_cast<int>(node[1]);
  }
  for (const auto& [w, h] : {std::pair{"image_width", "image_height"}, std::pair{"width", "height"}})
    if (file[w].isInt() && file[h].isInt()) {
      found.width = static_cast<int>(file[w]);
      found.height = static_cast<int>(file[h]);
    }
}

/// OpenCV's parsers call themselves for every level.
bool is_nested_deeply(const std::string& text) {
  constexpr int deepest = 64;
  int brackets = 0, elements = 0, indent = 0;
  bool at_start = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') --brackets;
    if (c == '<' && next != '!' && next != '?') elements += next == '/' ? -1 : 1;
    if (c == '/' && next == '>') --elements;
    indent = c == '\n' ? 0 : at_start && (c == ' ' || c == '-') ? indent + 1 : indent;
    at_start = c == '\n' || (at_start && (c == ' ' || c == '-'));
    if (brackets > deepest || elements > deepest || (at_start && indent > 4 * deepest)) return true;
  }
  return false;
}

[[noreturn]] void refuse_storage(const std::string& file, std::string_view reason) {
  throw InputError(
      fmt::format("{}: is no file that OpenCV's FileStorage wrote (YAML, XML or JSON){}; name the stereo "
                  "calibration.",
                  file, reason));
}

void read_one(const std::string& text, const std::string& path, Found& found) {
  constexpr std::size_t most = std::size_t{16} << 20;  // bytes
  if (text.size() > most) refuse_storage(path, fmt::format(": it has {} MB", text.size() >> 20));
  if (text.find('\0') != std::string::npos) refuse_storage(path, ": it holds a zero byte");
  if (is_nested_deeply(text)) refuse_storage(path, ": its elements are nested too deeply");
  const QuietOpenCv quiet;
  try {
    const cv::FileStorage file(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    take(found.camera[0], find_matrix(file, {"M1", "K1", "cameraMatrix1", "camera_matrix_1", "camera_matrix_left",
                                             "left_camera_matrix", "cameraMatrixL", "K_left", "CM1", "mtx_left"}));
    take(found.camera[1], find_matrix(file, {"M2", "K2", "cameraMatrix2", "camera_matrix_2", "camera_matrix_right",
                                             "right_camera_matrix", "cameraMatrixR", "K_right", "CM2", "mtx_right"}));
    take(found.distortion[0],
         find_matrix(file, {"D1", "distCoeffs1", "dist_coeffs_1", "distortion_coefficients_left",
                            "left_distortion_coefficients", "distCoeffsL", "D_left", "dist_left"}));
    take(found.distortion[1],
         find_matrix(file, {"D2", "distCoeffs2", "dist_coeffs_2", "distortion_coefficients_right",
                            "right_distortion_coefficients", "distCoeffsR", "D_right", "dist_right"}));
    take(found.rotation, find_matrix(file, {"R", "rotation", "stereo_R"}));
    take(found.translation, find_matrix(file, {"T", "translation", "stereo_T"}));
    read_size(file, found);
  } catch (const cv::Exception&) {
    refuse_storage(path, "");
  } catch (const std::bad_alloc&) {
    refuse_storage(path, ": it asks for more memory than there is");
  } catch (const std::logic_error& error) {  // OpenCV's parsers throw the standard library's own, too
    refuse_storage(path, fmt::format(" ({})", error.what()));
  }
}

Camera camera_of(const cv::Mat& k, const std::optional<cv::Mat>& distortion, const char* side, const Found& found,
                 const std::string& files) {
  const bool is_square = k.rows == 3 && k.cols == 3;
  if (!is_square || !(k.at<double>(0, 0) > 0) || !(k.at<double>(1, 1) > 0))
    throw InputError(fmt::format("{}: the {} camera matrix is {} x {}; expected 3 x 3 with positive focal lengths.",
                                 files, side, k.rows, k.cols));
  Camera camera{.width = found.width, .height = found.height};
  camera.fx = k.at<double>(0, 0);
  camera.skew = k.at<double>(0, 1);
  camera.cx = k.at<double>(0, 2);
  camera.fy = k.at<double>(1, 1);
  camera.cy = k.at<double>(1, 2);
  for (const double focal : {camera.fx, camera.fy})
    if (!bounds::focal_length.hold(focal))
      throw InputError(fmt::format("{}: the {} camera has a focal length of {:g} px; expected one from {:g} to {:g}.",
                                   files, side, focal, bounds::focal_length.lowest, bounds::focal_length.highest));
  for (const double number : {camera.skew, camera.cx, camera.cy})
    if (!bounds::pixel.hold(number))
      throw InputError(fmt::format("{}: the {} camera matrix holds {:g}; expected at most {:g} px.", files, side,
                                   number, bounds::pixel.highest));
  if (!distortion) return camera;
  const cv::Mat flat = distortion->reshape(1, 1);
  double* into[] = {&camera.k1, &camera.k2, &camera.p1, &camera.p2, &camera.k3};
  for (int i = 0; i < flat.cols; ++i) {
    const double value = flat.at<double>(0, i);
    if (i < 5) {
      *into[i] = value;
    } else if (value != 0) {
      throw InputError(
          fmt::format("{}: the {} camera has {} distortion terms (rational, thin prism or tilted); calibrate "
                      "it with five (k1 k2 p1 p2 k3).",
                      files, side, flat.cols));
    }
  }
  return camera;
}

Rigid right_from_left_of(const Found& found, const std::string& files, std::vector<std::string>* notes) {
  cv::Mat r = *found.rotation;
  const cv::Mat t = found.translation->reshape(1, 3);
  Rigid motion;
  if (r.total() == 3) {  // a rotation vector
    const cv::Mat v = r.reshape(1, 3);
    motion.rotation = rotation_from_vector<double>(Vector3(v.at<double>(0), v.at<double>(1), v.at<double>(2)));
  } else if (r.rows == 3 && r.cols == 3) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) motion.rotation(i, j) = r.at<double>(i, j);
    const Matrix3 nearest = nearest_rotation(motion.rotation);
    if (!((nearest - motion.rotation).cwiseAbs().maxCoeff() < 1e-3))
      throw InputError(
          fmt::format("{}: R is no rotation (its columns are not of length 1 and square to each other).", files));
    motion.rotation = nearest;
  } else {
    throw InputError(
        fmt::format("{}: R is {} x {}; expected a 3 x 3 rotation or a rotation vector.", files, r.rows, r.cols));
  }
  for (int i = 0; i < 3; ++i) motion.translation[i] = t.at<double>(i);
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
  require(found.translation.has_value() && found.translation->total() == 3, "translation T between the cameras");
  StereoRig rig;
  rig.left = camera_of(*found.camera[0], found.distortion[0], "left", found, names);
  rig.right = camera_of(*found.camera[1], found.distortion[1], "right", found, names);
  rig.right_from_left = right_from_left_of(found, names, notes);
  return rig;
}

}  // namespace handsight
