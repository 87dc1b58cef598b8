// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace handsight {
namespace {

TEST(Utf8, GoodAndBad) {
  for (const char* text : {"", "plain",
                           "Gr\xC3\xBC\xC3\x9F"
                           "e",
                           "\xE6\x97\xA5\xE6\x9C\xAC", "\xF0\x9F\xA4\x96"})
    EXPECT_TRUE(is_utf8(text)) << text;
  // Latin-1, cut off, overlong, surrogate, beyond the last character, a lone continuation
  for (const char* text : {"Gr\xFC\xDF"
                           "e",
                           "\xE6\x97", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"})
    EXPECT_FALSE(is_utf8(text));
  EXPECT_EQ(utf8_length("ab\xFF"
                        "cd"),
            2u);
}

TEST(Utf8, OtherBytesAreLatin1) {
  EXPECT_EQ(utf8_or_latin1("Gr\xFC\xDF"
                           "e \xC3\xBC"),
            "Gr\xC3\xBC\xC3\x9F"
            "e \xC3\xBC");
}

TEST(Shortened, StaysWholeWhereItFits) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(in_quotes("abc"), "\"abc\"");
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("abcdefgh", 6), "abc...");
  const std::string umlauts = shortened("\xC3\xBC\xC3\xBC\xC3\xBC\xC3\xBC\xC3\xBC", 8);
  EXPECT_EQ(umlauts, "\xC3\xBC\xC3\xBC...");
}

TEST(Shortened, IsOneLineOfUtf8) {
  EXPECT_EQ(shortened("a\nb\tc\xFF", 20), "a b c?");
  EXPECT_TRUE(is_utf8(shortened(std::string(1000, '\x80'), 60)));
}

TEST(ShownPath, KeepsTheEndOfALongOne) {
  const std::string shown = shown_path(std::string(5000, 'x') + "/session.xml");
  EXPECT_LE(shown.size(), 200u);
  EXPECT_TRUE(shown.starts_with("..."));
  EXPECT_TRUE(shown.ends_with("/session.xml"));
}

TEST(Refuse, SentencesStayShort) {
  const std::string long_text(100000, 'x');
  try {
    refuse(long_text, 12, verbatim(long_text));
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_GE(sentence.size(), 20u);
    EXPECT_LE(sentence.size(), 600u);
    EXPECT_NE(sentence.find(", line 12: "), std::string::npos);
  }
}

}  // namespace
}  // namespace handsight
