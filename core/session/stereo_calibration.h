// SPDX-License-Identifier: Apache-2.0
// Stereo calibrations as OpenCV writes them (cv::FileStorage: YAML, XML or JSON).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "camera/camera.h"

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
                                  std::vector<std::string>* notes = nullptr);
StereoRig parse_stereo_calibration(const std::vector<StereoCalibrationText>& texts,
                                   std::vector<std::string>* notes = nullptr);

}  // namespace handsight
