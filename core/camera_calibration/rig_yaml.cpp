// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "base/numbers.h"
#include "camera_calibration/camera_calibration.h"

namespace handsight {
namespace {

std::string matrix_entry(const std::string& name, int rows, int columns, const std::vector<double>& numbers) {
  std::string data;
  for (const double number : numbers) {
    std::string text = format_number(number);
    if (text.find_first_of(".e") == std::string::npos) text += '.';  // OpenCV reads a number without one as an integer
    data += (data.empty() ? "" : ", ") + text;
  }
  return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: [ {} ]\n", name, rows, columns,
                     data);
}

std::vector<double> camera_matrix(const Lens& lens) {
  const auto& n = lens.numbers;
  return {n[0], 0, n[2], 0, n[1], n[3], 0, 0, 1};
}

std::vector<double> row_by_row(const Matrix3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

}  // namespace

std::string rig_yaml(const CameraRig& rig, const std::vector<std::string>& names) {
  std::string text = "%YAML:1.0\n---\n";
  text += fmt::format("image_width: {}\nimage_height: {}\n", rig.lenses[0].width, rig.lenses[0].height);
  for (std::size_t i = 0; i < rig.lenses.size(); ++i) {
    const Lens& lens = rig.lenses[i];
    const std::vector<double> distortion(lens.numbers.begin() + 4, lens.numbers.end());
    const auto columns = static_cast<int>(distortion.size());
    std::string name;
    for (const char c : names[i]) name += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 32 ? '_' : c;
    text += fmt::format("camera_name_{}: \"{}\"\nlens_model_{}: \"{}\"\n", i + 1, name, i + 1, lens.model->name);
    if (lens.width != rig.lenses[0].width || lens.height != rig.lenses[0].height)
      text += fmt::format("image_width_{}: {}\nimage_height_{}: {}\n", i + 1, lens.width, i + 1, lens.height);
    text += matrix_entry(fmt::format("M{}", i + 1), 3, 3, camera_matrix(lens));
    text += matrix_entry(fmt::format("D{}", i + 1), 1, columns, distortion);
    if (rig.lenses.size() == 1) {
      text += matrix_entry("camera_matrix", 3, 3, camera_matrix(lens));
      text += matrix_entry("distortion_coefficients", 1, columns, distortion);
    }
    if (i == 0) continue;
    const std::string which = i == 1 ? "" : fmt::format("_{}", i + 1);
    const Rigid& motion = rig.from_first[i];
    text += matrix_entry("R" + which, 3, 3, row_by_row(motion.rotation));
    text += matrix_entry("T" + which, 3, 1, {motion.translation.x(), motion.translation.y(), motion.translation.z()});
  }
  return text;
}

}  // namespace handsight
