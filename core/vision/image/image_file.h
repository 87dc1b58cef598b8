// SPDX-License-Identifier: Apache-2.0
// Image files in and out.
#pragma once

#include <filesystem>
#include <string>

#include "camera/camera.h"
#include "vision/image/image.h"

namespace handsight {

/// Reads PNG, JPEG, PGM, BMP or TIFF as a grey image; colours by thesis (4.1), 16 bit scaled to 8. InputError where
/// the file is missing, is no image, is cut off or has more pixels than bounds::most_pixels by its header: a
/// half-decoded image would give wrong corners without a word.
Image read_image(const std::filesystem::path& file);

/// The same of an image that this camera took: one of another size is refused before it is decoded, as check_image_size
/// does.
Image read_image(const std::filesystem::path& file, const Camera& camera, const std::string& name);

/// Does an image file end before it should? Decoders fill what is missing with grey or print on their own.
bool is_cut_off(const std::string& bytes);

/// InputError where the image has another size than the camera; `name` is what the sentence calls it.
void check_image_size(const Image& image, const Camera& camera, const std::string& name);

/// The bytes of a PNG with strong compression. InputError where the image has a size that PNG has not.
std::string encoded_png(const Image& image);

/// Writes a PNG with strong compression, whole or not at all. InputError where it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace handsight
