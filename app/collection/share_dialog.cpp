// SPDX-License-Identifier: GPL-3.0-or-later
#include "collection/share_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "base/error.h"
#include "base/files.h"
#include "collection/share_picture.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {

namespace fs = std::filesystem;

ShareDialog::ShareDialog(Workbench& workbench, QWidget* parent) : QDialog(parent), workbench_(workbench) {
  make_layout();
  fill_sessions();
  connect(&workbench.document, &Document::opened, this, [this] {
    if (workbench_.document.collection()) show_present();
  });
  connect(&workbench.document, &Document::closed, this, &QDialog::reject);
  show_present();
}

ShareDialog::ShareDialog(Workbench& workbench, const fs::path& added, QWidget* parent)
    : QDialog(parent), workbench_(workbench), added_(session_folder(added)) {
  make_layout();
  fill_sessions();
  connect(&workbench.document, &Document::closed, this, &QDialog::reject);
  try_joining();
}

void ShareDialog::make_layout() {
  setObjectName("share_dialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(added_ ? tr("Add a session") : tr("What is shared"));
  session_ = new QComboBox(this);
  session_->setObjectName("share_session");
  session_->setAccessibleName(tr("Session"));
  with_ = new QComboBox(this);
  with_->setObjectName("share_with");
  with_->setAccessibleName(tr("Shares with"));
  auto* sessions = new QHBoxLayout;
  sessions->addWidget(session_, 1);
  sessions->addWidget(new QLabel(tr("shares with"), this));
  sessions->addWidget(with_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(12);
  layout->addLayout(sessions);
  layout->addWidget(find_row(0, tr("The robot"), tr("Joints, links and masses are one for all sessions.")));
  layout->addWidget(find_row(1, tr("The cameras or the tracker, at the same place"),
                             tr("One mount, one lens. What was moved in between is at another place.")));
  layout->addWidget(find_row(2, tr("The hand: the same markers or board on the same TCP"),
                             tr("One TCP→Body. What was taken off and put on again is another one.")));
  said_ = new QLabel(this);
  said_->setObjectName("share_said");
  said_->setWordWrap(true);
  layout->addWidget(said_);
  auto* buttons = new QHBoxLayout;
  if (added_) {
    if (!workbench_.document.collection()) {
      file_ = new QLineEdit(QString::fromStdString((common_folder(workbench_.document.file(), *added_ / "session.xml") /
                                                    "collection.xml")),
                            this);
      file_->setObjectName("collection_file");
      file_->setAccessibleName(tr("File to write"));
      layout->addWidget(new QLabel(tr("The collection is written to"), this));
      layout->addWidget(file_);
      connect(file_, &QLineEdit::textChanged, this, &ShareDialog::try_joining);
    }
    auto* alone = new QPushButton(tr("Open it by itself"), this);
    alone->setObjectName("open_alone");
    alone->setAutoDefault(false);
    connect(alone, &QPushButton::clicked, this, [this] {
      emit open_wanted(QString::fromStdString(added_->string()));
      accept();
    });
    add_ = new QPushButton(tr("Add the session"), this);
    add_->setObjectName("add_it");
    add_->setDefault(true);
    connect(add_, &QPushButton::clicked, this, &ShareDialog::add);
    buttons->addWidget(alone);
  }
  auto* away = new QPushButton(added_ ? tr("Cancel") : tr("Done"), this);
  away->setObjectName("share_away");
  away->setAutoDefault(!added_);
  connect(away, &QPushButton::clicked, this, &QDialog::reject);
  buttons->addStretch(1);
  buttons->addWidget(away);
  if (add_) buttons->addWidget(add_);
  layout->addLayout(buttons);
  setMinimumWidth(560);
}

QWidget* ShareDialog::find_row(std::size_t what, const QString& text, const QString& says) {
  auto* row = new QWidget(this);
  static const char* const names[] = {"share_robot", "share_rig", "share_body"};
  pictures_[what] = new SharePicture(static_cast<SharePicture::What>(what), row);
  boxes_[what] = new QCheckBox(text, row);
  boxes_[what]->setObjectName(names[what]);
  boxes_[what]->setAccessibleDescription(says);
  auto* sentence = new QLabel(says, row);
  sentence->setWordWrap(true);
  sentence->setContentsMargins(24, 0, 0, 0);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addWidget(boxes_[what]);
  words->addWidget(sentence);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pictures_[what]);
  layout->addLayout(words, 1);
  if (what == 0) {
    boxes_[0]->setChecked(true);
    boxes_[0]->setEnabled(false);
    pictures_[0]->set_shared(true);
  } else {
    connect(boxes_[what], &QCheckBox::clicked, this, [this, what](bool checked) { choose(what, checked); });
  }
  return row;
}

/// The session that is chosen, and those before or beside it.
void ShareDialog::fill_sessions() {
  const Collection c = present();
  for (QComboBox* box : {session_, with_}) box->clear();
  for (std::size_t i = 0; i < c.entries.size(); ++i)
    for (QComboBox* box : {session_, with_})
      box->addItem(QIcon(widgets::session_mark_picture(static_cast<int>(i), 16, devicePixelRatioF())),
                   QString::fromStdString(c.entries[i].title), static_cast<int>(i));
  const int last = static_cast<int>(c.entries.size()) - 1;
  if (added_) with_->removeItem(last);
  session_->setCurrentIndex(last);
  session_->setEnabled(!added_);
  with_->setCurrentIndex(0);
  for (QComboBox* box : {session_, with_})
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
      if (added_)
        try_joining();
      else
        show_present();
    });
}

std::size_t ShareDialog::entry() const { return static_cast<std::size_t>(session_->currentIndex()); }
std::size_t ShareDialog::with() const { return static_cast<std::size_t>(with_->currentIndex()); }

/// What is open, as a collection; with the session that is to be added last.
Collection ShareDialog::present() const {
  const Document& d = workbench_.document;
  Collection c;
  if (d.collection()) {
    c = *d.collection();
  } else {
    c.file = file_ ? fs::path(file_->text().trimmed().toStdString()) : fs::path();
    const std::string folder =
        c.file.empty() ? d.file().parent_path().string() : folder_in_collection(d.file().parent_path(), c.file);
    c = with_session(std::move(c), folder, d.file().parent_path().filename().string());
  }
  if (!added_) return c;
  const std::string folder = c.file.empty() ? added_->string() : folder_in_collection(*added_, c.file);
  c = with_session(std::move(c), folder, added_->filename().string());
  if (!d.collection()) c.title = c.entries.front().title + " + " + c.entries.back().title;
  return c;
}

Collection ShareDialog::wanted() const {
  return with_shared(present(), entry(), with(), {boxes_[1]->isChecked(), boxes_[2]->isChecked()});
}

/// As the open collection has it.
void ShareDialog::show_present() {
  const Collection c = present();
  const bool are_two = entry() < c.entries.size() && with() < c.entries.size() && entry() != with();
  const Shared now = are_two ? shared_by(c, entry(), with()) : Shared{};
  const std::array<bool, 3> values{true, now.rig, now.body};
  for (std::size_t i = 1; i < 3; ++i) {
    boxes_[i]->setChecked(values[i]);
    boxes_[i]->setEnabled(are_two);
    pictures_[i]->set_shared(values[i]);
  }
  say(are_two ? QString() : tr("Choose two sessions."));
}

void ShareDialog::choose(std::size_t what, bool is_shared) {
  pictures_[what]->set_shared(is_shared);
  if (added_) return try_joining();
  try {
    const QString a = session_->currentText(), b = with_->currentText();
    const QString sentence = what == 1   ? is_shared ? tr("the cameras of %1 are those of %2").arg(a, b)
                                                     : tr("the cameras of %1 are not those of %2").arg(a, b)
                               : is_shared ? tr("the hand of %1 is that of %2").arg(a, b)
                                         : tr("the hand of %1 is not that of %2").arg(a, b);
    workbench_.document.perform(workbench_.document.edit_of_collection(sentence, wanted()));
    show_present();
  } catch (const InputError& error) {
    show_present();
    say(translated_error(error));
  }
}

/// Says before the click what stands in the way.
void ShareDialog::try_joining() {
  try {
    const Collection c = wanted();
    OpenedFiles files;
    files.file = c.file;
    files.collection = c;
    files.collection->entries.clear();
    rejoined(files, {}, collection_text(c));
    const auto unsaved = workbench_.document.is_saved() || file_ == nullptr
                             ? 0
                             : std::abs(workbench_.document.undo_stack().index() -
                                        std::max(0, workbench_.document.undo_stack().cleanIndex()));
    say(unsaved > 0 ? tr("%1 of this session is saved with it.").arg(counted(unsaved, "%n action(s)")) : QString());
    add_->setEnabled(true);
  } catch (const std::exception& error) {
    say(translated_error(error));
    add_->setEnabled(false);
  }
}

void ShareDialog::add() {
  try {
    const Collection c = wanted();
    if (workbench_.document.collection()) {
      workbench_.document.perform(
          workbench_.document.edit_of_collection(tr("added the session %1").arg(session_->currentText()), c));
    } else {
      std::error_code error;
      if (fs::exists(c.file, error))
        throw InputError(verbatim(tr("%1 is there already and is not written over; name another file.")
                                      .arg(QString::fromStdString(c.file.string()))
                                      .toStdString()));
      workbench_.document.save();
      replace_file(c.file, collection_text(c));
      emit written(QString::fromStdString(c.file.string()));
    }
    accept();
  } catch (const std::exception& error) {
    say(translated_error(error));
  }
}

void ShareDialog::say(const QString& sentence) {
  said_->setText(sentence);
  said_->setVisible(!sentence.isEmpty());
}

}  // namespace handsight::app
