// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "session_texts.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string reader_refusal(const std::string& text) {
  return find_refusal([&] { parse_session(text, "session.xml"); });
}

/// What the small session refuses with one piece replaced.
std::string reader_refusal(const std::string& piece, const std::string& by) {
  return reader_refusal(changed(small_session, piece, by));
}

std::string tracker_refusal(const std::string& piece, const std::string& by) {
  return reader_refusal(changed(small_tracker_session, piece, by));
}

TEST(SessionReader, EverythingOfAStereoSession) {
  SessionLines lines;
  const Session session = parse_session(small_session, "session.xml", &lines);
  EXPECT_EQ(session.title, "Small");
  EXPECT_EQ(session.robot_file, "robot.urdf");
  EXPECT_EQ(session.tcp, "hand");
  EXPECT_EQ(session.gravity, Vector3(0, 0.5, -9.8));
  EXPECT_EQ(session.mount.link, "base");
  EXPECT_EQ(session.mount.mount_from_sensor.translation, Vector3(1, 2, 3));
  EXPECT_EQ(session.mount.mount_from_sensor.rotation, rotation_from_rpy({0.1, 0.2, 0.3}));
  EXPECT_FALSE(session.mount.estimate);
  EXPECT_TRUE(session.mount.known);
  ASSERT_TRUE(session.rig);
  EXPECT_FALSE(session.is_tracker());
  EXPECT_EQ(session.rig->at(1).camera_from_first.translation, Vector3(-0.2, 0, 0));
  const Camera& left = session.rig->at(0).camera;
  EXPECT_EQ(left.width, 640);
  EXPECT_EQ(left.height, 480);
  EXPECT_THAT((std::vector{left.fx, left.fy, left.skew, left.cx, left.cy, left.k1, left.k2, left.p1, left.p2, left.k3}),
              ElementsAre(500, 501, 0.5, 320, 240, -0.1, 0.2, 0.01, 0.02, 0.3));
  const Camera& right = session.rig->at(1).camera;
  EXPECT_THAT((std::vector{right.fx, right.skew, right.k1, right.k2, right.p1, right.p2, right.k3}),
              ElementsAre(510, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(session.sigma_pixel, 0.2);
  EXPECT_EQ(session.marker_count, 3);
  EXPECT_THAT(session.joints, ElementsAre("j1", "j2"));
  EXPECT_THAT(session.notes, IsEmpty());
  EXPECT_THAT(lines.observations, ElementsAre(15, 24, 25));
}

TEST(SessionReader, EverythingOfAnObservation) {
  const Session session = parse_session(small_session, "session.xml");
  ASSERT_EQ(session.observations.size(), 3u);
  const Observation& first = session.observations[0];
  EXPECT_EQ(first.id, 7);
  EXPECT_EQ(first.time, 1.5);
  EXPECT_THAT(first.position, ElementsAre(0.1, -0.2));
  EXPECT_THAT(first.velocity, ElementsAre(1, 2));
  EXPECT_THAT(first.torque, ElementsAre(3, 4));
  EXPECT_EQ(first.images[0], "images/7_left.png");
  EXPECT_EQ(first.images[1], "images/7_right.png");
  ASSERT_EQ(first.sightings.size(), 2u);
  EXPECT_EQ(first.sightings[0].marker, 0) << "in order of marker";
  EXPECT_EQ(seen_by(first.sightings[0], 0)->pixel, Vector2(10, 20));
  EXPECT_FALSE(seen_by(first.sightings[0], 1));
  EXPECT_EQ(first.sightings[0].by, MarkedBy::import);
  EXPECT_EQ(seen_by(first.sightings[1], 1)->pixel, Vector2(110, 210));
  EXPECT_EQ(first.sightings[1].by, MarkedBy::hand);
  EXPECT_EQ(first.decision, Decision::rejected);
  EXPECT_EQ(first.reason, "too far");
  EXPECT_FALSE(is_used(first));
  EXPECT_EQ(session.observations[1].velocity.size(), 0);
  EXPECT_FALSE(is_used(session.observations[1])) << "it has no marker";
  EXPECT_TRUE(is_used(session.observations[2]));
  EXPECT_EQ(session.observations[2].sightings[0].by, MarkedBy::tracker);
}

TEST(SessionReader, ATrackerSession) {
  const Session session = parse_session(small_tracker_session, "session.xml");
  EXPECT_TRUE(session.is_tracker());
  EXPECT_EQ(session.sigma_point, 0.0002);
  EXPECT_TRUE(session.mount.estimate);
  EXPECT_FALSE(session.mount.known);
  EXPECT_EQ(session.gravity, Vector3(0, 0, -9.81)) << "the default";
  EXPECT_EQ(session.observations.at(0).sightings.at(0).point.value(), Vector3(1, 2, 3));
  EXPECT_FALSE(parse_session(changed(small_tracker_session, " sigma=\"0.0002\"", ""), "s").sigma_point);
}

TEST(SessionReader, WhatIsKnownOfTheMount) {
  const auto mount = [](const std::string& by) {
    return parse_session(
               changed(small_session, R"(<mount_from_left xyz="1 2 3" rpy="0.1 0.2 0.3" estimate="no"/>)", by), "s")
        .mount;
  };
  EXPECT_TRUE(mount("<mount_from_left xyz='1 2 3'/>").known);
  EXPECT_FALSE(mount("<mount_from_left xyz='1 2 3'/>").estimate) << "default no";
  EXPECT_TRUE(mount("<mount_from_left/>").known) << "zeros";
  EXPECT_FALSE(mount("<mount_from_left estimate='yes'/>").known);
  EXPECT_TRUE(mount("<mount_from_left estimate='yes' rpy='0 0 1'/>").known);
  EXPECT_TRUE(mount("<mount_from_left estimate='yes' rpy='0 0 1'/>").estimate);
}

TEST(SessionReader, ChildrenInAnyOrder) {
  std::string text = small_session;
  const std::size_t joints = text.find("  <joints>"), end = text.find("</joints>") + 10;
  const std::string piece = text.substr(joints, end - joints);
  text.erase(joints, end - joints);
  text.insert(text.find("</handsight_session>"), piece);
  EXPECT_THAT(parse_session(text, "session.xml").joints, ElementsAre("j1", "j2"));
}

TEST(SessionReader, WhatIsUnknownIsNotedOnceForEachKind) {
  std::string text = changed(small_session, "<gravity ", "<foo/><gravity unit='m' ");
  text = changed(text, "<velocity>", "<bar/><velocity>");
  text = changed(text, "<observation id=\"3\" time=\"1.5\">", "<observation id=\"3\" time=\"1.5\"><bar/>");
  EXPECT_THAT(parse_session(text, "session.xml").notes,
              ElementsAre("session.xml: attribute unit of <gravity> is not known and is ignored (line 4).",
                          "session.xml: element <bar> in <observation> is not known and is ignored (2 times, first "
                          "at line 17).",
                          "session.xml: element <foo> in <handsight_session> is not known and is ignored (line 4)."));
}

TEST(SessionReader, MarkersOutsideTheImageAreNoted) {
  EXPECT_THAT(parse_session(changed(small_session, "left=\"10 20\"", "left=\"640 20\""), "session.xml").notes,
              ElementsAre("session.xml: markers lie outside their camera's image (1 positions)."));
}

TEST(SessionReader, APointInAStereoSessionIsUnknown) {
  EXPECT_THAT(parse_session(changed(small_session, "left=\"10 20\"", "left=\"10 20\" point=\"1 2 3\""), "s").notes,
              ElementsAre(HasSubstr("attribute point of <marker>")));
}

TEST(SessionRefuses, WrongFiles) {
  EXPECT_EQ(reader_refusal("version=\"1\" title", "version=\"2\" title"),
            "session.xml, line 2: <handsight_session> has version=\"2\", expected version=\"1\", the only "
            "one that this program reads.");
  EXPECT_THAT(reader_refusal(" version=\"1\" title", " title"), HasSubstr("no attribute version"));
  EXPECT_THAT(reader_refusal("<handsight_calibration version='1'/>"), HasSubstr("expected <handsight_session>"));
  EXPECT_THAT(reader_refusal("</observations>", ""), HasSubstr("well-formed"));
  EXPECT_THAT(reader_refusal(small_session.substr(0, 700)), HasSubstr("well-formed"));
  EXPECT_THAT(reader_refusal(""), HasSubstr("empty"));
  EXPECT_THAT(reader_refusal(std::string("\x7F"
                                         "ELF\x02\x01\x01\0\0\0",
                                         10)),
              HasSubstr("session.xml"));
}

TEST(SessionRefuses, MissingAndDoubleElements) {
  EXPECT_THAT(reader_refusal("<robot file=\"robot.urdf\" tcp=\"hand\"/>", ""), HasSubstr("has no element <robot>"));
  EXPECT_THAT(reader_refusal("<markers count=\"3\" sigma_pixel=\"0.2\"/>", ""), HasSubstr("has no element <markers>"));
  EXPECT_THAT(reader_refusal("<joints>j1 j2</joints>", ""), HasSubstr("has no element <joints>"));
  EXPECT_THAT(reader_refusal("<joints>j1 j2</joints>", "<joints>j1 j2</joints><joints/>"), HasSubstr("a second time"));
  EXPECT_THAT(reader_refusal("tcp=\"hand\"", ""), HasSubstr("no attribute tcp"));
  EXPECT_THAT(reader_refusal("file=\"robot.urdf\"", "file=\"\""), HasSubstr("expected a name"));
  EXPECT_THAT(reader_refusal("mount=\"base\"", ""), HasSubstr("no attribute mount"));
  EXPECT_THAT(reader_refusal("<mount_from_left xyz=\"1 2 3\" rpy=\"0.1 0.2 0.3\" estimate=\"no\"/>", ""),
              HasSubstr("has no element <mount_from_left>"));
  EXPECT_THAT(reader_refusal("<position>0.1 -0.2</position>", ""), HasSubstr("has no element <position>"));
}

TEST(SessionRefuses, BothDevicesOrNone) {
  EXPECT_THAT(reader_refusal("<joints>", "<tracker mount='base'/><joints>"),
              HasSubstr("line 13: <tracker> stands beside the <stereo> of line 5"));
  const std::size_t begin = small_session.find("<stereo"), end = small_session.find("</stereo>") + 9;
  EXPECT_THAT(reader_refusal(small_session.substr(0, begin) + small_session.substr(end)),
              HasSubstr("neither <stereo> nor <tracker>"));
}

TEST(SessionRefuses, Cameras) {
  EXPECT_EQ(reader_refusal("fx=\"500\"", "fx=\"0\""),
            "session.xml, line 8: <camera> has fx=\"0\", expected a positive number.");
  EXPECT_THAT(reader_refusal("fy=\"501\"", "fy=\"-1\""), HasSubstr("fy=\"-1\", expected a positive number"));
  EXPECT_THAT(reader_refusal("fx=\"500\"", "fx=\"nan\""), HasSubstr("fx=\"nan\""));
  EXPECT_THAT(reader_refusal("width=\"640\"", "width=\"0\""), HasSubstr("width=\"0\", expected an integer from 1"));
  EXPECT_THAT(reader_refusal("height=\"480\"", "height=\"-480\""), HasSubstr("height=\"-480\""));
  EXPECT_THAT(reader_refusal("width=\"640\"", "width=\"640.5\""), HasSubstr("width=\"640.5\""));
  EXPECT_THAT(reader_refusal("cx=\"320\"", ""), HasSubstr("no attribute cx"));
  EXPECT_THAT(reader_refusal("k1=\"-0.1\"", "k1=\"inf\""), HasSubstr("k1=\"inf\""));
  EXPECT_THAT(reader_refusal("name=\"right\"", "name=\"left\""),
              HasSubstr("line 9: <camera> is a second camera with name=\"left\""));
  EXPECT_THAT(reader_refusal("name=\"right\"", "name=\"middle\""), HasSubstr("expected one of: left, right"));
  EXPECT_THAT(reader_refusal("name=\"right\"", ""), HasSubstr("no attribute name"));
  EXPECT_THAT(
      reader_refusal(
          "<camera name=\"right\" width=\"800\" height=\"600\" fx=\"510\" fy=\"511\" cx=\"400\" cy=\"300\"/>", ""),
      HasSubstr("has no <camera name=\"right\">"));
  EXPECT_THAT(reader_refusal("<right_from_left xyz=\"-0.2 0 0\"", "<right_from_left xyz=\"0 0 0\""),
              HasSubstr("baseline"));
  EXPECT_THAT(reader_refusal("<right_from_left xyz=\"-0.2 0 0\"", "<right_from_left"), HasSubstr("baseline"));
  EXPECT_THAT(reader_refusal("xyz=\"1 2 3\"", "xyz=\"1 2\""),
              HasSubstr("line 6: <mount_from_left> has 2 numbers in xyz, expected 3"));
  EXPECT_THAT(reader_refusal("estimate=\"no\"", "estimate=\"maybe\""), HasSubstr("expected one of: no, yes"));
  EXPECT_THAT(reader_refusal("xyz=\"0 0.5 -9.8\"", "xyz=\"0 0.5 down\""), HasSubstr("has \"down\" in xyz"));
  EXPECT_THAT(tracker_refusal("sigma=\"0.0002\"", "sigma=\"-1\""),
              HasSubstr("sigma=\"-1\", expected a positive number"));
}

TEST(SessionRefuses, Markers) {
  EXPECT_THAT(reader_refusal("count=\"3\"", "count=\"0\""), HasSubstr("count=\"0\", expected an integer from 1 to 64"));
  EXPECT_THAT(reader_refusal("count=\"3\"", "count=\"65\""), HasSubstr("count=\"65\""));
  EXPECT_THAT(reader_refusal("sigma_pixel=\"0.2\"", "sigma_pixel=\"0\""), HasSubstr("expected a positive number"));
  EXPECT_EQ(reader_refusal("index=\"2\"", "index=\"3\""),
            "session.xml, line 20: <marker> has index=\"3\", expected an integer from 0 to 2.");
  EXPECT_THAT(reader_refusal("index=\"2\"", "index=\"-1\""), HasSubstr("index=\"-1\""));
  EXPECT_THAT(reader_refusal("index=\"2\"", "index=\"0\""),
              HasSubstr("line 21: <marker> has index=\"0\" a second time"));
  EXPECT_THAT(reader_refusal("left=\"10 20\"", ""), HasSubstr("has neither left nor right"));
  EXPECT_THAT(reader_refusal("left=\"10 20\"", "point=\"1 2 3\""), HasSubstr("has neither left nor right"));
  EXPECT_THAT(reader_refusal("left=\"10 20\"", "left=\"10\""), HasSubstr("has 1 numbers in left, expected 2"));
  EXPECT_THAT(reader_refusal("left=\"10 20\"", "left=\"10 nan\""), HasSubstr("\"nan\""));
  EXPECT_THAT(reader_refusal("by=\"hand\"", "by=\"magic\""), HasSubstr("expected one of: hand, tracker, import"));
  EXPECT_THAT(tracker_refusal("point=\"1 2 3\"", ""), HasSubstr("has no point"));
  EXPECT_THAT(tracker_refusal("point=\"1 2 3\"", "left=\"1 2\""), HasSubstr("has no point"));
}

TEST(SessionRefuses, Joints) {
  EXPECT_THAT(reader_refusal("j1 j2", "j1 j1"), HasSubstr("line 13: <joints> names joint \"j1\" a second time"));
  EXPECT_THAT(reader_refusal("j1 j2", " "), HasSubstr("names no joint"));
  EXPECT_EQ(reader_refusal("<position>0.1 -0.2</position>", "<position>0.1 -0.2 1</position>"),
            "session.xml, line 16: <position> has 3 numbers, expected 2, one for each of <joints>.");
  EXPECT_THAT(reader_refusal("<velocity>1 2<", "<velocity>1<"), HasSubstr("<velocity> has 1 numbers, expected 2"));
  EXPECT_THAT(reader_refusal("<torque>3 4<", "<torque><"), HasSubstr("<torque> has 0 numbers, expected 2"));
  EXPECT_THAT(reader_refusal("<torque>3 4<", "<torque>3 inf<"),
              HasSubstr("<torque> has \"inf\", expected 2 finite numbers"));
  EXPECT_THAT(reader_refusal("<position>0.1 -0.2<", "<position>0,1 -0,2<"), HasSubstr("has \"0,1\""));
}

TEST(SessionRefuses, Observations) {
  EXPECT_THAT(reader_refusal("id=\"3\"", "id=\"7\""), HasSubstr("line 24: <observation> has id=\"7\" a second time"));
  EXPECT_THAT(reader_refusal("id=\"3\"", "id=\"-3\""), HasSubstr("id=\"-3\", expected an integer of at least 0"));
  EXPECT_THAT(reader_refusal("id=\"3\"", "id=\"3.0\""), HasSubstr("id=\"3.0\""));
  EXPECT_THAT(reader_refusal("id=\"3\"", "id=\"99999999999999999999\""), HasSubstr("expected an integer"));
  EXPECT_THAT(reader_refusal("id=\"3\"", ""), HasSubstr("no attribute id"));
  EXPECT_THAT(reader_refusal("time=\"4\"", "time=\"1\""), HasSubstr("line 25: <observation> has time=\"1\" after 1.5"));
  EXPECT_THAT(reader_refusal("time=\"4\"", "time=\"nan\""), HasSubstr("time=\"nan\""));
  EXPECT_THAT(reader_refusal("time=\"4\"", ""), HasSubstr("no attribute time"));
  EXPECT_THAT(reader_refusal("state=\"rejected\"", "state=\"maybe\""),
              HasSubstr("expected one of: accepted, rejected, excluded"));
  EXPECT_THAT(reader_refusal("state=\"rejected\"", ""), HasSubstr("no attribute state"));
  const std::size_t begin = small_session.find("  <observations>"), end = small_session.find("</handsight");
  EXPECT_THAT(reader_refusal(small_session.substr(0, begin) + small_session.substr(end)), HasSubstr("no observation"));
  EXPECT_THAT(reader_refusal(small_session.substr(0, begin) + "<observations/>" + small_session.substr(end)),
              HasSubstr("no observation"));
}

TEST(SessionRefuses, ImagesOutsideTheFolder) {
  for (const char* path : {"", "/etc/passwd", "../left.png", "images/../../left.png", "images/.."})
    EXPECT_THAT(reader_refusal("images/7_left.png", path),
                AllOf(HasSubstr("line 19: <images> has left="), HasSubstr("inside it")))
        << path;
  EXPECT_EQ(reader_refusal("images/7_left.png", "images/..7.png"), "nothing was refused")
      << "only a name that has dots";
}

TEST(SessionRefuses, EveryFileThatIsCutOff) {
  for (std::size_t size = 0; size + 2 < small_session.size(); ++size)
    ASSERT_THAT(reader_refusal(small_session.substr(0, size)), HasSubstr("session.xml")) << size;
}

TEST(SessionRefuses, WithShortSentencesWhateverIsWritten) {
  const std::string absurd(1000000, 'x');
  for (const char* piece :
       {"version=\"1\" t", "fx=\"500\"", "count=\"3\"", "by=\"hand\"", "state=\"rejected\"", "id=\"3\""}) {
    const std::string name = std::string(piece).substr(0, std::string(piece).find('='));
    const std::string rest = std::string(piece).substr(std::string(piece).rfind('"') + 1);
    EXPECT_THAT(reader_refusal(piece, name + "=\"" + absurd + "\"" + rest), HasSubstr("...")) << piece;
  }
  EXPECT_THAT(reader_refusal("<position>0.1", "<position>" + absurd), HasSubstr("..."));
  EXPECT_THAT(find_refusal([&] { parse_session("<a/>", absurd); }), HasSubstr("..."));
  EXPECT_THAT(reader_refusal("<" + absurd + "/>"), HasSubstr("..."));
}

}  // namespace
}  // namespace handsight
