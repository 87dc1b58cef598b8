// SPDX-License-Identifier: Apache-2.0
#include "session/effect_definition.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

constexpr std::size_t most_parameters = 64, most_moves = 64, longest_text = 2000;

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !text.empty() && text.size() <= 64 && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

std::string required_identifier(const XmlNode& node, const char* attribute) {
  std::string name = required_name(node, attribute);
  if (!is_name(name))
    refuse(node, message("has {}={}, expected a letter and then letters, digits and _, 64 at most.",
                         verbatim(attribute), in_quotes(name)));
  return name;
}

std::string bounded_text(const XmlNode& node, const std::string& text) {
  if (text.size() > longest_text)
    refuse(node, message("holds {} characters, expected {} at most.", text.size(), longest_text));
  return text;
}

std::string list_words(const XmlNode& effect, std::string_view tag, Ignored& ignored) {
  const auto node = find_child(effect, tag);
  if (!node) return "";
  note_unknown(ignored, *node, {}, {}, true);
  const std::string text = bounded_text(*node, inner_text(*node));
  std::string words;
  for (const std::string_view word : split_words(text)) words += (words.empty() ? "" : " ") + std::string(word);
  return words;
}

DefinedParameter read_parameter(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {"name", "unit", "sigma"}, {});
  return {required_identifier(node, "name"), bounded_text(node, find_text(node, "unit").value_or("1")),
          required_positive(node, "sigma")};
}

}  // namespace

EffectDefinition read_effect_definition(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {"id", "title", "scope", "unnamed"},
               {"cause", "visibility", "check", "source", "parameter", "moves"});
  EffectDefinition d;
  d.file = node.file;
  d.line = node.line();
  d.id = required_identifier(node, "id");
  d.title = bounded_text(node, find_text(node, "title").value_or(d.id));
  constexpr const char* scopes[] = {"joint", "marker", "session"};
  d.scope = scopes[find_choice(node, "scope", {"joint", "marker", "session"}).value_or(0)];
  d.unnamed = find_choice(node, "unnamed", {"no", "yes"}).value_or(0) == 1;
  d.cause = list_words(node, "cause", ignored);
  d.visibility = list_words(node, "visibility", ignored);
  d.check = list_words(node, "check", ignored);
  d.source = list_words(node, "source", ignored);
  for (const XmlNode& child : children(node, "parameter")) {
    d.parameters.push_back(read_parameter(child, ignored));
    const auto same = [&](const DefinedParameter& p) { return p.name == d.parameters.back().name; };
    if (std::count_if(d.parameters.begin(), d.parameters.end(), same) > 1)
      refuse(child, message("is a second parameter {}, expected each name once.", in_quotes(d.parameters.back().name)));
  }
  for (const XmlNode& child : children(node, "moves")) {
    note_unknown(ignored, child, {"site", "by"}, {});
    d.moves.push_back({required_name(child, "site"), bounded_text(child, required_name(child, "by")), child.line()});
  }
  if (d.parameters.empty() || d.parameters.size() > most_parameters)
    refuse(node,
           message("{} has {} <parameter>, expected 1 to {}.", in_quotes(d.id), d.parameters.size(), most_parameters));
  if (d.moves.empty() || d.moves.size() > most_moves)
    refuse(node, message("{} has {} <moves>, expected 1 to {}: the sites that it moves, and by how much.",
                         in_quotes(d.id), d.moves.size(), most_moves));
  return d;
}

std::vector<EffectDefinition> parse_effect_definitions(const std::string& text, const std::string& file,
                                                       std::vector<Message>* notes) {
  const auto document = parse_xml(text, file);
  const XmlNode root = require_root(*document, file, "handsight_effects");
  require_version_1(root);
  Ignored ignored;
  note_unknown(ignored, root, {"version"}, {"effect"});
  std::vector<EffectDefinition> all;
  for (const XmlNode& node : children(root, "effect")) {
    all.push_back(read_effect_definition(node, ignored));
    const auto same = [&](const EffectDefinition& d) { return d.id == all.back().id; };
    if (std::count_if(all.begin(), all.end(), same) > 1)
      refuse(node, message("has id={} a second time, expected each effect once.", in_quotes(all.back().id)));
  }
  if (notes)
    for (Message& sentence : ignored_sentences(ignored, file)) notes->push_back(std::move(sentence));
  return all;
}

namespace {

std::vector<std::filesystem::path> xml_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".xml" && it->is_regular_file(error)) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<EffectDefinition> find_effect_definitions(const std::filesystem::path& session_folder,
                                                      const std::filesystem::path& user_folder,
                                                      std::vector<Message>& notes) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  if (std::filesystem::exists(session_folder / "effects.xml", error)) files.push_back(session_folder / "effects.xml");
  if (!user_folder.empty())
    for (std::filesystem::path& file : xml_files(user_folder)) files.push_back(std::move(file));
  std::vector<EffectDefinition> all;
  for (const std::filesystem::path& file : files)
    for (EffectDefinition& d : parse_effect_definitions(read_file(file), shown_path(file), &notes)) {
      const auto same = [&](const EffectDefinition& other) { return other.id == d.id; };
      const auto before = std::find_if(all.begin(), all.end(), same);
      if (before == all.end()) {
        all.push_back(std::move(d));
      } else {
        notes.push_back(message("{}, line {}: the effect \"{}\" is defined in {} already; that one counts.", d.file,
                                d.line, d.id, before->file));
      }
    }
  return all;
}

std::filesystem::path user_effects_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data)
    return std::filesystem::path(data) / "handsight" / "effects";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".local" / "share" / "handsight" / "effects";
  return {};
}

void write_effect_definition(tinyxml2::XMLElement& parent, const EffectDefinition& d) {
  tinyxml2::XMLElement& effect = *parent.InsertNewChildElement("effect");
  effect.SetAttribute("id", d.id.c_str());
  effect.SetAttribute("title", d.title.c_str());
  effect.SetAttribute("scope", d.scope.c_str());
  if (d.unnamed) effect.SetAttribute("unnamed", "yes");
  const auto add_text = [&](const char* tag, const std::string& text) {
    if (!text.empty()) effect.InsertNewChildElement(tag)->SetText(text.c_str());
  };
  add_text("cause", d.cause);
  add_text("visibility", d.visibility);
  add_text("check", d.check);
  add_text("source", d.source);
  for (const DefinedParameter& p : d.parameters) {
    tinyxml2::XMLElement& parameter = *effect.InsertNewChildElement("parameter");
    parameter.SetAttribute("name", p.name.c_str());
    parameter.SetAttribute("unit", p.unit.c_str());
    parameter.SetAttribute("sigma", format_number(p.sigma).c_str());
  }
  for (const DefinedMove& m : d.moves) {
    tinyxml2::XMLElement& moves = *effect.InsertNewChildElement("moves");
    moves.SetAttribute("site", m.site.c_str());
    moves.SetAttribute("by", m.formula.c_str());
  }
}

std::string effect_definition_text(const EffectDefinition& definition) {
  tinyxml2::XMLDocument document;
  tinyxml2::XMLElement* root = document.NewElement("root");
  document.InsertEndChild(root);
  write_effect_definition(*root, definition);
  tinyxml2::XMLPrinter printer(nullptr, true);
  root->FirstChildElement()->Accept(&printer);
  return printer.CStr();
}

}  // namespace handsight
