// SPDX-License-Identifier: Apache-2.0
// Calibrations of cameras as OpenCV writes them (cv::FileStorage: YAML, XML or JSON).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "camera/rig.h"

namespace handsight {

/// A file's text and what sentences call it.
struct StereoCalibrationText {
  std::string text, file;
};

/// The rig from one file, or from intrinsics and extrinsics in several: camera matrices (M1 M2, K1 K2,
/// cameraMatrix1 ...), distortion (D1 D2, distCoeffs1 ...: k1 k2 p1 p2 k3), R and T of X_right = R X_left + T, and the
/// image size where it is written (0 where it is not). A T longer than 5 is taken for millimetres, with a sentence in
/// `notes`. InputError where something is missing or no camera of this model.
StereoRig read_stereo_calibration(const std::vector<std::filesystem::path>& files,
                                  std::vector<Message>* notes = nullptr);
StereoRig parse_stereo_calibration(const std::vector<StereoCalibrationText>& texts,
                                   std::vector<Message>* notes = nullptr);

/// The rig of one to eight cameras from what `rig_yaml` and OpenCV write: M1 D1 image_width image_height (of one camera
/// also camera_matrix, cameraMatrix, K or mtx, and distortion_coefficients, distCoeffs, D or dist), M2 D2 R T, and for
/// more R_3 T_3 ..., of X_k = R X_1 + T. D holds 4 or 5 of Brown's numbers, 8 with the rational terms, or the 4 of a
/// fisheye where `lens_model_k` says so. Names are those of camera_name_k; of two cameras left and right. Pairs of
/// other names as `read_stereo_calibration` has it.
Rig read_rig_calibration(const std::vector<std::filesystem::path>& files, std::vector<Message>* notes = nullptr);
Rig parse_rig_calibration(const std::vector<StereoCalibrationText>& texts, std::vector<Message>* notes = nullptr);

}  // namespace handsight
