// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/opened_files.h"

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "base/files.h"
#include "estimation/fit/joined_collection.h"
#include "estimation/fit/member_noise.h"
#include "session/edit.h"
#include "session/session_xml.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

Session joined_session(const OpenedFiles& files) {
  return joined(files.members, files.collection->title, files.collection->file);
}

/// A label as its own session numbers markers and cameras; what it weighs beside other sensors is not its own.
Sighting own_sighting(const SessionPart& part, const Observation& known, Sighting s) {
  s.marker -= part.first_marker;
  const auto same = std::find_if(known.sightings.begin(), known.sightings.end(),
                                 [&](const Sighting& k) { return k.marker == s.marker; });
  const Sighting* const before = same == known.sightings.end() ? nullptr : &*same;
  for (CameraPoint& p : s.in_cameras) {
    p.camera -= part.first_camera;
    const CameraPoint* const seen = before ? seen_by(*before, p.camera) : nullptr;
    p.sigma = seen && seen->pixel == p.pixel ? seen->sigma : std::nullopt;
  }
  s.point_sigma = before ? before->point_sigma : std::nullopt;
  s.usual_sigma = before ? before->usual_sigma : 0;
  return s;
}

void take_state(const SessionPart& part, const EditableState& state, Observation& own) {
  EditableState mine{{}, state.decision, state.reason};
  for (const Sighting& s : state.sightings) mine.sightings.push_back(own_sighting(part, own, s));
  set_state(own, mine);
}

bool are_same(const Session& a, const Session& b) {
  return std::equal(
      a.observations.begin(), a.observations.end(), b.observations.begin(), b.observations.end(),
      [](const Observation& x, const Observation& y) { return same_state(read_state(x), read_state(y)); });
}

bool is_same_entry(const CollectionEntry& a, const CollectionEntry& b) {
  return a.folder == b.folder && a.title == b.title;
}

}  // namespace

OpenedSession open_files(const fs::path& path) {
  OpenedSession opened;
  if (!is_collection(path)) {
    opened.session = read_session(path);
    opened.files.file = opened.session.file;
    return opened;
  }
  opened.files.collection = read_collection(path);
  opened.files.file = opened.files.collection->file;
  opened.files.members =
      list_members(*opened.files.collection, [](const std::string& folder) { return read_session(folder); });
  opened.session = joined_session(opened.files);
  const std::vector<Message>& notes = opened.files.collection->notes;
  opened.session.notes.insert(opened.session.notes.begin(), notes.begin(), notes.end());
  return opened;
}

std::string make_content(const OpenedFiles& files) {
  std::string content = read_file(files.file);
  for (const JoinedMember& m : files.members) content += '\0' + read_file(m.session.file);
  return content;
}

std::string shared_text(const OpenedFiles& files) { return collection_text(*files.collection); }

std::vector<JoinedMember> members_with(const OpenedFiles& files, const Session& now) {
  std::vector<JoinedMember> members = files.members;
  if (members.empty()) return members;
  if (members.size() == 1) {
    members.front().session.observations = now.observations;
    return members;
  }
  const Session before = joined_session(files);
  for (std::size_t i = 0; i < before.observations.size(); ++i) {
    const Observation& o = before.observations[i];
    const EditableState state = read_state(now.observations.at(i));
    if (same_state(read_state(o), state)) continue;
    const SessionPart& part = before.parts[static_cast<std::size_t>(o.part)];
    for (Observation& own : members[static_cast<std::size_t>(o.part)].session.observations)
      if (own.id == o.id - part.first_id) take_state(part, state, own);
  }
  return members;
}

OpenedSession rejoined(const OpenedFiles& files, const Session& session, const std::string& text) {
  OpenedSession opened;
  opened.files.file = files.file;
  opened.files.collection = parse_collection(text, files.file);
  const std::vector<JoinedMember> known = members_with(files, session);
  bool are_others = opened.files.collection->entries.size() != known.size();
  for (const CollectionEntry& entry : opened.files.collection->entries) {
    JoinedMember m{.title = entry.title, .rig = entry.rig, .body = entry.body, .own = entry.own};
    const auto& before = files.collection->entries;
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const CollectionEntry& e) { return is_same_entry(e, entry); });
    if (same == before.end()) {
      m.session = read_session(find_folder(*opened.files.collection, entry));
      are_others = true;
    } else {
      const JoinedMember& one = known[static_cast<std::size_t>(same - before.begin())];
      m.session = one.session;
      m.noise = one.noise;
    }
    opened.files.members.push_back(std::move(m));
  }
  if (are_others) {  // as they would be had they been opened together
    for (JoinedMember& m : opened.files.members) m.noise.reset();
    learn_noise(opened.files.members);
  }
  opened.session = joined_session(opened.files);
  return opened;
}

SavedFiles saved_files(const OpenedFiles& files, const Session& now, bool is_collection_changed) {
  SavedFiles saved{files, {}, {}};
  saved.files.members = members_with(files, now);
  const std::string collection = is_collection_changed ? shared_text(files) : read_file(files.file);
  if (is_collection_changed) saved.texts.push_back({files.file, collection});
  saved.content = collection;
  for (std::size_t i = 0; i < files.members.size(); ++i) {
    Session& session = saved.files.members[i].session;
    if (!are_same(session, files.members[i].session)) {
      session.source = std::make_shared<const std::string>(session_text(session));
      saved.texts.push_back({session.file, *session.source});
    }
    saved.content += '\0' + *session.source;
  }
  return saved;
}

void write_files(const SavedFiles& saved) {
  for (const FileText& one : saved.texts) replace_file(one.file, one.text);
}

}  // namespace handsight::app
