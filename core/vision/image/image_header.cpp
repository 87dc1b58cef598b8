// SPDX-License-Identifier: Apache-2.0
#include "vision/image/image_header.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace handsight {
namespace {

/// An unsigned number of so many bytes; nothing beyond the end.
std::optional<std::int64_t> number_at(std::string_view bytes, std::size_t place, std::size_t count, bool big_endian) {
  if (place > bytes.size() || bytes.size() - place < count) return std::nullopt;
  std::int64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = place + (big_endian ? i : count - 1 - i);
    number = number << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return number;
}

std::optional<ImageSize> measure_size(std::optional<std::int64_t> width, std::optional<std::int64_t> height) {
  if (!width || !height || *width <= 0 || *height <= 0) return std::nullopt;
  return ImageSize{*width, *height};
}

/// The first frame header among the segments.
std::optional<ImageSize> jpeg_size(std::string_view bytes) {
  for (std::size_t place = 2; place + 4 <= bytes.size();) {
    if (static_cast<unsigned char>(bytes[place]) != 0xff) return std::nullopt;
    const auto marker = static_cast<unsigned char>(bytes[place + 1]);
    const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) return measure_size(number_at(bytes, place + 7, 2, true), number_at(bytes, place + 5, 2, true));
    if (marker == 0xff) {
      ++place;  // a filling byte
    } else if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
      place += 2;  // a marker without a segment
    } else {
      place += 2 + static_cast<std::size_t>(std::max<std::int64_t>(*number_at(bytes, place + 2, 2, true), 2));
    }
  }
  return std::nullopt;
}

std::optional<ImageSize> portable_size(std::string_view bytes) {
  std::size_t place = 2;
  std::int64_t numbers[2] = {0, 0};
  for (std::int64_t& number : numbers) {
    while (place < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[place])) || bytes[place] == '#')) {
      if (bytes[place] == '#') place = std::min(bytes.find('\n', place), bytes.size() - 1);
      ++place;
    }
    for (int digits = 0; digits < 10 && place < bytes.size() && bytes[place] >= '0' && bytes[place] <= '9'; ++digits)
      number = 10 * number + (bytes[place++] - '0');
  }
  return measure_size(numbers[0], numbers[1]);
}

std::optional<ImageSize> bitmap_size(std::string_view bytes) {
  const auto header = number_at(bytes, 14, 4, false);
  if (header == 12) return measure_size(number_at(bytes, 18, 2, false), number_at(bytes, 20, 2, false));
  const auto width = number_at(bytes, 18, 4, false), height = number_at(bytes, 22, 4, false);
  if (!width || !height) return std::nullopt;
  return measure_size(width,
                      std::abs(static_cast<std::int64_t>(static_cast<std::int32_t>(*height))));  // negative: top down
}

/// Tags 256 and 257 of the first directory.
std::optional<ImageSize> tiff_size(std::string_view bytes, bool big_endian) {
  const auto directory = number_at(bytes, 4, 4, big_endian);
  if (!directory) return std::nullopt;
  const auto count = number_at(bytes, static_cast<std::size_t>(*directory), 2, big_endian);
  std::optional<std::int64_t> width, height;
  for (std::int64_t i = 0; count && i < *count; ++i) {
    const auto place = static_cast<std::size_t>(*directory + 2 + 12 * i);
    const auto tag = number_at(bytes, place, 2, big_endian), kind = number_at(bytes, place + 2, 2, big_endian);
    if (!tag || !kind) return std::nullopt;
    const auto value = number_at(bytes, place + 8, kind == 3 ? 2 : 4, big_endian);
    if (tag == 256) width = value;
    if (tag == 257) height = value;
  }
  return measure_size(width, height);
}

/// Its first chunk: with a canvas (VP8X), lossless (VP8L), or a key frame of VP8.
std::optional<ImageSize> webp_size(std::string_view bytes) {
  const std::string_view chunk = bytes.substr(12, 4);
  const auto number = [&](std::size_t place, std::size_t count) { return number_at(bytes, place, count, false); };
  if (chunk == "VP8X") {
    const auto width = number(24, 3), height = number(27, 3);
    return width && height ? measure_size(*width + 1, *height + 1) : std::nullopt;
  }
  if (chunk == "VP8L") {
    const auto both = number(21, 4);
    return both ? measure_size((*both & 0x3fff) + 1, (*both >> 14 & 0x3fff) + 1) : std::nullopt;
  }
  const auto width = number(26, 2), height = number(28, 2);
  return chunk == "VP8 " && width && height ? measure_size(*width & 0x3fff, *height & 0x3fff) : std::nullopt;
}

}  // namespace

std::optional<ImageSize> image_size(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv))
    return measure_size(number_at(bytes, 16, 4, true), number_at(bytes, 20, 4, true));
  if (bytes.starts_with("\xff\xd8"sv)) return jpeg_size(bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') return portable_size(bytes);
  if (bytes.starts_with("BM"sv)) return bitmap_size(bytes);
  if (bytes.size() > 16 && bytes.starts_with("RIFF"sv) && bytes.substr(8, 4) == "WEBP") return webp_size(bytes);
  if (bytes.starts_with("II*\0"sv)) return tiff_size(bytes, false);
  if (bytes.starts_with("MM\0*"sv)) return tiff_size(bytes, true);
  return std::nullopt;
}

}  // namespace handsight
