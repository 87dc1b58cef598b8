// SPDX-License-Identifier: Apache-2.0
// A document and another program write one session: what does not collide is put together, what does is asked, and
// nothing disappears.
#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "base/files.h"
#include "document/document.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::app {
namespace {

using What = Collision::What;

class TwoWriters : public testing::Test {
 protected:
  TwoWriters() {
    const auto from = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "thesis_simulation";
    session = folder.path / "session";
    std::filesystem::copy(from, session, std::filesystem::copy_options::recursive);
    QObject::connect(&document, &Document::noticed, [this](const QString& sentence) { notices << sentence; });
    QObject::connect(&document, &Document::collided, [this] { ++asked; });
  }
  static EditableState decided(const Observation& o, Decision decision, const std::string& reason) {
    return {o.sightings, decision, looked_up(reason)};
  }
  static EditableState moved(const Observation& o, double pixels) {
    EditableState state = read_state(o);
    for (Sighting& s : state.sightings)
      for (CameraPoint& p : s.in_cameras) p.pixel.x() += pixels;
    return state;
  }
  void perform(std::size_t index, const EditableState& after) {
    const std::int64_t id = document.session().observations[index].id;
    ASSERT_TRUE(document.perform(document.make_edit(QString("changed observation %1").arg(id), {{id, after}})));
  }
  void exclude(std::size_t index, const std::string& reason) {
    perform(index, decided(document.session().observations[index], Decision::excluded, reason));
  }
  /// What another program does to the file.
  void there(const std::function<void(Session&)>& change) {
    Session s = read_session(session);
    change(s);
    replace_session(s);
  }
  void exclude_there(std::size_t index, const std::string& reason) {
    there([&](Session& s) {
      s.observations[index].decision = Decision::excluded;
      s.observations[index].reason = looked_up(reason);
    });
  }
  Session on_disk() const { return read_session(session); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(session), {}));
  }

  TemporaryFolder folder;
  std::filesystem::path session;
  Document document;
  QStringList notices;
  int asked = 0;
};

TEST_F(TwoWriters, WhatDoesNotCollideIsPutTogetherAtASave) {
  document.open(session);
  const std::size_t count = files();
  exclude(1, "here");
  perform(3, moved(document.session().observations[3], 0.5));
  exclude_there(2, "there");
  // Of the same observation, but the other part of it.
  there([&](Session& s) { s.observations[3].decision = Decision::rejected, s.observations[3].reason = "there too"; });
  document.save();
  EXPECT_EQ(asked, 0);
  const Session s = on_disk();
  EXPECT_EQ(s.observations[1].reason, "here");
  EXPECT_EQ(s.observations[2].reason, "there");
  EXPECT_EQ(s.observations[3].reason, "there too");
  EXPECT_EQ(session_text(s), session_text(document.session()));
  EXPECT_TRUE(notices.back().contains("another program")) << notices.back().toStdString();
  EXPECT_EQ(files(), count) << "nothing had to be kept beside it";
  EXPECT_TRUE(document.is_saved());
  // Undone it is as it was made here alone; done again it is there again.
  document.undo();
  EXPECT_EQ(document.session().observations[2].decision, Decision::none);
  EXPECT_EQ(document.session().observations[1].reason, "here");
  document.redo();
  EXPECT_EQ(document.session().observations[2].reason, "there");
  exclude(4, "later");
  notices.clear();
  document.save();
  EXPECT_FALSE(notices.back().contains("another program")) << "only once: " << notices.back().toStdString();
  EXPECT_EQ(on_disk().observations[2].reason, "there");
}

TEST_F(TwoWriters, WhatIsNotUnderstoodOfTheirsStays) {
  document.open(session);
  exclude(1, "here");
  replace_file(session / "session.xml", read_file(session / "session.xml") + "<!-- another program -->\n");
  document.save();
  EXPECT_EQ(on_disk().observations[1].reason, "here");
  EXPECT_NE(read_file(session / "session.xml").find("<!-- another program -->"), std::string::npos);
}

TEST_F(TwoWriters, WhatCollidesIsAskedAndNothingIsWrittenBefore) {
  document.open(session);
  exclude(1, "here");
  exclude(5, "only here");
  perform(3, moved(document.session().observations[3], 0.5));
  exclude_there(1, "there");
  there([&](Session& s) { set_state(s.observations[3], moved(s.observations[3], -1)); });
  const std::string theirs = read_file(session / "session.xml");
  const std::string mine = session_text(document.session());
  document.save();
  EXPECT_EQ(asked, 1);
  ASSERT_EQ(document.collisions().size(), 2U);
  EXPECT_EQ(document.collisions()[0].what, What::decision);
  EXPECT_EQ(document.collisions()[0].mine.reason, "here");
  EXPECT_EQ(document.collisions()[0].theirs.reason, "there");
  EXPECT_EQ(document.collisions()[1].what, What::labels);
  EXPECT_EQ(read_file(session / "session.xml"), theirs);
  EXPECT_EQ(session_text(document.session()), mine);
  EXPECT_FALSE(document.is_saved());
  // Put off, it is asked again.
  document.put_off_collisions();
  EXPECT_TRUE(document.collisions().empty());
  document.save();
  ASSERT_EQ(document.collisions().size(), 2U);
  EXPECT_TRUE(document.decide_collisions({true, false}));
  EXPECT_TRUE(document.collisions().empty());
  const Session s = on_disk();
  EXPECT_EQ(s.observations[1].reason, "here");
  EXPECT_EQ(s.observations[5].reason, "only here");
  const double was = document.session().observations[3].sightings[0].in_cameras[0].pixel.x();
  EXPECT_DOUBLE_EQ(s.observations[3].sightings[0].in_cameras[0].pixel.x(), was);
  EXPECT_TRUE(document.is_saved());
  document.undo();
  EXPECT_NEAR(document.session().observations[3].sightings[0].in_cameras[0].pixel.x(), was + 1.5, 1e-9)
      << "undone: as it was labelled here";
}

TEST_F(TwoWriters, WhatIsWrittenWhileOneDecidesIsAskedToo) {
  document.open(session);
  exclude(1, "here");
  exclude(2, "here");
  exclude_there(1, "there");
  document.save();
  ASSERT_EQ(document.collisions().size(), 1U);
  exclude_there(2, "there");
  EXPECT_FALSE(document.decide_collisions({true}));
  ASSERT_EQ(document.collisions().size(), 2U);
  EXPECT_EQ(on_disk().observations[2].reason, "there");
  EXPECT_TRUE(document.decide_collisions({true, true}));
  EXPECT_EQ(on_disk().observations[1].reason, "here");
  EXPECT_EQ(on_disk().observations[2].reason, "here");
}

TEST_F(TwoWriters, NewObservationsOfBothSidesAreThereInTheOrderOfTime) {
  document.open(session);
  const auto& all = document.session().observations;
  const std::int64_t first_free = all.back().id + 1;
  Observation mine = all.back();
  mine.id = first_free;
  mine.time += 20;
  mine.decision = Decision::excluded;
  mine.reason = "here";
  Edit edit{.sentence = "took a picture"};
  edit.added.push_back(mine);
  ASSERT_TRUE(document.perform(edit));
  there([&](Session& s) {
    Observation theirs = s.observations.back();
    theirs.id = first_free;  // the same number, another observation
    theirs.time += 10;
    theirs.decision = Decision::excluded;
    theirs.reason = "there";
    s.observations.push_back(theirs);
  });
  document.save();
  EXPECT_EQ(asked, 0);
  const Session s = on_disk();
  ASSERT_EQ(s.observations.size(), static_cast<std::size_t>(first_free) + 2);
  EXPECT_EQ(s.observations[s.observations.size() - 2].reason, "there");
  EXPECT_EQ(s.observations[s.observations.size() - 2].id, first_free);
  EXPECT_EQ(s.observations.back().reason, "here");
  EXPECT_EQ(session_text(s), session_text(document.session()));
}

TEST_F(TwoWriters, WhereMoreThanLabelsDiffersTheirsIsBegunAnewWithWhatWasDoneHereOnTop) {
  document.open(session);
  exclude(1, "here");
  ModelSettings settings = document.settings();
  settings.fix_markers = true;
  Edit edit{.sentence = "held the markers"};
  edit.settings = SettingsEdit{document.settings(), settings};
  ASSERT_TRUE(document.perform(edit));
  there([&](Session& s) { s.observations.erase(s.observations.begin() + 4); });
  document.save();
  EXPECT_EQ(asked, 0);
  const Session s = on_disk();
  EXPECT_EQ(s.observations.size(), document.session().observations.size());
  EXPECT_EQ(s.observations[4].id, 5);
  EXPECT_EQ(s.observations[1].reason, "here");
  EXPECT_TRUE(document.settings().fix_markers);
  document.undo();
  EXPECT_EQ(document.session().observations[1].decision, Decision::none);
  EXPECT_EQ(document.session().observations.size(), s.observations.size());
}

TEST_F(TwoWriters, WhoeverListensHearsOfItAsOfAnySessionThatGoesAndComes) {
  document.open(session);
  exclude(1, "here");
  const std::size_t before = document.session().observations.size();
  QStringList heard;
  const QObject listener;  // goes before the document does
  const auto tell = [&](const char* what) {
    heard << QString("%1: %2, %3").arg(what).arg(document.is_open()).arg(document.session().observations.size());
  };
  QObject::connect(&document, &Document::closing, &listener, [&] { tell("closing"); });
  QObject::connect(&document, &Document::closed, &listener, [&] { tell("closed"); });
  QObject::connect(&document, &Document::opened, &listener, [&] { tell("opened"); });
  there([&](Session& s) { s.observations.erase(s.observations.begin() + 4); });
  document.save();
  EXPECT_EQ(heard, (QStringList{QString("closing: 1, %1").arg(before), "closed: 0, 0",
                                QString("opened: 1, %1").arg(before - 1)}))
      << heard.join("; ").toStdString();
  EXPECT_TRUE(document.is_open());
  EXPECT_TRUE(document.is_saved());
}

TEST_F(TwoWriters, AnObservationThatIsGoneThereAndChangedHereIsAsked) {
  document.open(session);
  exclude(4, "here");
  there([&](Session& s) { s.observations.erase(s.observations.begin() + 4); });
  document.save();
  ASSERT_EQ(document.collisions().size(), 1U);
  EXPECT_EQ(document.collisions()[0].what, What::gone);
  EXPECT_TRUE(document.decide_collisions({true}));
  EXPECT_EQ(on_disk().observations[4].id, 4);
  EXPECT_EQ(on_disk().observations[4].reason, "here");
}

TEST_F(TwoWriters, OtherMarkersAreAskedAsAWholeAndTheOtherOneIsKept) {
  document.open(session);
  exclude(1, "here");
  std::string text = read_file(session / "session.xml");
  const std::size_t at = text.find("count=\"3\"");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 9, "count=\"4\"");
  replace_file(session / "session.xml", text);
  const std::size_t count = files();
  document.save();
  ASSERT_EQ(document.collisions().size(), 1U);
  EXPECT_EQ(document.collisions()[0].what, What::session);
  EXPECT_TRUE(document.decide_collisions({true}));
  EXPECT_EQ(on_disk().marker_count, 3);
  EXPECT_EQ(files(), count + 1) << "what the other program wrote is kept beside it";
}

TEST_F(TwoWriters, UnsavedActionsComeOnTopOfWhatAnotherProgramWroteSince) {
  document.open(session);
  exclude(1, "here");
  exclude(2, "undone");
  document.undo();
  document.close();
  exclude_there(3, "there");
  document.open(session);
  EXPECT_EQ(document.session().observations[1].reason, "here");
  EXPECT_EQ(document.session().observations[2].decision, Decision::none);
  EXPECT_EQ(document.session().observations[3].reason, "there");
  EXPECT_EQ(document.undo_stack().count(), 1);
  EXPECT_FALSE(document.is_saved());
  EXPECT_TRUE(notices.back().contains("on top of it")) << notices.back().toStdString();
  document.undo();
  EXPECT_EQ(document.session().observations[1].decision, Decision::none);
  document.redo();
  document.close();
  document.open(session);
  EXPECT_EQ(document.session().observations[1].reason, "here") << "they are in the journal now";
}

TEST_F(TwoWriters, UnsavedActionsThatCollideAreAskedAtTheNextOpening) {
  document.open(session);
  exclude(1, "here");
  exclude(2, "only here");
  document.close();
  exclude_there(1, "there");
  document.open(session);
  EXPECT_EQ(asked, 1);
  ASSERT_EQ(document.collisions().size(), 1U);
  EXPECT_EQ(document.session().observations[1].reason, "there") << "until it is decided";
  EXPECT_EQ(document.session().observations[2].reason, "only here");
  EXPECT_TRUE(document.decide_collisions({true}));
  EXPECT_EQ(document.session().observations[1].reason, "here");
  EXPECT_EQ(on_disk().observations[1].reason, "there") << "only the user's save changes the session";
  document.save();
  EXPECT_EQ(on_disk().observations[1].reason, "here");
}

/// 200 rounds of two writers that change, save and undo as they like. Every reason that was ever written is in the
/// file, or was asked about, or was taken back by the one who wrote it.
TEST_F(TwoWriters, In200RoundsNothingDisappearsWithoutAWord) {
  document.open(session);
  std::mt19937 random(3);
  const auto any = [&](std::size_t below) { return random() % below; };
  int collisions = 0;
  for (int round = 0; round < 200; ++round) {
    const std::size_t count = document.session().observations.size();
    const std::string name = std::to_string(round);
    const std::size_t mine = any(count), theirs = any(count);
    exclude(mine, "here " + name);
    if (any(4) == 0) {
      document.undo();
      exclude(mine, "again here " + name);
    }
    exclude_there(theirs, "there " + name);
    if (any(3) == 0) {  // closed in the middle of it
      document.close();
      document.open(session);
    }
    const std::string in_window = document.session().observations[mine].reason;
    if (!document.collisions().empty()) {
      ++collisions;
      ASSERT_TRUE(document.decide_collisions(std::vector<bool>(document.collisions().size(), any(2) == 0)));
    }
    document.save();
    bool kept_mine = true;
    if (!document.collisions().empty()) {
      ++collisions;
      kept_mine = any(2) == 0;
      ASSERT_TRUE(document.decide_collisions(std::vector<bool>(document.collisions().size(), kept_mine)));
    }
    const Session s = on_disk();
    ASSERT_EQ(session_text(s), session_text(document.session())) << round;
    if (mine != theirs) {
      ASSERT_EQ(s.observations[mine].reason, in_window) << round;
      ASSERT_EQ(s.observations[theirs].reason, "there " + name) << round;
    } else {
      ASSERT_TRUE(s.observations[mine].reason.english().ends_with(" " + name)) << round;
    }
  }
  EXPECT_GT(collisions, 0);
}

}  // namespace
}  // namespace handsight::app
