// SPDX-License-Identifier: Apache-2.0
// Files that are not read, named for what they are.
#pragma once

#include <filesystem>
#include <string_view>

namespace handsight {

/// InputError where the file begins as one of a kind that is known and not read: the sentence says what it is and the
/// command or the way that makes of it what is. `begin`: its first bytes, 32 at least where it is longer.
void refuse_foreign_file(const std::filesystem::path& path, std::string_view begin);

}  // namespace handsight
