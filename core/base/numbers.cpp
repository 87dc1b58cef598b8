// SPDX-License-Identifier: Apache-2.0
#include "base/numbers.h"

#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"

namespace handsight {

std::string format_number(double number) {
  check(std::isfinite(number), "a number to be written is not finite: {}", number);
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string format_numbers(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ' ';
    text += format_number(number);
  }
  return text;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::vector<std::string_view> split_words(std::string_view text) {
  constexpr std::string_view white = " \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(white); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(white, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(white, end);
  }
  return words;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text, std::string* bad_word) {
  std::vector<double> numbers;
  for (const std::string_view word : split_words(text)) {
    const std::optional<double> number = parse_number(word);
    if (!number) {
      if (bad_word) *bad_word = word;
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace handsight
