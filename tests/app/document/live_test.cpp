// SPDX-License-Identifier: Apache-2.0
// What has arrived in a watched folder, as actions of the document.
#include <gtest/gtest.h>

#include "app/arriving_session.h"
#include "document/document.h"

namespace handsight::app {
namespace {

class Live : public testing::Test, protected test::ArrivingSession {
 protected:
  Live() : ArrivingSession(8) {}
};

TEST_F(Live, ArrivalsAreActionsThatOutliveAKillAndAreSaved) {
  bring(8);
  bring(9);
  const auto arrival = [&](std::int64_t id) {
    Observation o = one(id);
    o.sightings.clear();
    o.decision = Decision::none;
    o.reason = {};
    return Edit{.sentence = "arrived", .added = {o}};
  };
  const std::string untouched = read_file(home / "session.xml");
  {
    Document document;
    document.open(home);
    document.perform(arrival(8));
    document.perform(arrival(9));
    ASSERT_EQ(document.session().observations.size(), 10U);
    document.undo();
    EXPECT_EQ(document.session().observations.size(), 9U) << "undo takes back what came last";
    EXPECT_EQ(document.find(9), nullptr);
    document.redo();
  }
  EXPECT_EQ(read_file(home / "session.xml"), untouched) << "the session changes only by Save";
  Document document;
  document.open(home);
  ASSERT_EQ(document.session().observations.size(), 10U) << "what arrived is there again";
  EXPECT_EQ(document.find(9)->position, one(9).position);
  EXPECT_EQ(document.find(9)->images[1], one(9).images[1]);
  document.save();
  EXPECT_EQ(read_session(home).observations.size(), 10U);
  document.undo_all();
  EXPECT_EQ(session_text(document.session()), untouched);
}

}  // namespace
}  // namespace handsight::app
