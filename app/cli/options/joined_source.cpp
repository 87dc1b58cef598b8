// SPDX-License-Identifier: Apache-2.0
#include "joined_source.h"

#include <algorithm>

#include "base/error.h"

namespace handsight::cli {
namespace {

std::vector<std::string> parted(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (end > begin) names.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

/// Gives the sessions of each list one name.
void share(const std::vector<std::string>& lists, const char* option, std::string CollectionEntry::*what,
           Collection& collection) {
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (const std::string& name : parted(lists[i])) {
      const auto found = std::find_if(collection.entries.begin(), collection.entries.end(),
                                      [&](const CollectionEntry& e) { return e.folder == name || e.title == name; });
      if (found == collection.entries.end())
        throw InputError(
            message("{} {}: \"{}\" is none of the sessions that were given; name them as they are "
                    "given, with commas between.",
                    option, lists[i], name));
      (*found).*what = fmt::format("{} {}", option, i + 1);
    }
}

}  // namespace

Collection gather_collection(const std::vector<std::string>& paths, const std::vector<std::string>& same_rig,
                             const std::vector<std::string>& same_body) {
  Collection collection;
  for (const std::string& path : paths) {
    const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
    const std::filesystem::path folder = normal.filename().empty() ? normal.parent_path() : normal;
    std::string title =
        folder.filename() == "session.xml" ? folder.parent_path().filename().string() : folder.filename().string();
    const auto is_taken = [&](const std::string& name) {
      return std::any_of(collection.entries.begin(), collection.entries.end(),
                         [&](const CollectionEntry& e) { return e.title == name; });
    };
    if (is_taken(title)) title = path;
    for (int i = 2; is_taken(title); ++i) title = fmt::format("{} ({})", path, i);
    collection.entries.push_back({path, title, "", "", {}});
    collection.title += (collection.title.empty() ? "" : " + ") + title;
  }
  share(same_rig, "--same-rig", &CollectionEntry::rig, collection);
  share(same_body, "--same-body", &CollectionEntry::body, collection);
  return collection;
}

}  // namespace handsight::cli
