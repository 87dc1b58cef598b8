// SPDX-License-Identifier: Apache-2.0
// How commands declare their options: a face before CLI11, whose headers alone take the compiler longer than a command
// does. Only command_line.cpp and describe.cpp include them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/bounds.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace handsight::cli {

enum ExitCode { done = 0, answer_is_no = 1, wrong_input = 2 };

/// A declared option, and what may stand after it. Every function returns the option itself.
struct Option {
  CLI::Option* parsed = nullptr;

  Option required() const;
  /// So many values; without this one, or any number for a list.
  Option takes(int count) const;
  Option takes(int least, int most) const;
  /// Of a list: one value each time that the option is given, not all that follow it.
  Option one_at_a_time() const;
  /// Numbers finite and within bounds. (CLI11's own checks let NaN through.)
  Option within(const Bounds& bounds) const;
  Option within(double lowest, double highest) const;
  /// Whole numbers from one to the other.
  Option from_to(int lowest, int highest) const;
  Option one_of(const std::vector<std::string>& words) const;
  /// Not beside the other.
  Option excludes(const Option& other) const;
  /// The help says the default: what the variable holds now, or this text.
  Option shows_default() const;
  Option shows_default(const std::string& text) const;
  /// What the help writes for the value.
  Option shown_as(const std::string& word) const;
};

/// What may be typed after the program's name, or after a command's. Variables are written by `parse`: they must live
/// until then.
struct CommandLine {
  CLI::App* parser = nullptr;

  CommandLine command(const std::string& name, const std::string& description) const;
  /// Left out of the help.
  CommandLine hidden() const;
  /// Was this command typed?
  bool is_given() const;

  /// `name`: "--json", or "SESSION" for what stands by its place.
  Option option(const std::string& name, std::string& value, const std::string& description = "") const;
  Option option(const std::string& name, int& value, const std::string& description) const;
  Option option(const std::string& name, std::int64_t& value, const std::string& description) const;
  Option option(const std::string& name, std::uint64_t& value, const std::string& description) const;
  Option option(const std::string& name, double& value, const std::string& description) const;
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& description) const;
  Option option(const std::string& name, std::vector<int>& values, const std::string& description) const;
  Option option(const std::string& name, std::vector<double>& values, const std::string& description) const;
  Option flag(const std::string& name, bool& given, const std::string& description) const;
};

/// A program of commands, of which one must be typed; it has --help, and --version with this text.
std::shared_ptr<CLI::App> make_program(const std::string& name, const std::string& description,
                                       const std::string& version);

/// Reads what was typed into the declared variables. Where the program is to end with that (--help, --version, an
/// error, which are printed), its exit code.
std::optional<int> parse(CLI::App& program, int argc, char** argv);

}  // namespace handsight::cli
