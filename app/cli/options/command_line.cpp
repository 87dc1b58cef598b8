// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

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

std::optional<int> parse(CLI::App& program, int argc, char** argv) {
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = program.exit(error, out, err);
    std::cout << printable(out.str());
    std::cerr << printable(err.str());
    return code == 0 ? done : wrong_input;
  }
}

}  // namespace handsight::cli
