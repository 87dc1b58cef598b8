// SPDX-License-Identifier: Apache-2.0
#include "vision/image/image_file.h"

#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "codec/image_codec.h"
#include "vision/image/image_header.h"

namespace handsight {
namespace {

bool starts_with(const std::string& bytes, std::string_view start) {
  return std::string_view(bytes).substr(0, start.size()) == start;
}

std::size_t byte_at(const std::string& bytes, std::size_t place) {
  return place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0;
}

/// Where a JPEG's picture begins: behind the segments, of which EXIF may hold a thumbnail with an end of its own.
std::size_t start_of_scan(const std::string& bytes) {
  std::size_t place = 2;
  while (place + 4 <= bytes.size() && byte_at(bytes, place) == 0xff && byte_at(bytes, place + 1) != 0xda)
    place += byte_at(bytes, place + 1) == 0xff ? 1 : 2 + 256 * byte_at(bytes, place + 2) + byte_at(bytes, place + 3);
  return place;
}

/// Bytes that a binary PGM or PPM must have by its header; 0 where the header is not understood.
std::size_t portable_size(const std::string& bytes) {
  std::size_t place = 2, numbers[3] = {0, 0, 0};
  for (std::size_t& number : numbers) {
    while (place < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[place])) || bytes[place] == '#')) {
      if (bytes[place] == '#') place = std::min(bytes.find('\n', place), bytes.size() - 1);
      ++place;
    }
    for (int digits = 0; digits < 6 && std::isdigit(static_cast<int>(byte_at(bytes, place))); ++digits, ++place)
      number = 10 * number + (byte_at(bytes, place) - '0');
    if (number == 0) return 0;
  }
  return place + 1 + numbers[0] * numbers[1] * (numbers[2] > 255 ? 2 : 1) * (bytes[1] == '6' ? 3 : 1);
}

Image from_mat(const cv::Mat& grey) {
  Image image(grey.cols, grey.rows);
  for (int v = 0; v < grey.rows; ++v) std::memcpy(image.row(v), grey.ptr(v), static_cast<std::size_t>(grey.cols));
  return image;
}

/// Industrial and infrared cameras use 10, 12 or 14 of an image's 16 bits: what the brightest pixel needs is the whole
/// range.
double brightest_of_16_bits(const cv::Mat& image) {
  double brightest = 0;
  cv::minMaxLoc(image.reshape(1), nullptr, &brightest);
  for (const int bits : {8, 10, 12, 14})
    if (brightest < 1 << bits) return (1 << bits) - 1;
  return 65535;
}

/// Thesis (4.1) with its own weights, rounded to the nearest grey level.
cv::Mat to_grey(const cv::Mat& any) {
  cv::Mat eight;
  if (any.depth() == CV_8U) {
    eight = any;
  } else {
    any.convertTo(eight, CV_8U, any.depth() == CV_16U ? 255 / brightest_of_16_bits(any) : 255.0);
  }
  if (eight.channels() == 1) return eight;
  cv::Mat grey;
  cv::cvtColor(eight, grey, eight.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

/// Loaded once, and kept as long as the program runs. InputError where it is not beside the program.
const ImageCodec& image_codec() {
  static const ImageCodec* const codec = [] {
    void* const module = dlopen("libhandsight_image_codec.so", RTLD_NOW | RTLD_LOCAL);
    void* const entry = module ? dlsym(module, "handsight_image_codec") : nullptr;
    if (!entry)
      throw InputError(message("The reader of image files cannot be loaded: {}; build Handsight again.", dlerror()));
    return reinterpret_cast<decltype(&handsight_image_codec)>(entry)();
  }();
  return *codec;
}

}  // namespace

bool is_cut_off(const std::string& bytes) {
  const std::string_view all(bytes);
  if (starts_with(bytes, "\x89PNG")) {
    const std::size_t end = all.rfind("IEND");
    return end == std::string_view::npos || end + 8 > all.size();  // a checksum follows
  }
  if (starts_with(bytes, "\xff\xd8")) return all.find("\xff\xd9", start_of_scan(bytes)) == std::string_view::npos;
  if (starts_with(bytes, "P5") || starts_with(bytes, "P6")) return bytes.size() < portable_size(bytes);
  const auto little_endian = [&](std::size_t place) {
    return byte_at(bytes, place) + (byte_at(bytes, place + 1) << 8) + (byte_at(bytes, place + 2) << 16) +
           (byte_at(bytes, place + 3) << 24);
  };
  if (starts_with(bytes, "RIFF")) return bytes.size() < 8 + little_endian(4);
  if (starts_with(bytes, "BM")) return bytes.size() < little_endian(2);
  return false;
}

namespace {

void require_size(const ImageSize& size, const Camera& camera, const std::string& name) {
  if (size.width == camera.width && size.height == camera.height) return;
  throw InputError(
      message("{} is {} x {}, the camera says {} x {}; use the images that the camera was calibrated with.",
              shown_path(name), size.width, size.height, camera.width, camera.height));
}

/// `camera`: the one that it must be of, or null.
Image read(const std::filesystem::path& file, const Camera* camera, const std::string& name) {
  const std::string bytes = read_file(file);
  if (is_cut_off(bytes))
    throw InputError(message("{}: the image is cut off after {} bytes; copy it again from where it came.",
                             shown_path(file), bytes.size()));
  const std::optional<ImageSize> reported = image_size(bytes);
  if (reported && camera) require_size(*reported, *camera, name);
  if (reported && static_cast<double>(reported->width) * static_cast<double>(reported->height) > bounds::most_pixels)
    throw InputError(message("{}: the image says that it has {} x {} pixels; at most {:g} million are read.",
                             shown_path(file), reported->width, reported->height, 1e-6 * bounds::most_pixels));
  const cv::Mat decoded = reported ? image_codec().decode(bytes) : cv::Mat();
  if (decoded.empty())
    throw InputError(message("{}: is no image that can be read ({} bytes); PNG, JPEG, PGM, BMP, TIFF and WebP can.",
                             shown_path(file), bytes.size()));
  Image image = from_mat(to_grey(decoded));
  if (camera) check_image_size(image, *camera, name);
  return image;
}

}  // namespace

Image read_image(const std::filesystem::path& file) { return read(file, nullptr, {}); }

Image read_image(const std::filesystem::path& file, const Camera& camera, const std::string& name) {
  return read(file, &camera, name);
}

void check_image_size(const Image& image, const Camera& camera, const std::string& name) {
  require_size({image.width, image.height}, camera, name);
}

std::string encoded_png(const Image& image) {
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  const std::vector<std::uint8_t> bytes = image_codec().encode_png(grey);
  if (bytes.empty())
    throw InputError(message("The image of {} x {} could not be encoded as PNG.", image.width, image.height));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_png(const Image& image, const std::filesystem::path& file) { replace_file(file, encoded_png(image)); }

}  // namespace handsight
