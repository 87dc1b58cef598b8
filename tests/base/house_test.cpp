// SPDX-License-Identifier: Apache-2.0
// The house is in order: of the folders of core, widgets and app each uses only those above it, and each is told of in
// its CMakeLists.txt.
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

/// The folders in the order in which the CMakeLists.txt of `house` tells of them: the first group of each match, which
/// may name several.
std::vector<std::string> told_folders(const std::string& house, const std::regex& line) {
  const std::string text = read_file(root / house / "CMakeLists.txt");
  static const std::regex name("[a-z]+");
  std::vector<std::string> folders;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
    const std::string names = (*i)[1];
    for (std::sregex_iterator n(names.begin(), names.end(), name); n != end; ++n) folders.push_back(n->str());
  }
  return folders;
}

/// What the sources of a folder include with a path of at least two parts, below `prefix`: the first part.
std::set<std::string> included_folders(const std::filesystem::path& folder, const std::string& prefix) {
  const std::regex include("#include \"" + prefix + "([a-z_]+)/");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i) found.insert((*i)[1]);
  }
  return found;
}

void expect_one_way(const std::string& house, const std::string& prefix, const std::vector<std::string>& folders,
                    const std::set<std::string>& beside_each_other = {}) {
  for (std::size_t i = 0; i < folders.size(); ++i)
    for (const std::string& used : included_folders(root / house / folders[i], prefix)) {
      const auto place = std::find(folders.begin(), folders.end(), used);
      if (place == folders.end() || used == folders[i]) continue;
      EXPECT_LT(place - folders.begin(), static_cast<std::ptrdiff_t>(i))
          << house << "/" << folders[i] << " uses " << used << ", which is below it";
      EXPECT_FALSE(beside_each_other.contains(used) && beside_each_other.contains(folders[i]))
          << folders[i] << " and " << used << " are not to know each other";
    }
}

/// The folders that hold sources.
std::set<std::string> folders_on_disk(const std::string& house) {
  std::set<std::string> folders;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / house))
    if (entry.path().extension() == ".cpp" && entry.path().parent_path() != root / house)
      folders.insert(entry.path().parent_path().filename().string());
  return folders;
}

TEST(House, AFolderOfCoreUsesOnlyThoseAboveIt) {
  const auto folders = told_folders("core", std::regex("handsight_library\\(([a-z]+)"));
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

}  // namespace
}  // namespace handsight::test
