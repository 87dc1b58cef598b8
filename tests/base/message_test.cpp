// SPDX-License-Identifier: Apache-2.0
// A message is its English form and its arguments; both give the sentence that fmt would have written.
#include "base/message.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/message_xml.h"
#include "base/text.h"

namespace handsight::test {
namespace {

TEST(Message, ItsFormHasPlacesAndItsEnglishIsWhatFmtWrites) {
  const std::string name = "arm_2";
  const Message m = message("{} has {:.1f} mm in {} poses", name, 0.53, 12);
  EXPECT_EQ(m.form(), "%1 has %2 mm in %3 poses");
  EXPECT_EQ(m.english(), fmt::format("{} has {:.1f} mm in {} poses", name, 0.53, 12));
  ASSERT_EQ(m.arguments().size(), 3U);
  EXPECT_EQ(m.arguments()[0].kind(), Message::Kind::verbatim);
  EXPECT_EQ(m.arguments()[1].kind(), Message::Kind::number);
  EXPECT_EQ(m.arguments()[1].form(), "0.5");
  EXPECT_EQ(m.arguments()[2].kind(), Message::Kind::number);
}

TEST(Message, WordsAndMessagesKeepWhatTheyAre) {
  const Message inner = message("{} px", 3);
  const Message m = message("the {} image is off by {}", true ? "left" : "right", inner);
  EXPECT_EQ(m.arguments()[0].kind(), Message::Kind::form) << "a word is translated";
  EXPECT_EQ(m.arguments()[1].form(), "%1 px");
  EXPECT_EQ(m.english(), "the left image is off by 3 px");
}

TEST(Message, ADigitCountMayBeAnArgument) {
  const Message m = message("{:.{}f} of {}", 1.23456, 2, std::string("x"));
  EXPECT_EQ(m.form(), "%1 of %2");
  EXPECT_EQ(m.english(), "1.23 of x");
  EXPECT_EQ(m.arguments().size(), 2U) << "the count of digits takes no place of its own";
  EXPECT_EQ(message("{0:.{1}f} and {2}", 1.23456, 3, 7).english(), "1.235 and 7");
}

TEST(Message, APlaceThatIsUsedTwiceTakesOneArgument) {
  const Message m = message("{0} {2}, {1} {2}", 1, 2, "mm");
  EXPECT_EQ(m.form(), "%1 %2, %3 %2");
  EXPECT_EQ(m.english(), "1 mm, 2 mm");
  EXPECT_EQ(m.arguments().size(), 3U);
}

TEST(Message, DoubledBracesAreBraces) {
  EXPECT_EQ(message("{{{}}}", 1).english(), "{1}");
  EXPECT_EQ(message("{{{}}}", 1).form(), "{%1}");
}

TEST(Message, ASignOfPercentIsNoPlace) {
  EXPECT_EQ(message("{} % of 50 %", 12).english(), "12 % of 50 %");
  EXPECT_EQ(Message("%1 stays where there are no arguments").english(), "%1 stays where there are no arguments");
}

TEST(Message, MessagesInARowAreASequence) {
  Message all;
  EXPECT_TRUE(all.empty());
  all += message("{} points.", 3);
  EXPECT_EQ(all.kind(), Message::Kind::form) << "one alone is itself";
  all += " None is wrong.";
  EXPECT_EQ(all.kind(), Message::Kind::sequence);
  EXPECT_EQ(all.english(), "3 points. None is wrong.");
  EXPECT_EQ((Message("a") + verbatim("b") + Message()).english(), "ab");
}

TEST(Message, JoinedHasItsOwnWordBeforeTheLast) {
  EXPECT_EQ(joined({"a", "b", "c"}, ", ", " and ").english(), "a, b and c");
  EXPECT_EQ(joined({"a", "b"}, ", ", " and ").english(), "a and b");
  EXPECT_EQ(joined(verbatim(std::vector<std::string>{"x", "y"})).english(), "x, y");
  EXPECT_TRUE(joined({}).empty());
}

TEST(Message, ThoseThatSayTheSameAreEqual) {
  EXPECT_EQ(message("{} px", 3), Message("3 px"));
  EXPECT_FALSE(message("{} px", 3) == message("{} px", 4));
}

TEST(Message, WhatIsTooLongToShowIsCutAndStaysAsItIs) {
  const Message m = message("{} and {}", std::string("one"), std::string("two"));
  EXPECT_EQ(at_most(m, 60).form(), "%1 and %2");
  EXPECT_EQ(at_most(m, 8).kind(), Message::Kind::verbatim);
  EXPECT_EQ(at_most(m, 8).english(), "one a...");
}

TEST(Message, IsReadFromAFileAsItWasWritten) {
  Message deep = "end";
  for (int i = 0; i < 3; ++i) deep = message("in {}: {:.2f} {}", deep, 1.5, std::string("<&\"'>"));
  deep += " and more";
  tinyxml2::XMLDocument document;
  tinyxml2::XMLElement* root = document.NewElement("a");
  document.InsertEndChild(root);
  write_message(*root, deep);
  const auto parsed = parse_xml(xml_text(document), "f.xml");
  const Message back = read_message(children(require_root(*parsed, "f.xml", "a")).front());
  EXPECT_EQ(back, deep);
  EXPECT_EQ(back.arguments()[0].arguments()[0].form(), "in %1: %2 %3");
  EXPECT_EQ(back.arguments()[0].arguments()[2].kind(), Message::Kind::verbatim);
  EXPECT_FALSE(has_parts("end"));
  EXPECT_TRUE(has_parts(deep));
}

TEST(Message, TooDeepInAFileIsRefused) {
  std::string text;
  for (int i = 0; i < 9; ++i) text = "<form text=\"%1\">" + text + "</form>";
  const auto parsed = parse_xml("<a>" + text + "<other/></a>", "f.xml");
  const auto parts = children(require_root(*parsed, "f.xml", "a"));
  EXPECT_THROW((void)read_message(parts[0]), InputError);
  EXPECT_THROW((void)read_message(parts[1]), InputError);
}

TEST(Message, AnErrorCarriesItsMessage) {
  try {
    refuse("session.xml", 12, message("has {} cameras.", 9));
    ADD_FAILURE() << "refuse came back";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "session.xml, line 12: has 9 cameras.");
    EXPECT_EQ(error.sentence().form(), "%1, line %2: %3");
    EXPECT_EQ(error.sentence().arguments()[2].form(), "has %1 cameras.");
  }
}

}  // namespace
}  // namespace handsight::test
