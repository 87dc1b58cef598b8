// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <algorithm>

#include "base/error.h"

namespace handsight {

namespace {

/// Bytes of the valid UTF-8 character at the start of `text`; 0 where there is none. RFC 3629.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const unsigned char second = byte(1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return length;
}

/// Of a terminal: C0, DEL and C1 (U+0080 to U+009F).
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  std::size_t good = 0;
  while (good < text.size()) {
    const std::size_t length = character_length(text.substr(good));
    if (length == 0) return good;
    good += length;
  }
  return good;
}

bool is_utf8(std::string_view text) { return utf8_length(text) == text.size(); }

std::string utf8_or_latin1(std::string_view text) {
  std::string good;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    good += text.substr(0, length);
    text.remove_prefix(length);
    if (text.empty()) break;
    const auto byte = static_cast<unsigned char>(text[0]);
    good += static_cast<char>(0xC0 | (byte >> 6));
    good += static_cast<char>(0x80 | (byte & 0x3F));
    text.remove_prefix(1);
  }
  return good;
}

std::string shortened(std::string_view text, std::size_t most) {
  const bool whole = text.size() <= most;
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    std::string character = length == 0 ? "?" : std::string(text.substr(0, length));
    if (is_control(character)) character = " ";
    if (!whole && shown.size() + character.size() + 3 > most) return shown + "...";
    shown += character;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, length);
    if (length == 0 || (is_control(character) && character != "\n" && character != "\t"))
      shown += '?';
    else
      shown += character;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

std::string in_quotes(std::string_view text, std::size_t most) { return '"' + shortened(text, most) + '"'; }

std::string shown_path(const std::filesystem::path& path) {
  constexpr std::size_t most = 200;
  const std::string whole = path.string();
  if (whole.size() <= most) return shortened(whole, most);
  std::string_view end = std::string_view(whole).substr(whole.size() - (most - 3));
  while (!end.empty() && (static_cast<unsigned char>(end[0]) & 0xC0) == 0x80) end.remove_prefix(1);
  return "..." + shortened(end, most);
}

Message at_most(const Message& message, std::size_t most) {
  const std::string english = message.english();
  return english.size() <= most ? message : verbatim(shortened(english, most));
}

Message system_text(int error) { return {Message::Kind::form, std::generic_category().message(error)}; }

Message system_text(const std::error_code& error) { return {Message::Kind::form, error.message()}; }

void refuse(std::string_view file, int line, const Message& sentence) {
  const std::string name = shortened(file, 80), shown = shortened(sentence.english(), 480);
  const Message whole = line > 0 ? message("{}, line {}: {}", name, line, sentence) : message("{}: {}", name, sentence);
  throw InputError(whole, line > 0 ? fmt::format("{}, line {}: {}", name, line, shown) : name + ": " + shown);
}

}  // namespace handsight
