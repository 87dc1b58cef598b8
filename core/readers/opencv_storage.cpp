// SPDX-License-Identifier: Apache-2.0
#include "readers/opencv_storage.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/bounds.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {
namespace {

using Entries = std::map<std::string, StorageEntry>;

constexpr std::size_t largest_storage = std::size_t{16} << 20;  // bytes
constexpr std::size_t most_side = 64;                           // rows or columns of a camera's matrix

[[noreturn]] void refuse_text(const std::string& file, const Message& reason) {
  throw InputError(
      message("{}: is no file that OpenCV's FileStorage wrote (YAML, XML or JSON): {}; name the stereo calibration.",
              file, at_most(reason, 200)));
}

bool is_storage_nested_deeply(std::string_view text) {
  constexpr int deepest = 64;
  int brackets = 0, elements = 0, indent = 0;
  bool at_start = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
    brackets += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (c == '<' && next != '!' && next != '?') elements += next == '/' ? -1 : 1;
    if (c == '/' && next == '>') --elements;
    indent = c == '\n' ? 0 : at_start && (c == ' ' || c == '-') ? indent + 1 : indent;
    at_start = c == '\n' || (at_start && (c == ' ' || c == '-'));
    if (brackets > deepest || elements > deepest || (at_start && indent > 4 * deepest)) return true;
  }
  return false;
}

StorageEntry faulty(Message reason) { return {0, 0, {}, std::move(reason)}; }

/// A matrix that is reported with its rows and columns.
StorageEntry find_entry(std::optional<std::int64_t> rows, std::optional<std::int64_t> cols,
                        std::vector<double> numbers) {
  const auto is_side = [](std::optional<std::int64_t> side) {
    return side && *side >= 0 && *side <= static_cast<std::int64_t>(most_side);
  };
  if (!is_side(rows) || !is_side(cols)) return faulty("its rows or cols are none of a camera's matrix");
  if (static_cast<std::size_t>(*rows * *cols) != numbers.size())
    return faulty(message("it says {} x {} and has {} numbers", *rows, *cols, numbers.size()));
  for (const double number : numbers)
    if (!bounds::distortion.hold(number)) return faulty(message("it holds {:g}", number));
  return {static_cast<int>(*rows), static_cast<int>(*cols), std::move(numbers), {}};
}

/// A list of numbers; `rows` of them side by side where it is a list of lists.
StorageEntry list_of(std::vector<double> numbers, std::size_t rows = 0) {
  const std::size_t count = numbers.size();
  if (rows == 0 || count % rows != 0) rows = count;
  if (rows == 0) return faulty("it is empty");
  if (rows > most_side) return faulty(message("it is a list of {} numbers", count));
  return find_entry(static_cast<std::int64_t>(rows), static_cast<std::int64_t>(count / rows), std::move(numbers));
}

StorageEntry not_a_number(const std::string& word) {
  return faulty(message("{} is no finite number", in_quotes(word)));
}

// ---- YAML
// ------------------------------------------------------------------------------------------------------------

std::string_view without_comment(std::string_view line) {
  const std::size_t hash = line.find('#');
  return hash == std::string_view::npos || (hash > 0 && line[hash - 1] != ' ') ? line : line.substr(0, hash);
}

/// What follows "NAME:" in a text; nothing where the name is not there.
std::optional<std::string_view> after_name(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || std::string_view(" \n\t{,\"").find(text[at - 1]) != std::string_view::npos;
    std::string_view rest = text.substr(at + name.size());
    if (rest.starts_with('"')) rest.remove_prefix(1);
    if (begins && rest.starts_with(':')) return rest.substr(1);
  }
  return std::nullopt;
}

std::optional<std::int64_t> integer_after(std::string_view text, std::string_view name) {
  const auto rest = after_name(text, name);
  if (!rest) return std::nullopt;
  const auto words = split_words(rest->substr(0, rest->find_first_of("\n,}")));
  return words.size() == 1 ? parse_integer(words[0]) : std::nullopt;
}

/// The numbers between the first '[' and what closes it.
StorageEntry bracketed(std::string_view text) {
  std::string plain;
  int depth = 0;
  std::size_t inner = 0;
  for (const char c : text.substr(text.find('['))) {
    if (c == '[' && ++depth == 2) ++inner;
    if (c == ']' && --depth == 0) break;
    plain += c == '[' || c == ']' || c == ',' ? ' ' : c;
  }
  if (depth != 0) return faulty("its list is not closed");
  std::string bad_word;
  const auto numbers = parse_numbers(plain, &bad_word);
  return numbers ? list_of(*numbers, inner) : not_a_number(bad_word);
}

StorageEntry yaml_entry(std::string_view body);

/// A list of matrices, a row for each: as vectors of rotation and place of many images are written.
StorageEntry list_of_matrices(std::string_view body, std::string_view mark) {
  std::vector<double> numbers;
  std::size_t rows = 0;
  for (std::size_t at = body.find(mark); at != std::string_view::npos;) {
    const std::size_t next = body.find(mark, at + mark.size());
    const std::string_view one = body.substr(at + mark.size(), next - at - mark.size());
    StorageEntry matrix = yaml_entry(one.substr(0, one.rfind(']') + 1));
    if (!matrix.fault.empty()) return matrix;
    if (rows++ > 0 && numbers.size() != (rows - 1) * matrix.numbers.size())
      return faulty("its matrices differ in size");
    numbers.insert(numbers.end(), matrix.numbers.begin(), matrix.numbers.end());
    at = next;
  }
  const std::size_t cols = numbers.size() / rows;
  return {static_cast<int>(rows), static_cast<int>(cols), std::move(numbers), {}};
}

StorageEntry yaml_entry(std::string_view body) {
  constexpr std::string_view mark = "- !!opencv-matrix";
  if (body.find(mark) != std::string_view::npos) return list_of_matrices(body, mark);
  if (const auto data = after_name(body, "data")) {
    if (data->find('[') == std::string_view::npos) return faulty("its data is no list");
    StorageEntry numbers = bracketed(*data);
    if (!numbers.fault.empty()) return numbers;
    return find_entry(integer_after(body, "rows"), integer_after(body, "cols"), std::move(numbers.numbers));
  }
  if (body.find('[') != std::string_view::npos) return bracketed(body);
  std::vector<double> numbers;
  for (const std::string_view word : split_words(body)) {
    if (word == "-" || word.starts_with('!')) continue;
    const auto number = parse_number(word);
    if (!number) return not_a_number(std::string(word));
    numbers.push_back(*number);
  }
  return list_of(std::move(numbers));
}

Entries yaml_entries(std::string_view text) {
  Entries entries;
  std::string name, body;
  const auto finish = [&] {
    if (!name.empty()) entries.emplace(name, yaml_entry(body));
    body.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_comment(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line[0] == '%' || line.starts_with("---") || line.starts_with("...")) continue;
    const std::size_t colon = line.find(':');
    if (line.find_first_of(" \t-]}\r") == 0 || colon == std::string_view::npos) {
      body += '\n';
      body += line;
      continue;
    }
    finish();
    name = line.substr(0, colon);
    std::erase_if(name, [](char c) { return c == '"' || c == '\'' || c == ' '; });
    body = line.substr(colon + 1);
  }
  finish();
  return entries;
}

// ---- JSON and XML
// ----------------------------------------------------------------------------------------------------

StorageEntry json_list(const nlohmann::json& list) {
  std::vector<double> numbers;
  std::size_t inner = 0;
  const auto take = [&](const nlohmann::json& value) {
    if (value.is_number()) numbers.push_back(value.get<double>());
    return value.is_number();
  };
  for (const nlohmann::json& value : list) {
    bool is_good = value.is_array() || take(value);
    if (value.is_array()) {
      ++inner;
      is_good = std::all_of(value.begin(), value.end(), take);
    }
    if (!is_good) return faulty("it holds something that is no number");
  }
  return list_of(std::move(numbers), inner);
}

StorageEntry json_entry(const nlohmann::json& value) {
  if (value.is_number()) return list_of({value.get<double>()});
  if (value.is_array()) return json_list(value);
  if (!value.is_object() || !value.contains("data") || !value["data"].is_array()) return faulty("it is no matrix");
  StorageEntry numbers = json_list(value["data"]);
  if (!numbers.fault.empty()) return numbers;
  const auto side = [&](const char* name) -> std::optional<std::int64_t> {
    if (!value.contains(name) || !value[name].is_number_integer()) return std::nullopt;
    return value[name].get<std::int64_t>();
  };
  return find_entry(side("rows"), side("cols"), std::move(numbers.numbers));
}

Entries parse_json(const std::string& text, const std::string& file) {
  const nlohmann::json all = nlohmann::json::parse(text, nullptr, false, true);
  if (all.is_discarded() || !all.is_object()) refuse_text(file, "it is no JSON object");
  Entries entries;
  for (const auto& [name, value] : all.items()) entries.emplace(name, json_entry(value));
  return entries;
}

StorageEntry xml_entry(const XmlNode& node) {
  const auto numbers_in = [](const XmlNode& where, std::vector<double>& numbers) {
    std::string bad_word;
    auto found = parse_numbers(inner_text(where), &bad_word);
    if (found) numbers = std::move(*found);
    return bad_word;
  };
  std::vector<double> numbers;
  const auto data = find_child(node, "data");
  if (const std::string bad = numbers_in(data ? *data : node, numbers); !bad.empty()) return not_a_number(bad);
  if (!data) return list_of(std::move(numbers));
  const auto side = [&](const char* name) {
    const auto child = find_child(node, name);
    const auto words = child ? inner_text(*child) : std::string();
    return split_words(words).size() == 1 ? parse_integer(split_words(words)[0]) : std::nullopt;
  };
  return find_entry(side("rows"), side("cols"), std::move(numbers));
}

Entries parse_xml_storage(const std::string& text, const std::string& file) {
  const auto document = parse_xml(text, file);
  Entries entries;
  for (const XmlNode& node : children(require_root(*document, file, "opencv_storage")))
    entries.emplace(node.tag(), xml_entry(node));
  return entries;
}

}  // namespace

Entries parse_opencv_storage(const std::string& text, const std::string& file) {
  if (text.size() > largest_storage) refuse_text(file, message("it has {} MB", text.size() >> 20));
  if (text.find('\0') != std::string::npos) refuse_text(file, "it holds a zero byte");
  if (is_storage_nested_deeply(text)) refuse_text(file, "its elements are nested too deeply");
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) refuse_text(file, "it is empty");
  Entries entries = text[first] == '{'   ? parse_json(text, file)
                    : text[first] == '<' ? parse_xml_storage(text, file)
                                         : yaml_entries(text);
  if (entries.empty()) refuse_text(file, "it has no entries with names");
  return entries;
}

}  // namespace handsight
