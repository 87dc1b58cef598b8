// SPDX-License-Identifier: Apache-2.0
// A collection as the document: opened, changed with undo, saved into its sessions, brought back after a kill.
#include <gtest/gtest.h>

#include <QEventLoop>
#include <QTimer>

#include "app/two_hands.h"
#include "base/error.h"
#include "base/files.h"
#include "document/document.h"
#include "document/refit.h"
#include "session/collection.h"
#include "temporary_folder.h"

namespace handsight::app {
namespace {

class CollectionDocument : public testing::Test {
 protected:
  CollectionDocument() { file = test::two_hands(folder.path, 20); }
  bool fitted(Document& document) {
    QEventLoop loop;
    QTimer poll, limit;
    QObject::connect(&poll, &QTimer::timeout, [&] {
      if (document.model()) loop.quit();
    });
    QObject::connect(&limit, &QTimer::timeout, &loop, &QEventLoop::quit);
    poll.start(1);
    limit.start(60000);
    loop.exec();
    return document.model() != nullptr && document.model()->fit != nullptr;
  }
  static void exclude(Document& document, std::int64_t id) {
    const EditableState after{document.find(id)->sightings, Decision::excluded, "by the user"};
    document.perform(document.make_edit("excluded", {{id, after}}));
  }
  Collection apart() {
    Collection c = *document.collection();
    for (CollectionEntry& e : c.entries) e.rig.clear();
    return c;
  }

  TemporaryFolder folder;
  std::filesystem::path file;
  Document document;
};

TEST_F(CollectionDocument, OpensByItsFolderAndFitsEachHand) {
  Jobs jobs;
  Refit refit(document, jobs);
  document.open(folder.path);
  ASSERT_TRUE(document.collection());
  EXPECT_EQ(document.file(), file);
  EXPECT_EQ(document.session().parts.size(), 2U);
  ASSERT_TRUE(fitted(document));
  ASSERT_EQ(document.model()->hands.size(), 2U);
  EXPECT_EQ(document.model()->hands[1].session->tcp, "left_hand");
  EXPECT_NE(document.model()->hands[0].tcp_from_body.translation, document.model()->hands[1].tcp_from_body.translation);
  EXPECT_EQ(document.model()->calibration->sessions.size(), 2U) << "what is exported holds all hands";
}

TEST_F(CollectionDocument, SavesDecisionsIntoTheSessionTheyBelongTo) {
  document.open(file);
  const std::string right = read_file(folder.path / "right" / "session.xml"), collection = read_file(file);
  exclude(document, 25);
  document.save();
  EXPECT_TRUE(document.is_saved());
  EXPECT_EQ(read_file(folder.path / "right" / "session.xml"), right) << "nothing was done to it";
  EXPECT_EQ(read_file(file), collection);
  const Session left = read_session(folder.path / "left");
  const auto own = 25 - document.session().parts[1].first_id;
  for (const Observation& o : left.observations) EXPECT_EQ(o.decision == Decision::excluded, o.id == own) << o.id;
  ASSERT_EQ(left.observations.size(), 20U);
  EXPECT_EQ(left.observations[static_cast<std::size_t>(own)].sightings.front().marker, 0) << "numbered as its own";
  EXPECT_FALSE(left.observations[static_cast<std::size_t>(own)].sightings.front().in_cameras.front().sigma);
  document.undo();
  EXPECT_FALSE(document.is_saved());
  document.save();
  EXPECT_EQ(read_session(folder.path / "left").observations[static_cast<std::size_t>(own)].decision, Decision::none);
}

TEST_F(CollectionDocument, WhatIsSharedIsChangedAndUndoneWithEverythingElse) {
  document.open(file);
  EXPECT_EQ(document.session().rig->count(), 2);
  exclude(document, 3);
  document.perform(document.edit_of_collection("cameras of their own", apart()));
  EXPECT_EQ(document.session().rig->count(), 4);
  EXPECT_EQ(document.session().other_mounts.size(), 1U);
  EXPECT_EQ(document.find(3)->decision, Decision::excluded) << "what was done before stays";
  exclude(document, 30);
  document.undo();
  EXPECT_EQ(document.find(30)->decision, Decision::none);
  document.undo();
  EXPECT_EQ(document.session().rig->count(), 2);
  EXPECT_EQ(document.find(3)->decision, Decision::excluded);
  document.redo();
  document.save();
  EXPECT_EQ(read_collection(file).entries[0].rig, "");
}

TEST_F(CollectionDocument, ComesBackAsItWasLeft) {
  document.open(file);
  document.perform(document.edit_of_collection("cameras of their own", apart()));
  exclude(document, 30);
  document.close();
  Document later;
  later.open(file);
  EXPECT_EQ(later.session().rig->count(), 4);
  EXPECT_EQ(later.find(30)->decision, Decision::excluded);
  later.undo_all();
  EXPECT_EQ(later.session().rig->count(), 2);
  EXPECT_TRUE(later.is_saved());
}

TEST_F(CollectionDocument, ASessionIsAddedAndTakenBack) {
  test::write_hand(test::of_left_hand(read_session(folder.path / "right")), folder.path / "left_again", 9, 15);
  document.open(file);
  const auto before = document.session().observations.size();
  Collection more = *document.collection();
  more.entries.push_back({"left_again", "left_again", "head", "", {}});
  document.perform(document.edit_of_collection("added", more));
  EXPECT_EQ(document.session().parts.size(), 3U);
  EXPECT_EQ(document.session().observations.size(), before + 15);
  document.undo();
  EXPECT_EQ(document.session().parts.size(), 2U);
  EXPECT_EQ(document.session().observations.size(), before);
  more.entries.back().folder = "nowhere";
  EXPECT_THROW(document.edit_of_collection("added", more), InputError);
  EXPECT_EQ(document.session().parts.size(), 2U) << "nothing is done then";
}

TEST_F(CollectionDocument, WhatAnotherProgramWroteIsNotWrittenOver) {
  document.open(file);
  exclude(document, 2);
  Session right = read_session(folder.path / "right");
  right.observations[7].decision = Decision::excluded;
  right.observations[7].reason = "elsewhere";
  save_session(right);
  EXPECT_TRUE(document.is_changed_by_another());
  EXPECT_THROW(document.save(), InputError);
  document.close();
  Document again;
  again.open(file);
  EXPECT_EQ(again.find(2)->decision, Decision::excluded) << "on top of it";
  EXPECT_EQ(again.find(7)->decision, Decision::excluded);
}

TEST_F(CollectionDocument, MarkersOfBoardsComeBackFromTheJournal) {
  EditableState after{{seen_at(80, {1, 2}, Vector2{3, 4})}, Decision::none, ""};
  Edit edit{.sentence = "labelled", .observations = {{5, {}, after}}};
  const Edit back = parse_edit(edit_text(edit));
  EXPECT_EQ(back.observations.front().after.sightings.front().marker, 80);
}

}  // namespace
}  // namespace handsight::app
