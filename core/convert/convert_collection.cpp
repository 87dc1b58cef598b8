// SPDX-License-Identifier: Apache-2.0
#include "convert/convert_collection.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/convert.h"
#include "convert/own_files.h"
#include "readers/bags/bag.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// As a folder may be called: "/head/left" is head_left.
std::string plain_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.';
    if (is_plain || (!name.empty() && name.back() != '_')) name += is_plain ? c : '_';
  }
  while (!name.empty() && (name.back() == '_' || name.back() == '.')) name.pop_back();
  name.erase(0, std::min(name.find_first_not_of('.'), name.size()));
  return name;
}

bool are_different(const std::vector<std::string>& names) {
  const std::set<std::string> once(names.begin(), names.end());
  return once.size() == names.size() && !once.contains("");
}

/// What tells each session from the others: hands, then cameras, frames and mounts, as many of them as it takes.
std::vector<std::string> telling_titles(const std::vector<ConvertOptions>& sessions) {
  std::vector<std::string> names(sessions.size());
  const std::string ConvertOptions::*const telling[] = {&ConvertOptions::tcp, &ConvertOptions::camera,
                                                        &ConvertOptions::target_frame, &ConvertOptions::mount};
  for (const auto what : telling) {
    if (are_different(names)) break;
    const bool is_one = std::all_of(sessions.begin(), sessions.end(),
                                    [&](const ConvertOptions& o) { return o.*what == sessions.front().*what; });
    for (std::size_t i = 0; !is_one && i < names.size(); ++i)
      if (const std::string name = plain_name(sessions[i].*what); !name.empty())
        names[i] += (names[i].empty() ? "" : "_") + name;
  }
  return names;
}

/// Gives every one a title of its own that is a folder's name too.
void name_sessions(std::vector<ConvertOptions>& sessions) {
  const std::vector<std::string> telling = telling_titles(sessions);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    std::string name = plain_name(sessions[i].title);
    if (name.empty()) name = telling[i].empty() ? "session" : telling[i];
    std::string own = name;
    for (int k = 2; !taken.insert(own).second; ++k) own = fmt::format("{}_{}", name, k);
    sessions[i].title = own;
  }
}

std::vector<std::vector<std::string>> list_words(const std::vector<ConvertOptions>& sessions) {
  std::vector<std::vector<std::string>> words;
  for (const ConvertOptions& o : sessions) words.push_back({o.title, o.tcp, o.camera, o.target_frame});
  return words;
}

/// Would both be the same session?
bool are_alike(const ConvertOptions& a, const ConvertOptions& b) {
  const auto of = [](const ConvertOptions& o) {
    return std::tuple(o.tcp, o.mount, o.camera, o.target_frame, o.target ? describe_target(*o.target) : "");
  };
  return of(a) == of(b);
}

void require_different(const std::vector<ConvertOptions>& sessions, const std::vector<std::vector<fs::path>>& files) {
  for (std::size_t a = 0; a < sessions.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (are_alike(sessions[a], sessions[b]) && files[a] == files[b])
        throw InputError(
            message("The sessions {} and {} would be the same; each needs a --tcp, a --camera, a --target-frame or a "
                    "--target of its own, or files with its --title in their names.",
                    in_quotes(sessions[b].title), in_quotes(sessions[a].title)));
}

/// Hands of a robot of which only a flange is known have nothing in common.
void require_one_robot(const std::vector<Conversion>& made, const std::vector<ConvertOptions>& sessions) {
  const auto is_unknown = [](const Conversion& c) { return c.session.robot_file.empty(); };
  const bool one_hand = std::all_of(sessions.begin(), sessions.end(),
                                    [&](const ConvertOptions& o) { return o.tcp == sessions.front().tcp; });
  if (std::none_of(made.begin(), made.end(), is_unknown)) return;
  if (one_hand && std::all_of(made.begin(), made.end(), is_unknown)) return;
  throw InputError(
      "The sessions have different hands, and no robot is known that both are of; name its URDF with --robot.");
}

/// A name for each group of two and more, by what they have in common; "" for those that are alone.
std::vector<std::string> shared_names(const std::vector<std::string>& keys, const std::vector<std::string>& wanted) {
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].empty() || std::count(keys.begin(), keys.end(), keys[i]) < 2) {
      all.emplace_back();
      continue;
    }
    if (!names.contains(keys[i])) {
      std::string name = plain_name(wanted[i]);
      for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{}_{}", plain_name(wanted[i]), k);
      names[keys[i]] = name;
    }
    all.push_back(names[keys[i]]);
  }
  return all;
}

const char* sensor_kind(const Session& s) {
  if (s.rig) return "cameras";
  if (s.pose_sensor) return "poses of a target";
  return s.is_touch() ? "touches" : "points of a tracker";
}

/// What two sessions must have in common to have one rig; empty: nothing is reported.
std::string rig_key(const Conversion& c, bool one_sensor) {
  const Session& s = c.session;
  if (s.is_touch()) return "";
  const std::string sensor = one_sensor && !s.rig ? "one" : c.sensor;
  return sensor.empty() ? "" : fmt::format("{}\n{}\n{}", sensor_kind(s), s.mount.link, sensor);
}

std::string body_key(const Conversion& c) {
  if (c.target.empty()) return "";
  return fmt::format("{}\n{}\n{}", sensor_kind(c.session), c.session.tcp, c.target);
}

void require_one_sensor(const std::vector<Conversion>& made) {
  const Session& first = made.front().session;
  for (const Conversion& c : made) {
    const Session& s = c.session;
    if (s.rig || s.is_touch() || std::string_view(sensor_kind(s)) != sensor_kind(first) ||
        s.mount.link != first.mount.link)
      throw InputError(
          message("--one-sensor: the session {} is of {} on {}, {} of {} on {}; one tracker stands on one link, and "
                  "cameras are told by their images.",
                  in_quotes(first.title), sensor_kind(first), in_quotes(first.mount.link), in_quotes(s.title),
                  sensor_kind(s), in_quotes(s.mount.link)));
  }
}

void note_shared(const std::vector<CollectionEntry>& entries, std::string CollectionEntry::*what, const char* is_one,
                 std::vector<Message>& notes) {
  std::map<std::string, std::string> sessions;
  for (const CollectionEntry& e : entries)
    if (!(e.*what).empty()) sessions[e.*what] += (sessions[e.*what].empty() ? "" : ", ") + e.title;
  for (const auto& [name, titles] : sessions) notes.push_back(message("{} have one {} ({}).", titles, is_one, name));
  if (sessions.empty())
    notes.push_back(
        message("No two sessions have one {}; where they have, say so in "
                "collection.xml.",
                is_one));
}

Collection gather_collection(const std::vector<Conversion>& made, const CollectionOptions& o,
                             std::vector<Message>& notes) {
  std::vector<std::string> rigs, bodies, mounts, hands;
  for (const Conversion& c : made) {
    rigs.push_back(rig_key(c, o.one_sensor));
    bodies.push_back(body_key(c));
    mounts.push_back(c.session.mount.link);
    hands.push_back(c.session.tcp);
  }
  const std::vector<std::string> rig = shared_names(rigs, mounts), body = shared_names(bodies, hands);
  Collection collection;
  collection.file = o.out / "collection.xml";
  collection.title = o.title.empty() ? o.out.filename().string() : o.title;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::string title = made[i].session.title;
    collection.entries.push_back({title, title, rig[i], body[i], {}});
  }
  note_shared(collection.entries, &CollectionEntry::rig, "sensor at one place", notes);
  note_shared(collection.entries, &CollectionEntry::body, "body on one hand", notes);
  return collection;
}

Conversion converted_one(const std::vector<fs::path>& files, ConvertOptions o, const fs::path& out) {
  o.out = out / o.title;
  if (std::none_of(files.begin(), files.end(), is_bag)) o.camera.clear();  // it has told whose files are whose
  try {
    return convert(files, o);
  } catch (const InputError& error) {
    throw InputError(message("Session {}: {}", in_quotes(o.title), error.sentence()));
  }
}

void note_files(const std::vector<ConvertOptions>& sessions, const std::vector<std::vector<fs::path>>& files,
                std::size_t all, std::vector<Message>& notes) {
  for (std::size_t i = 0; i < sessions.size(); ++i)
    if (files[i].size() < all)
      notes.push_back(
          message("{} is made of {} of the {} files, by their names.", sessions[i].title, files[i].size(), all));
}

}  // namespace

ConvertedCollection convert_collection(const std::vector<fs::path>& files, const CollectionOptions& options) {
  CollectionOptions o = options;
  for (const char* name : {"collection.xml", "session.xml"})
    if (fs::exists(o.out / name))
      throw InputError(message("{}: there is a {} already; take another folder.", shown_path(o.out), name));
  ConvertedCollection made;
  auto whose = files_of_sessions(files, list_words(o.sessions));
  name_sessions(o.sessions);
  require_different(o.sessions, whose);
  note_files(o.sessions, whose, files.size(), made.notes);
  const bool is_new = !fs::exists(o.out);
  std::vector<fs::path> folders;
  try {
    for (std::size_t i = 0; i < o.sessions.size(); ++i) {
      const fs::path folder = o.out / o.sessions[i].title;
      if (fs::exists(folder))
        throw InputError(message("{}: is there already; take another folder, or another title.", shown_path(folder)));
      folders.push_back(folder);
      made.sessions.push_back(converted_one(whose[i], o.sessions[i], o.out));
      require_one_robot(made.sessions, o.sessions);
    }
    if (o.one_sensor) require_one_sensor(made.sessions);
    made.collection = gather_collection(made.sessions, o, made.notes);
    replace_file(made.collection.file, collection_text(made.collection));
  } catch (...) {
    std::error_code error;
    for (const fs::path& folder : folders) fs::remove_all(folder, error);
    if (is_new && !o.out.empty()) fs::remove_all(o.out, error);
    throw;
  }
  return made;
}

}  // namespace handsight
