// SPDX-License-Identifier: Apache-2.0
// Files that are read in pieces, and the numbers in them (little endian).
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace handsight {

/// A file of which a window is in memory.
class FileBytes {
 public:
  explicit FileBytes(const std::filesystem::path& file);
  std::uint64_t size() const { return size_; }

  /// Bytes from `offset` on, fewer than `count` at the file's end; they hold until the next call.
  std::string_view view(std::uint64_t offset, std::uint64_t count);

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0, begin_ = 0;
  std::string window_;
};

/// Takes numbers and texts from the front of a record. From where the record ends too early on they are 0 and empty,
/// and `ended` is true.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : left_(bytes) {}

  template <class T>
  T number() {
    T value{};
    const std::string_view raw = bytes(sizeof(T));
    if (!ended) std::memcpy(&value, raw.data(), sizeof(T));  // x86-64 is little endian, too
    return value;
  }

  std::string_view bytes(std::uint64_t count) {
    ended = ended || count > left_.size();
    if (ended) return {};
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

  /// With its length (32 bit) before it.
  std::string_view text() { return bytes(number<std::uint32_t>()); }

  std::string_view left() const { return left_; }
  bool more() const { return !ended && !left_.empty(); }

  bool ended = false;

 private:
  std::string_view left_;
};

}  // namespace handsight
