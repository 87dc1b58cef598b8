// SPDX-License-Identifier: Apache-2.0
// Sessions of one camera, of three and of eight: <cameras> in and out.
#include <gmock/gmock.h>

#include "session/session_texts.h"

namespace handsight {
namespace {

using testing::HasSubstr;

const std::string three_cameras = R"(<handsight_session version="1" title="Three">
  <robot file="robot.urdf" tcp="hand"/>
  <cameras mount="base">
    <mount_from_first xyz="1 2 3" rpy="0.1 0.2 0.3" estimate="yes"/>
    <camera name="front" width="640" height="480" fx="500" fy="501" cx="320" cy="240" k1="-0.1"/>
    <camera name="side" width="800" height="600" fx="510" fy="511" cx="400" cy="300"><from_first xyz="-0.2 0 0.1" rpy="0 0.1 0"/></camera>
    <camera name="top_2" width="800" height="600" fx="520" fy="521" cx="401" cy="301"><from_first xyz="0 0.3 0"/></camera>
  </cameras>
  <markers count="2" sigma_pixel="0.3"/>
  <joints>j1 j2</joints>
  <observations>
    <observation id="0" time="1">
      <position>0.1 -0.2</position>
      <images front="0_front.png" top_2="0_top.png"/>
      <marker index="0" front="1 2" top_2="5 6" top_2_sigma="0.1 0.2 0" by="hand"/>
      <marker index="1" side="3 4" by="import"/>
    </observation>
  </observations>
</handsight_session>
)";

const std::string one_camera = R"(<handsight_session version="1">
  <robot file="robot.urdf" tcp="hand"/>
  <cameras mount="hand"><mount_from_first estimate="yes"/>
    <camera name="eye" width="640" height="480" fx="500" fy="501" cx="320" cy="240"/></cameras>
  <markers count="1"/><joints>j1</joints>
  <observations><observation id="0" time="0"><position>0.5</position><marker index="0" eye="1 2"/></observation></observations>
</handsight_session>
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    parse_session(text, "session.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RigSession, IsRead) {
  const Session s = parse_session(three_cameras, "session.xml");
  EXPECT_TRUE(s.notes.empty());
  ASSERT_TRUE(s.rig);
  EXPECT_EQ(camera_names(*s.rig), (std::vector<std::string>{"front", "side", "top_2"}));
  EXPECT_STREQ(device_tag(s), "cameras");
  EXPECT_EQ(s.mount.mount_from_sensor.translation, Vector3(1, 2, 3));
  EXPECT_TRUE(s.mount.estimate);
  EXPECT_EQ(s.rig->at(0).camera.k1, -0.1);
  EXPECT_EQ(s.rig->at(1).camera_from_first.translation, Vector3(-0.2, 0, 0.1));
  EXPECT_EQ(s.rig->at(2).camera_from_first.rotation, Matrix3::Identity());
  const Observation& o = s.observations[0];
  EXPECT_EQ(o.images[0], "0_front.png");
  EXPECT_EQ(o.images[1], "");
  EXPECT_EQ(o.images[2], "0_top.png");
  ASSERT_EQ(o.sightings.size(), 2u);
  EXPECT_EQ(seen_by(o.sightings[0], 0)->pixel, Vector2(1, 2));
  EXPECT_FALSE(seen_by(o.sightings[0], 1));
  EXPECT_EQ(seen_by(o.sightings[0], 2)->sigma->v, 0.2);
  EXPECT_EQ(seen_by(o.sightings[1], 1)->pixel, Vector2(3, 4));
}

TEST(RigSession, OfOneCameraOnTheHand) {
  const Session s = parse_session(one_camera, "session.xml");
  EXPECT_TRUE(s.notes.empty());
  EXPECT_EQ(s.rig->count(), 1);
  EXPECT_EQ(s.mount.link, "hand");
  EXPECT_FALSE(s.mount.known);
  EXPECT_EQ(seen_by(s.observations[0].sightings[0], 0)->pixel, Vector2(1, 2));
}

TEST(RigSession, WrittenFromScratchReadsBack) {
  for (const std::string& text : {three_cameras, one_camera, small_session}) {
    Session s = parse_session(text, "session.xml");
    s.source.reset();
    const Session again = parse_session(session_text(s), "session.xml");
    EXPECT_TRUE(again.notes.empty());
    ASSERT_EQ(again.rig->count(), s.rig->count());
    EXPECT_STREQ(device_tag(again), device_tag(s));
    for (int c = 0; c < s.rig->count(); ++c) {
      EXPECT_EQ(again.rig->at(c).name, s.rig->at(c).name);
      EXPECT_EQ(again.rig->at(c).camera.fx, s.rig->at(c).camera.fx);
      EXPECT_EQ(again.rig->at(c).camera.width, s.rig->at(c).camera.width);
      EXPECT_LT(small_motion_between(again.rig->at(c).camera_from_first, s.rig->at(c).camera_from_first).norm(), 1e-15);
      EXPECT_EQ(again.observations[0].images, s.observations[0].images);
    }
    ASSERT_EQ(again.observations[0].sightings.size(), s.observations[0].sightings.size());
    for (std::size_t m = 0; m < s.observations[0].sightings.size(); ++m)
      for (int c = 0; c < s.rig->count(); ++c) {
        const CameraPoint *a = seen_by(again.observations[0].sightings[m], c),
                          *b = seen_by(s.observations[0].sightings[m], c);
        ASSERT_EQ(a == nullptr, b == nullptr);
        if (!a) continue;
        EXPECT_EQ(a->pixel, b->pixel);
        EXPECT_EQ(a->sigma.has_value(), b->sigma.has_value());
      }
  }
}

TEST(RigSession, SavingKeepsTheRestAndChangesThePoint) {
  Session s = parse_session(three_cameras, "session.xml");
  see(s.observations[0].sightings[1], 2, Vector2(7, 8));
  forget(s.observations[0].sightings[0], 0);
  const std::string text = session_text(s);
  EXPECT_THAT(text, HasSubstr(R"(<marker index="0" top_2="5 6" top_2_sigma="0.1 0.2 0" by="hand"/>)"));
  EXPECT_THAT(text, HasSubstr(R"(<marker index="1" side="3 4" by="import" top_2="7 8"/>)"));
  EXPECT_THAT(text, HasSubstr(R"(<from_first xyz="0 0.3 0"/>)"));
}

TEST(RigSession, RefusesWhatIsWrong) {
  EXPECT_THAT(refusal(changed(three_cameras, "name=\"side\"", "name=\"front\"")), HasSubstr("names that differ"));
  EXPECT_THAT(refusal(changed(three_cameras, "name=\"side\"", "name=\"a side\"")), HasSubstr("letters, digits and _"));
  EXPECT_THAT(refusal(changed(three_cameras, "name=\"side\"", "name=\"index\"")), HasSubstr("another name"));
  EXPECT_THAT(refusal(changed(three_cameras, "name=\"side\"", "name=\"front_sigma\"")), HasSubstr("_sigma"));
  EXPECT_THAT(refusal(changed(three_cameras, R"(<from_first xyz="0 0.3 0"/>)", "")), HasSubstr("no <from_first>"));
  EXPECT_THAT(refusal(changed(one_camera, R"(cy="240"/>)", R"(cy="240"><from_first xyz="0 0 0"/></camera>)")),
              HasSubstr("the first is the reference"));
  EXPECT_THAT(refusal(changed(one_camera, "eye=\"1 2\"", "left=\"1 2\"")), HasSubstr("has no eye"));
  EXPECT_THAT(refusal(changed(three_cameras, "side=\"3 4\"", "")), HasSubstr("neither front nor side nor top_2"));
  std::string nine;
  for (int c = 0; c < 8; ++c)
    nine += "<camera name=\"c" + std::to_string(c) +
            R"(" width="640" height="480" fx="500" fy="501" cx="320" cy="240"><from_first xyz="0.1 0 0"/></camera>)";
  EXPECT_THAT(refusal(changed(one_camera, "</cameras>", nine + "</cameras>")), HasSubstr("at most 8"));
  EXPECT_THAT(
      refusal(changed(one_camera, "<markers", "<tracker mount=\"base\"><mount_from_tracker/></tracker><markers")),
      HasSubstr("stands beside the <cameras>"));
}

TEST(RigSession, LensesOfOtherModelsAreReadAndWritten) {
  Session wide = parse_session(
      changed(one_camera, "cy=\"240\"", "cy=\"240\" model=\"fisheye\" k1=\"0.1\" k4=\"-0.02\""), "session.xml");
  EXPECT_TRUE(wide.notes.empty());
  EXPECT_TRUE(wide.rig->at(0).camera.is_fisheye);
  EXPECT_EQ(wide.rig->at(0).camera.k4, -0.02);
  Session rational =
      parse_session(changed(one_camera, "cy=\"240\"", "cy=\"240\" k4=\"0.3\" k6=\"0.01\""), "session.xml");
  EXPECT_TRUE(rational.notes.empty());
  for (Session* s : {&wide, &rational}) {
    s->source.reset();
    const Camera again = parse_session(session_text(*s), "session.xml").rig->at(0).camera,
                 &before = s->rig->at(0).camera;
    EXPECT_EQ(again.is_fisheye, before.is_fisheye);
    EXPECT_EQ(Vector3(again.k4, again.k5, again.k6), Vector3(before.k4, before.k5, before.k6));
    EXPECT_EQ(again.k1, before.k1);
  }
  EXPECT_THAT(refusal(changed(one_camera, "cy=\"240\"", "cy=\"240\" model=\"fisheye\" p1=\"0.1\"")),
              HasSubstr("k1 k2 k3 k4"));
  EXPECT_THAT(refusal(changed(one_camera, "cy=\"240\"", "cy=\"240\" model=\"pinhole\"")), HasSubstr("fisheye"));
}

}  // namespace
}  // namespace handsight
