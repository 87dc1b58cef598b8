// SPDX-License-Identifier: Apache-2.0
#include "session/collection.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr const char* root_tag = "handsight_collection";
constexpr const char* usual_name = "collection.xml";

std::vector<std::string> list_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t\n", begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

fs::path home_of(const fs::path& file) {
  std::error_code error;
  return fs::weakly_canonical(file.parent_path().empty() ? "." : file.parent_path(), error);
}

/// In the collection's folder, or in that in which it lies?
bool is_near(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path home = home_of(file);
  const fs::path there = fs::weakly_canonical(home / folder, error), around = home.parent_path();
  return std::mismatch(around.begin(), around.end(), there.begin(), there.end()).first == around.end();
}

void require_near(const XmlNode& node, const fs::path& file, const std::string& folder) {
  if (fs::path(folder).is_absolute() || !is_near(file, folder))
    refuse(node, message("has folder=\"{}\", expected a session's folder inside the collection's folder or beside it, "
                         "its path relative to the collection.",
                         folder));
}

/// Of a path, be there a slash at its end or not.
std::string last_part(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
}

CollectionEntry find_entry(const XmlNode& node, const fs::path& file) {
  CollectionEntry entry;
  entry.folder = required_text(node, "folder");
  require_near(node, file, entry.folder);
  entry.title = find_name(node, "title").value_or(last_part(entry.folder));
  entry.rig = find_name(node, "rig").value_or("");
  entry.body = find_name(node, "body").value_or("");
  entry.own = list_words(find_text(node, "own").value_or(""));
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
  const fs::path file = fs::is_directory(path, error) ? path / usual_name : path;
  return parse_collection(read_file(file), file);
}

Collection parse_collection(const std::string& text, const fs::path& file) {
  Collection collection;
  collection.file = file;
  const std::string name = collection.file.filename().string();
  const auto document = parse_xml(text, name);
  const XmlNode root = require_root(*document, name, root_tag);
  require_version_1(root);
  Ignored ignored;
  note_unknown(ignored, root, {"version", "title"}, {"session"});
  collection.title = find_text(root, "title").value_or(collection.file.parent_path().filename().string());
  for (const XmlNode& node : children(root, "session")) {
    note_unknown(ignored, node, {"folder", "title", "rig", "body", "own"}, {});
    collection.entries.push_back(find_entry(node, collection.file));
    const std::string& title = collection.entries.back().title;
    for (std::size_t i = 0; i + 1 < collection.entries.size(); ++i)
      if (collection.entries[i].title == title)
        refuse(node, message("is a second session called \"{}\", expected another title=\"\" for one of them.", title));
  }
  if (collection.entries.empty()) refuse(root, "has no <session>, expected one at least.");
  collection.notes = ignored_sentences(ignored, name);
  return collection;
}

fs::path find_folder(const Collection& collection, const CollectionEntry& entry) {
  return (collection.file.parent_path() / entry.folder).lexically_normal();
}

std::string folder_in_collection(const fs::path& session_folder, const fs::path& file) {
  std::error_code error;
  const fs::path there = fs::weakly_canonical(session_folder, error);
  if (!is_near(file, there))
    throw InputError(
        message("{}: lies neither inside the folder of {} nor beside it; write the collection into the folder that "
                "holds the sessions.",
                shown_path(there), shown_path(file)));
  return there.lexically_relative(home_of(file)).generic_string();
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
    const std::string last = last_part(entry.folder);
    if (entry.title != last) session->SetAttribute("title", entry.title.c_str());
    if (!entry.rig.empty()) session->SetAttribute("rig", entry.rig.c_str());
    if (!entry.body.empty()) session->SetAttribute("body", entry.body.c_str());
    std::string own;
    for (const std::string& effect : entry.own) own += (own.empty() ? "" : " ") + effect;
    if (!own.empty()) session->SetAttribute("own", own.c_str());
  }
  return xml_text(document);
}

}  // namespace handsight
