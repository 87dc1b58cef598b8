// SPDX-License-Identifier: GPL-3.0-or-later
// The one document of the window: a session, what the user did to it, and the model's versions with their fits.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <map>
#include <memory>
#include <unordered_map>

#include "document/edit.h"
#include "document/journal.h"
#include "document/model_version.h"
#include "document/opened_files.h"
#include "session/merge.h"
#include "session/session.h"

namespace handsight::app {

/// The id of an observation by its index in the session of a model; -1 where it has gone since.
std::int64_t id_at(const Session& session, int index);

/// The title of a session as its file has it, else the name of its folder.
QString written_title(const Session& session);
/// The same as it is shown: a sample's title in the user's language.
QString display_name(const Session& session);

class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// Opens a session or a collection (folder or file) with what the journal remembers of it. InputError where it cannot
  /// be read; the document is then as it was.
  void open(const std::filesystem::path& path);
  /// The same of files that were read already, beside the window (open_files).
  void open(OpenedSession read);
  /// Closes what is open; the journal keeps what was not saved.
  void close();
  bool is_open() const { return journal_ != nullptr; }

  /// session.xml, or the collection's file.
  const std::filesystem::path& file() const { return files_.file; }
  /// The collection that is open; null where it is one session by itself.
  const Collection* collection() const { return files_.collection ? &*files_.collection : nullptr; }
  /// Makes this collection of the one that is open. InputError where its sessions cannot be read or joined; nothing is
  /// done then.
  Edit edit_of_collection(const QString& sentence, const Collection& after) const;
  /// Is the session announced as opened() the one that was open, joined otherwise?
  bool is_rejoining() const { return is_rejoining_; }

  const Session& session() const { return *session_; }
  /// The same for a job: nothing is copied, and what is changed later is changed in a copy.
  std::shared_ptr<const Session> shared_session() const { return session_; }
  const ModelSettings& settings() const { return settings_; }
  /// Index into Session::observations, -1 where there is none of this id.
  int find_index(std::int64_t id) const;
  const Observation* find(std::int64_t id) const;

  /// Does one action: written to the journal, then done, then announced. An edit that changes nothing is left out.
  /// False where it cannot be written down: then it is not done, and `noticed` says why.
  bool perform(Edit edit);
  void undo();
  void redo();
  /// Back to before the first action, one by one.
  void undo_all();
  const QUndoStack& undo_stack() const { return stack_; }
  /// Replaces session.xml. What another program wrote since it was read is put together with what was done here, as an
  /// action that can be undone; where the two collide nothing is written and `collided` asks. InputError where it
  /// cannot be written.
  void save();
  /// Where another program wrote what collides with what was done here, by order of observations; empty: nowhere.
  const std::vector<Collision>& collisions() const { return collisions_; }
  /// Decides them, one by one, for what was done here or there; then saves where it was a save that met them. False
  /// where there are others by now.
  bool decide_collisions(const std::vector<bool>& mine);
  /// Leaves them undecided: nothing is written, the next save asks again.
  void put_off_collisions();
  bool is_saved() const { return stack_.isClean(); }
  /// Has another program written session.xml since it was read or written here? False where it cannot be read now.
  bool is_changed_by_another() const;

  /// The present state of session and settings, and how often second looks came in; undone, it is the same again. A
  /// result made for another one is stale.
  std::int64_t revision() const { return state_ * most_looks + looks_; }

  /// The model of the present state; null until it is fitted.
  ModelVersionPointer model() const;
  /// Of the present state, but told before the second looks came in; null where there is none.
  ModelVersionPointer model_before_second_looks() const;
  /// The last one that was fitted, which may be of an earlier state: what the window shows meanwhile. Null before.
  ModelVersionPointer shown_model() const { return shown_; }
  /// Shows a version that was fitted earlier, until the next fit.
  void show_version(const ModelVersionPointer& version);
  /// Versions from the beginning to the present state, null where an action's fit was never asked for.
  std::vector<ModelVersionPointer> versions() const;
  /// Is this fit, or one that shares it, still at hand? Of long sessions the versions of a while ago are forgotten
  /// (their errors stay in stairs_memory.h); undone to, they are fitted again.
  bool keeps(const ModelVersion& version) const;
  /// How many observations the versions at hand may have together; two versions are kept whatever they have.
  void keep_at_most(std::size_t observations) { most_kept_ = observations; }
  /// Takes a fit, unless it is stale.
  void take_version(const ModelVersionPointer& version);

  /// What a second look at rejected observations found; not part of the session, not undone. Announced as edited({}).
  const SecondLooks& second_looks() const { return second_looks_; }
  void take_second_looks(const SecondLooks& looks);

  /// What was measured on the real robot, by effect; null where nothing was.
  const RobotReading* find_reading(const std::string& effect) const;
  const std::map<std::string, RobotReading>& readings() const { return readings_; }
  /// Remembers what was measured (absent: forgets it). Empty where that changes nothing.
  Edit edit_of_reading(const std::string& effect, const std::optional<RobotReading>& reading) const;

  /// Unfinished labels of an observation; null where there are none.
  const LabelDraft* find_draft(std::int64_t id) const;
  /// Remembers unfinished labels (absent: forgets them). Empty where that changes nothing.
  Edit edit_of_draft(const QString& sentence, std::int64_t id, const std::optional<LabelDraft>& draft) const;

  /// A new number for Edit::joins.
  std::int64_t new_join() { return ++last_join_; }

  /// Edits made of the present state.
  Edit make_edit(const QString& sentence, const std::vector<std::pair<std::int64_t, EditableState>>& after) const;

 signals:
  void opened();
  /// The session is about to go: everything of it can still be asked.
  void closing();
  void closed();
  /// Observations changed (labels, decisions), came or went. Empty: none, only settings.
  void edited(const std::vector<std::int64_t>& ids);
  void settings_changed();
  void readings_changed();
  /// The unfinished labels of this observation came, changed or went.
  void draft_changed(std::int64_t id);
  void model_changed();
  void saved_changed(bool is_saved);
  /// collisions() came or went.
  void collided();
  /// A sentence for the read-out line.
  void noticed(const QString& sentence);

 private:
  friend class EditCommand;
  void apply(const Edit& edit, bool forward, std::int64_t becomes);
  void apply_collection(const Edit& edit, bool forward);
  void apply_notes(const Edit& edit, bool forward);
  void tell_notes(const Edit& edit);
  std::optional<std::string> what_another_wrote() const;
  std::string set_aside(const std::string& theirs) const;
  void write_session(const QString& more, bool is_theirs_known);
  void save_collection();
  bool save_with(const std::string& theirs, const std::vector<Collision>& decided, const std::vector<bool>& mine);
  bool take_over(const Merge& merge, Session theirs, const std::string& digest);
  bool begin_anew(Session theirs, const Session& merged, const std::string& digest);
  void put_on_top(const JournalContents& contents);
  bool perform_before_another(Edit own, const ModelSettings& settings);
  bool perform_notes(const std::map<std::string, RobotReading>& readings,
                     const std::map<std::int64_t, LabelDraft>& drafts);
  void put_in(OpenedSession opened, const std::string& digest);
  void set_collisions(std::vector<Collision> collisions, bool at_save);
  static constexpr std::int64_t most_looks = 1 << 20;
  static std::int64_t state_in(std::int64_t revision) { return revision / most_looks; }
  Session& own_session();
  void add_observations(const std::vector<Observation>& added);
  void insert_in_time(const Observation& observation, std::vector<Observation>& observations);
  void remove_observations(const std::vector<Observation>& removed);
  void number_observations();
  void replay(const JournalContents& contents);
  bool write_down(const JournalEntry& entry);
  void push(Edit edit);
  void forget_old_versions();
  /// " (0.24 → 9.1 px)": the errors at two indices of the undo stack; empty where they are not known.
  QString errors_text(int from, int to) const;

  OpenedFiles files_;
  std::string collection_on_disk_;  // shared_text as it was read or written
  std::shared_ptr<Session> session_ = std::make_shared<Session>();
  ModelSettings settings_;
  std::map<std::string, RobotReading> readings_;
  std::map<std::int64_t, LabelDraft> drafts_;
  std::unordered_map<std::int64_t, int> index_of_;
  std::unique_ptr<Journal> journal_;
  std::string digest_;  // of session.xml (make_content a collection) as it was read or last written
  QUndoStack stack_;
  std::map<int, ModelVersionPointer> versions_;  // by index of the undo stack
  ModelVersionPointer shown_;
  SecondLooks second_looks_;
  std::vector<Collision> collisions_;
  bool collided_at_save_ = false;  // else at opening: theirs is open already
  std::int64_t state_ = 0, last_state_ = 0, looks_ = 0;
  std::int64_t last_join_ = 0;
  std::size_t most_kept_ = 200000;
  bool is_replaying_ = false, is_rejoining_ = false;
  bool applies_ = true;  // false while entries are replayed that session.xml already holds
};

}  // namespace handsight::app
