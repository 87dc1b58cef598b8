// SPDX-License-Identifier: Apache-2.0
#include "convert/listed_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "convert/recorder_columns.h"
#include "readers/texts/cells.h"
#include "readers/texts/plain_text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr int deepest = 8;                  // maps within maps
constexpr std::size_t most_in_a_row = 512;  // numbers of one measurement
constexpr std::size_t most_in_a_list = 64;  // longer ones are covariances, images, logs

bool is_one_of(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

/// One measurement: numbers and words by the names of their columns, in the order in which they came.
struct Row {
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<std::pair<std::string, std::string>> words;
};

/// The columns of a list, by what it is called: axes of a place or a turn, the robot's joints, or its own name with
/// numbers.
std::vector<std::string> columns_of_list(const std::string& path, std::size_t count,
                                         const std::vector<std::string>& joints) {
  const std::size_t dot = path.rfind('.');
  const std::string name = lower_case(path.substr(dot == std::string::npos ? 0 : dot + 1));
  const std::string before = dot == std::string::npos ? "" : path.substr(0, dot + 1);
  const auto axes = [&](std::initializer_list<const char*> names) {
    std::vector<std::string> columns;
    for (const char* axis : names) columns.push_back(before + axis);
    return columns;
  };
  if (count == 3 && is_one_of(name, {"position", "translation", "tvec", "t", "xyz", "trans", "pos", "point", "p"}))
    return axes({"x", "y", "z"});
  if (count == 3 && is_one_of(name, {"rvec", "rotvec", "rotation_vector", "rod", "axis_angle"}))
    return axes({"rvx", "rvy", "rvz"});
  if (count == 3 && is_one_of(name, {"rpy", "euler", "rpy_rad"})) return axes({"roll", "pitch", "yaw"});
  if (count == 4 &&
      is_one_of(name, {"orientation", "rotation", "quaternion", "quat", "q", "quaternion_xyzw", "quat_xyzw"}))
    return axes({"qx", "qy", "qz", "qw"});
  if (count == 4 && is_one_of(name, {"quaternion_wxyz", "quat_wxyz"})) return axes({"qw", "qx", "qy", "qz"});
  const bool is_of_joints = is_one_of(
      name, {"joints", "joint_angles", "joint_positions", "joint_position", "joint_pos", "joint_state", "joint_states",
             "positions", "angles", "q", "position", "actual_q", "joint_values", "config", "configuration"});
  if (is_of_joints && count == joints.size()) return joints;
  if (is_of_joints && count > 4) {
    std::vector<std::string> columns;
    for (std::size_t i = 0; i < count; ++i) columns.push_back(fmt::format("joint_{}", i + 1));
    return columns;
  }
  const std::string last = dot == std::string::npos ? path : path.substr(dot + 1);
  if (count == 7 && is_one_of(name, {"pose", "tcp", "flange", "target", "tag", "transform", "marker", "board"})) {
    const std::string of = name == "pose" ? before : before + last + ".";
    return {of + "x", of + "y", of + "z", of + "qx", of + "qy", of + "qz", of + "qw"};
  }
  if (count == 6 && is_one_of(name, {"pose", "tcp", "flange", "target", "tag", "transform", "tcp_pose"})) {
    const std::string of = name == "pose" ? before : before + last + ".";
    return {of + "x", of + "y", of + "z", of + "rx", of + "ry", of + "rz"};
  }
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < count; ++i) columns.push_back(fmt::format("{}_{}", path, i));
  return columns;
}

/// A stamp of ROS in s.
std::optional<double> stamp_seconds(const YAML::Node& node) {
  if (!node.IsMap()) return std::nullopt;
  for (const auto& [whole, part] : {std::pair{"sec", "nanosec"}, {"secs", "nsecs"}}) {
    const auto seconds = yaml_number(node, whole), rest = yaml_number(node, part);
    if (seconds && rest) return *seconds + 1e-9 * *rest;
  }
  return std::nullopt;
}

/// A JointState: names and positions.
bool add_joint_state(const YAML::Node& map, Row& row) {
  const YAML::Node names = map["name"], positions = map["position"];
  if (!names || !positions || !names.IsSequence() || !positions.IsSequence() || names.size() != positions.size())
    return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto number =
        names[i].IsScalar() && positions[i].IsScalar() ? parse_number(positions[i].Scalar()) : std::optional<double>();
    if (!number) return false;
    row.numbers.emplace_back(names[i].Scalar(), *number);
  }
  return true;
}

void add_node(const YAML::Node& node, const std::string& path, const std::vector<std::string>& joints, Row& row,
              int depth) {
  if (depth > deepest || row.numbers.size() + row.words.size() > most_in_a_row) return;
  const std::string name = path.substr(path.rfind('.') + 1);
  if (node.IsMap()) {
    if (const auto time = stamp_seconds(node)) {
      if (name == "stamp") row.numbers.emplace_back("time", *time);
      return;
    }
    if (add_joint_state(node, row)) {
      if (const YAML::Node header = node["header"]) add_node(header, "header", joints, row, depth + 1);
      return;
    }
    const bool is_shell =
        is_one_of(name, {"pose", "transform", "joints", "joint_angles", "joint_positions", "joint_state"});
    const std::string before = path.empty() || is_shell ? path.substr(0, path.size() - name.size()) : path + ".";
    for (const auto& entry : node) add_node(entry.second, before + entry.first.Scalar(), joints, row, depth + 1);
    return;
  }
  if (node.IsScalar()) {
    const auto number = cell_number(node.Scalar(), false);
    if (name == "seq" || name == "frame_id") return;
    if (number)
      row.numbers.emplace_back(path, *number);
    else
      row.words.emplace_back(path, node.Scalar());
    return;
  }
  const auto numbers = node.IsSequence() ? yaml_numbers(node) : std::nullopt;
  if (!numbers || numbers->empty() || numbers->size() > most_in_a_list) return;
  const std::vector<std::string> columns = columns_of_list(path, numbers->size(), joints);
  for (std::size_t i = 0; i < columns.size(); ++i) row.numbers.emplace_back(columns[i], (*numbers)[i]);
}

/// The place of a column, made where it is new.
std::size_t place_of(const std::string& name, Table& table) {
  for (std::size_t c = 0; c < table.width(); ++c)
    if (table.columns[c].name == name) return c;
  table.columns.push_back({name, ""});
  return table.width() - 1;
}

std::optional<Table> table_of_rows(const std::vector<Row>& rows, const std::string& file) {
  Table table;
  table.file = file;
  table.has_header = true;
  for (const Row& row : rows) {
    for (const auto& [name, number] : row.numbers) place_of(name, table);
    for (const auto& [name, word] : row.words) table.columns[place_of(name, table)].words.resize(rows.size());
  }
  if (rows.size() < 2 || table.width() < 3) return std::nullopt;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    table.rows.emplace_back(table.width(), no_number);
    table.lines.push_back(static_cast<int>(r) + 1);
    for (const auto& [name, number] : rows[r].numbers) table.rows.back()[place_of(name, table)] = number;
    for (const auto& [name, word] : rows[r].words) table.columns[place_of(name, table)].words[r] = word;
  }
  return table;
}

/// The parts of a text between lines of "---", or its lines where each is a map of JSON.
std::vector<std::string> documents_of(const std::string& text) {
  std::vector<std::string> parts(1);
  bool are_lines = !text.empty() && text.front() == '{';
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty()) continue;
    are_lines = are_lines && line.front() == '{' && line.back() == '}';
    if (line == "---" || are_lines) parts.emplace_back();
    if (line != "---") parts.back() += line + "\n";
  }
  std::erase(parts, "");
  return parts;
}

/// A message of a PoseArray with one pose is one of a pose; nothing where it holds none.
std::optional<YAML::Node> message_of_one_pose(const YAML::Node& item, const std::string& file) {
  if (!item.IsMap() || !item["header"] || !item["poses"] || !item["poses"].IsSequence()) return item;
  const YAML::Node poses = item["poses"];
  if (poses.size() == 0) return std::nullopt;
  if (poses.size() > 1)
    throw InputError(
        message("{}: its messages hold several poses each (PoseArray), and which is meant nothing tells; "
                "`ros2 topic echo --field poses[0] TOPIC` prints one of them.",
                file));
  YAML::Node one;
  one["header"] = item["header"];
  one["pose"] = poses[0];
  return one;
}

/// The list that a document is, or has under its only list of maps; its own map where it is one of several documents.
std::vector<YAML::Node> items_of(const std::vector<std::string>& documents, const std::string& file) {
  std::vector<YAML::Node> items;
  for (const std::string& document : documents) items.push_back(parse_yaml(document, file));
  if (items.size() != 1) {
    std::vector<YAML::Node> messages;
    for (const YAML::Node& item : items)
      if (const auto one = message_of_one_pose(item, file)) messages.push_back(*one);
    return messages;
  }
  YAML::Node list = items.front();
  if (list.IsMap())
    for (const auto& entry : items.front())
      if (entry.second.IsSequence() && entry.second.size() > 1 && entry.second[0].IsMap()) list.reset(entry.second);
  items.clear();
  if (list.IsSequence())
    for (const YAML::Node& item : list) items.push_back(item);
  return items;
}

/// The numbers between brackets behind a word of the text from `at` on; moves `at` behind them.
std::optional<std::vector<double>> numbers_behind(const std::string& text, const char* word, std::size_t& at) {
  const std::size_t begin = text.find(word, at);
  const std::size_t open = begin == std::string::npos ? begin : text.find('[', begin);
  const std::size_t close = open == std::string::npos ? open : text.find(']', open);
  if (close == std::string::npos) return std::nullopt;
  std::string inside = text.substr(open + 1, close - open - 1);
  std::replace(inside.begin(), inside.end(), ',', ' ');
  at = close;
  return parse_numbers(inside);
}

/// What tf2_echo (and tf_echo of ROS 1) prints.
std::optional<Table> rows_of_tf_echo(const std::string& text, const std::string& file) {
  if (text.find("Translation: [") == std::string::npos || text.find("in Quaternion") == std::string::npos)
    return std::nullopt;
  std::vector<Row> rows;
  for (std::size_t at = 0;;) {
    std::size_t time_at = text.find("At time ", at);
    const auto place = numbers_behind(text, "Translation:", at);
    const auto turn = place ? numbers_behind(text, "in Quaternion", at) : std::nullopt;
    if (!turn) break;
    if (place->size() != 3 || turn->size() != 4)
      throw InputError(
          message("{}: what tf2_echo printed is not whole at its pose {}; expected three numbers and four.", file,
                  rows.size()));
    Row& row = rows.emplace_back();
    if (time_at != std::string::npos && time_at < at) {
      time_at += 8;
      const std::string word = text.substr(time_at, text.find_first_of(" \r\n", time_at) - time_at);
      if (const auto time = parse_number(word)) row.numbers.emplace_back("time", *time);
    }
    constexpr std::array names{"x", "y", "z", "qx", "qy", "qz", "qw"};
    for (std::size_t i = 0; i < names.size(); ++i)
      row.numbers.emplace_back(names[i], i < 3 ? (*place)[i] : (*turn)[i - 3]);
  }
  return table_of_rows(rows, file);
}

/// "array([[1., 2.]," and "pose: [1, 2]" without what stands about the numbers.
std::string without_brackets(std::string line) {
  const std::size_t open = line.find_first_of("[(");
  const std::size_t begin = line.find_first_not_of(" \t");
  const bool has_word = begin != std::string::npos && open != std::string::npos &&
                        std::isalpha(static_cast<unsigned char>(line[begin])) != 0;
  if (has_word) line = line.substr(open);
  if (line.find("dtype=") != std::string::npos) line.resize(line.find("dtype="));
  for (char& c : line)
    if (c == '[' || c == ']' || c == '(' || c == ')' || c == ',') c = ' ';
  if (line.find("array") != std::string::npos) line.replace(line.find("array"), 5, " ");
  return line;
}

/// As many numbers in each line, in brackets.
std::optional<Table> rows_of_brackets(const std::string& text, const std::string& file) {
  Table table;
  table.file = file;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const std::string plain = without_brackets(line);
    const auto numbers = parse_numbers(plain);
    if (!numbers) return std::nullopt;
    if (numbers->empty()) continue;
    if (line.find_first_of("[(])") == std::string::npos || numbers->size() < 3) return std::nullopt;
    if (!table.rows.empty() && table.rows.front().size() != numbers->size()) return std::nullopt;
    table.rows.push_back(*numbers);
    table.lines.push_back(number);
  }
  if (table.rows.size() < 2) return std::nullopt;
  table.columns.resize(table.rows.front().size());
  return table;
}

/// Columns whose cells are lists ("[0.1, 0.2, 0.3]") as columns of numbers.
void spread_lists(Table& table, const std::vector<std::string>& joints) {
  for (std::size_t c = table.width(); c-- > 0;) {
    const std::vector<std::string> words = table.columns[c].words;
    std::vector<std::vector<double>> lists;
    for (const std::string& word : words) {
      const auto numbers =
          word.starts_with("[") || word.starts_with("(") ? parse_numbers(without_brackets(word)) : std::nullopt;
      if (!numbers || numbers->size() < 3 || (!lists.empty() && numbers->size() != lists.front().size())) break;
      lists.push_back(*numbers);
    }
    if (words.empty() || lists.size() != words.size()) continue;
    const std::vector<std::string> names = columns_of_list(table.columns[c].name, lists.front().size(), joints);
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (std::size_t i = 0; i < names.size(); ++i)
      table.columns.insert(table.columns.begin() + at + static_cast<std::ptrdiff_t>(i), {names[i], ""});
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      table.rows[r].erase(table.rows[r].begin() + at);
      table.rows[r].insert(table.rows[r].begin() + at, lists[r].begin(), lists[r].end());
    }
  }
}

constexpr char left_out[] = "left_out_";

/// Where the text is a table without a header that has as many columns; those that are left out are gone.
std::optional<Table> named_table(const std::string& text, const std::string& file,
                                 const std::vector<std::string>& joints, const std::vector<std::string>& columns) {
  if (text.find_first_of("0123456789") == std::string::npos || looks_like_yaml(text)) return std::nullopt;
  const auto bare = parse_table(text, file, joints);
  if (!bare || bare->has_header || bare->width() != columns.size()) return std::nullopt;
  auto table = parse_headed_table(text, file, joints, columns);
  for (std::size_t c = columns.size(); table && c-- > 0;) {
    if (columns[c] != "-") continue;
    table->columns.erase(table->columns.begin() + static_cast<std::ptrdiff_t>(c));
    for (auto& row : table->rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
  }
  return table;
}

}  // namespace

bool has_several_documents(const std::string& text) { return documents_of(text).size() > 1; }

std::optional<Table> parse_listed_rows(const std::string& text, const std::string& file,
                                       const std::vector<std::string>& joints) {
  std::vector<Row> rows;
  for (const YAML::Node& item : items_of(documents_of(text), file)) {
    if (!item.IsMap()) return std::nullopt;
    add_node(item, "", joints, rows.emplace_back(), 0);
  }
  return table_of_rows(rows, file);
}

std::optional<Table> parse_printed_rows(const std::string& text, const std::string& file) {
  if (auto table = rows_of_tf_echo(text, file)) return table;
  return rows_of_brackets(text, file);
}

std::optional<Table> parse_headed_table(const std::string& text, const std::string& file,
                                        const std::vector<std::string>& joints,
                                        const std::vector<std::string>& columns) {
  const char separator = cell_separator(std::string_view(text).substr(0, text.find('\n')));
  std::string header;
  for (std::size_t c = 0; c < columns.size(); ++c)
    header += (c > 0 ? std::string(1, separator) : "") +
              (columns[c] == "-" ? fmt::format("{}{}", left_out, c + 1) : columns[c]);
  auto table = parse_table(header + "\n" + text, file, joints);
  for (std::size_t i = 0; table && i < table->lines.size(); ++i) --table->lines[i];  // as they stand in the file
  return table;
}

std::optional<Table> parse_measured_table(const std::string& text, const std::string& file,
                                          const std::vector<std::string>& joints,
                                          const std::vector<std::string>& columns) {
  if (auto table = columns.empty() ? std::nullopt : named_table(text, file, joints, columns)) return table;
  const std::string_view begin = first_line(text);
  if (!begin.starts_with("p["))
    if (auto table = parse_printed_rows(text, file)) return table;
  const bool is_yaml = looks_like_yaml(text) || begin.starts_with("{");
  if (is_yaml) return parse_listed_rows(text, file, joints);
  auto table = parse_recorded_table(text, file, joints);
  if (table) spread_lists(*table, joints);
  return table;
}

}  // namespace handsight
