// SPDX-License-Identifier: Apache-2.0
#include "describe.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

namespace handsight::cli {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  std::vector<const CLI::App*> all;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) all.push_back(command);
  return all;
}

/// "--json", "-h": what is typed.
std::vector<std::string> flags_of(const CLI::Option& o) {
  std::vector<std::string> flags;
  for (const std::string& name : o.get_snames()) flags.push_back("-" + name);
  for (const std::string& name : o.get_lnames()) flags.push_back("--" + name);
  return flags;
}

bool takes_value(const CLI::Option& o) { return o.get_items_expected_max() > 0; }

/// roff reads a backslash, a quote or a dot at the beginning of a line as its own.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return (!out.empty() && (out[0] == '.' || out[0] == '\'') ? "\\&" : "") + out;
}

std::string option_paragraph(const CLI::Option& o) {
  std::string names;
  for (const std::string& flag : flags_of(o)) names += (names.empty() ? "" : ", ") + flag;
  if (names.empty()) names = o.get_name();
  if (takes_value(o) && !o.get_positional()) names += " VALUE";
  return fmt::format(".TP\n.B {}\n{}\n", roff(names), roff(o.get_description()));
}

std::string in_single_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string long_flags(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* o : command.get_options())
    for (const std::string& name : o->get_lnames()) text += (text.empty() ? "" : " ") + ("--" + name);
  return text;
}

std::string bash_completion(const CLI::App& app) {
  std::string names, cases;
  for (const CLI::App* command : commands_of(app)) {
    names += (names.empty() ? "" : " ") + command->get_name();
    cases += fmt::format("    {}) options=\"{}\" ;;\n", command->get_name(), long_flags(*command));
  }
  return fmt::format(R"(# bash completion for handsight-cli
_handsight_cli() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command="" options="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${{COMP_WORDS[i]}} != -* ]]; then command=${{COMP_WORDS[i]}}; break; fi
  done
  if [[ -z $command ]]; then
    COMPREPLY=($(compgen -W "{} --help --version" -- "$word"))
    return
  fi
  case $command in
{}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    compopt -o filenames 2>/dev/null
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -F _handsight_cli handsight-cli
)",
                     names, cases);
}

/// A colon and brackets are zsh's own in such a list.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == ':' || c == '[' || c == ']' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out;
}

std::string zsh_completion(const CLI::App& app) {
  std::string list, cases;
  for (const CLI::App* command : commands_of(app)) {
    list += "    " + in_single_quotes(command->get_name() + ":" + zsh_text(command->get_description())) + "\n";
    std::string options;
    for (const CLI::Option* o : command->get_options())
      for (const std::string& name : o->get_lnames())
        options += " " + in_single_quotes(fmt::format("--{}[{}]{}", name, zsh_text(o->get_description()),
                                                      takes_value(*o) ? ":value:_files" : ""));
    cases += fmt::format("    {}) _arguments{} '*:file:_files' ;;\n", command->get_name(), options);
  }
  return "#compdef handsight-cli\n_handsight_cli() {\n  local -a commands\n  commands=(\n" + list +
         "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n  local "
         "command=${words[2]}\n"
         "  shift words\n  (( CURRENT-- ))\n  case $command in\n" +
         cases + "  esac\n}\n_handsight_cli \"$@\"\n";
}

std::string fish_completion(const CLI::App& app) {
  std::string text = "# fish completion for handsight-cli\n";
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format("complete -c handsight-cli -n __fish_use_subcommand -f -a {} -d {}\n", command->get_name(),
                        in_single_quotes(command->get_description()));
    for (const CLI::Option* o : command->get_options())
      for (const std::string& name : o->get_lnames())
        text += fmt::format("complete -c handsight-cli -n '__fish_seen_subcommand_from {}' -l {} {}-d {}\n",
                            command->get_name(), name, takes_value(*o) ? "-r " : "",
                            in_single_quotes(o->get_description()));
  }
  return text;
}

}  // namespace

std::string manual_page(const CommandLine& program, const std::string& version) {
  const CLI::App& app = *program.parser;
  std::string text = fmt::format(
      ".TH HANDSIGHT\\-CLI 1 \"\" \"handsight {}\" \"User Commands\"\n.SH NAME\nhandsight\\-cli \\- {}\n.SH "
      "SYNOPSIS\n.B "
      "handsight\\-cli\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}\nEvery command has \\fB\\-\\-help\\fR.\n.SH "
      "COMMANDS\n",
      version, roff("calibrates where a robot's hand is, and finds why it is elsewhere"), roff(app.get_description()));
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format(".SS {}\n{}.\n", roff(command->get_name()), roff(command->get_description()));
    for (const CLI::Option* o : command->get_options())
      if (o->get_name() != "--help" && !o->get_description().empty()) text += option_paragraph(*o);
  }
  return text +
         ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\ndone, but the answer is no\n.TP\n.B 2\nwrong input or "
         "usage\n.SH "
         "ENVIRONMENT\n.TP\n.B HANDSIGHT_ROBOTS\nfolders, with a colon between, in which the robots of sessions may "
         "lie\n";
}

std::string completion(const CommandLine& program, const std::string& shell) {
  const CLI::App& app = *program.parser;
  return shell == "zsh" ? zsh_completion(app) : shell == "fish" ? fish_completion(app) : bash_completion(app);
}

}  // namespace handsight::cli
