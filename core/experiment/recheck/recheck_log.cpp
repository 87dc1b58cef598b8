// SPDX-License-Identifier: Apache-2.0
#include "experiment/recheck/recheck_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>

#include "base/files.h"
#include "base/message_xml.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

// What a log has is told by its first line: each of these was the newest once.
constexpr std::array headers{"utc,id,e_value,changed,what,where,text", "utc,id,e_value,changed,what,where,text,numbers",
                             "utc,id,e_value,changed,what,where,text,numbers,parts"};
constexpr std::size_t least_columns = 7;

std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// "joint_offset:a3.offset=0.0002+-1e-05 rad"
std::string make_text(const RecheckNumber& n) {
  return fmt::format("{}{}{}.{}={:.5g}+-{:.3g} {}", n.what, n.where.empty() ? "" : ":", n.where, n.name, n.value,
                     n.sigma, n.unit);
}

std::string numbers_text(const std::vector<RecheckNumber>& numbers) {
  std::string text;
  for (const RecheckNumber& n : numbers) text += (text.empty() ? "" : "; ") + make_text(n);
  return text;
}

/// The cells of a line; nothing where a quote is not closed.
std::optional<std::vector<std::string>> split_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  if (is_quoted) return std::nullopt;
  return cells;
}

/// What make_text wrote; nothing where it is something else.
std::optional<RecheckNumber> number_of(const std::string& text) {
  const auto equal = text.find('='), plus = text.find("+-", equal == std::string::npos ? 0 : equal);
  if (equal == std::string::npos || plus == std::string::npos) return std::nullopt;
  const auto dot = text.rfind('.', equal), space = text.find(' ', plus);
  if (dot == std::string::npos || space == std::string::npos) return std::nullopt;
  const std::string place = text.substr(0, dot);
  const auto colon = place.find(':');
  RecheckNumber n{.what = place.substr(0, colon),
                  .where = colon == std::string::npos ? "" : place.substr(colon + 1),
                  .name = text.substr(dot + 1, equal - dot - 1),
                  .unit = text.substr(space + 1)};
  const auto value = parse_number(text.substr(equal + 1, plus - equal - 1));
  const auto sigma = parse_number(text.substr(plus + 2, space - plus - 2));
  if (!value || !sigma) return std::nullopt;
  n.value = *value;
  n.sigma = *sigma;
  return n;
}

std::vector<RecheckNumber> list_numbers(const std::string& text) {
  std::vector<RecheckNumber> numbers;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find("; ", from), text.size());
    if (const auto n = number_of(text.substr(from, to - from))) numbers.push_back(*n);
    from = to + 2;
  }
  return numbers;
}

/// The message as XML in one line.
std::string parts_text(const Message& text) {
  tinyxml2::XMLDocument document;
  tinyxml2::XMLElement* const root = document.NewElement("text");
  document.InsertEndChild(root);
  write_message(*root, text);
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}

/// What parts_text wrote; the English of the line where it is nothing of that kind.
Message message_of(const std::string& parts, const std::string& english, const std::string& file) {
  try {
    const auto document = parse_xml(parts, file);
    const auto all = children(require_root(*document, file, "text"));
    if (all.size() == 1) return read_message(all.front());
  } catch (const InputError&) {
  }
  return verbatim(english);
}

RecheckEntry find_entry(const std::vector<std::string>& cells, const std::string& file, int line) {
  RecheckEntry e{
      .utc = cells[0], .changed = cells[3] == "1", .what = cells[4], .where = cells[5], .text = verbatim(cells[6])};
  const auto id = parse_integer(cells[1]);
  const auto value = parse_number(cells[2]);
  if (!id || !value || (cells[3] != "0" && cells[3] != "1"))
    refuse(file, line,
           message("expected a time, an observation's number, an e-value and 0 or 1, as recheck --csv writes them; "
                   "move the file away, and recheck begins a new one."));
  e.id = *id;
  e.e_value = *value;
  if (cells.size() > least_columns) e.numbers = list_numbers(cells[least_columns]);
  if (cells.size() > least_columns + 1) e.text = message_of(cells[least_columns + 1], cells[6], file);
  return e;
}

bool is_header(const std::string& line) { return std::find(headers.begin(), headers.end(), line) != headers.end(); }

/// Of a log that is there.
std::string header_of(const fs::path& csv) {
  std::ifstream file(csv, std::ios::binary);
  std::string line;
  std::getline(file, line);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

}  // namespace

double compute_e_value(const WatchStep& step) {
  constexpr double largest = 690;  // ln of what a double still holds
  return std::exp(std::min(step.ln_e_value, largest));
}

RecheckEntry recheck_entry(const std::string& utc, std::int64_t id, const WatchStep& step) {
  RecheckEntry e{utc, id, compute_e_value(step), step.changed, step.what, step.where, step.text, {}};
  for (const WatchedChange& change : step.each) {
    if (change.what != "camera_mount" && change.what != "body_slip" && change.what != "joint_offset") continue;
    Eigen::Index next = 0;
    for (const EffectTerm& term : change.terms) {
      const Effect& effect = term_effect(term);
      for (std::size_t p = 0; p < term.values.size(); ++p)
        if (!effect.parameters[p].is_choice)
          e.numbers.push_back({change.what, change.where, effect.parameters[p].name, term.values[p],
                               change.sigma[next++], effect.parameters[p].unit});
    }
  }
  return e;
}

void add_to_log(const fs::path& csv, const RecheckEntry& e) {
  std::error_code error;
  const bool is_new = !fs::exists(csv, error) || fs::file_size(csv, error) == 0;
  const std::string header = is_new ? headers.back() : header_of(csv);
  std::ofstream file(csv, std::ios::app | std::ios::binary);
  if (is_new) file << header << '\n';
  std::string line = fmt::format("{},{},{:.6g},{},{},{},{}", e.utc, e.id, e.e_value, e.changed ? 1 : 0, e.what,
                                 quoted(e.where), quoted(e.text.english()));
  if (header != headers[0]) line += ',' + quoted(numbers_text(e.numbers));
  if (header == headers.back()) line += ',' + quoted(parts_text(e.text));
  file << line << '\n';
  if (!file.flush()) throw InputError(message("{} cannot be written; is the disk full?", shown_path(csv)));
}

std::vector<RecheckEntry> read_recheck_log(const fs::path& csv) {
  std::error_code error;
  if (!fs::exists(csv, error)) return {};
  const std::string text = read_file(csv), name = shown_path(csv);
  std::vector<RecheckEntry> entries;
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = text.find('\n', from);
    if (to == std::string::npos) break;  // a line that is being written
    std::string line = text.substr(from, to - from);
    from = to + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (++number == 1 && !is_header(line))
      refuse(name, 1, message("is no log of recheck; expected the columns {}.", headers.back()));
    if (number == 1 || line.empty()) continue;
    const auto cells = split_cells(line);
    if (!cells || cells->size() < least_columns)
      refuse(name, number, message("has {} columns, expected {} at least.", cells ? cells->size() : 0, least_columns));
    entries.push_back(find_entry(*cells, name, number));
  }
  return entries;
}

}  // namespace handsight
