// SPDX-License-Identifier: Apache-2.0
#include "base/numbers.h"

#include <gmock/gmock.h>

#include <bit>
#include <cfloat>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"

namespace handsight {
namespace {

using testing::ElementsAre;

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

TEST(Numbers, ReadBackBitForBit) {
  std::mt19937_64 random(7);
  int tried = 0;
  while (tried < 100000) {
    const double number = std::bit_cast<double>(random());
    if (!std::isfinite(number)) continue;
    ++tried;
    const auto back = parse_number(format_number(number));
    ASSERT_TRUE(back) << format_number(number);
    ASSERT_EQ(bits(*back), bits(number)) << format_number(number);
  }
}

TEST(Numbers, SpecialNumbersReadBack) {
  for (const double number : {0.0, -0.0, DBL_MIN, DBL_MAX, -DBL_MAX, std::numeric_limits<double>::denorm_min(), 0.1,
                              1.0 / 3, 1e22, 9007199254740993.0})
    EXPECT_EQ(bits(parse_number(format_number(number)).value()), bits(number)) << number;
}

TEST(Numbers, AreShort) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(-9.81), "-9.81");
  EXPECT_EQ(format_number(3), "3");
  const double some[] = {1, 0.5, -2};
  EXPECT_EQ(format_numbers(some), "1 0.5 -2");
}

TEST(Numbers, NonFiniteAreNotWritten) {
  EXPECT_THROW(format_number(NAN), BrokenPromise);
  EXPECT_THROW(format_number(INFINITY), BrokenPromise);
}

TEST(Numbers, GarbageIsRefused) {
  for (const char* text : {"",
                           " ",
                           "nan",
                           "-nan",
                           "NaN",
                           "inf",
                           "-inf",
                           "Infinity",
                           "1e999",
                           "-1e999",
                           "0x10",
                           "1,5",
                           "1.5x",
                           "1 2",
                           "--1",
                           "+-1",
                           "++1",
                           "+",
                           "-",
                           ".",
                           "e5",
                           "1e",
                           "\xC2\xA0"
                           "1",
                           "1\n"})
    EXPECT_FALSE(parse_number(text)) << '"' << text << '"';
}

TEST(Numbers, UsualSpellingsAreRead) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1E-3"), 1e-3);
  EXPECT_EQ(parse_number("1e+3"), 1e3);
  EXPECT_EQ(parse_number("007"), 7.0);
}

TEST(Numbers, ListsNameTheirBadWord) {
  EXPECT_THAT(parse_numbers(" 1\t-2.5\r\n3e1 ").value(), ElementsAre(1, -2.5, 30));
  EXPECT_TRUE(parse_numbers("").value().empty());
  std::string bad;
  EXPECT_FALSE(parse_numbers("1 2 tree 4", &bad));
  EXPECT_EQ(bad, "tree");
}

TEST(Numbers, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool german = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const auto read = parse_number("1.5");
  const std::string written = format_number(1.5);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(read, 1.5);
  EXPECT_EQ(written, "1.5");
  if (!german) GTEST_SKIP() << "no de_DE.UTF-8 locale on this machine: tried in the C locale only";
}

TEST(Integers, AreStrict) {
  EXPECT_EQ(parse_integer("42"), 42);
  EXPECT_EQ(parse_integer("-1"), -1);
  for (const char* text : {"", "1.0", "1e3", " 1", "99999999999999999999", "0x1", "one"})
    EXPECT_FALSE(parse_integer(text)) << text;
}

}  // namespace
}  // namespace handsight
