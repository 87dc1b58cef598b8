// SPDX-License-Identifier: Apache-2.0
// The tables of trials and benchmarks in their two forms, and that docs/measurements has the columns that they print.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"
#include "trials/table.h"

namespace handsight::test {
namespace {

using trials::share_text;
using trials::Table;
using trials::TableOutput;

const std::filesystem::path source_root = HANDSIGHT_SOURCE_DIR;

Table two_columns(TableOutput output) {
  return {{{.heading = "set", .width = 6}, {"rms px", 3}, {"found", 1, "%"}}, output};
}

TEST(TrialTables, AreAlignedForPeople) {
  const Table table = two_columns({});
  EXPECT_EQ(table.heading(), "set       rms px     found\n");
  EXPECT_EQ(table.row({"even", 0.01234, 99.96}), "even       0.012   100.0 %\n");
  EXPECT_EQ(table.row({"tilted", 1234567}), "tilted  1,234,567\n");
  EXPECT_EQ(table.row({"", -9999}), "           -9999\n");
}

TEST(TrialTables, AreMarkdownWhereAskedFor) {
  const Table table = two_columns({.is_markdown = true});
  EXPECT_EQ(table.heading(), "| set | rms px | found |\n|---|---|---|\n");
  EXPECT_EQ(table.row({"even", 0.01234, 99.96}), "| even | 0.012 | 100.0 % |\n");
  EXPECT_EQ(table.row({"none", NAN}), "| none | | |\n");
  EXPECT_EQ(table.row({"large", -12345, 10000}), "| large | -12,345 | 10,000 % |\n");
}

TEST(TrialTables, SharesHaveDigitsWhereAskedFor) {
  EXPECT_EQ(share_text(7, 9), "7 of 9");
  EXPECT_EQ(share_text(7, 9, 1), "7 of 9, 77.8 %");
  EXPECT_EQ(share_text(0, 0, 1), "0 of 0, 0.0 %");
}

/// What stands on standard output while `work` runs.
template <class Work>
std::string printed(const Work& work) {
  const std::filesystem::path path = std::filesystem::path(HANDSIGHT_BINARY_DIR) / "trial_tables_test.txt";
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO), file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  dup2(file, STDOUT_FILENO);
  work();
  std::fflush(stdout);
  dup2(before, STDOUT_FILENO);
  close(before), close(file);
  const std::string text = read_file(path);
  std::filesystem::remove(path);
  return text;
}

/// A program that reads its arguments, says something and prints a table.
void run(std::vector<std::string> words, std::vector<std::string>& read) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int count = static_cast<int>(words.size());
  Table table = two_columns(trials::take_table_output(count, pointers.data()));
  read.assign(pointers.begin(), pointers.begin() + count);
  EXPECT_EQ(pointers[static_cast<std::size_t>(count)], nullptr);
  fmt::print("row by row\n");
  std::fflush(stdout);
  table.print({"a", 1.0});
  table.print({"b", 2.0});
}

TEST(TrialTables, StandardOutputHoldsNothingElseInMarkdown) {
  std::vector<std::string> read;
  EXPECT_EQ(printed([&] {
              run({"trial", "--markdown", "20", "kind"}, read);
            }),
            "\n| set | rms px | found |\n|---|---|---|\n| a | 1.000 | |\n| b | 2.000 | |\n");
  EXPECT_EQ(read, (std::vector<std::string>{"trial", "20", "kind"}));
  EXPECT_EQ(printed([&] {
              run({"trial", "20"}, read);
            }),
            "row by row\n\nset       rms px     found\na          1.000\nb          2.000\n");
  EXPECT_EQ(read, (std::vector<std::string>{"trial", "20"}));
}

struct DocumentTable {
  std::string place;    // file and line
  std::string before;   // the text since the last heading or table
  std::string program;  // the first that its last paragraph with a program names; empty where there is none
  std::vector<std::string> headings;
};

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> all;
  std::istringstream parts(row.substr(1));
  for (std::string part; std::getline(parts, part, '|');) {
    part = std::regex_replace(part, std::regex("^ +| +$|\\*\\*"), "");
    if (!part.empty()) all.push_back(part);
  }
  return all;
}

std::string named_program(const std::string& before) {
  static const std::regex program("(^|[^-a-z_])((trial|benchmark)_[a-z_]+)");
  std::string found, paragraph;
  std::istringstream lines(before + "\n\n");
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) {
      paragraph += line + "\n";
      continue;
    }
    std::smatch match;
    if (std::regex_search(paragraph, match, program)) found = match[2];
    paragraph.clear();
  }
  return found;
}

std::vector<DocumentTable> tables_of(const std::string& name, const std::string& text) {
  std::vector<DocumentTable> tables;
  std::istringstream lines(text);
  std::string before;
  bool in_table = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool is_row = line.starts_with('|');
    if (is_row && !in_table) {
      DocumentTable& table = tables.emplace_back();
      table.place = name + ":" + std::to_string(number);
      table.before = std::exchange(before, "");
      table.program = named_program(table.before);
      table.headings = cells(line);
    }
    in_table = is_row;
    if (line.starts_with('#')) before.clear();
    if (!is_row) before += line + "\n";
  }
  return tables;
}

/// The texts in quotes; those that follow each other are one.
std::set<std::string> literals(const std::string& source) {
  static const std::regex next("\"\\s*\\n\\s*\""), quoted("\"((?:[^\"\\\\\\n]|\\\\.)*)\"");
  const std::string text = std::regex_replace(source, next, "");
  std::set<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), quoted), end; i != end; ++i) all.insert((*i)[1]);
  return all;
}

/// A heading of the source, or one of its formats filled with numbers and texts of the source.
bool is_heading_of(const std::string& heading, const std::set<std::string>& literals) {
  static const std::regex special(R"([-\[\]().+*?^$|\\/])"), field(R"(\{[^}]*\})"), number("[0-9.]+");
  if (literals.contains(heading)) return true;
  return std::any_of(literals.begin(), literals.end(), [&](const std::string& form) {
    if (form.find('{') == std::string::npos || form.size() > heading.size() + 20) return false;
    const std::string text = std::regex_replace(std::regex_replace(form, field, "\x01"), special, "\\$&");
    if (text.find_first_of("{}") != std::string::npos) return false;
    std::smatch match;
    if (!std::regex_match(heading, match, std::regex(std::regex_replace(text, std::regex("\x01"), "(.+?)"))))
      return false;
    return std::all_of(match.begin() + 1, match.end(), [&](const auto& part) {
      return std::regex_match(part.str(), number) || literals.contains(part.str());
    });
  });
}

/// The headings of a table that its program does not print.
std::vector<std::string> strange_headings(const DocumentTable& table, const std::string& source) {
  const std::set<std::string> known = literals(source);
  std::vector<std::string> strange;
  for (const std::string& heading : table.headings)
    if (!is_heading_of(heading, known)) strange.push_back(heading);
  return strange;
}

TEST(TrialTables, AHeadingThatTheProgramDoesNotPrintIsFound) {
  const std::string source = R"cpp(Table t({{"set"},
                                            {"rms, "
                                             "px",
                                             3},
                                            {fmt::format("recall, seed {}", seed)}});
                                   for (auto x : {"one", "place"}) fmt::format("{}: {}", x, y);)cpp";
  const auto tables = tables_of("page",
                                "`trial_old`\n\n`trial_some 3 --benchmark_no`, as `trial_other`:\n\n| set | rms, px | "
                                "**recall, seed 71** | one: place |\n|---|\n| a |\n"
                                "# New\n| set | rms, mm | recall, seed x | two: place |\n|---|\n");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].program, "trial_some");
  EXPECT_EQ(tables[0].place, "page:5");
  EXPECT_TRUE(strange_headings(tables[0], source).empty());
  EXPECT_EQ(tables[1].program, "");
  EXPECT_EQ(strange_headings(tables[1], source), (std::vector<std::string>{"rms, mm", "recall, seed x", "two: place"}));
}

std::string source_of(const std::string& program) {
  for (const char* folder : {"tests/trials", "tests/benchmarks", "tests/app/programs"})
    if (const auto path = source_root / folder / (program + ".cpp"); std::filesystem::exists(path))
      return read_file(path);
  return {};
}

/// A table below a command of a trial or a benchmark is that program's, or the text above it says "by hand".
TEST(TrialTables, TheDocumentsHaveTheColumnsOfTheirPrograms) {
  static const std::regex by_hand("[Bb]y\\s+hand");
  int checked = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_root / "docs" / "measurements")) {
    for (const DocumentTable& table : tables_of(entry.path().filename(), read_file(entry.path()))) {
      if (table.program.empty() || std::regex_search(table.before, by_hand)) continue;
      const std::string source = source_of(table.program);
      EXPECT_FALSE(source.empty()) << table.place << ": there is no " << table.program;
      if (source.find("trials/table.h") == std::string::npos) {
        ADD_FAILURE() << table.place << ": " << table.program << " prints no table; say \"by hand\" above it";
        continue;
      }
      for (const std::string& heading : strange_headings(table, source))
        ADD_FAILURE() << table.place << ": " << table.program << " prints no column \"" << heading << "\"";
      ++checked;
    }
  }
  EXPECT_GE(checked, 20) << "tables below commands are not found any more";
}

}  // namespace
}  // namespace handsight::test
