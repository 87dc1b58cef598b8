// SPDX-License-Identifier: Apache-2.0
// Whole files in and out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace handsight {

/// The bytes of a whole file, of at most 1 GiB. InputError where it cannot be read, and where it is no regular file: a
/// pipe or a device may never end.
std::string read_file(const std::filesystem::path& path);

/// Replaces (or makes) a file whole: a temporary file in the same folder is written, flushed to the disk and
/// renamed, so that readers see the old content or the new one. Keeps the old file's permissions; follows
/// symbolic links. Where it fails the old file stays as it was and InputError says why; so it does where what is there
/// is no regular file, or write protected. Removes what a killed run has left in the folder.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// What a file held, in a few bytes.
struct FileDigest {
  std::uint64_t size = 0, first = 0, second = 0;
  bool operator==(const FileDigest&) const = default;
};
FileDigest digest_of_content(std::string_view content);

/// Of the file as it is now; nothing where there is none. InputError where it cannot be read.
std::optional<FileDigest> compute_digest(const std::filesystem::path& path);

/// As replace_file, but only where the file still holds what it did; InputError where another program has changed or
/// removed it since. Two programs that use this one after another, or at once, never lose what either has written.
void replace_unchanged_file(const std::filesystem::path& path, std::string_view content, const FileDigest& expected);

/// An empty new folder inside `parent` to make something in that is then renamed. What killed runs have left of such
/// folders is removed. InputError where it cannot be made.
std::filesystem::path make_temporary_folder(const std::filesystem::path& parent);

}  // namespace handsight
