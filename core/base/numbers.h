// SPDX-License-Identifier: Apache-2.0
// Numbers as text: written so that they read back bit for bit, read strictly, whatever the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

/// The shortest text that reads back as the same double, bit for bit. The number is finite.
std::string format_number(double number);

/// The same for several, separated by spaces.
std::string format_numbers(std::span<const double> numbers);

/// One finite decimal number and nothing else; a leading '+' is allowed, "nan", "inf", hexadecimal and what
/// does not fit a double are not.
std::optional<double> parse_number(std::string_view text);

/// One decimal integer and nothing else.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// The words of a text between spaces, tabs and line ends; views into `text`.
std::vector<std::string_view> split_words(std::string_view text);

/// Finite numbers between spaces, tabs and line ends. Nothing where a word is no number; it is then put into
/// `bad_word`.
std::optional<std::vector<double>> parse_numbers(std::string_view text, std::string* bad_word = nullptr);

}  // namespace handsight
