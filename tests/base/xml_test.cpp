// SPDX-License-Identifier: Apache-2.0
#include "base/xml.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The refusal of `read(root of text)`.
std::string xml_refusal(const std::string& text, auto&& read) {
  try {
    const auto document = parse_xml(text, "f.xml");
    read(require_root(*document, "f.xml", "a"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string xml_refusal(const std::string& text) {
  return xml_refusal(text, [](const XmlNode&) {});
}

TEST(Xml, MalformedTextsAreRefusedWithTheirLine) {
  EXPECT_EQ(xml_refusal("<a>\n<b>\n</a>"),
            "f.xml, line 2: an element is closed by another name or not at all, expected well-formed XML.");
  EXPECT_THAT(xml_refusal(""), HasSubstr("the file is empty"));
  EXPECT_THAT(xml_refusal("<a><!-- x</a>"), HasSubstr("comment"));
  EXPECT_THAT(xml_refusal("<a b=1/>"), HasSubstr("attribute"));
  EXPECT_THAT(xml_refusal("no xml at all"), HasSubstr("f.xml"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(xml_refusal(deep), HasSubstr("too deeply"));
}

TEST(Xml, NamesWithAZeroByteAreRefused) {
  EXPECT_THAT(xml_refusal("<a>\n<b c='hand&#0;x'/></a>"), HasSubstr("line 2: the reference &#0;"));
  EXPECT_THAT(xml_refusal("<a>&#x00;</a>"), HasSubstr("zero byte"));
  EXPECT_EQ(xml_refusal("<a c='&#48;&#x30;&amp;#0;'><!-- &#0; --></a>"), "nothing was refused");
}

TEST(Xml, ReferencesThatAreNoneAreRefused) {
  // Behind another reference such an '&' was read as the byte that stood there before.
  EXPECT_THAT(xml_refusal("<a>\n&lt;]x,\u00bb]&arkerdi</a>"), AllOf(HasSubstr("line 2"), HasSubstr("expected &amp;")));
  EXPECT_THAT(xml_refusal("<a x='this & that'/>"), HasSubstr("expected &amp;"));
  EXPECT_THAT(xml_refusal("<a>&#xD800;</a>"), HasSubstr("&#xD800; stands for no character"));
  EXPECT_THAT(xml_refusal("<a>&#99999999999;</a>"), HasSubstr("stands for no character"));
  EXPECT_THAT(xml_refusal("<a>&#12x;</a>"), HasSubstr("expected &amp;"));
  EXPECT_NO_THROW(
      parse_xml("<!-- this & that --><a x='&quot;&#13;&#x41;'>&lt;&amp;&apos;<![CDATA[a & b]]></a>", "f.xml"));
}

TEST(Xml, WhatWouldCostTooMuchIsRefusedBeforeItIsParsed) {
  std::string attributes = "<a";
  for (int i = 0; i < 100000; ++i) attributes += " x" + std::to_string(i) + "=''";
  EXPECT_THAT(xml_refusal(attributes + "/>"), HasSubstr("more than 300 attributes"));
  std::string elements = "<a>";
  for (int i = 0; i < 2'000'000; ++i) elements += "<a/>";
  EXPECT_THAT(xml_refusal(elements + "</a>"), HasSubstr("elements and attributes"));
  std::string quoted = "<a b='" + std::string(100, '<') + "=\"\"=\"'/>";
  EXPECT_THAT(xml_refusal(quoted), Not(HasSubstr("attributes, expected")));
}

TEST(Xml, TextsAndNumbersAreBounded) {
  const auto name = [](const XmlNode& a) { required_name(a, "n"); };
  EXPECT_EQ(xml_refusal("<a n='" + std::string(500, 'n') + "'/>", name), "nothing was refused");
  EXPECT_THAT(xml_refusal("<a n='" + std::string(501, 'n') + "'/>", name), HasSubstr("has 501 bytes in n"));
  EXPECT_THAT(xml_refusal("<a n='" + std::string(5000, 'n') + "'/>", [](const XmlNode& a) { find_text(a, "n"); }),
              HasSubstr("expected at most 4000"));
  EXPECT_EQ(xml_refusal("<a n='1e160'/>", [](const XmlNode& a) { find_number(a, "n"); }),
            "f.xml, line 1: <a> has the number 1e+160 in n, expected a number from -1e+30 to 1e+30.");
  EXPECT_THAT(xml_refusal("<a n='3'/>",
                          [](const XmlNode& a) {
                            find_positive(a, "n", {0, 2});
                          }),
              HasSubstr("expected a number from 0 to 2"));
  EXPECT_THAT(xml_refusal("<a n='1 2 3'/>",
                          [](const XmlNode& a) {
                            find_numbers(a, "n", 3, {0, 2});
                          }),
              HasSubstr("has the number 3 in n"));
  EXPECT_THAT(xml_refusal("<a>1 2 -3</a>",
                          [](const XmlNode& a) {
                            inner_numbers(a, 3, "x", {0, 2});
                          }),
              HasSubstr("has the number -3, expected"));
}

TEST(Xml, OtherEncodingsAreRefused) {
  EXPECT_THAT(xml_refusal("<a>\n<b c='\xFC'/></a>"), HasSubstr("line 2: the file holds bytes that are not UTF-8"));
  EXPECT_THAT(xml_refusal(std::string("<a>\0</a>", 8)), HasSubstr("zero byte"));
  EXPECT_THAT(xml_refusal("<a b='&#xD800;'/>", [](const XmlNode& a) { find_text(a, "b"); }), HasSubstr("no character"));
}

TEST(Xml, TheOutermostElementIsTheOneExpected) {
  EXPECT_EQ(xml_refusal("\n<b/>"), "f.xml, line 2: the outermost element is <b>, expected <a>.");
  EXPECT_THAT(xml_refusal("<a/>\n<a/>"), HasSubstr("line 2: <a> is a second outermost element"));
  EXPECT_THAT(xml_refusal("<!-- only a comment -->"), HasSubstr("no element"));
}

TEST(Xml, NothingStandsOutsideTheOutermostElement) {
  EXPECT_THAT(xml_refusal("<a/>\nhello"),
              HasSubstr("line 2: the text \"hello\" stands outside of the outermost element"));
  EXPECT_THAT(xml_refusal("hello <a/>"), HasSubstr("stands outside"));
  EXPECT_THAT(xml_refusal("<a/>\n</b> and much more"), HasSubstr("closing tag too many"));
  EXPECT_THAT(xml_refusal("<a/><!"), HasSubstr("closing tag too many"));
  EXPECT_EQ(xml_refusal("<?xml version='1.0'?><!-- x -->\n<a/>\n<!-- x -->\n"), "nothing was refused");
}

TEST(Xml, NumbersInAttributes) {
  const auto document = parse_xml("<a x=' 1.5 ' v='1 2 3' n='7'/>", "f.xml");
  const XmlNode a = require_root(*document, "f.xml", "a");
  EXPECT_EQ(required_number(a, "x"), 1.5);
  EXPECT_THAT(required_numbers(a, "v", 3), ElementsAre(1, 2, 3));
  EXPECT_EQ(required_integer(a, "n", 0, 9), 7);
  EXPECT_FALSE(find_number(a, "none"));
}

TEST(Xml, RefusalsSayWhatWasFoundAndExpected) {
  const std::string text = "<r/>";
  EXPECT_EQ(xml_refusal("<a x='nan'/>", [](const XmlNode& a) { required_number(a, "x"); }),
            "f.xml, line 1: <a> has x=\"nan\", expected one finite number.");
  EXPECT_EQ(xml_refusal("<a x='0'/>", [](const XmlNode& a) { required_positive(a, "x"); }),
            "f.xml, line 1: <a> has x=\"0\", expected a positive number.");
  EXPECT_EQ(xml_refusal("<a/>", [](const XmlNode& a) { required_number(a, "x"); }),
            "f.xml, line 1: <a> has no attribute x, expected x=\"...\".");
  EXPECT_EQ(xml_refusal("<a v='1 2'/>", [](const XmlNode& a) { required_numbers(a, "v", 3); }),
            "f.xml, line 1: <a> has 2 numbers in v, expected 3.");
  EXPECT_EQ(xml_refusal("<a v='1 b 2'/>", [](const XmlNode& a) { required_numbers(a, "v", 3); }),
            "f.xml, line 1: <a> has \"b\" in v, expected 3 finite numbers.");
  EXPECT_EQ(xml_refusal("<a n='64'/>", [](const XmlNode& a) { required_integer(a, "n", 0, 63); }),
            "f.xml, line 1: <a> has n=\"64\", expected an integer from 0 to 63.");
  EXPECT_EQ(xml_refusal("<a n='-1'/>", [](const XmlNode& a) { required_integer(a, "n", 0, INT64_MAX); }),
            "f.xml, line 1: <a> has n=\"-1\", expected an integer of at least 0.");
  EXPECT_EQ(xml_refusal("<a c='maybe'/>",
                        [](const XmlNode& a) {
                          find_choice(a, "c", {"no", "yes"});
                        }),
            "f.xml, line 1: <a> has c=\"maybe\", expected one of: no, yes.");
  EXPECT_EQ(xml_refusal("<a>1 2</a>", [](const XmlNode& a) { inner_numbers(a, 3, "one for each of <joints>"); }),
            "f.xml, line 1: <a> has 2 numbers, expected 3, one for each of <joints>.");
  EXPECT_EQ(xml_refusal("<a><b/>\n<b/></a>", [](const XmlNode& a) { find_child(a, "b"); }),
            "f.xml, line 2: <b> stands a second time in <a>, expected once.");
  EXPECT_EQ(xml_refusal("<a/>", [](const XmlNode& a) { required_child(a, "b"); }),
            "f.xml, line 1: <a> has no element <b>, expected one.");
  EXPECT_THAT(xml_refusal("<a x='${pi}'/>", [](const XmlNode& a) { required_number(a, "x"); }), HasSubstr("xacro"));
}

TEST(Xml, CommentsDoNotHideNumbers) {
  const auto document = parse_xml("<a>1 <!-- 7 --> 2<![CDATA[ 3 ]]></a>", "f.xml");
  EXPECT_THAT(inner_numbers(require_root(*document, "f.xml", "a"), 3), ElementsAre(1, 2, 3));
}

TEST(Xml, WhatIsUnknownIsCounted) {
  const auto document = parse_xml("<a x='1' y='2'>\n<b/>\n<c/><c/>\nhello</a>", "f.xml");
  Ignored ignored;
  note_unknown(ignored, require_root(*document, "f.xml", "a"), {"x"}, {"b"});
  EXPECT_THAT(ignored_sentences(ignored, "f.xml"),
              ElementsAre("f.xml: attribute y of <a> is not known and is ignored (line 1).",
                          "f.xml: element <c> in <a> is not known and is ignored (2 times, first at line 3).",
                          "f.xml: text in <a> is not known and is ignored (line 4)."));
}

TEST(Xml, TextsReadBack) {
  const std::string value = "\r a \r\n <b> & \"c\" 'd' \t\n \xC3\xBC";
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewElement("a"));
  document.RootElement()->SetAttribute("x", value.c_str());
  const auto back = parse_xml(xml_text(document), "f.xml");
  EXPECT_EQ(find_text(require_root(*back, "f.xml", "a"), "x"), value);
}

TEST(Xml, AnAttributeThatStandsTwiceIsRefused) {
  EXPECT_THAT(xml_refusal("<a x='1' x='2'/>"), HasSubstr("stands twice"));
}

TEST(Xml, VersionIsOne) {
  EXPECT_EQ(xml_refusal("<a version='2'/>", require_version_1),
            "f.xml, line 1: <a> has version=\"2\", expected version=\"1\", the only one that this program reads.");
  EXPECT_THAT(xml_refusal("<a/>", require_version_1), HasSubstr("version"));
  EXPECT_EQ(xml_refusal("<a version='1'/>", require_version_1), "nothing was refused");
}

}  // namespace
}  // namespace handsight
