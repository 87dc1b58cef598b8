// SPDX-License-Identifier: Apache-2.0
// What the names of images and of their folders say: when an image was taken, and by which camera.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace handsight {

/// A date with its time of day, or seconds since 1970 with their fraction, in a name.
struct NamedMoment {
  std::int64_t number = 0;         // grows with time
  std::size_t begin = 0, end = 0;  // where it stands in the name
};

/// That of "shot_2024-07-23_16-02-40", "img_20240723_160240123" or "1305031102.175304"; nothing where a name has none.
std::optional<NamedMoment> moment_in_name(const std::string& name);

/// A name for each folder by which it can be distinguished from the others: its own, or that of the nearest folder
/// above in which they differ ("cam0" of cam0/data beside cam1/data).
std::vector<std::string> telling_names(const std::vector<std::filesystem::path>& folders);

}  // namespace handsight
