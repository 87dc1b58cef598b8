// SPDX-License-Identifier: Apache-2.0
// Cells of tables: what is a number, what is none, what is a time; units; texts in UTF-16.
#include "readers/texts/cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "readers/table.h"
#include "readers/texts/plain_text.h"

namespace handsight {
namespace {

TEST(Cells, WhatSaysThatThereIsNothingIsNoNumber) {
  for (const char* cell : {"", "nan", "NaN", "-", "#N/A", "None", "inf", "-inf", "missing"}) {
    const auto number = cell_number(cell, false);
    ASSERT_TRUE(number) << cell;
    EXPECT_TRUE(std::isnan(*number)) << cell;
  }
  EXPECT_FALSE(cell_number("ok", false));
  EXPECT_EQ(cell_number("-1,5", true), -1.5);
}

TEST(Cells, DatesAreSecondsOfOneClock) {
  EXPECT_EQ(clock_seconds("1970-01-02T00:00:01.5Z"), 86401.5);
  EXPECT_EQ(clock_seconds("02.01.1970 00:00:01"), 86401.0);
  EXPECT_EQ(clock_seconds("1970-01-02 02:00:00+02:00"), 86400.0);
  EXPECT_EQ(clock_seconds("16:02:40.25"), 57760.25);
  for (const char* cell : {"1970-13-01 00:00:00", "1.2.3", "12:61:00", "1970-01-02", "10:20"})
    EXPECT_FALSE(clock_seconds(cell)) << cell;
}

TEST(Cells, UnitsAreKnownByAllTheirNames) {
  EXPECT_EQ(metres_of_unit(plain_unit("inches")), 0.0254);
  EXPECT_EQ(metres_of_unit(plain_unit("1/100 mm")), 1e-5);
  EXPECT_EQ(metres_of_unit(plain_unit("µm")), 1e-6);
  EXPECT_FALSE(metres_of_unit("deg"));
}

TEST(Cells, SeparatorsInQuotesAreNone) {
  EXPECT_EQ(cell_separator("1;\"0,5\""), ';');
  EXPECT_EQ(split_cells("3,\"[0.1, 0.2]\",x", ','), (TextCells{"3", "[0.1, 0.2]", "x"}));
}

TEST(Cells, ColumnsOfWordsStandBesideNumbers) {
  const auto table = parse_table("a,b,state\n1,2,ok\n3,4,late\n", "t.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->columns[2].words, (std::vector<std::string>{"ok", "late"}));
  EXPECT_THROW(parse_table("a,b\n1,2\n3,x\n", "t.csv"), std::exception);  // a slip among numbers is none
}

TEST(Cells, TextOfSixteenBitsIsRead) {
  const std::string little(
      "\xFF\xFE"
      "a\0;\0"
      "\xE4\0"
      "\n\0",
      10),
      big("\xFE\xFF"
          "\0a\x20\xAC",
          6);
  EXPECT_EQ(plain_text(little), "a;\xC3\xA4\n");
  EXPECT_EQ(plain_text(big), "a\xE2\x82\xAC");
  EXPECT_EQ(plain_text("abc"), "abc");
}

}  // namespace
}  // namespace handsight
