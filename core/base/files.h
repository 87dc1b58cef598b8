// SPDX-License-Identifier: Apache-2.0
// Whole files in and out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handsight {

/// The bytes of a whole file, of at most 1 GiB. InputError where it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Replaces (or makes) a file whole: a temporary file in the same folder is written, flushed to the disk and
/// renamed, so that readers see the old content or the new one. Keeps the old file's permissions; follows
/// symbolic links. Where it fails the old file stays as it was and InputError says why.
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace handsight
