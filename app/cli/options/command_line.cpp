// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <numeric>
#include <sstream>
#include <utility>

#include "base/numbers.h"
#include "base/text.h"

namespace handsight::cli {

Option Option::required() const { return {parsed->required()}; }
Option Option::takes(int count) const { return {parsed->expected(count)}; }
Option Option::takes(int least, int most) const { return {parsed->expected(least, most)}; }

Option Option::one_at_a_time() const { return {parsed->allow_extra_args(false)}; }

Option Option::within(const Bounds& bounds) const {
  const std::string range = fmt::format("{:g} to {:g}", bounds.lowest, bounds.highest);
  const auto wrong = [bounds, range](std::string& text) -> std::string {
    const std::optional<double> number = parse_number(text);
    if (number && bounds.hold(*number)) return {};
    return fmt::format("{} is no number from {}", in_quotes(text), range);
  };
  return {parsed->check(CLI::Validator(wrong, range))};
}

Option Option::within(double lowest, double highest) const { return within(Bounds{lowest, highest}); }
Option Option::from_to(int lowest, int highest) const { return {parsed->check(CLI::Range(lowest, highest))}; }
Option Option::one_of(const std::vector<std::string>& words) const { return {parsed->check(CLI::IsMember(words))}; }
Option Option::excludes(const Option& other) const { return {parsed->excludes(other.parsed)}; }
Option Option::shows_default() const { return {parsed->capture_default_str()}; }
Option Option::shows_default(const std::string& text) const { return {parsed->default_str(text)}; }
Option Option::shown_as(const std::string& word) const { return {parsed->type_name(word)}; }

CommandLine CommandLine::command(const std::string& name, const std::string& description) const {
  return {parser->add_subcommand(name, description)};
}

CommandLine CommandLine::hidden() const { return {parser->group("")}; }
bool CommandLine::is_given() const { return parser->parsed(); }

Option CommandLine::option(const std::string& name, std::string& value, const std::string& description) const {
  return {parser->add_option(name, value, description)};
}
Option CommandLine::option(const std::string& name, int& value, const std::string& description) const {
  return {parser->add_option(name, value, description)};
}
Option CommandLine::option(const std::string& name, std::int64_t& value, const std::string& description) const {
  return {parser->add_option(name, value, description)};
}
Option CommandLine::option(const std::string& name, std::uint64_t& value, const std::string& description) const {
  return {parser->add_option(name, value, description)};
}
Option CommandLine::option(const std::string& name, double& value, const std::string& description) const {
  return {parser->add_option(name, value, description)};
}
Option CommandLine::option(const std::string& name, std::vector<std::string>& values,
                           const std::string& description) const {
  return {parser->add_option(name, values, description)};
}
Option CommandLine::option(const std::string& name, std::vector<int>& values, const std::string& description) const {
  return {parser->add_option(name, values, description)};
}
Option CommandLine::option(const std::string& name, std::vector<double>& values, const std::string& description) const {
  return {parser->add_option(name, values, description)};
}
Option CommandLine::flag(const std::string& name, bool& given, const std::string& description) const {
  return {parser->add_flag(name, given, description)};
}

std::shared_ptr<CLI::App> make_program(const std::string& name, const std::string& description,
                                       const std::string& version) {
  auto program = std::make_shared<CLI::App>(description, name);
  program->set_version_flag("--version", version);
  program->require_subcommand(1);
  return program;
}

namespace {

/// The command that was typed, else the program itself.
const CLI::App& typed_command(const CLI::App& program) {
  const auto typed = program.get_subcommands();
  return typed.empty() ? program : *typed.front();
}

/// What is missing, with what it is.
std::string missing_sentence(const CLI::App& program, const std::string& said) {
  constexpr std::string_view end = " is required";
  const std::string name = said.ends_with(end) ? said.substr(0, said.size() - end.size()) : std::string();
  const CLI::App& command = typed_command(program);
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr || option->get_description().empty()) return {};
  return fmt::format("{} is missing: {}.\n{} {} --help lists all that it takes.\n", name, option->get_description(),
                     program.get_name(), command.get_name());
}

std::size_t letters_apart(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = before + (a[i - 1] == b[j - 1] ? 0 : 1);
      before = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// Which of the commands is meant, or which there are.
std::string unknown_command_sentence(const CLI::App& program, const std::string& typed) {
  std::string names, nearest;
  std::size_t apart = typed.size();
  for (const CLI::App* command : program.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    names += (names.empty() ? "" : " ") + command->get_name();
    const std::size_t now = letters_apart(typed, command->get_name());
    if (now < apart && now <= 2) {
      apart = now;
      nearest = command->get_name();
    }
  }
  const std::string meant = nearest.empty() ? fmt::format("the commands are {}", names) : "is " + nearest + " meant?";
  const std::string begin = typed.empty() ? "No command is given" : "There is no command " + in_quotes(typed);
  return fmt::format("{}; {}{}\n{} --help says what each does.\n", begin, meant, nearest.empty() ? "." : "",
                     program.get_name());
}

/// The first word that is no option; empty: there is none.
std::string first_word(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] != '-' && (i == 1 || std::string_view(argv[i - 1]) != "--threads")) return argv[i];
  return {};
}

/// A sentence of our own where CLI11's says neither what is meant nor what to type next; empty: its own will do.
std::string own_sentence(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  if (dynamic_cast<const CLI::RequiredError*>(&error) == nullptr) return {};
  if (program.get_subcommands().empty()) return unknown_command_sentence(program, first_word(argc, argv));
  return missing_sentence(program, error.what());
}

}  // namespace

std::optional<int> parse(CLI::App& program, int argc, char** argv) {
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (const std::string sentence = own_sentence(program, error, argc, argv); !sentence.empty()) {
      std::cerr << printable(sentence);
      return wrong_input;
    }
    std::ostringstream out, err;
    const int code = program.exit(error, out, err);
    std::cout << printable(out.str());
    std::cerr << printable(err.str());
    return code == 0 ? done : wrong_input;
  }
}

}  // namespace handsight::cli
