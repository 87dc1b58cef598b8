// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/made_of_files.h"

#include <algorithm>

#include "convert/bags/bag_sessions.h"
#include "convert/convert.h"
#include "convert/convert_collection.h"

namespace handsight::app {
namespace {

MadeOfFiles collected(const std::vector<std::filesystem::path>& files, const ConvertOptions& o,
                      const std::vector<ConvertOptions>& sessions, std::vector<Message> notes) {
  const ConvertedCollection made = convert_collection(files, {o.out, o.title, false, sessions});
  MadeOfFiles all{made.collection.file, made.sessions.size(), 0, std::move(notes)};
  const auto add = [&](const Message& note) {
    if (std::find(all.notes.begin(), all.notes.end(), note) == all.notes.end()) all.notes.push_back(note);
  };
  for (const Conversion& c : made.sessions) {
    all.observations += c.session.observations.size();
    for (const Message& note : c.notes) add(note);
  }
  for (const Message& note : made.notes) add(note);
  return all;
}

}  // namespace

MadeOfFiles made_of_files(const std::vector<std::filesystem::path>& files, const ConvertOptions& o,
                          bool is_mount_open) {
  std::vector<Message> notes;
  ConvertOptions open = o;
  if (is_mount_open) open.mount.clear();
  const std::vector<ConvertOptions> sessions = sessions_of_bag(files, {open}, notes);
  if (sessions.size() > 1) return collected(files, o, sessions, std::move(notes));
  const Conversion made = convert(files, o);
  return {made.session.file, 1, made.session.observations.size(), made.notes};
}

}  // namespace handsight::app
