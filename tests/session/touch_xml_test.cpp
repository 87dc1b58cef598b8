// SPDX-License-Identifier: Apache-2.0
#include "session/touch_xml.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

std::string text_with(const std::string& fixtures, const std::string& touches) {
  std::string observations;
  int id = 0;
  for (std::size_t begin = 0; begin < touches.size();) {
    const std::size_t end = touches.find("/>", begin) + 2;
    observations += "<observation id=\"" + std::to_string(id) + "\" time=\"" + std::to_string(id) +
                    "\"><position>0.1 0.2</position>" + touches.substr(begin, end - begin) + "</observation>";
    ++id;
    begin = end;
  }
  return "<handsight_session version=\"1\"><robot file=\"r.urdf\" tcp=\"hand\"/><touch sigma=\"1e-4\">" + fixtures +
         "</touch><joints>a b</joints><observations>" + observations + "</observations></handsight_session>";
}

const std::string all_fixtures =
    "<plane id=\"table\" normal=\"0 0 2\" offset=\"0.3\" estimate=\"yes\" sigma=\"2e-5\"/>"
    "<point id=\"socket\" estimate=\"yes\" mount=\"stand\"/>"
    "<line id=\"edge\" xyz=\"0.1 0 0\" direction=\"1 0 0\" estimate=\"yes\"/>"
    "<gauge id=\"dial\" xyz=\"0 0 1\" axis=\"0 1 0\"/>"
    "<length id=\"bar\" to=\"1 2 3\" estimate=\"yes\"/>"
    "<apart of=\"socket\" from=\"bar\" by=\"0.05\" sigma=\"1e-5\"/>";
const std::string all_touches =
    "<touched fixture=\"table\" value=\"0.00012\"/><touched fixture=\"socket\"/><touched fixture=\"edge\"/>"
    "<touched fixture=\"dial\" value=\"-0.003\"/><touched fixture=\"bar\" value=\"0.3\"/>";

std::string refusal(const std::string& fixtures, const std::string& touches) {
  try {
    parse_session(text_with(fixtures, touches), "session.xml");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(TouchXml, EachFixtureIsAPartWithAMountOfItsOwn) {
  const Session s = parse_session(text_with(all_fixtures, all_touches), "session.xml");
  ASSERT_EQ(s.fixtures.size(), 5U);
  ASSERT_EQ(s.parts.size(), 5U);
  EXPECT_EQ(s.other_mounts.size(), 4U);
  EXPECT_EQ(s.marker_count, 1);
  EXPECT_EQ(s.fixtures[0].sigma, 2e-5);
  EXPECT_EQ(s.fixtures[1].sigma, 1e-4) << "the session's own";
  EXPECT_TRUE(s.mount.mount_from_sensor.rotation.col(2).isApprox(Vector3::UnitZ()));
  EXPECT_NEAR(s.mount.mount_from_sensor.translation.z(), 0.3, 1e-12);
  EXPECT_FALSE(s.other_mounts[0].known);
  EXPECT_FALSE(s.other_mounts[2].estimate);
  EXPECT_EQ(s.distances.front().from, 4);
  EXPECT_EQ(s.observations[0].sightings.front().point->z(), 0.00012);
  EXPECT_EQ(s.observations[2].sightings.size(), 2U) << "an edge holds two numbers";
  EXPECT_EQ(s.observations[4].sightings.front().reading, fixtures::length.numbers.front().reading);
  EXPECT_EQ(s.observations[4].part, 4);
}

TEST(TouchXml, WrittenItReadsBack) {
  Session s = parse_session(text_with(all_fixtures, all_touches), "session.xml");
  s.source.reset();
  const Session again = parse_session(session_text(s), "session.xml");
  ASSERT_EQ(again.fixtures.size(), s.fixtures.size());
  for (std::size_t f = 0; f < s.fixtures.size(); ++f) {
    EXPECT_EQ(again.fixtures[f].id, s.fixtures[f].id);
    EXPECT_EQ(again.fixtures[f].kind, s.fixtures[f].kind);
    EXPECT_EQ(again.fixtures[f].sigma, s.fixtures[f].sigma);
  }
  EXPECT_EQ(again.other_mounts[0].known, s.other_mounts[0].known);
  EXPECT_TRUE(again.other_mounts[3].mount_from_sensor.translation.isApprox(Vector3(1, 2, 3)));
  ASSERT_EQ(again.observations.size(), s.observations.size());
  for (std::size_t i = 0; i < s.observations.size(); ++i) {
    EXPECT_EQ(again.observations[i].part, s.observations[i].part);
    EXPECT_EQ(*again.observations[i].sightings.front().point, *s.observations[i].sightings.front().point);
  }
}

TEST(TouchXml, SaysWhatIsWrong) {
  const std::string socket = "<point id=\"socket\" estimate=\"yes\"/>", touched = "<touched fixture=\"socket\"/>";
  EXPECT_EQ(refusal(socket, touched), "");
  EXPECT_NE(refusal("", touched).find("holds no fixture"), std::string::npos);
  EXPECT_NE(refusal(socket + socket, touched).find("a second time"), std::string::npos);
  EXPECT_NE(refusal(socket, "<touched fixture=\"hole\"/>").find("one of the fixtures: socket"), std::string::npos);
  EXPECT_NE(refusal("<gauge id=\"g\" estimate=\"yes\"/>", touched).find("does not say where it is"), std::string::npos);
  EXPECT_NE(refusal("<length id=\"bar\" to=\"1 2 3\"/>", "<touched fixture=\"bar\"/>").find("the length that was read"),
            std::string::npos);
  EXPECT_NE(refusal(socket + "<apart of=\"socket\" from=\"socket\" by=\"1\" sigma=\"1e-5\"/>", touched)
                .find("from a fixture to itself"),
            std::string::npos);
}

}  // namespace
}  // namespace handsight
