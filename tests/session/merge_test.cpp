// SPDX-License-Identifier: Apache-2.0
// What two have changed of one session, put together: what does not collide is all there, what does is reported.
#include "session/merge.h"

#include <gtest/gtest.h>

#include "session/session_xml.h"

namespace handsight {
namespace {

using What = Collision::What;

class MergeOfTwo : public testing::Test {
 protected:
  MergeOfTwo() {
    base = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "thesis_simulation");
    mine = theirs = base;
  }
  static void exclude(Session& session, std::size_t index, const std::string& reason) {
    session.observations[index].decision = Decision::excluded;
    session.observations[index].reason = looked_up(reason);
  }
  static void move_labels(Session& session, std::size_t index, double pixels) {
    for (Sighting& s : session.observations[index].sightings)
      for (CameraPoint& p : s.in_cameras) p.pixel.x() += pixels;
  }
  static void add(Session& session, double time, const std::string& reason) {
    Observation o = session.observations.back();
    o.id += 1;
    o.time = time;
    o.reason = looked_up(reason);
    session.observations.push_back(o);
  }
  double end() const { return base.observations.back().time; }
  Merge merge() const { return merged(own_changes(base, mine), &mine, theirs); }

  Session base, mine, theirs;
};

TEST_F(MergeOfTwo, LabelsAndDecisionOfAnObservationAreTwoParts) {
  exclude(mine, 1, "here");
  move_labels(mine, 3, 0.5);
  exclude(theirs, 2, "there");
  exclude(theirs, 3, "there too");
  const Merge merge = this->merge();
  EXPECT_TRUE(merge.collisions.empty());
  EXPECT_EQ(merge.kept, 2);
  Session expected = theirs;
  exclude(expected, 1, "here");
  move_labels(expected, 3, 0.5);
  EXPECT_EQ(session_text(merge.session), session_text(expected));
}

TEST_F(MergeOfTwo, WhereBothChangedTheSamePartItIsAsTheOtherHasItUntilMineIsTaken) {
  exclude(mine, 1, "here");
  move_labels(mine, 3, 0.5);
  exclude(theirs, 1, "there");
  move_labels(theirs, 3, -1);
  Merge merge = this->merge();
  ASSERT_EQ(merge.collisions.size(), 2U);
  EXPECT_EQ(merge.collisions[0].what, What::decision);
  EXPECT_EQ(merge.collisions[0].mine.reason, "here");
  EXPECT_EQ(merge.collisions[0].theirs.reason, "there");
  EXPECT_EQ(merge.collisions[1].what, What::labels);
  EXPECT_EQ(session_text(merge.session), session_text(theirs));
  for (const Collision& c : merge.collisions) take_mine(c, merge.session);
  EXPECT_EQ(session_text(merge.session), session_text(mine));
}

TEST_F(MergeOfTwo, WhatBothMadeAlikeCollidesNowhere) {
  exclude(mine, 1, "the same");
  exclude(theirs, 1, "the same");
  const Merge merge = this->merge();
  EXPECT_TRUE(merge.collisions.empty());
  EXPECT_EQ(merge.kept, 0);
}

TEST_F(MergeOfTwo, OneThatIsGoneThereComesBackAtItsPlaceWhereMineIsTaken) {
  exclude(mine, 4, "here");
  theirs.observations.erase(theirs.observations.begin() + 4);
  Merge merge = this->merge();
  ASSERT_EQ(merge.collisions.size(), 1U);
  EXPECT_EQ(merge.collisions[0].what, What::gone);
  take_mine(merge.collisions[0], merge.session);
  EXPECT_EQ(session_text(merge.session), session_text(mine));
  // Where it is not known any more what it was, it is counted.
  EXPECT_EQ(merged(own_changes(base, mine), nullptr, theirs).lost, 1);
}

TEST_F(MergeOfTwo, NewOnesOfBothAreThereInTheOrderOfTimeAndOneHasAnotherNumber) {
  add(mine, end() + 20, "here");
  add(theirs, end() + 10, "there");
  const Merge merge = this->merge();
  const auto& all = merge.session.observations;
  ASSERT_EQ(all.size(), base.observations.size() + 2);
  EXPECT_EQ(all[all.size() - 2].reason, "there");
  EXPECT_EQ(all.back().reason, "here");
  const std::int64_t number = theirs.observations.back().id;
  EXPECT_EQ(merge.renumbered, (std::vector<std::pair<std::int64_t, std::int64_t>>{{number, number + 1}}));
}

TEST_F(MergeOfTwo, IntoASessionOfOtherMarkersNothingIsPut) {
  exclude(mine, 1, "here");
  theirs.marker_count += 1;
  const Merge merge = this->merge();
  ASSERT_EQ(merge.collisions.size(), 1U);
  EXPECT_EQ(merge.collisions[0].what, What::session);
  EXPECT_EQ(session_text(merge.session), session_text(theirs));
}

TEST_F(MergeOfTwo, OfActionsAndTheirUndoingsTheNetIsTold) {
  const auto edit_to = [&](const Session& from, std::size_t index, const std::string& reason) {
    Session to = from;
    exclude(to, index, reason);
    return *edit_between(from, to);
  };
  const SessionEdit first = edit_to(base, 1, "first"), undone = edit_to(base, 2, "undone");
  Session with_first = base;
  exclude(with_first, 1, "first");
  const SessionEdit second = edit_to(with_first, 1, "second");
  Session with_new = base;
  add(with_new, end() + 1, "came");
  const SessionEdit came = *edit_between(base, with_new);
  SessionEdit net = own_changes({{first, true}, {undone, true}, {undone, false}, {second, true}, {came, true}});
  ASSERT_EQ(net.observations.size(), 1U);
  EXPECT_EQ(net.observations[0].before.reason, base.observations[1].reason);
  EXPECT_EQ(net.observations[0].after.reason, "second");
  ASSERT_EQ(net.added.size(), 1U);
  EXPECT_EQ(net.added[0].reason, "came");
  EXPECT_TRUE(own_changes({{came, true}, {came, false}}).is_empty());
}

TEST_F(MergeOfTwo, AnEditBetweenTwoSessionsTellsLabelsDecisionsAndNewOnesAlone) {
  exclude(mine, 1, "here");
  add(mine, end() + 1, "came");
  const auto edit = edit_between(base, mine);
  ASSERT_TRUE(edit.has_value());
  ASSERT_EQ(edit->observations.size(), 1U);
  EXPECT_EQ(edit->observations[0].after.reason, "here");
  EXPECT_EQ(edit->added.size(), 1U);
  Session other = base;
  other.observations[2].position[0] += 1e-3;
  EXPECT_FALSE(edit_between(base, other).has_value());
  other = base;
  std::swap(other.observations[2], other.observations[3]);
  EXPECT_FALSE(edit_between(base, other).has_value());
  other = base;
  other.observations.pop_back();
  EXPECT_FALSE(edit_between(base, other).has_value());
  other = base;
  other.gravity.x() += 1;
  EXPECT_FALSE(edit_between(base, other).has_value());
}

}  // namespace
}  // namespace handsight
