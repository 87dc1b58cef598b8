// SPDX-License-Identifier: Apache-2.0
#include "codec/image_codec.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <mutex>
#include <opencv2/imgcodecs.hpp>

namespace handsight {
namespace {

/// What the image libraries print themselves has no place on standard error: a file that cannot be read becomes a
/// sentence. (libpng and libtiff write to the descriptor, whatever OpenCV is told.)
class QuietErrors {
 public:
  QuietErrors() : lock_(mutex()), kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
    std::fflush(stderr);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    if (kept_ >= 0) ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~QuietErrors() {
    std::fflush(stderr);
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  std::scoped_lock<std::mutex> lock_;
  int kept_;
};

cv::Mat decode(const std::string& bytes) {
  const QuietErrors quiet;
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
  try {
    // The camera's numbers hold for the sensor's pixels: an image is not turned by what its EXIF block says.
    return cv::imdecode(buffer, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const std::exception&) {
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
