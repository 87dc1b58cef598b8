// SPDX-License-Identifier: Apache-2.0
#include "live/image_arrival.h"

#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "vision/image/image_file.h"
#include "vision/image/image_header.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds patience{2000};

/// Header and length are looked at first: they cost next to nothing, and nearly all that is half written fails there.
Message fault_of(const fs::path& file, const Camera& camera) {
  const auto set_aside = [&](const Message& why) {
    return message("{} is set aside until it is written again: {}.", file.filename().string(), why);
  };
  try {
    const std::string bytes = read_file(file);
    if (is_cut_off(bytes)) return set_aside(message("it is cut off after {} bytes", bytes.size()));
    const auto size = image_size(bytes);
    if (size && (size->width != camera.width || size->height != camera.height))
      return set_aside(
          message("it is {} x {}, the camera says {} x {}", size->width, size->height, camera.width, camera.height));
    read_image(file);
  } catch (const InputError& error) {
    return error.sentence();
  }
  return {};
}

}  // namespace

void ImageArrival::begin_look() {
  before_ = std::exchange(stamps_, {});
  now_ = std::chrono::steady_clock::now();
}

void ImageArrival::look_at(const fs::path& file) {
  std::error_code error;
  Stamp stamp{fs::file_size(file, error), fs::last_write_time(file, error), now_};
  const auto known = before_.find(file.string());
  if (known != before_.end() && known->second.size == stamp.size && known->second.written == stamp.written) {
    stamp = std::move(known->second);
    stamp.is_as_before = true;
  }
  stamps_[file.string()] = std::move(stamp);
}

std::chrono::milliseconds ImageArrival::age(const Stamp& stamp) const {
  return std::chrono::duration_cast<std::chrono::milliseconds>(now_ - stamp.since);
}

bool ImageArrival::may_be_opened(const fs::path& file) const { return !settles_in_ || is_overdue(file); }

bool ImageArrival::is_overdue(const fs::path& file) const {
  const Stamp& stamp = stamps_.at(file.string());
  return stamp.is_as_before && age(stamp) >= settles_in_.value_or(patience);
}

const Message& ImageArrival::fault(const fs::path& file, const Camera& camera) {
  Stamp& stamp = stamps_.at(file.string());
  if (!stamp.is_last_word) {
    stamp.fault = fault_of(file, camera);
    // Clocks of files are coarse: what is written fast may look as it did before.
    stamp.is_last_word = stamp.fault->empty() || is_overdue(file);
  }
  return *stamp.fault;
}

}  // namespace handsight
