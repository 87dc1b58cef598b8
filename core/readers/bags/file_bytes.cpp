// SPDX-License-Identifier: Apache-2.0
#include "readers/bags/file_bytes.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace handsight {

FileBytes::FileBytes(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::file_size(file, error);
  if (!stream_ || error)
    throw InputError(message("{}: the file cannot be read; is it there, and may you read it?", shown_path(file)));
}

std::string_view FileBytes::view(std::uint64_t offset, std::uint64_t count) {
  constexpr std::uint64_t least = 1 << 20;
  count = offset < size_ ? std::min(count, size_ - offset) : 0;
  if (offset < begin_ || offset + count > begin_ + window_.size()) {
    window_.resize(std::min(std::max(count, least), size_ - std::min(offset, size_)));
    if (window_.capacity() > 4 * window_.size() + least) window_.shrink_to_fit();  // after one huge record
    begin_ = offset;
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(window_.data(), static_cast<std::streamsize>(window_.size()));
    window_.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream_.gcount(), 0)));
  }
  const std::uint64_t skipped = std::min<std::uint64_t>(offset - begin_, window_.size());
  return std::string_view(window_).substr(skipped, count);
}

}  // namespace handsight
