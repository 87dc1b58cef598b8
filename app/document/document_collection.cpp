// SPDX-License-Identifier: GPL-3.0-or-later
// A collection in the document: joined anew where it is changed, and saved into its sessions.
#include <algorithm>

#include "base/error.h"
#include "document/document.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {

Edit Document::edit_of_collection(const QString& sentence, const Collection& after) const {
  check(files_.is_collection(), "no collection is open");
  const std::string text = collection_text(after);
  if (text == shared_text(files_)) return {};
  rejoined(files_, *session_, text);  // throws where that cannot be
  Edit edit{.sentence = sentence};
  edit.collection = CollectionEdit{shared_text(files_), text};
  return edit;
}

/// The numbers of markers and cameras may be others then: views begin anew.
void Document::apply_collection(const Edit& edit, bool forward) {
  try {
    OpenedSession opened = rejoined(files_, *session_, forward ? edit.collection->after : edit.collection->before);
    files_ = std::move(opened.files);
    // Who was given a reference in this round of events may look at it to the end of the round.
    QMetaObject::invokeMethod(
        this, [before = session_] {}, Qt::QueuedConnection);
    session_ = std::make_shared<Session>(std::move(opened.session));
  } catch (const InputError& error) {  // its files have gone, or changed since
    emit noticed(translated_error(error));
    return;
  }
  number_observations();
  shown_.reset();
  second_looks_.clear();
  if (is_replaying_) return;
  is_rejoining_ = true;
  emit opened();
  is_rejoining_ = false;
  emit edited({});
}

void Document::save_collection() {
  if (what_another_wrote())
    throw InputError(
        verbatim(tr("The collection or one of its sessions was changed by another program since it was opened; "
                    "close it and open "
                    "it again: what was done here is put on top of it.")
                     .toStdString()));
  SavedFiles saved = saved_files(files_, *session_, shared_text(files_) != collection_on_disk_);
  const std::string digest = compute_digest(saved.content);
  const bool is_marked = write_down({JournalEntry::Kind::saved, {}, digest});
  write_files(saved);
  files_ = std::move(saved.files);
  collection_on_disk_ = shared_text(files_);
  digest_ = digest;
  stack_.setClean();
  emit noticed(tr("Saved in %1: %2")
                   .arg(QString::fromStdString(files_.file.string()),
                        counted(static_cast<qint64>(saved.texts.size()), "%n file(s)")));
  if (!is_marked) emit noticed(tr("Saved, but the journal cannot be written: a kill would bring the actions back."));
}

}  // namespace handsight::app
