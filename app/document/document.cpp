// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document.h"

#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "base/files.h"
#include "document/effect_words.h"
#include "document/sample_titles.h"
#include "session/session_xml.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {

class EditCommand : public QUndoCommand {
 public:
  EditCommand(Document& document, Edit edit) : document_(document), edit_(std::move(edit)) { setText(edit_.sentence); }
  void redo() override {
    if (after_ == 0) {
      before_ = document_.state_;
      after_ = edit_.leaves_model() ? before_ : ++document_.last_state_;
    }
    document_.apply(edit_, true, after_);
  }
  void undo() override { document_.apply(edit_, false, before_); }
  int id() const override { return edit_.joins == 0 ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const EditCommand&>(*other);
    if (later.edit_.joins != edit_.joins) return false;
    edit_ = joined(std::move(edit_), later.edit_);
    after_ = later.after_;
    setText(edit_.sentence);
    return true;
  }

 private:
  Document& document_;
  Edit edit_;
  std::int64_t before_ = 0, after_ = 0;  // states of the document
};

Document::Document(QObject* parent) : QObject(parent) {
  connect(&stack_, &QUndoStack::cleanChanged, this, [this](bool clean) {
    if (!is_replaying_) emit saved_changed(clean);
  });
}

Document::~Document() { close(); }

void Document::open(const std::filesystem::path& path) { open(open_files(path)); }

void Document::open(OpenedSession read) {
  const std::string digest = compute_digest(make_content(read.files));
  const bool is_same_file =
      journal_ && std::filesystem::weakly_canonical(read.files.file) == std::filesystem::weakly_canonical(files_.file);
  if (is_same_file) close();
  auto journal = std::make_unique<Journal>(read.files.file, digest, &read.session);
  close();
  journal_ = std::move(journal);
  put_in(std::move(read), digest);
  const JournalContents contents = journal_->take_contents();
  replay(contents);
  emit opened();
  if (!contents.from_before.empty()) {
    put_on_top(contents);
  } else if (!contents.notice.empty()) {
    emit noticed(QString::fromStdString(contents.notice));
  } else if (!stack_.isClean()) {
    const int unsaved = std::abs(stack_.index() - std::max(0, stack_.cleanIndex()));
    emit noticed(
        tr("Opened where you left it: %1 not yet saved in session.xml.").arg(counted(unsaved, "%n action(s)")));
  }
  emit saved_changed(is_saved());
}

void Document::close() {
  if (!journal_) return;
  emit closing();
  // What session.xml cannot hold (the model's effects, what was measured) stays in the journal.
  if (stack_.isClean() && settings_ == ModelSettings{} && readings_.empty() && drafts_.empty()) {
    try {
      journal_->clear(compute_digest(make_content(files_)));
    } catch (const InputError&) {
      // The session's folder is gone; the journal is then set aside when it comes back.
    }
  }
  journal_.reset();
  put_in({}, {});
  emit closed();
}

/// What is open is this session as it was read; nothing has been done to it.
void Document::put_in(OpenedSession opened, const std::string& digest) {
  stack_.clear();
  versions_.clear();
  shown_.reset();
  second_looks_.clear();
  collisions_.clear();
  files_ = std::move(opened.files);
  collection_on_disk_ = files_.is_collection() ? shared_text(files_) : std::string();
  session_ = std::make_shared<Session>(std::move(opened.session));
  settings_ = {};
  readings_.clear();
  drafts_.clear();
  digest_ = digest;
  number_observations();
  state_ = ++last_state_;
}

std::int64_t id_at(const Session& session, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < session.observations.size()
             ? session.observations[static_cast<std::size_t>(index)].id
             : -1;
}

QString written_title(const Session& s) {
  return QString::fromStdString(s.title.empty() ? s.file.parent_path().filename().string() : s.title);
}

QString display_name(const Session& s) { return shown_title(written_title(s)); }

void Document::number_observations() {
  index_of_.clear();
  for (std::size_t i = 0; i < session_->observations.size(); ++i)
    index_of_[session_->observations[i].id] = static_cast<int>(i);
}

/// To be changed: whoever works on the session as it was keeps that.
Session& Document::own_session() {
  if (session_.use_count() == 1) {
    std::atomic_thread_fence(std::memory_order_acquire);  // what the last job read, it has read
    return *session_;
  }
  const std::shared_ptr<const Session> before = session_;
  session_ = std::make_shared<Session>(*before);
  // Who was given a reference in this round of events may look at it to the end of the round.
  QMetaObject::invokeMethod(
      this, [before] {}, Qt::QueuedConnection);
  return *session_;
}

/// One that another program wrote between those that were there; models know observations by their place.
void Document::insert_in_time(const Observation& o, std::vector<Observation>& observations) {
  observations.insert(std::upper_bound(observations.begin(), observations.end(), o.time,
                                       [](double time, const Observation& other) { return time < other.time; }),
                      o);
  number_observations();
  shown_.reset();
}

void Document::add_observations(const std::vector<Observation>& added) {
  if (added.empty()) return;
  std::vector<Observation>& observations = own_session().observations;
  for (const Observation& o : added)
    if (find_index(o.id) < 0) {
      const bool is_last = observations.empty() || observations.back().time <= o.time;
      if (!is_last) {
        insert_in_time(o, observations);
        continue;
      }
      observations.push_back(o);
      index_of_[o.id] = static_cast<int>(observations.size()) - 1;
    }
}

void Document::remove_observations(const std::vector<Observation>& removed) {
  if (removed.empty()) return;
  std::erase_if(own_session().observations, [&](const Observation& o) {
    return std::any_of(removed.begin(), removed.end(), [&](const Observation& r) { return r.id == o.id; });
  });
  number_observations();
  // A model that knows what has gone is shown no longer: rather the last one before.
  const auto fits = [this](const ModelVersionPointer& version) {
    return !version || !version->inspection || version->inspection->rows.size() <= session_->observations.size();
  };
  if (fits(shown_)) return;
  shown_ = model();
  if (shown_) return;
  for (const auto& [index, version] : versions_)
    if (index < stack_.index() && version && version->inspection && fits(version)) shown_ = version;
}

int Document::find_index(std::int64_t id) const {
  const auto found = index_of_.find(id);
  return found == index_of_.end() ? -1 : found->second;
}

const Observation* Document::find(std::int64_t id) const {
  const int index = find_index(id);
  return index < 0 ? nullptr : &session_->observations[static_cast<std::size_t>(index)];
}

Edit Document::make_edit(const QString& sentence,
                         const std::vector<std::pair<std::int64_t, EditableState>>& after) const {
  Edit edit{.sentence = sentence};
  for (const auto& [id, state] : after) {
    const Observation* observation = find(id);
    if (observation && !same_state(read_state(*observation), state))
      edit.observations.push_back({id, read_state(*observation), state});
  }
  return edit;
}

const RobotReading* Document::find_reading(const std::string& effect) const {
  const auto found = readings_.find(effect);
  return found == readings_.end() ? nullptr : &found->second;
}

Edit Document::edit_of_reading(const std::string& effect, const std::optional<RobotReading>& reading) const {
  const RobotReading* known = find_reading(effect);
  if (!known && !reading) return {};
  if (known && reading && *known == *reading) return {};
  Edit edit{.sentence = reading ? tr("measured for %1").arg(effect_text(effect, {}))
                                : tr("forgot what was measured for %1").arg(effect_text(effect, {}))};
  edit.reading = ReadingEdit{effect, known ? std::optional(*known) : std::nullopt, reading};
  return edit;
}

const LabelDraft* Document::find_draft(std::int64_t id) const {
  const auto found = drafts_.find(id);
  return found == drafts_.end() ? nullptr : &found->second;
}

Edit Document::edit_of_draft(const QString& sentence, std::int64_t id, const std::optional<LabelDraft>& draft) const {
  const LabelDraft* known = find_draft(id);
  if (!known && !draft) return {};
  if (known && draft && *known == *draft) return {};
  Edit edit{.sentence = sentence};
  edit.draft = DraftEdit{id, known ? std::optional(*known) : std::nullopt, draft};
  return edit;
}

bool Document::write_down(const JournalEntry& entry) {
  if (is_replaying_) return true;
  try {
    journal_->append(entry);
    return true;
  } catch (const InputError& error) {
    emit noticed(translated_error(error));
    return false;
  }
}

void Document::push(Edit edit) {
  versions_.erase(versions_.upper_bound(stack_.index()), versions_.end());
  stack_.push(new EditCommand(*this, std::move(edit)));
}

bool Document::perform(Edit edit) {
  if (!journal_ || edit.is_empty()) return true;
  if (!write_down({JournalEntry::Kind::done, edit, {}})) return false;
  push(std::move(edit));
  return true;
}

void Document::undo() {
  if (!journal_ || !stack_.canUndo() || !write_down({JournalEntry::Kind::undone, {}, {}})) return;
  const QString sentence = stack_.undoText();
  const int from = stack_.index();
  stack_.undo();
  if (!is_replaying_) emit noticed(tr("Undone: %1%2").arg(sentence, errors_text(from, stack_.index())));
}

void Document::redo() {
  if (!journal_ || !stack_.canRedo() || !write_down({JournalEntry::Kind::redone, {}, {}})) return;
  const QString sentence = stack_.redoText();
  const int from = stack_.index();
  stack_.redo();
  if (!is_replaying_) emit noticed(tr("Done again: %1%2").arg(sentence, errors_text(from, stack_.index())));
}

void Document::undo_all() {
  while (stack_.canUndo()) {
    const int before = stack_.index();
    undo();
    if (stack_.index() == before) return;
  }
}

/// What no model depends on: readings of the robot, unfinished labels.
void Document::apply_notes(const Edit& edit, bool forward) {
  if (edit.reading) {
    const std::optional<RobotReading>& reading = forward ? edit.reading->after : edit.reading->before;
    readings_.erase(edit.reading->effect);
    if (reading) readings_[edit.reading->effect] = *reading;
  }
  if (edit.draft) {
    const std::optional<LabelDraft>& draft = forward ? edit.draft->after : edit.draft->before;
    drafts_.erase(edit.draft->observation);
    if (draft) drafts_[edit.draft->observation] = *draft;
  }
}

void Document::tell_notes(const Edit& edit) {
  if (is_replaying_) return;
  if (edit.reading) emit readings_changed();
  if (edit.draft) emit draft_changed(edit.draft->observation);
}

void Document::apply(const Edit& edit, bool forward, std::int64_t becomes) {
  state_ = becomes;
  if (edit.settings) settings_ = forward ? edit.settings->after : edit.settings->before;
  apply_notes(edit, forward);
  if (edit.leaves_model()) return tell_notes(edit);
  if (!applies_) return;
  if (edit.collection) return apply_collection(edit, forward);
  std::vector<std::int64_t> ids;
  for (const Observation& o : edit.added) ids.push_back(o.id);
  if (forward) add_observations(edit.added);
  for (const ObservationEdit& o : edit.observations) {
    const int index = find_index(o.id);
    if (index < 0) continue;
    set_state(own_session().observations[static_cast<std::size_t>(index)], forward ? o.after : o.before);
    ids.push_back(o.id);
  }
  const ModelVersionPointer shown = shown_;
  if (!forward) remove_observations(edit.added);
  if (is_replaying_) return;
  tell_notes(edit);
  if (shown_ != shown) emit model_changed();
  if (edit.settings) emit settings_changed();
  emit edited(ids);
}

void Document::replay(const JournalContents& contents) {
  is_replaying_ = true;
  for (std::size_t i = 0; i < contents.entries.size(); ++i) {
    const JournalEntry& entry = contents.entries[i];
    // What session.xml already holds is only listed, so that it can be undone.
    applies_ = i >= contents.in_file;
    last_join_ = std::max(last_join_, entry.edit.joins);
    switch (entry.kind) {
      case JournalEntry::Kind::done:
        push(entry.edit);
        break;
      case JournalEntry::Kind::undone:
        stack_.undo();
        break;
      case JournalEntry::Kind::redone:
        stack_.redo();
        break;
      case JournalEntry::Kind::saved:
        if (i < contents.in_file) stack_.setClean();
        break;
    }
  }
  applies_ = true;
  is_replaying_ = false;
}

}  // namespace handsight::app
