// SPDX-License-Identifier: Apache-2.0
// <target> in sessions: in, out and what is refused.
#include <gmock/gmock.h>

#include "detection/target_finding.h"
#include "print/target_xml.h"
#include "session/sample.h"
#include "session/session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

std::string find_session(const std::string& target,
                         const std::string& observation = "<marker index=\"3\" eye=\"1 2\"/>") {
  return R"(<handsight_session version="1">
  <robot file="robot.urdf" tcp="hand"/>
  <cameras mount="hand"><mount_from_first estimate="yes"/>
    <camera name="eye" width="640" height="480" fx="500" fy="501" cx="320" cy="240"/></cameras>
  )" + target +
         R"(
  <joints>j1</joints>
  <observations><observation id="0" time="0"><position>0.5</position>)" +
         observation + R"(</observation></observations>
</handsight_session>
)";
}

const std::string charuco =
    "<target kind=\"charuco\" columns=\"8\" rows=\"11\" square=\"0.015\" marker=\"0.011\" dictionary=\"DICT_5X5_100\"";

std::string target_refusal(const std::string& text) {
  try {
    parse_session(text, "session.xml");
  } catch (const InputError& error) {
    EXPECT_GE(std::string(error.what()).size(), 20u);
    EXPECT_LE(std::string(error.what()).size(), 600u);
    return error.what();
  }
  return "";
}

TEST(TargetSession, PointsAreMarkersByNumber) {
  const Session s = parse_session(find_session(charuco + " sigma_pixel=\"0.3\"/>"), "session.xml");
  EXPECT_TRUE(s.notes.empty());
  ASSERT_TRUE(s.target);
  EXPECT_EQ(s.marker_count, 70);
  ASSERT_TRUE(s.shape);
  EXPECT_EQ(s.shape->markers.size(), 70u);
  EXPECT_EQ(s.shape->markers[8], Vector3(0.03, 0.03, 0));
  EXPECT_TRUE(s.shape->is_rigid());
  EXPECT_EQ(s.sigma_pixel, 0.3);
  EXPECT_EQ(s.observations[0].sightings[0].marker, 3);
  EXPECT_FALSE(needs_label(s));
}

TEST(TargetSession, EveryKindIsRead) {
  const Session grid =
      parse_session(find_session("<target kind=\"aprilgrid\" columns=\"6\" rows=\"6\" tag=\"0.088\" spacing=\"0.3\"/>"),
                    "session.xml");
  EXPECT_EQ(grid.marker_count, 144);
  const Session chess = parse_session(
      find_session("<target kind=\"chessboard\" columns=\"9\" rows=\"6\" square=\"0.025\"/>"), "session.xml");
  EXPECT_EQ(chess.marker_count, 54);
  EXPECT_TRUE(chess.notes.empty());
  const Session tags = parse_session(
      find_session("<target kind=\"tags\" dictionary=\"tag36h11\" size=\"0.05\" ids=\"3 7 9\"/>"), "session.xml");
  EXPECT_EQ(tags.marker_count, 12);
  EXPECT_EQ(tags.shape->piece_count(), 3);
  EXPECT_EQ(tags.shape->piece(7), 1);
  EXPECT_FALSE(tags.shape->is_rigid());
}

TEST(TargetSession, ThePrintIsKnownAsIsSaid) {
  EXPECT_EQ(parse_session(find_session(charuco + " sigma=\"1e-4\"/>"), "session.xml").shape->sigma, 1e-4);
  EXPECT_EQ(parse_session(find_session(charuco + " sigma=\"0\"/>"), "session.xml").shape->sigma, 0.0);
  EXPECT_FALSE(parse_session(find_session(charuco + " sigma=\"free\"/>"), "session.xml").shape->sigma);
}

TEST(TargetSession, AChessboardThatLooksTheSameTurnedIsSaid) {
  const Session s = parse_session(
      find_session("<target kind=\"chessboard\" columns=\"9\" rows=\"7\" square=\"0.025\"/>"), "session.xml");
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_THAT(s.notes[0], HasSubstr("half a turn"));
}

TEST(TargetSession, IsWrittenAndReadBack) {
  for (const std::string& element :
       {charuco + " layout=\"old\" first_id=\"4\" sigma=\"0.0002\"/>", charuco + " sigma=\"free\"/>",
        std::string(
            "<target kind=\"tags\" dictionary=\"tag36h11\" size=\"0.05\" ids=\"3 7 9\" sigma_pixel=\"0.25\"/>")}) {
    Session s = parse_session(find_session(element), "session.xml");
    s.source.reset();
    const Session again = parse_session(session_text(s), "session.xml");
    EXPECT_EQ(target_words(*again.target), target_words(*s.target));
    EXPECT_EQ(again.sigma_pixel, s.sigma_pixel);
    EXPECT_EQ(again.observations[0].sightings[0].marker, 3);
  }
}

TEST(TargetSession, WhatIsWrongIsRefused) {
  EXPECT_THAT(target_refusal(find_session(charuco + "/><markers count=\"3\"/>")), HasSubstr("beside the <markers>"));
  EXPECT_THAT(target_refusal(find_session("<target kind=\"pose\"/>")), HasSubstr("<pose_sensor>"));
  EXPECT_THAT(target_refusal(find_session("<target kind=\"charucco\"/>")), HasSubstr("chessboard, charuco"));
  EXPECT_THAT(target_refusal(find_session("<target kind=\"chessboard\" rows=\"5\" square=\"0.1\"/>")),
              HasSubstr("columns"));
  EXPECT_THAT(target_refusal(find_session("<target columns=\"4\"/>")), HasSubstr("kind"));
  EXPECT_THAT(
      target_refusal(find_session("<target kind=\"chessboard\" columns=\"100\" rows=\"100\" square=\"0.01\"/>")),
      HasSubstr("4096"));
  EXPECT_THAT(target_refusal(find_session(charuco + "/>", "<marker index=\"70\" eye=\"1 2\"/>")), HasSubstr("index"));
  EXPECT_THAT(target_refusal(
                  find_session(charuco + "/>", "<marker index=\"69\" eye=\"1 2\"/><marker index=\"69\" eye=\"1 2\"/>")),
              HasSubstr("second time"));
  std::string tracked = find_session(charuco + "/>");
  const auto from = tracked.find("<cameras"), to = tracked.find("</cameras>") + 10;
  tracked.replace(from, to - from, "<tracker mount=\"hand\"><mount_from_tracker/></tracker>");
  EXPECT_THAT(target_refusal(tracked), HasSubstr("found in images"));
}

TEST(TargetSession, APartOfItHasTheTargetToo) {
  const Session s = parse_session(find_session(charuco + "/>"), "session.xml");
  const Session part = take_part(s, {0});
  EXPECT_TRUE(part.target);
  EXPECT_EQ(part.shape->markers.size(), 70u);
}

TEST(TargetSession, OnlyAnonymousMarkersInImagesNeedALabel) {
  const std::string images = "<images eye=\"a.png\"/>";
  EXPECT_TRUE(needs_label(parse_session(find_session("<markers count=\"3\"/>", images), "session.xml")));
  EXPECT_FALSE(needs_label(parse_session(
      find_session("<markers count=\"4\"/>", images + "<marker index=\"3\" eye=\"1 2\"/>"), "session.xml")));
  EXPECT_FALSE(needs_label(parse_session(find_session(charuco + "/>", images), "session.xml")));
}

TEST(TargetSession, ImagesThatAreNotThereAreCountedAndNamed) {
  const TemporaryFolder folder;
  Session s = parse_session(find_session(charuco + "/>", "<images eye=\"a.png\"/>"), "session.xml");
  s.file = folder.path / "session.xml";
  const TargetSearch search = find_targets(s);
  EXPECT_EQ(search.looked_at, 1);
  EXPECT_EQ(search.found, 0);
  ASSERT_FALSE(search.notes.empty());
  EXPECT_THAT(search.notes.back(), HasSubstr("a.png"));
}

}  // namespace
}  // namespace handsight
