// SPDX-License-Identifier: Apache-2.0
// What bags are compressed with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/message.h"

namespace handsight {

enum class Compression { none, zstd, lz4, bz2 };  // lz4: its frame format, which MCAP and ROS 1 use

struct Decompressed {
  std::string bytes;  // as far as they could be had
  Message fault;      // why not further; empty: they are whole
};

/// At most `most` bytes; more of them is a fault, too.
Decompressed decompressed(Compression compression, std::string_view bytes, std::size_t most);

/// Do the bytes begin as zstd's frames do?
bool begins_as_zstd(std::string_view bytes);

/// A zstd file into another, piece by piece; returns why it did not come to its end, empty where it did. InputError
/// where the new file cannot be written.
Message decompress_file(const std::filesystem::path& from, const std::filesystem::path& into);

/// CRC-32 as zip and MCAP have it, of these bytes after those whose sum is `before`.
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace handsight
