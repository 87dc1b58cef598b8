// SPDX-License-Identifier: Apache-2.0
// Whatever an image file begins with: its header tells a size above nothing, or nothing.
#include "fuzz.h"
#include "vision/image/image_header.cpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto reported = handsight::image_size({reinterpret_cast<const char*>(data), size});
  handsight::demand(!reported || (reported->width > 0 && reported->height > 0), "a size is above nothing");
  return 0;
}
