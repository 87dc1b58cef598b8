// SPDX-License-Identifier: Apache-2.0
// Sentences for people: shortened quotations, UTF-8, and refusals that stay between 20 and 600 characters.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "base/message.h"

namespace handsight {

/// Bytes at the text's start that are valid UTF-8 (no overlong forms, no surrogates); all of them for a good
/// text.
std::size_t utf8_length(std::string_view text);
bool is_utf8(std::string_view text);

/// The text with every byte that is not part of valid UTF-8 read as Latin-1.
std::string utf8_or_latin1(std::string_view text);

/// The text on one line of printable UTF-8, of at most `most` bytes; what is left out is written as "...",
/// bytes that cannot be shown as '?'.
std::string shortened(std::string_view text, std::size_t most = 60);

/// The whole text as a terminal may show it: control characters but for line ends and tabs, and bytes that are not
/// UTF-8, as '?', so that no title or name can steer the terminal.
std::string printable(std::string_view text);

/// `shortened` in double quotes.
std::string in_quotes(std::string_view text, std::size_t most = 60);

/// The message itself where its English has at most so many bytes, else that, shortened.
Message at_most(const Message& message, std::size_t most = 60);

/// What the system says of an error (`errno`, or that of a library), to be translated: "No such file or directory".
Message system_text(int error);
Message system_text(const std::error_code& error);

/// A path to show: whole where short, else its end.
std::string shown_path(const std::filesystem::path& path);

/// Throws InputError "FILE, line LINE: SENTENCE" (line 0: none is named), kept within 600 characters.
[[noreturn]] void refuse(std::string_view file, int line, const Message& sentence);

}  // namespace handsight
