// SPDX-License-Identifier: Apache-2.0
#include "codec/image_codec.h"

#include <opencv2/imgcodecs.hpp>

namespace handsight {
namespace {

cv::Mat decode(const std::string& bytes) {
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
  try {
    // The camera's numbers hold for the sensor's pixels: an image is not turned by what its EXIF block says.
    return cv::imdecode(buffer, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    return {};
  }
}

std::vector<std::uint8_t> encode_png(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  try {
    if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 9})) bytes.clear();
  } catch (const cv::Exception&) {
    bytes.clear();
  }
  return bytes;
}

}  // namespace
}  // namespace handsight

const handsight::ImageCodec* handsight_image_codec() {
  static const handsight::ImageCodec codec{handsight::decode, handsight::encode_png};
  return &codec;
}
