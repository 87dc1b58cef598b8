// SPDX-License-Identifier: Apache-2.0
// What the module handsight_image_codec offers: OpenCV's readers and writers of image files. It is loaded when the
// first image is read or written, because more than a hundred libraries hang on it, which take longer to load than many
// a command takes to run.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace handsight {

struct ImageCodec {
  /// The image in these bytes with its own channels and depth, not turned by what EXIF says; empty where it is none.
  cv::Mat (*decode)(const std::string& bytes);

  /// The bytes of a strongly compressed PNG of an 8 bit image; empty where it cannot be encoded.
  std::vector<std::uint8_t> (*encode_png)(const cv::Mat& image);
};

}  // namespace handsight

/// The module's one symbol.
extern "C" const handsight::ImageCodec* handsight_image_codec();
