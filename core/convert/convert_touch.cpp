// SPDX-License-Identifier: Apache-2.0
// Touches of a probe: tables of joint angles, what was touched and what it read.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "convert/convert_inputs.h"
#include "convert/touch_table.h"
#include "readers/bags/bag.h"
#include "readers/texts/cells.h"
#include "readers/texts/plain_text.h"
#include "robot/urdf.h"
#include "session/fixtures/find_fixture.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> list_words(const std::string& text) {
  std::vector<std::string> words;
  for (const std::string_view w : split_words(text)) words.emplace_back(w);
  return words;
}

/// "sigma=2e-5" into an attribute; commas in numbers stand for blanks.
void set_attribute(tinyxml2::XMLElement& element, const std::string& word, const std::string& option) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(
        message("{}: {} is no NAME=VALUE such as sigma=2e-5; a fixture's name is one word (\"socket 1\" of "
                "a table is socket_1 here).",
                option, in_quotes(shortened(word))));
  std::string value = word.substr(equals + 1);
  if (word.substr(0, equals) != "mount") std::replace(value.begin(), value.end(), ',', ' ');
  element.SetAttribute(word.substr(0, equals).c_str(), value.c_str());
}

/// What a fixture of that name is likely to be, where nobody says; null: it does not tell. The last of several kinds: a
/// socket in a plate is a socket.
const FixtureKind* kind_by_name(const std::string& id) {
  const FixtureKind* found = nullptr;
  for (const FixtureKind* kind : fixture_kinds())
    if (std::any_of(kind->called.begin(), kind->called.end(), [&](const char* word) { return says(id, {word}); }))
      found = kind;
  return found;
}

/// "point, line, gauge or length": the tags of all kinds but the first.
Message other_tags() {
  const std::vector<std::string> tags = fixture_tags();
  return joined(verbatim(std::vector<std::string>(tags.begin() + 1, tags.end())), ", ", " or ");
}

/// "line, gauge or length": of those whose place has to be said.
Message tags_with_place() {
  return joined(verbatim(fixture_tags([](const FixtureKind& kind) { return !kind.frame_through; })), ", ", " or ");
}

/// The fixtures as they stand in a session: those that options describe, then those that tables name.
class Fixtures {
 public:
  Fixtures(const ConvertOptions& o, std::vector<Message>& notes) : notes_(notes) {
    root_ = document_.NewElement("touch");
    document_.InsertEndChild(root_);
    if (o.sigma) root_->SetAttribute("sigma", fmt::format("{}", *o.sigma).c_str());
    for (const std::string& fixture : o.fixtures) add_described(fixture);
    apart_ = o.apart;
  }

  /// The only one that is described; of several none.
  std::string only() const { return ids_.size() == 1 ? ids_.front() : ""; }

  void require(const std::string& id, const std::string& file) {
    if (std::find(ids_.begin(), ids_.end(), id) != ids_.end()) return;
    for (const std::string& known : ids_)
      if (lower_case(known) == lower_case(id))
        throw InputError(message("{}: the fixtures {} and {} differ in capitals alone; write it one way.", file,
                                 in_quotes(shortened(known, 60)), in_quotes(shortened(id, 60))));
    const FixtureKind* const kind = kind_by_name(id);
    if (!kind)
      throw InputError(message(
          "{0}: nothing says what the fixture {1} is; name it with --fixture \"{2} {3}\", or {4} in place of {2}.",
          file, in_quotes(shortened(id, 60)), fixture_tags().front(), shortened(id, 60), other_tags()));
    notes_.push_back(
        message("{}: the fixture {} is taken for a {} by its name; say --fixture \"KIND {}\" where it "
                "is something else.",
                file, in_quotes(shortened(id, 60)), kind->tag, shortened(id, 60)));
    add(kind->tag, id);
  }

  /// What a fixture reads where its table tells nothing.
  std::optional<double> value_of(const std::string& id) const {
    const auto found = values_.find(id);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  }

  void read_into(Session& session) {
    for (const std::string& text : apart_) {
      const std::vector<std::string> words = list_words(text);
      if (words.size() < 3)
        throw InputError(message("--apart {}: write two fixtures, by=METRES and sigma=METRES.", in_quotes(text)));
      tinyxml2::XMLElement& apart = *root_->InsertNewChildElement("apart");
      apart.SetAttribute("of", words[0].c_str());
      apart.SetAttribute("from", words[1].c_str());
      for (std::size_t w = 2; w < words.size(); ++w) set_attribute(apart, words[w], "--apart");
      require_metres(apart.DoubleAttribute("by"), text);
    }
    // Written out and read again, so that the sentences of its reader are those of a session's.
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    const auto text = parse_xml(printer.CStr(), "--fixture");
    Ignored ignored;
    read_touch(require_root(*text, "--fixture", "touch"), session, ignored);
  }

 private:
  tinyxml2::XMLElement& add(const std::string& kind, const std::string& id) {
    tinyxml2::XMLElement& element = *root_->InsertNewChildElement(kind.c_str());
    element.SetAttribute("id", id.c_str());
    element.SetAttribute("estimate", "yes");
    ids_.push_back(id);
    return element;
  }

  void add_described(const std::string& text) {
    const std::vector<std::string> words = list_words(text);
    if (words.size() < 2 || !find_fixture_kind(words[0]))
      throw InputError(
          message("--fixture {}: write what it is and its name, \"plane table\", \"point socket_1\", or "
                  "a {} with its place.",
                  in_quotes(shortened(text)), tags_with_place()));
    tinyxml2::XMLElement& element = add(words[0], words[1]);
    for (std::size_t w = 2; w < words.size(); ++w)
      if (words[w].starts_with("value="))
        values_[words[1]] = value_from(words[w]);
      else
        set_attribute(element, words[w], "--fixture");
  }

  static void require_metres(double by, const std::string& text) {
    constexpr double farthest = 20;  // m: farther than any robot reaches from one fixture to another
    if (by > farthest)
      throw InputError(message("--apart {}: distances are in metres; {:g} mm is by={:g}.", in_quotes(shortened(text)),
                               by, 1e-3 * by));
  }

  static double value_from(const std::string& word) {
    const auto value = parse_number(word.substr(word.find('=') + 1));
    if (!value) throw InputError(message("--fixture: {} is no number of metres.", in_quotes(shortened(word))));
    return *value;
  }

  std::vector<Message>& notes_;
  tinyxml2::XMLDocument document_;
  tinyxml2::XMLElement* root_ = nullptr;
  std::vector<std::string> ids_, apart_;
  std::map<std::string, double> values_;
};

/// As many columns without a header as the robot has joints are these, in its order.
void name_joints(Table& table, const Robot& robot, std::vector<Message>& notes) {
  const std::vector<std::string> names = joint_names(robot);
  if (table.has_header || table.width() != names.size()) return;
  for (std::size_t c = 0; c < names.size(); ++c) table.columns[c].name = names[c];
  table.has_header = true;
  notes.push_back(message("{}: has no header; its columns are taken for {}{}.", table.file, "",
                          shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
}

/// What each file's touches are of where it does not say: its name, behind that of its folder where several have it.
std::vector<std::string> fixtures_of_files(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    const auto has_its_name = [&](const fs::path& other) { return other.stem() == file.stem(); };
    const bool is_alone = std::count_if(files.begin(), files.end(), has_its_name) == 1;
    const std::string folder = fs::absolute(file).lexically_normal().parent_path().filename().string();
    names.push_back(is_alone || folder.empty() ? file.stem().string() : folder + "_" + file.stem().string());
  }
  return names;
}

/// As sentences call the file: behind its folder where several have its name.
std::string shown_among(const fs::path& file, const std::vector<fs::path>& files) {
  const auto has_its_name = [&](const fs::path& other) { return other.filename() == file.filename(); };
  const fs::path folder = fs::absolute(file).lexically_normal().parent_path().filename();
  return shown_path(std::count_if(files.begin(), files.end(), has_its_name) == 1 ? file.filename()
                                                                                 : folder / file.filename());
}

/// The tables among the files, each under its name; InputError where one is something else.
std::vector<std::pair<fs::path, Table>> tables_of(const std::vector<fs::path>& files, const Robot& robot,
                                                  const ConvertOptions& o, std::vector<Message>& notes) {
  std::vector<std::pair<fs::path, Table>> tables;
  for (const fs::path& file : files) {
    std::optional<Table> table;
    if (fs::is_regular_file(file))
      table = parse_touch_table(read_text(file), shown_among(file, files), &robot, o.columns);
    if (!table)
      throw InputError(message(
          "{}: is no table of touches; a session of touches is made of tables (CSV) of joint angles, fixture and "
          "reading, and of the robot.",
          shown_path(file)));
    name_joints(*table, robot, notes);
    if (!table->has_header)
      throw InputError(
          message("{}: has no header; name its columns in a first line, or with --table-columns \"a1 a2 ... "
                  "fixture value[mm]\".",
                  table->file));
    tables.emplace_back(file, std::move(*table));
  }
  if (tables.empty())
    throw InputError("There is no table of touches; name a CSV of joint angles, fixture and reading.");
  return tables;
}

/// Of a reading that is told by what it is off from the fixture's value.
double whole_reading(const TouchRow& row, const Fixture& fixture, const Fixtures& fixtures, const std::string& file) {
  const std::optional<double> from = fixtures.value_of(row.fixture);
  if (!from && fixture.kind->value == TouchValue::whole)
    throw InputError(
        message("{}: the readings of {} are deviations, and nothing says from which length; say --fixture \"{} {} ... "
                "value=METRES\".",
                file, in_quotes(row.fixture), std::string(fixture.kind->tag), shortened(row.fixture, 60)));
  return from.value_or(0) + *row.value;
}

void add_row(const TouchRow& row, const TouchTable& table, const Fixtures& fixtures, const std::string& file,
             Session& s) {
  const auto found =
      std::find_if(s.fixtures.begin(), s.fixtures.end(), [&](const Fixture& f) { return f.id == row.fixture; });
  std::optional<double> value = row.value ? row.value : fixtures.value_of(row.fixture);
  if (table.are_deviations && row.value) value = whole_reading(row, *found, fixtures, file);
  if (is_instrument(*found->kind) && !value)
    throw InputError(
        message("{}: a touch of {} has no reading, and it reads one; fill the column value, or say "
                "--fixture \"... value=METRES\" where it is the same for all.",
                file, in_quotes(row.fixture)));
  if (table.joints != s.joints)
    throw InputError(message("{}: has other joints, or in another order, than the table before.", file));
  Observation& o = s.observations.emplace_back();
  o.id = static_cast<std::int64_t>(s.observations.size()) - 1;
  o.time = row.time.value_or(static_cast<double>(o.id));
  o.position = row.position;
  o.part = static_cast<int>(found - s.fixtures.begin());
  o.sightings = touch_sightings(*found, row.marker, value.value_or(0));
  s.marker_count = std::max(s.marker_count, row.marker + 1);
}

/// One after another where several tables have times of their own.
void settle_times(std::vector<TouchTable>& tables) {
  double next = 0;
  for (TouchTable& t : tables) {
    if (t.rows.empty()) continue;
    const double first = t.rows.front().time.value_or(0);
    for (std::size_t r = 0; r < t.rows.size(); ++r)
      t.rows[r].time = next + (t.rows[r].time ? *t.rows[r].time - first : static_cast<double>(r));
    next = *t.rows.back().time + 1;
  }
}

void note_fixtures(const Session& s, std::vector<Message>& notes) {
  for (std::size_t f = 0; f < s.fixtures.size(); ++f) {
    const auto count = std::count_if(s.observations.begin(), s.observations.end(),
                                     [&](const Observation& o) { return o.part == static_cast<int>(f); });
    notes.push_back(message("Fixture {}: {} touches.", s.fixtures[f].id, count));
  }
  const bool any_undetermined =
      std::any_of(s.fixtures.begin(), s.fixtures.end(), [](const Fixture& f) { return !f.sigma.has_value(); });
  if (any_undetermined)
    notes.emplace_back(
        "How exactly a touch tells is estimated; where it is known say it: --sigma (m), or sigma=METRES of a "
        "--fixture.");
}

Session written(Session s, const FieldUrdf& robot, const ConvertOptions& o) {
  ask_whether_to_go_on(o);
  std::error_code error;
  fs::create_directories(o.out, error);
  if (error) throw InputError(message("{}: the folder cannot be made ({}).", shown_path(o.out), system_text(error)));
  replace_file(o.out / "robot.urdf", robot.text);
  replace_file(s.file, session_text(s));
  return read_session(s.file);
}

/// Words in a table, each of which sounds like a fixture.
bool are_known_fixtures(const std::vector<std::string>& words) {
  return !words.empty() &&
         std::all_of(words.begin(), words.end(), [](const std::string& w) { return kind_by_name(w); });
}

/// A table of joint readings and nothing else.
bool holds_joints_alone(const fs::path& file, const Robot& robot) {
  if (!fs::is_regular_file(file) || is_bag(file)) return false;
  const auto table = parse_touch_table(read_text(file), shown_path(file.filename()), &robot, {});
  if (!table) return false;
  return table->has_header ? list_joint_columns(*table, robot).size() == table->width()
                           : table->width() == joint_names(robot).size();
}

/// Files of joint readings alone, each named after a fixture: socket_1.csv, front/hole_0.csv.
bool are_named_after_fixtures(const std::vector<fs::path>& files, const Robot& robot) {
  if (files.empty() || !are_known_fixtures(fixtures_of_files(files))) return false;
  try {
    return std::all_of(files.begin(), files.end(), [&](const fs::path& f) { return holds_joints_alone(f, robot); });
  } catch (const InputError&) {
    return false;  // what it is, and what is wrong in it, is said where it is read
  }
}

}  // namespace

bool are_touches(const std::vector<fs::path>& files, const Robot* robot, const ConvertOptions& o) {
  if (!o.fixtures.empty() || (robot && are_named_after_fixtures(files, *robot))) return true;
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    if (!fs::is_regular_file(file) || is_bag(file)) return false;
    const std::string extension = file.extension().string();
    if (extension != ".csv" && extension != ".txt" && extension != ".tsv") return false;
    try {
      const auto table = parse_touch_table(read_text(file), shown_path(file.filename()), robot, o.columns);
      return table && (names_fixtures(*table) || are_known_fixtures(list_fixtures(*table)));
    } catch (const InputError&) {
      return false;  // what it is, and what is wrong in it, is said where it is read
    }
  });
}

Conversion from_touches(const std::optional<FieldUrdf>& robot, const std::vector<fs::path>& files,
                        const ConvertOptions& o, Conversion c) {
  if (!robot) throw InputError("There is no robot; name its URDF with --robot.");
  SessionParts links;
  std::vector<Message> mount_notes;
  require_links(*robot, o, links, mount_notes);
  Fixtures fixtures(o, c.notes);
  std::vector<TouchTable> tables;
  std::vector<std::string> names;
  const std::vector<std::string> fixtures_of = fixtures_of_files(files);
  for (auto& [file, table] : tables_of(files, robot->robot, o, c.notes)) {
    c.took.push_back(message("{}: a table of touches", table.file));
    names.push_back(table.file);
    const std::string fixture =
        fixtures.only().empty() || files.size() > 1 ? fixtures_of[names.size() - 1] : fixtures.only();
    tables.push_back(read_touch_table(std::move(table), robot->robot, fixture, o.degrees, c.notes));
    for (const TouchRow& row : tables.back().rows) fixtures.require(row.fixture, names.back());
  }
  settle_times(tables);
  Session s;
  s.file = o.out / "session.xml";
  s.title = o.title.empty() ? o.out.filename().string() : o.title;
  s.robot = parse_urdf(robot->text, "robot.urdf", nullptr);
  s.robot_file = "robot.urdf";
  s.tcp = links.tcp;
  if (find_link(s.robot, s.tcp) < 0)
    throw InputError(message("--tcp {}: the robot has no such link; it has: {}.", in_quotes(s.tcp),
                             shortened(fmt::format("{}", fmt::join(link_names(s.robot), " ")), 300)));
  s.marker_count = 1;
  fixtures.read_into(s);
  s.joints = tables.front().joints;
  for (std::size_t t = 0; t < tables.size(); ++t)
    for (const TouchRow& row : tables[t].rows) add_row(row, tables[t], fixtures, names[t], s);
  c.session = written(std::move(s), *robot, o);
  note_fixtures(c.session, c.notes);
  return c;
}

}  // namespace handsight
