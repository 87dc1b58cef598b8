// SPDX-License-Identifier: Apache-2.0
// Texts of files: in UTF-8, whatever saved them, and how they begin.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handsight {

/// UTF-16 with its mark as UTF-8 (spreadsheets' "Unicode text", what PowerShell writes behind ">"); others as they are.
std::string plain_text(std::string text);

/// The first line of a text that is no remark.
std::string_view first_line(std::string_view text);

/// Does it begin as YAML does, "name: value" or "- value"?
bool looks_like_yaml(std::string_view text);

/// The plain text of a file. InputError where it cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace handsight
