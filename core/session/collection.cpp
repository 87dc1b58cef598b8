// SPDX-License-Identifier: Apache-2.0
#include "session/collection.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/xml.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr const char* root_tag = "handsight_collection";
constexpr const char* usual_name = "collection.xml";

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t\n", begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// The collection's folder, or that in which it lies.
void require_near(const XmlNode& node, const fs::path& file, const std::string& folder) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(file.parent_path().empty() ? "." : file.parent_path(), error);
  const fs::path there = fs::weakly_canonical(home / folder, error), around = home.parent_path();
  const bool is_near = !fs::path(folder).is_absolute() &&
                       std::mismatch(around.begin(), around.end(), there.begin(), there.end()).first == around.end();
  if (!is_near)
    refuse(node,
           "has folder=\"" + folder +
               "\", expected a session's folder inside the collection's folder or beside it, its path relative to "
               "the collection.");
}

CollectionEntry entry_of(const XmlNode& node, const fs::path& file) {
  CollectionEntry entry;
  entry.folder = required_text(node, "folder");
  require_near(node, file, entry.folder);
  const fs::path path = fs::path(entry.folder).lexically_normal();
  const std::string last = path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
  entry.title = find_name(node, "title").value_or(last);
  entry.rig = find_name(node, "rig").value_or("");
  entry.body = find_name(node, "body").value_or("");
  entry.own = words_of(find_text(node, "own").value_or(""));
  return entry;
}

}  // namespace

bool is_collection(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    return fs::exists(path / usual_name, error) && !fs::exists(path / "session.xml", error);
  if (path.extension() != ".xml" || !fs::is_regular_file(path, error)) return false;
  return path.filename() == usual_name || read_file(path).find(std::string("<") + root_tag) != std::string::npos;
}

Collection read_collection(const fs::path& path) {
  std::error_code error;
  Collection collection;
  collection.file = fs::is_directory(path, error) ? path / usual_name : path;
  const std::string name = collection.file.filename().string();
  const auto document = parse_xml(read_file(collection.file), name);
  const XmlNode root = root_of(*document, name, root_tag);
  require_version_1(root);
  Ignored ignored;
  note_unknown(ignored, root, {"version", "title"}, {"session"});
  collection.title = find_text(root, "title").value_or(collection.file.parent_path().filename().string());
  for (const XmlNode& node : children(root, "session")) {
    note_unknown(ignored, node, {"folder", "title", "rig", "body", "own"}, {});
    collection.entries.push_back(entry_of(node, collection.file));
    const std::string& title = collection.entries.back().title;
    for (std::size_t i = 0; i + 1 < collection.entries.size(); ++i)
      if (collection.entries[i].title == title)
        refuse(node, "is a second session called \"" + title + "\", expected another title=\"\" for one of them.");
  }
  if (collection.entries.empty()) refuse(root, "has no <session>, expected one at least.");
  collection.notes = ignored_sentences(ignored, name);
  return collection;
}

fs::path folder_of(const Collection& collection, const CollectionEntry& entry) {
  return (collection.file.parent_path() / entry.folder).lexically_normal();
}

std::string collection_text(const Collection& collection) {
  tinyxml2::XMLDocument document;
  tinyxml2::XMLElement* root = document.NewElement(root_tag);
  document.InsertEndChild(root);
  root->SetAttribute("version", "1");
  root->SetAttribute("title", collection.title.c_str());
  for (const CollectionEntry& entry : collection.entries) {
    tinyxml2::XMLElement* session = root->InsertNewChildElement("session");
    session->SetAttribute("folder", entry.folder.c_str());
    const fs::path last = fs::path(entry.folder).filename();
    if (entry.title != last.string()) session->SetAttribute("title", entry.title.c_str());
    if (!entry.rig.empty()) session->SetAttribute("rig", entry.rig.c_str());
    if (!entry.body.empty()) session->SetAttribute("body", entry.body.c_str());
    std::string own;
    for (const std::string& effect : entry.own) own += (own.empty() ? "" : " ") + effect;
    if (!own.empty()) session->SetAttribute("own", own.c_str());
  }
  return xml_text(document);
}

}  // namespace handsight
