// SPDX-License-Identifier: Apache-2.0
// A look over an XML text before it is parsed: what would cost far more memory or time than any of the formats needs.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "base/error.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {
namespace {

constexpr std::size_t largest_text = std::size_t{512} << 20;  // bytes
constexpr std::size_t most_attributes = 300;                  // of one element: they are compared with each other
constexpr std::size_t parts_always = 200'000;                 // elements and attributes of a text of any size
constexpr std::size_t bytes_a_part = 10;                      // beyond them: a part of the formats is longer
constexpr std::size_t most_parts = 10'000'000;                // about 1 GB once parsed

/// The number of "#65" or "#x41", 0x110000 for one that is larger than any character.
std::optional<unsigned> number_of_reference(std::string_view name) {
  if (!name.starts_with("#")) return std::nullopt;
  const bool is_hexadecimal = name.starts_with("#x");
  const std::string_view digits = name.substr(is_hexadecimal ? 2 : 1);
  unsigned value = 0;
  const auto [stopped, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, is_hexadecimal ? 16 : 10);
  if (digits.empty() || stopped != digits.data() + digits.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return 0x110000;
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

/// Walks over a text, knowing its line.
class Walk {
 public:
  Walk(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  bool at_end() const { return place_ >= text_.size(); }
  std::string_view rest() const { return text_.substr(place_); }
  char here() const { return text_[place_]; }

  void go(std::size_t bytes) {
    for (; bytes > 0 && !at_end(); --bytes, ++place_) line_ += text_[place_] == '\n';
  }
  /// Behind the next `end`, or to the text's end.
  void go_behind(std::string_view end) {
    const std::size_t found = rest().find(end);
    go(found == std::string_view::npos ? rest().size() : found + end.size());
  }
  [[noreturn]] void stop(const Message& sentence) const { refuse(file_, line_, sentence); }

  void count_part() {
    if (++parts_ > std::min(most_parts, parts_always + text_.size() / bytes_a_part))
      stop(
          message("the file holds more than {} elements and attributes, expected at most {} and one for each {} "
                  "bytes.",
                  parts_ - 1, parts_always, bytes_a_part));
  }
  /// A reference that is none would be read as some other byte, and half of a character could not be read back; &#0;
  /// would end a text where a program reads it, and let one name pass for another.
  void check_reference() const {
    std::string_view name = rest().substr(1, 40);
    const std::size_t end = name.find(';');
    name = name.substr(0, end == std::string_view::npos ? 0 : end);
    static constexpr std::array<std::string_view, 5> names{"lt", "gt", "amp", "quot", "apos"};
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    const auto value = number_of_reference(name);
    if (!value) stop("'&' stands alone, expected &amp; for the character itself.");
    if (*value == 0) stop("the reference &#0; stands for a zero byte, expected text.");
    if (*value > 0x10FFFF || (*value >= 0xD800 && *value < 0xE000))
      stop(message("the reference &{}; stands for no character, expected text.", name));
  }

 private:
  std::string_view text_, file_;
  std::size_t place_ = 0, parts_ = 0;
  int line_ = 1;
};

/// From '<' to behind '>'.
void walk_over_tag(Walk& walk) {
  std::size_t attributes = 0;
  char quote = 0;
  walk.count_part();
  for (walk.go(1); !walk.at_end(); walk.go(1)) {
    const char c = walk.here();
    if (quote != 0) {
      if (c == '&') walk.check_reference();
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
      walk.count_part();
      if (++attributes > most_attributes)
        walk.stop(message("an element has more than {} attributes, expected far fewer.", most_attributes));
    } else if (c == '>') {
      return walk.go(1);
    }
  }
}

}  // namespace

void check_xml_limits(std::string_view text, std::string_view file) {
  if (text.size() > largest_text)
    refuse(file, 0, message("the file has {} MB, expected at most {}.", text.size() >> 20, largest_text >> 20));
  Walk walk(text, file);
  while (!walk.at_end()) {
    if (walk.here() == '&') walk.check_reference();
    if (walk.here() != '<') {
      walk.go(1);
    } else if (walk.rest().starts_with("<!--")) {
      walk.go_behind("-->");
    } else if (walk.rest().starts_with("<![CDATA[")) {
      walk.go_behind("]]>");
    } else if (walk.rest().starts_with("<?")) {
      walk.go_behind("?>");
    } else if (walk.rest().starts_with("</")) {
      walk.go_behind(">");
    } else {
      walk_over_tag(walk);
    }
  }
}

}  // namespace handsight
