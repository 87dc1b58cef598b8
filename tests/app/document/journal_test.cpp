// SPDX-License-Identifier: Apache-2.0
// Nothing is lost: what the journal must survive.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <random>

#include "app/document/killed_writer.h"
#include "app/document/kills.h"
#include "base/error.h"
#include "base/files.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::app {
namespace {

class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    const auto from = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "thesis_simulation";
    session = folder.path / "session";
    std::filesystem::copy(from, session, std::filesystem::copy_options::recursive);
  }
  std::filesystem::path journal_file() const {
    return state_folder() / "journals" /
           (compute_digest(std::filesystem::weakly_canonical(session / "session.xml").string()) + ".journal");
  }
  static Edit exclude(const Document& document, std::size_t index, const char* reason) {
    const Observation& o = document.session().observations[index];
    EditableState after = read_state(o);
    after.decision = Decision::excluded;
    after.reason = looked_up(reason);
    return document.make_edit(QString("excluded observation %1").arg(o.id), {{o.id, after}});
  }
  TemporaryFolder folder;
  std::filesystem::path session;
};

TEST_F(JournalTest, UnsavedActionsAreThereAtTheNextOpening) {
  const std::string before = read_file(session / "session.xml");
  {
    Document document;
    document.open(session);
    document.perform(exclude(document, 1, "one"));
    document.perform(exclude(document, 2, "two"));
    document.undo();
  }
  EXPECT_EQ(read_file(session / "session.xml"), before) << "only the user's save changes the session";
  Document document;
  document.open(session);
  EXPECT_FALSE(document.is_saved());
  EXPECT_EQ(document.session().observations[1].reason, "one");
  EXPECT_EQ(document.session().observations[2].decision, Decision::none);
  EXPECT_TRUE(document.undo_stack().canRedo());
  document.redo();
  EXPECT_EQ(document.session().observations[2].reason, "two");
  document.undo_all();
  EXPECT_TRUE(document.is_saved());
  EXPECT_EQ(session_text(document.session()), before);
}

TEST_F(JournalTest, ActionsCanBeUndoneBeyondASaveAndAKill) {
  Document document;
  document.open(session);
  document.perform(exclude(document, 1, "one"));
  document.save();
  document.perform(exclude(document, 2, "two"));
  const std::string kept = read_file(journal_file());
  document.undo_all();
  document.close();
  // As if it had been killed before the two undos:
  replace_file(journal_file(), kept);
  Document again;
  again.open(session);
  EXPECT_EQ(again.session().observations[2].reason, "two");
  EXPECT_EQ(again.undo_stack().index(), 2);
  EXPECT_EQ(again.undo_stack().cleanIndex(), 1);
  again.undo_all();
  EXPECT_EQ(again.session().observations[1].decision, Decision::none);
  EXPECT_FALSE(again.is_saved());
}

TEST_F(JournalTest, ALineThatWasCutOffLosesOnlyItself) {
  const auto file = journal_file();
  {
    Document document;
    document.open(session);
    document.perform(exclude(document, 1, "one"));
    document.perform(exclude(document, 2, "two"));
  }
  const std::string whole = read_file(file);
  const std::size_t second = whole.rfind("\ndo ") + 1;
  for (std::size_t length = second; length < whole.size(); length += 7) {
    replace_file(file, whole.substr(0, length));
    Document document;
    document.open(session);
    EXPECT_EQ(document.session().observations[1].reason, "one") << length;
    EXPECT_EQ(document.session().observations[2].decision, Decision::none) << length;
    document.perform(exclude(document, 3, "three"));
    document.close();
    document.open(session);
    EXPECT_EQ(document.session().observations[3].reason, "three") << length;
  }
}

TEST_F(JournalTest, LinesThatAreNotUnderstoodAreSetAsideAndSaid) {
  {
    Document document;
    document.open(session);
    for (std::size_t i = 1; i <= 3; ++i) document.perform(exclude(document, i, "mine"));
  }
  std::string text = read_file(journal_file());
  const std::size_t second = text.find("\ndo ", text.find("\ndo ") + 1) + 1;
  text.insert(second, "dance {\"of\": \"a later version\"}\n");
  replace_file(journal_file(), text);
  Document document;
  QString notice;
  QObject::connect(&document, &Document::noticed, [&](const QString& sentence) { notice = sentence; });
  document.open(session);
  EXPECT_EQ(document.undo_stack().count(), 1);
  EXPECT_TRUE(notice.contains("Line 3")) << notice.toStdString();
  EXPECT_TRUE(notice.contains(".aside")) << notice.toStdString();
  int kept = 0;
  for (const auto& file : std::filesystem::directory_iterator(journal_file().parent_path()))
    kept += read_file(file.path()) == text ? 1 : 0;
  EXPECT_EQ(kept, 1) << "the whole journal is there still";
}

TEST_F(JournalTest, WhatCannotBeSetAsideIsNotCutOff) {
  {
    Document document;
    document.open(session);
    document.perform(exclude(document, 1, "one"));
  }
  const std::string journal = read_file(journal_file());
  replace_file(session / "session.xml", read_file(session / "session.xml") + "<!-- another program -->\n");
  // Where the copy would go there is a folder that cannot be replaced by a file.
  const auto aside = journal_file().string() + "." + compute_digest(journal).substr(0, 8) + ".aside";
  std::filesystem::create_directories(aside + "/full");
  Document document;
  try {
    document.open(session);
    FAIL() << "it opened, and the actions are nowhere";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("set aside"), std::string::npos) << error.what();
  }
  EXPECT_EQ(read_file(journal_file()), journal);
  // And nobody holds the lock of a journal that could not be opened.
  std::filesystem::remove_all(aside);
  document.open(session);
  EXPECT_TRUE(document.is_open());
}

/// No file may grow beyond what it is, as on a full disk.
class FullDisk {
 public:
  FullDisk() {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = 1;
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(JournalTest, OnAFullDiskPerformSaysThatItWasNotDone) {
  Document document;
  document.open(session);
  EXPECT_TRUE(document.perform(exclude(document, 1, "one")));
  {
    const FullDisk full;
    EXPECT_FALSE(document.perform(exclude(document, 2, "two")));
  }
  EXPECT_EQ(document.session().observations[2].decision, Decision::none);
  EXPECT_TRUE(document.perform(exclude(document, 3, "three")));
  document.close();
  document.open(session);
  EXPECT_EQ(document.session().observations[1].reason, "one");
  EXPECT_EQ(document.session().observations[3].reason, "three");
}

TEST_F(JournalTest, UnfinishedLabelsAreRememberedAndUndone) {
  const LabelDraft one = {{0, {10.25, 20.5}, false, std::nullopt}};
  const LabelDraft two = {{0, {10.25, 20.5}, false, std::nullopt}, {2, {30, 40}, true, Vector2(50, 60)}};
  const std::string before = read_file(session / "session.xml");
  {
    Document document;
    document.open(session);
    document.perform(document.edit_of_draft("placed marker 0", 1, one));
    document.perform(document.edit_of_draft("placed marker 2", 1, two));
    EXPECT_TRUE(document.edit_of_draft("again", 1, two).is_empty());
    document.save();
  }
  EXPECT_EQ(read_file(session / "session.xml"), before) << "the session holds whole labels only";
  Document document;
  document.open(session);
  ASSERT_NE(document.find_draft(1), nullptr);
  EXPECT_EQ(*document.find_draft(1), two);
  const std::int64_t revision = document.revision();
  document.undo();
  EXPECT_EQ(*document.find_draft(1), one);
  EXPECT_EQ(document.revision(), revision) << "no model depends on them";
  document.undo();
  EXPECT_EQ(document.find_draft(1), nullptr);
}

TEST_F(JournalTest, TwoWindowsCannotHaveTheSameSession) {
  Document one, two;
  one.open(session);
  try {
    two.open(session);
    FAIL() << "the second window opened it too";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("another window"), std::string::npos);
  }
  one.close();
  two.open(session);
  EXPECT_TRUE(two.is_open());
}

TEST_F(JournalTest, KilledAtRandomMomentsNothingIsLostButTheLastAction) {
  std::mt19937 random(1);
  std::uniform_int_distribution<useconds_t> microseconds(2000, 60000);
  int known = 0;
  for (int round = 0; round < test::kills(50); ++round) {
    const auto said = test::said_before_killed("--write-until-killed", {session.string()}, microseconds(random));
    ASSERT_FALSE(said.empty()) << "the process died by itself";
    const int last = std::atoi(said.back().c_str());
    ASSERT_GT(last, known);
    Document document;
    document.open(session);
    const int count = document.undo_stack().index();
    ASSERT_TRUE(count == last || count == last + 1) << "round " << round << ": said " << last << ", found " << count;
    const auto& observations = document.session().observations;
    for (int n = std::max(1, count - static_cast<int>(observations.size()) + 1); n <= count; ++n)
      ASSERT_EQ(observations[static_cast<std::size_t>(n) % observations.size()].reason, "action " + std::to_string(n));
    known = count;
    if (document.is_saved()) {  // killed right after a save: closed like this, nothing would be left to recover
      document.perform(test::numbered_action(document, ++known));
      ASSERT_FALSE(document.is_saved());
    }
    if (round % 10 == 9) {  // the history stays short
      document.undo_all();
      document.save();
      document.close();
      known = 0;
    }
  }
}

}  // namespace
}  // namespace handsight::app
