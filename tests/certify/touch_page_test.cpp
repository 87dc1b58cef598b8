// SPDX-License-Identifier: Apache-2.0
#include "certify/touch_page.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

std::size_t count_page_numbers(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(TouchPage, HasEveryFixtureAndLinesToFillInOnTwoPages) {
  const std::string pdf = touch_page_pdf("handsight test");
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4"));
  for (const char* kind : {"(plane)", "(point)", "(line)", "(gauge)", "(length)", "(fixture)", "(34)"})
    EXPECT_EQ(count_page_numbers(pdf, kind), 1u) << kind;
  EXPECT_EQ(count_page_numbers(pdf, "/Type /Page "), 2u);
}

}  // namespace
}  // namespace handsight
