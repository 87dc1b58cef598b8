// SPDX-License-Identifier: Apache-2.0
// The house is in order: of the folders of core, widgets and app, and of their rooms, each uses only those above it,
// each is described in its CMakeLists.txt, none is too full to be found through, no sources include each other in a
// circle, and no two types have one name.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"

namespace handsight::test {
namespace {

const std::filesystem::path root = HANDSIGHT_SOURCE_DIR;

bool is_source(const std::filesystem::path& path) {
  const auto kind = path.extension();
  return kind == ".h" || kind == ".cpp" || kind == ".inc";
}

/// The folders in the order in which the CMakeLists.txt of `house` tells of them: the first group of each match, which
/// may name several.
std::vector<std::string> told_folders(const std::string& house, const std::regex& line) {
  const std::string text = read_file(root / house / "CMakeLists.txt");
  static const std::regex name("[a-z_]+");
  std::vector<std::string> folders;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
    const std::string names = (*i)[1];
    for (std::sregex_iterator n(names.begin(), names.end(), name); n != end; ++n) folders.push_back(n->str());
  }
  return folders;
}

/// Of the folders of `house` those from which the sources of `folder` include something, as "PREFIXFOLDER/...".
std::set<std::string> included_folders(const std::filesystem::path& house, const std::string& folder,
                                       const std::string& prefix) {
  const std::regex include("#include \"" + prefix + "(([a-z_]+)/[^\"]+)\"");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(house / folder)) {
    if (!is_source(entry.path())) continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i)
      if (std::filesystem::exists(house / i->str(1))) found.insert((*i)[2]);  // core has a compare/ as app has
  }
  return found;
}

void expect_one_way(const std::string& house, const std::string& prefix, const std::vector<std::string>& folders,
                    const std::set<std::string>& beside_each_other = {}) {
  for (std::size_t i = 0; i < folders.size(); ++i)
    for (const std::string& used : included_folders(root / house, folders[i], prefix)) {
      const auto place = std::find(folders.begin(), folders.end(), used);
      if (place == folders.end() || used == folders[i]) continue;
      EXPECT_LT(place - folders.begin(), static_cast<std::ptrdiff_t>(i))
          << house << "/" << folders[i] << " uses " << used << ", which is below it";
      EXPECT_FALSE(beside_each_other.contains(used) && beside_each_other.contains(folders[i]))
          << folders[i] << " and " << used << " are not to know each other";
    }
}

/// The rooms of a folder of core as the list beside its library tells them: "rooms: image/ corners/ markers/".
std::map<std::string, std::vector<std::string>> told_rooms() {
  const std::string text = read_file(root / "core" / "CMakeLists.txt");
  static const std::regex library("handsight_library\\(([a-z_]+)"), rooms("rooms: ((?:[a-z_]+/ ?)+)"), room("[a-z_]+");
  std::map<std::string, std::vector<std::string>> found;
  std::string pending;  // told in the line above the library
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    std::smatch list, name;
    if (std::regex_search(line, list, rooms)) pending = list[1];
    if (pending.empty() || !std::regex_search(line, name, library)) continue;
    for (std::sregex_iterator i(pending.begin(), pending.end(), room), none; i != none; ++i)
      found[name[1]].push_back(i->str());
    pending.clear();
  }
  return found;
}

/// What a source includes of the project, found as the compiler finds it: beside it, then below one of `below`.
std::vector<std::filesystem::path> included_sources(const std::filesystem::path& source,
                                                    const std::vector<std::filesystem::path>& below) {
  static const std::regex include("#include \"([^\"]+)\"");
  const std::string text = read_file(source);
  std::vector<std::filesystem::path> found;
  for (std::sregex_iterator i(text.begin(), text.end(), include), none; i != none; ++i) {
    std::vector<std::filesystem::path> places = {source.parent_path()};
    places.insert(places.end(), below.begin(), below.end());
    for (const auto& place : places)
      if (std::filesystem::exists(place / i->str(1))) {
        found.push_back((place / i->str(1)).lexically_normal());
        break;
      }
  }
  return found;
}

/// x.h, x.cpp and x.inc are one.
std::string find_unit(const std::filesystem::path& source) {
  return std::filesystem::path(source).replace_extension().string();
}

/// A circle of units that include each other, as far as `from` leads into one; empty where there is none.
std::vector<std::string> circle_from(const std::string& from, const std::map<std::string, std::set<std::string>>& uses,
                                     std::set<std::string>& done, std::vector<std::string>& way) {
  if (done.contains(from)) return {};
  if (const auto again = std::find(way.begin(), way.end(), from); again != way.end()) return {again, way.end()};
  way.push_back(from);
  for (const std::string& next : uses.at(from))
    if (uses.contains(next))
      if (auto circle = circle_from(next, uses, done, way); !circle.empty()) return circle;
  way.pop_back();
  done.insert(from);
  return {};
}

/// The folders that hold sources.
std::set<std::string> folders_on_disk(const std::string& house) {
  std::set<std::string> folders;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house))
    if (entry.path().extension() == ".cpp" && entry.path().parent_path() != root / house)
      folders.insert(entry.path().lexically_relative(root / house).begin()->string());
  return folders;
}

TEST(House, AFolderOfCoreUsesOnlyThoseAboveIt) {
  const auto folders = told_folders("core", std::regex("handsight_library\\(([a-z_]+)"));
  ASSERT_GE(folders.size(), 12U);
  expect_one_way("core", "", folders);
}

TEST(House, AFolderOfWidgetsUsesOnlyThoseAboveIt) {
  const auto folders = told_folders("widgets", std::regex("#   ([a-z]+)/ "));
  EXPECT_EQ(std::set<std::string>(folders.begin(), folders.end()), folders_on_disk("widgets"));
  expect_one_way("widgets", "widgets/", folders);
}

TEST(House, AFolderOfTheWindowUsesOnlyThoseAboveItAndWorkspacesDoNotKnowEachOther) {
  const auto folders = told_folders("app", std::regex("#   ((?:[a-z]+/ )+)"));
  std::set<std::string> there = folders_on_disk("app");
  for (const char* program : {"cli", "python"}) there.erase(program);
  EXPECT_EQ(std::set<std::string>(folders.begin(), folders.end()), there);
  expect_one_way("app", "", folders, {"label", "calibrate", "inspect", "explain", "export"});
}

TEST(House, ARoomUsesOnlyThoseAboveIt) {
  const auto rooms = told_rooms();
  ASSERT_GE(rooms.size(), 4U);
  for (const auto& [folder, names] : rooms) {
    std::set<std::string> there;
    for (const auto& entry : std::filesystem::directory_iterator(root / "core" / folder))
      if (entry.is_directory()) there.insert(entry.path().filename().string());
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), there) << "rooms of core/" << folder;
    expect_one_way("core/" + folder, folder + "/", names);
  }
}

TEST(House, NoFolderIsTooFull) {
  constexpr int most = 25;  // sources, headers apart
  for (const char* house : {"core", "widgets", "app"}) {
    std::map<std::string, int> sources;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house))
      if (entry.path().extension() == ".cpp") ++sources[entry.path().parent_path().string()];
    for (const auto& [folder, count] : sources) EXPECT_LE(count, most) << folder;
  }
}

TEST(House, NoSourcesIncludeEachOtherInACircle) {
  std::map<std::string, std::set<std::string>> uses;
  for (const char* house : {"core", "widgets", "app"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house)) {
      if (!is_source(entry.path())) continue;
      auto& used = uses[find_unit(entry.path())];
      for (const auto& other :
           included_sources(entry.path(), {root / "core", root / "app", root / "app" / "cli", root}))
        if (find_unit(other) != find_unit(entry.path())) used.insert(find_unit(other));
    }
  ASSERT_GE(uses.size(), 300U);
  std::set<std::string> done;
  for (const auto& [unit, used] : uses) {
    std::vector<std::string> way, circle = circle_from(unit, uses, done, way);
    std::string reported;
    for (const std::string& one : circle) reported += one + "\n";
    ASSERT_TRUE(circle.empty()) << "include each other:\n" << reported;
  }
}

/// The sources of core, widgets and app in which this is written.
std::set<std::string> sources_with(const std::regex& what) {
  std::set<std::string> found;
  for (const char* house : {"core", "widgets", "app"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house))
      if (is_source(entry.path()) && std::regex_search(read_file(entry.path()), what))
        found.insert(entry.path().lexically_relative(root).string());
  return found;
}

TEST(House, WhatManyNeedStandsInOnePlace) {
  using Places = std::set<std::string>;
  EXPECT_EQ(sources_with(std::regex("tolower")), Places{"core/base/letters.cpp"}) << "lower_case";
  EXPECT_EQ(sources_with(std::regex("size\\(\\) / 2\\);\n *std::nth_element")), Places{"core/base/median.h"})
      << "median";
}

/// The types that a source defines for others to see, "handsight::app::Player": those outside an unnamed namespace.
std::vector<std::string> shown_types(const std::string& text) {
  static const std::regex line(
      "^(?:namespace ([\\w:]*) ?\\{$|(\\}  // namespace)|(?:enum class|enum|struct|class) (\\w+) [^;{]*\\{)",
      std::regex::multiline);
  std::vector<std::string> inside, types;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
    const std::smatch& m = *i;
    const bool is_hidden = std::find(inside.begin(), inside.end(), "") != inside.end();
    if (m[2].matched && !inside.empty()) {
      inside.pop_back();
    } else if (m[3].matched && !is_hidden) {
      std::string name;
      for (const std::string& outer : inside) name += outer + "::";
      types.push_back(name + m.str(3));
    } else if (!m[2].matched && !m[3].matched) {
      inside.push_back(m.str(1));
    }
  }
  return types;
}

/// The linker keeps one of what two make for lists of their types, and the other works with wrong sizes.
TEST(House, NoTwoTypesHaveOneName) {
  std::map<std::string, std::set<std::string>> places;
  for (const char* house : {"core", "widgets", "app"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house))
      if (is_source(entry.path()))
        for (const std::string& type : shown_types(read_file(entry.path())))
          places[type].insert(entry.path().lexically_relative(root).string());
  ASSERT_GE(places.size(), 500U);
  ASSERT_TRUE(places.contains("handsight::app::Player"));
  for (const auto& [type, in] : places) EXPECT_EQ(in.size(), 1U) << type << ": " << *in.begin() << ", " << *in.rbegin();
}

TEST(House, AnExporterKnowsNoEffectByName) {
  const std::string list = read_file(root / "core" / "effects" / "list.inc");
  static const std::regex entry("HANDSIGHT_EFFECT\\((\\w+)\\)");
  std::string ids;
  for (std::sregex_iterator i(list.begin(), list.end(), entry), none; i != none; ++i)
    ids += (ids.empty() ? "" : "|") + i->str(1);
  ASSERT_NE(ids, "");
  for (const std::string& source : sources_with(std::regex("\"(" + ids + ")\"")))
    EXPECT_FALSE(source.starts_with("core/export/")) << source << ": ask the effect for its formulas";
}

}  // namespace
}  // namespace handsight::test
