// SPDX-License-Identifier: Apache-2.0
#include "convert/own_files.h"

#include <algorithm>
#include <cctype>

#include "base/letters.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// Letters and digits in lower case, "_" for all between: "_left_hand_points_csv_".
std::string plain(const std::string& text) {
  std::string words = "_";
  for (const char c : lower_case(text)) {
    const auto sign = static_cast<unsigned char>(c);
    if (std::isalnum(sign) || sign >= 128)
      words += c;
    else if (words.back() != '_')
      words += '_';
  }
  return words.back() == '_' ? words : words + "_";
}

bool is_robot_file(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".urdf" || ending == ".xml" || ending == ".xacro";
}

fs::path whole_path(const fs::path& file) {
  const fs::path normal = fs::absolute(file).lexically_normal();
  return normal.filename().empty() ? normal.parent_path() : normal;
}

/// The deepest folder that holds them all.
fs::path folder_above(const std::vector<fs::path>& files) {
  fs::path above = whole_path(files.front()).parent_path();
  for (const fs::path& file : files) {
    const fs::path there = whole_path(file).parent_path();
    fs::path both;
    for (auto a = above.begin(), b = there.begin(); a != above.end() && b != there.end() && *a == *b; ++a, ++b)
      both /= *a;
    above = both;
  }
  return above;
}

/// How long the longest of these words in the name is; 0: none is in it.
std::size_t longest_word(const std::string& name, const std::vector<std::string>& words) {
  std::size_t longest = 0;
  for (const std::string& word : words) {
    const std::string wanted = plain(word);
    if (wanted.size() > 1 && name.find(wanted) != std::string::npos) longest = std::max(longest, wanted.size());
  }
  return longest;
}

}  // namespace

std::vector<std::vector<fs::path>> files_of_sessions(const std::vector<fs::path>& files,
                                                     const std::vector<std::vector<std::string>>& words_of_sessions) {
  std::vector<std::vector<fs::path>> own(words_of_sessions.size());
  if (files.empty()) return own;
  const fs::path above = folder_above(files);
  for (const fs::path& file : files) {
    const std::string name = is_robot_file(file) ? "" : plain(whole_path(file).lexically_relative(above).string());
    std::vector<std::size_t> lengths;
    for (const auto& words : words_of_sessions) lengths.push_back(longest_word(name, words));
    const std::size_t longest = *std::max_element(lengths.begin(), lengths.end());
    for (std::size_t s = 0; s < own.size(); ++s)
      if (lengths[s] == longest) own[s].push_back(file);
  }
  return own;
}

}  // namespace handsight
