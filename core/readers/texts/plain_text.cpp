// SPDX-License-Identifier: Apache-2.0
#include "readers/texts/plain_text.h"

#include <algorithm>
#include <cstdint>

#include "base/files.h"

namespace handsight {
namespace {

void append_utf8(std::string& out, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xC0 | c >> 6);
    put(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    put(0xE0 | c >> 12);
    put(0x80 | (c >> 6 & 0x3F));
    put(0x80 | (c & 0x3F));
  } else {
    put(0xF0 | c >> 18);
    put(0x80 | (c >> 12 & 0x3F));
    put(0x80 | (c >> 6 & 0x3F));
    put(0x80 | (c & 0x3F));
  }
}

}  // namespace

std::string plain_text(std::string text) {
  const bool is_little = text.starts_with("\xFF\xFE"), is_big = text.starts_with("\xFE\xFF");
  if (!is_little && !is_big) return text;
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]), second = static_cast<unsigned char>(text[at + 1]);
    return static_cast<std::uint32_t>(is_little ? first | second << 8 : first << 8 | second);
  };
  std::string out;
  for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
    std::uint32_t c = unit(at);
    const bool is_first_half = c >= 0xD800 && c < 0xDC00;
    if (is_first_half && at + 3 < text.size()) {
      c = 0x10000 + ((c - 0xD800) << 10) + ((unit(at + 2) - 0xDC00) & 0x3FF);
      at += 2;
    }
    append_utf8(out, c);
  }
  return out;
}

std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (!line.empty() && line.front() != '#' && line != "---") return line;
  }
  return {};
}

bool looks_like_yaml(std::string_view text) {
  const std::string_view line = first_line(text);
  return line.starts_with("- ") || line.starts_with("[") || line.ends_with(":") ||
         (line.find(": ") != std::string_view::npos && line.find_first_of(",;\t") == std::string_view::npos) ||
         (line.find(": ") != std::string_view::npos && line.find('[') != std::string_view::npos);
}

std::string read_text(const std::filesystem::path& file) { return plain_text(read_file(file)); }

}  // namespace handsight
