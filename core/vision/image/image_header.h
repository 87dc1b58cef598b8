// SPDX-License-Identifier: Apache-2.0
// What an image file says of itself before anything of it is decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace handsight {

struct ImageSize {
  std::int64_t width = 0, height = 0;  // px
};

/// By the header of a PNG, JPEG, PNM (P1 to P6), BMP, TIFF or WebP file; nothing where it is none of them, or is broken
/// off.
std::optional<ImageSize> image_size(std::string_view bytes);

}  // namespace handsight
