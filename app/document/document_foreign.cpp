// SPDX-License-Identifier: GPL-3.0-or-later
// Saving, and what another program wrote into session.xml since it was read.
#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "document/document.h"
#include "session/session_xml.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

bool are_same(const Collision& a, const Collision& b) { return a.what == b.what && a.id == b.id; }

/// The session that a merge makes with what was decided for here.
Session decided_session(const Merge& merge, const std::vector<Collision>& decided, const std::vector<bool>& mine) {
  Session session = merge.session;
  for (const Collision& c : merge.collisions)
    for (std::size_t i = 0; i < decided.size(); ++i)
      if (are_same(c, decided[i]) && mine[i]) take_mine(c, session);
  return session;
}

/// The action that makes one session of the other; nothing where it cannot be said as one.
std::optional<Edit> action_between(const Session& from, const Session& to) {
  auto edit = edit_between(from, to);
  if (!edit) return std::nullopt;
  return Edit{.observations = std::move(edit->observations), .added = std::move(edit->added)};
}

/// What stood in a journal that belongs to another content of the file, net.
struct Unsaved {
  std::vector<DoneEdit> done;  // since the last save
  ModelSettings settings;
  std::map<std::string, RobotReading> readings;
  std::map<std::int64_t, LabelDraft> drafts;
};

template <class Map, class Key, class Value>
void put(Map& map, const Key& key, const std::optional<Value>& value) {
  map.erase(key);
  if (value) map[key] = *value;
}

void walk(const Edit& edit, bool forward, Unsaved& unsaved) {
  unsaved.done.push_back({{edit.observations, edit.added}, forward});
  if (edit.settings) unsaved.settings = forward ? edit.settings->after : edit.settings->before;
  if (edit.reading) put(unsaved.readings, edit.reading->effect, forward ? edit.reading->after : edit.reading->before);
  if (edit.draft) put(unsaved.drafts, edit.draft->observation, forward ? edit.draft->after : edit.draft->before);
}

Unsaved unsaved_of(const std::vector<JournalEntry>& entries) {
  Unsaved unsaved;
  std::vector<Edit> stack;
  std::size_t index = 0;
  for (const JournalEntry& entry : entries) switch (entry.kind) {
      case JournalEntry::Kind::done:
        stack.resize(index);
        // What joins the action before it is undone with it.
        if (entry.edit.joins != 0 && index > 0 && stack.back().joins == entry.edit.joins) {
          stack.back() = joined(std::move(stack.back()), entry.edit);
        } else {
          stack.push_back(entry.edit);
          ++index;
        }
        walk(entry.edit, true, unsaved);
        break;
      case JournalEntry::Kind::undone:
        if (index > 0) walk(stack[--index], false, unsaved);
        break;
      case JournalEntry::Kind::redone:
        if (index < stack.size()) walk(stack[index++], true, unsaved);
        break;
      case JournalEntry::Kind::saved:
        unsaved.done.clear();
        break;
    }
  return unsaved;
}

}  // namespace

std::optional<std::string> Document::what_another_wrote() const {
  std::error_code error;
  if (!std::filesystem::exists(files_.file, error)) return std::nullopt;
  std::string theirs = make_content(files_);
  return compute_digest(theirs) == digest_ ? std::nullopt : std::optional(std::move(theirs));
}

bool Document::is_changed_by_another() const {
  if (!journal_) return false;
  try {
    return what_another_wrote().has_value();
  } catch (const InputError&) {
    return false;
  }
}

void Document::save() {
  if (!journal_) return;
  if (files_.is_collection()) return save_collection();
  const auto theirs = what_another_wrote();
  if (!theirs) return write_session({}, true);
  save_with(*theirs, {}, {});
}

/// False where something is left to decide.
bool Document::save_with(const std::string& text, const std::vector<Collision>& decided,
                         const std::vector<bool>& mine) {
  Session theirs;
  try {
    theirs = read_session(session_->file);
  } catch (const InputError&) {
    // What is no session cannot be put together with one.
    write_session(tr("; another program had changed it meanwhile, and what it wrote is kept in %1")
                      .arg(QString::fromStdString(set_aside(text))),
                  false);
    return true;
  }
  const Session base = parse_session(*session_->source, session_->file.filename().string());
  Merge merge = merged(own_changes(base, *session_), session_.get(), theirs);
  for (const Collision& c : merge.collisions) {
    const bool is_decided =
        std::any_of(decided.begin(), decided.end(), [&](const Collision& d) { return are_same(c, d); });
    if (is_decided) continue;
    set_collisions(std::move(merge.collisions), true);
    return false;
  }
  set_collisions({}, true);
  if (!merge.collisions.empty() && merge.collisions.front().what == Collision::What::session) {
    if (mine.front()) {
      write_session(tr("; what the other program wrote is kept in %1").arg(QString::fromStdString(set_aside(text))),
                    false);
    } else {
      begin_anew(theirs, theirs, compute_digest(text));
    }
    return true;
  }
  merge.session = decided_session(merge, decided, mine);
  if (take_over(merge, std::move(theirs), compute_digest(text)))
    write_session(tr("; what another program wrote meanwhile is in it too"), true);
  return true;
}

/// `is_theirs_known`: only what is known to stand there is replaced.
void Document::write_session(const QString& more, bool is_theirs_known) {
  const std::string text = session_text(*session_);
  const std::string digest = compute_digest(text);
  // Marked before the file is replaced: a kill between the two finds the old content, and replays.
  // Where the state folder's disk is full the session itself is saved all the same.
  const bool is_marked = write_down({JournalEntry::Kind::saved, {}, digest});
  std::error_code error;
  if (is_theirs_known && session_->source && std::filesystem::exists(session_->file, error)) {
    replace_unchanged_file(session_->file, text, digest_of_content(*session_->source));
  } else {
    replace_file(session_->file, text);
  }
  own_session().source = std::make_shared<const std::string>(text);
  digest_ = digest;
  stack_.setClean();
  emit noticed(tr("Saved in %1").arg(QString::fromStdString(session_->file.string())) + more +
               (more.isEmpty() ? "" : "."));
  if (!is_marked) emit noticed(tr("Saved, but the journal cannot be written: a kill would bring the actions back."));
}

/// Copies it beside session.xml, and says where to.
std::string Document::set_aside(const std::string& theirs) const {
  std::filesystem::path aside = session_->file;
  aside.replace_filename(session_->file.stem().string() + "." + compute_digest(theirs).substr(0, 8) +
                         session_->file.extension().string());
  replace_file(aside, theirs);
  return aside.string();
}

/// The document becomes what the merge made: by one more action where that can tell it, else begun anew with what was
/// done here on top. False where it cannot be written down.
bool Document::take_over(const Merge& merge, Session theirs, const std::string& digest) {
  auto edit = action_between(*session_, merge.session);
  if (!edit) return begin_anew(std::move(theirs), merge.session, digest);
  const auto changed = static_cast<qint64>(edit->observations.size() + edit->added.size());
  edit->sentence = tr("took over %1 from another program").arg(counted(changed, "%n observation(s)"));
  if (!perform(std::move(*edit))) return false;
  own_session().source = merge.session.source;  // what is not understood of it stays
  digest_ = digest;
  return true;
}

bool Document::begin_anew(Session theirs, const Session& merged, const std::string& digest) {
  std::optional<Edit> own = action_between(theirs, merged);
  check(own.has_value(), "what was done here cannot be told as an action on what another program wrote");
  emit closing();
  const ModelSettings settings = settings_;
  const auto readings = readings_;
  const auto drafts = drafts_;
  const std::filesystem::path kept = journal_->clear_and_keep(digest);
  std::unique_ptr<Journal> journal = std::move(journal_);
  OpenedFiles files;
  files.file = theirs.file;
  put_in({}, {});
  emit closed();
  journal_ = std::move(journal);
  put_in({std::move(files), std::move(theirs)}, digest);
  emit opened();
  emit saved_changed(is_saved());
  const bool is_done = perform_before_another(std::move(*own), settings);
  const bool is_whole = perform_notes(readings, drafts) && is_done;
  std::error_code error;
  if (is_whole) std::filesystem::remove(kept, error);
  return is_done;
}

/// What was done here, as one action on what another program wrote. False where it cannot be written down.
bool Document::perform_before_another(Edit own, const ModelSettings& settings) {
  own.sentence = tr("what was done here before another program changed the session");
  if (!(settings == settings_)) own.settings = SettingsEdit{settings_, settings};
  return perform(std::move(own));
}

/// False where not all of it fits what is open, or can be written down.
bool Document::perform_notes(const std::map<std::string, RobotReading>& readings,
                             const std::map<std::int64_t, LabelDraft>& drafts) {
  bool is_whole = true;
  for (const auto& [effect, reading] : readings) is_whole = perform(edit_of_reading(effect, reading)) && is_whole;
  for (const auto& [id, draft] : drafts)
    is_whole = find(id) && perform(edit_of_draft(tr("unfinished labels"), id, draft)) && is_whole;
  return is_whole;
}

void Document::put_on_top(const JournalContents& contents) {
  const Unsaved unsaved = unsaved_of(contents.from_before);
  Merge merge = merged(own_changes(unsaved.done), nullptr, *session_);
  const bool fits = merge.collisions.empty() || merge.collisions.front().what != Collision::What::session;
  auto edit = fits ? action_between(*session_, merge.session) : std::nullopt;
  if (!edit) return emit noticed(QString::fromStdString(contents.notice));
  bool is_whole = perform_before_another(std::move(*edit), unsaved.settings) && merge.lost == 0;
  is_whole = perform_notes(unsaved.readings, unsaved.drafts) && is_whole;
  const QString kept = QString::fromStdString(contents.kept_in.string());
  if (!merge.collisions.empty()) {
    emit noticed(tr("session.xml was changed by another program. Your unsaved actions are on top of it, but for what "
                    "both have changed; all of them are kept in %1.")
                     .arg(kept));
    return set_collisions(std::move(merge.collisions), false);
  }
  std::error_code error;
  if (is_whole) std::filesystem::remove(contents.kept_in, error);
  emit noticed(is_whole
                   ? tr("session.xml was changed by another program. Your unsaved actions are on top of it, as one "
                        "action.")
                   : tr("session.xml was changed by another program. Your unsaved actions are on top of it as far "
                        "as they fit it; all of them are kept in %1.")
                         .arg(kept));
}

void Document::set_collisions(std::vector<Collision> collisions, bool at_save) {
  if (collisions.empty() && collisions_.empty()) return;
  collisions_ = std::move(collisions);
  collided_at_save_ = at_save;
  emit collided();
}

void Document::put_off_collisions() { set_collisions({}, false); }

bool Document::decide_collisions(const std::vector<bool>& mine) {
  if (collisions_.empty() || mine.size() != collisions_.size()) return false;
  const std::vector<Collision> decided = std::exchange(collisions_, {});
  if (collided_at_save_) {
    const auto theirs = what_another_wrote();
    if (theirs) {
      if (!save_with(*theirs, decided, mine)) return false;
    } else {
      write_session({}, true);
    }
  } else {
    Session session = *session_;
    for (std::size_t i = 0; i < decided.size(); ++i)
      if (mine[i]) take_mine(decided[i], session);
    if (auto edit = action_between(*session_, session)) {
      edit->sentence = tr("kept what was done here against another program");
      perform(std::move(*edit));
    }
  }
  emit collided();
  return true;
}

}  // namespace handsight::app
