// SPDX-License-Identifier: Apache-2.0
// No header of core includes more than it says: of every header of the project that it includes it names something.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"

namespace handsight::test {
namespace {

const std::filesystem::path core = HANDSIGHT_SOURCE_DIR "/core";

/// Without comments, includes and what strings hold.
std::string code_of(const std::string& text) {
  static const std::regex comment("//[^\n]*|/\\*[^*]*\\*+(?:[^/*][^*]*\\*+)*/"),
      text_literal("\"(?:[^\"\\\\\n]|\\\\.)*\""), include("#include[^\n]*");
  const std::string code = std::regex_replace(text, comment, " ");
  return std::regex_replace(std::regex_replace(code, include, ""), text_literal, "\"\"");
}

std::set<std::string> words_of(const std::string& code) {
  static const std::regex word("[A-Za-z_]\\w*");
  std::set<std::string> words;
  for (std::sregex_iterator i(code.begin(), code.end(), word), end; i != end; ++i) words.insert(i->str());
  return words;
}

bool opens_namespace(const std::string& before) {
  static const std::regex opening("(namespace[ \\w:]*|extern \"\" )$");
  return std::regex_search(before, opening);
}

/// What stands in namespaces, the insides of types, functions and brackets taken out: "{}", "()".
std::string outline(const std::string& code) {
  std::string text, statement;
  std::vector<bool> is_namespace;  // of the braces that are open
  int inside = 0;                  // braces that are open and no namespace's
  for (const char c : code) {
    if (c == '{') {
      is_namespace.push_back(inside == 0 && opens_namespace(statement));
      if (!is_namespace.back() && inside++ == 0) text += "{}";
      if (is_namespace.back()) text += ";";
      statement.clear();
    } else if (c == '}' && !is_namespace.empty()) {
      if (!is_namespace.back()) --inside;
      is_namespace.pop_back();
      statement.clear();
    } else if (inside == 0) {
      text += c;
      statement = c == ';' ? "" : statement + c;
    }
  }
  static const std::regex brackets("\\([^()]+\\)"),
      parameters("template *<[^<>]*(<[^<>]*>[^<>]*)*>|namespace [\\w:]*|namespace");
  for (std::string before; before != text;) text = std::regex_replace(before = text, brackets, "()");
  return std::regex_replace(text, parameters, "");
}

/// The types, functions, constants and enumerators that can be named once the header is included; not what it only
/// announces.
std::set<std::string> declared_names(const std::string& text) {
  static const std::regex type("\\b(?:struct|enum class|class|enum|union|concept) (?!class)(\\w+)(?! ?;|\\w)"),
      alias("\\busing (\\w+) ="), value("\\b([A-Za-z_]\\w*)(?:\\[[^\\]]*\\])?\\s*(?:\\(\\)|=|;|\\{\\})"),
      enumerators("\\benum(?: \\w+)?(?: : \\w+)? *\\{([^}]*)\\}"), macro("#define (\\w+)");
  std::set<std::string> names;
  const auto take = [&](const std::string& where, const std::regex& what) {
    for (std::sregex_iterator i(where.begin(), where.end(), what), end; i != end; ++i) names.insert(i->str(1));
  };
  static const std::regex directive("(^|\n) *#[^\n]*(\\\\\n[^\n]*)*");
  const std::string code = std::regex_replace(code_of(text), directive, "\n"), outside = outline(code);
  static const std::regex announced("\\b(?:struct|class) \\w+;");
  const std::string defined = std::regex_replace(outside, announced, "");
  for (const std::regex* what : {&type, &alias, &value}) take(defined, *what);
  take(text, macro);
  for (std::sregex_iterator i(code.begin(), code.end(), enumerators), end; i != end; ++i) {
    const std::set<std::string> listed = words_of(i->str(1));
    names.insert(listed.begin(), listed.end());
  }
  return names;
}

struct Header {
  std::string text;
  std::set<std::string> words;
};

/// The headers of core; those of include/handsight, which pass on what they include, apart.
std::map<std::string, Header> read_headers() {
  std::map<std::string, Header> headers;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(core)) {
    const std::string name = entry.path().lexically_relative(core).string();
    if (entry.path().extension() != ".h" || name.starts_with("include/")) continue;
    const std::string text = read_file(entry.path());
    headers[name] = {text, words_of(code_of(text))};
  }
  return headers;
}

bool share_a_name(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) { return b.contains(name); });
}

TEST(Includes, WhatAHeaderDeclaresIsRead) {
  const std::string text = R"(
#define HANDSIGHT_ONE 1
namespace handsight {
struct Announced;
/// Not Spoken() of.
struct Found { int inside = 0; };
enum class Kind { first };
enum Plain { second };
using Alias = std::vector<int>;
inline constexpr double limit = 3;
template <class T> T twice(const T& of, int by = 2) { T local = of; return local; }
namespace more { extern const Found named; }
}
)";
  EXPECT_EQ(declared_names(text), (std::set<std::string>{"HANDSIGHT_ONE", "Found", "Kind", "Plain", "second", "Alias",
                                                         "limit", "twice", "named"}));
}

TEST(Includes, AHeaderOfCoreNamesSomethingOfEachThatItIncludes) {
  const std::map<std::string, Header> headers = read_headers();
  ASSERT_GE(headers.size(), 400U);
  static const std::regex include("#include \"([^\"]+\\.h)\"");
  std::map<std::string, std::set<std::string>> declared;
  for (const auto& [name, header] : headers)
    for (std::sregex_iterator i(header.text.begin(), header.text.end(), include), end; i != end; ++i) {
      const auto included = headers.find(i->str(1));
      ASSERT_NE(included, headers.end()) << name << " includes " << i->str(1);
      std::set<std::string>& names = declared[included->first];
      if (names.empty()) names = declared_names(included->second.text);
      EXPECT_TRUE(share_a_name(names, header.words)) << name << " names nothing of " << included->first;
    }
}

}  // namespace
}  // namespace handsight::test
