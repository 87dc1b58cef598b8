// SPDX-License-Identifier: GPL-3.0-or-later
#include "collection/shared.h"

#include <fmt/format.h>

#include <algorithm>

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

void share(Collection& c, std::size_t entry, std::size_t with, std::string CollectionEntry::*what, bool is_shared) {
  std::string& own = c.entries[entry].*what;
  std::string& other = c.entries[with].*what;
  if (!is_shared) {
    if (own == other) own.clear();
    return;
  }
  if (other.empty()) other = c.entries[with].title;
  own = other;
}

bool is_same(const std::string& a, const std::string& b) { return !a.empty() && a == b; }

}  // namespace

Shared shared_by(const Collection& c, std::size_t entry, std::size_t with) {
  const CollectionEntry &a = c.entries.at(entry), &b = c.entries.at(with);
  return {is_same(a.rig, b.rig), is_same(a.body, b.body)};
}

Collection with_shared(Collection c, std::size_t entry, std::size_t with, const Shared& shared) {
  share(c, entry, with, &CollectionEntry::rig, shared.rig);
  share(c, entry, with, &CollectionEntry::body, shared.body);
  return c;
}

Collection with_session(Collection c, const std::string& folder, const std::string& title) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(c.entries.begin(), c.entries.end(), [&](const CollectionEntry& e) { return e.title == name; });
  };
  std::string unique = title;
  for (int i = 2; is_taken(unique); ++i) unique = fmt::format("{} ({})", title, i);
  c.entries.push_back({folder, unique, "", "", {}});
  return c;
}

fs::path session_folder(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return fs::is_directory(real, error) ? real : real.parent_path();
}

fs::path common_folder(const fs::path& a, const fs::path& b) {
  fs::path common;
  const fs::path first = session_folder(a).parent_path(), second = session_folder(b).parent_path();
  for (auto i = first.begin(), j = second.begin(); i != first.end() && j != second.end() && *i == *j; ++i, ++j)
    common /= *i;
  return common;
}

}  // namespace handsight::app
