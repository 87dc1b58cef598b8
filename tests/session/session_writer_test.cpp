// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "base/files.h"
#include "session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;
using testing::Not;

void expect_same(const Sighting& a, const Sighting& b) {
  EXPECT_EQ(a.marker, b.marker);
  ASSERT_EQ(a.in_cameras.size(), b.in_cameras.size());
  for (std::size_t i = 0; i < a.in_cameras.size(); ++i) {
    EXPECT_EQ(a.in_cameras[i].camera, b.in_cameras[i].camera);
    EXPECT_EQ(a.in_cameras[i].pixel, b.in_cameras[i].pixel);
  }
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.by, b.by);
}

void expect_same(const Observation& a, const Observation& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.position, b.position);
  EXPECT_TRUE(a.velocity.size() == b.velocity.size() && a.velocity == b.velocity);
  EXPECT_TRUE(a.torque.size() == b.torque.size() && a.torque == b.torque);
  EXPECT_EQ(a.images[0], b.images[0]);
  EXPECT_EQ(a.images[1], b.images[1]);
  EXPECT_EQ(a.decision, b.decision);
  EXPECT_EQ(a.reason, b.reason);
  ASSERT_EQ(a.sightings.size(), b.sightings.size());
  for (std::size_t i = 0; i < a.sightings.size(); ++i) expect_same(a.sightings[i], b.sightings[i]);
}

void expect_same(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  for (const auto number : {&Camera::fx, &Camera::fy, &Camera::skew, &Camera::cx, &Camera::cy, &Camera::k1, &Camera::k2,
                            &Camera::p1, &Camera::p2, &Camera::k3})
    EXPECT_EQ(a.*number, b.*number);
}

/// All numbers equal bit for bit, but rotations, which are written as angles.
void expect_same(const Session& a, const Session& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.robot_file, b.robot_file);
  EXPECT_EQ(a.tcp, b.tcp);
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.mount.link, b.mount.link);
  EXPECT_EQ(a.mount.estimate, b.mount.estimate);
  EXPECT_EQ(a.mount.known, b.mount.known);
  EXPECT_EQ(a.mount.mount_from_sensor.translation, b.mount.mount_from_sensor.translation);
  EXPECT_TRUE(a.mount.mount_from_sensor.rotation.isApprox(b.mount.mount_from_sensor.rotation, 1e-15));
  ASSERT_EQ(a.is_tracker(), b.is_tracker());
  if (a.rig) {
    expect_same(a.rig->at(0).camera, b.rig->at(0).camera);
    expect_same(a.rig->at(1).camera, b.rig->at(1).camera);
    EXPECT_EQ(a.rig->at(1).camera_from_first.translation, b.rig->at(1).camera_from_first.translation);
  }
  EXPECT_EQ(a.sigma_pixel, b.sigma_pixel);
  EXPECT_EQ(a.sigma_point, b.sigma_point);
  EXPECT_EQ(a.marker_count, b.marker_count);
  EXPECT_EQ(a.joints, b.joints);
  ASSERT_EQ(a.observations.size(), b.observations.size());
  for (std::size_t i = 0; i < a.observations.size(); ++i) expect_same(a.observations[i], b.observations[i]);
}

Session reread(const Session& session) { return parse_session(session_text(session), "session.xml"); }

TEST(SessionWriter, FromScratchReadsBack) {
  for (const std::string& text : {small_session, small_tracker_session}) {
    Session session = parse_session(text, "session.xml");
    session.source.reset();
    session.title = "R\xC3\xA9sum\xC3\xA9 <&> \"quoted\" 'it'";
    session.observations[0].time = std::nextafter(-1.0 / 3, 0.0);
    session.observations[0].position[0] = std::nextafter(0.1, 1.0);
    session.observations[0].reason = "5 > 3 & \"so\"";
    session.observations[0].decision = Decision::excluded;
    expect_same(session, reread(session));
  }
}

TEST(SessionWriter, UnchangedNumbersKeepTheirSpelling) {
  const std::string text = changed(small_session, "left=\"10 20\"", "left=\"1.0e1   20.000\"");
  EXPECT_THAT(session_text(parse_session(text, "session.xml")), HasSubstr("left=\"1.0e1   20.000\""));
}

TEST(SessionWriter, AnUnchangedSessionStaysAsItWas) {
  const std::string text = session_text(parse_session(small_session, "session.xml"));
  EXPECT_EQ(text, session_text(parse_session(text, "session.xml"))) << "saving settles at once";
  expect_same(parse_session(small_session, "session.xml"), parse_session(text, "session.xml"));
}

TEST(SessionWriter, MarkersAndDecisionsAreBroughtUpToDate) {
  Session session = parse_session(small_session, "session.xml");
  Observation& first = session.observations[0];
  see(first.sightings[0], 1, Vector2(1.0 / 3, 2));  // a camera more
  forget(first.sightings[1], 0);                    // and one less
  first.sightings[1].by = MarkedBy::tracker;
  first.decision = Decision::none;
  first.reason = {};
  session.observations[1].sightings = {seen_at(1, Vector2(5, 6), Vector2(7, 8), MarkedBy::hand)};
  session.observations[1].decision = Decision::accepted;
  session.observations[2].sightings.clear();
  const Session back = reread(session);
  expect_same(session, back);
  const std::string text = session_text(session);
  EXPECT_THAT(text, Not(HasSubstr("too far")));
  EXPECT_THAT(text, HasSubstr("right=\"0.3333333333333333 2\""));
}

/// So that a session is read in the language of who reads it.
TEST(SessionWriter, AReasonKeepsItsParts) {
  Session session = parse_session(small_session, "session.xml");
  const Message reason =
      message("joints moved {:.1f} deg since observation {}", 0.53, 12) + message(" ({})", "blurred");
  session.observations[0].decision = Decision::rejected;
  session.observations[0].reason = reason;
  const std::string text = session_text(session);
  EXPECT_THAT(text, HasSubstr("reason=\"joints moved 0.5 deg since observation 12 (blurred)\""));
  const Message back = reread(session).observations[0].reason;
  EXPECT_EQ(back, reason);
  ASSERT_EQ(back.arguments().size(), 2U);
  EXPECT_EQ(back.arguments()[0].form(), "joints moved %1 deg since observation %2");
  EXPECT_EQ(back.arguments()[0].arguments()[0].kind(), Message::Kind::number);
  EXPECT_EQ(back.arguments()[1].arguments()[0].kind(), Message::Kind::form);
  EXPECT_EQ(session_text(parse_session(text, "session.xml")), text);

  std::string changed = text;  // by a program that knows the text alone
  changed.replace(changed.find("joints moved 0.5"), 16, "joints moved 0.7");
  const Message theirs = parse_session(changed, "session.xml").observations[0].reason;
  EXPECT_EQ(theirs, "joints moved 0.7 deg since observation 12 (blurred)");
  EXPECT_TRUE(theirs.arguments().empty());

  session.observations[0].reason = "blurred";
  EXPECT_THAT(session_text(session), Not(HasSubstr("<form")));
}

TEST(SessionWriter, MarkersStandBeforeTheDecision) {
  Session session = parse_session(small_session, "session.xml");
  session.observations[0].sightings = {seen_at(1, Vector2(5, 6), {}, MarkedBy::hand)};
  const std::string text = session_text(session);
  EXPECT_LT(text.find("index=\"1\""), text.find("<decision"));
  expect_same(session, reread(session));
}

TEST(SessionWriter, ATrackersPointsAreBroughtUpToDate) {
  Session session = parse_session(small_tracker_session, "session.xml");
  session.observations[0].sightings[0].point = Vector3(1.0 / 3, 2, 3);
  expect_same(session, reread(session));
  EXPECT_THAT(session_text(session), HasSubstr("estimate=\"yes\"/>"));
}

TEST(SessionWriter, WhatIsNotUnderstoodIsKept) {
  std::string text =
      changed(small_session, "<gravity ", "<!-- a remark --><weather sky=\"blue\">dry</weather><gravity unit='m' ");
  text = changed(text, "<marker index=\"2\"", "<marker index=\"2\" confidence=\"0.9\" point=\"far\"");
  text = changed(text, "<velocity>", "<temperature>21.50</temperature><velocity>");
  Session session = parse_session(text, "session.xml");
  see(session.observations[0].sightings[1], 0, Vector2(1, 2));
  const std::string saved = session_text(session);
  for (const char* kept : {"<!-- a remark -->", "<weather sky=\"blue\">dry</weather>", "unit=\"m\"",
                           "confidence=\"0.9\"", "point=\"far\"", "<temperature>21.50</temperature>", "left=\"1 2\""})
    EXPECT_THAT(saved, HasSubstr(kept));
}

TEST(SessionWriter, ObservationsAreAddedAndLeftOutById) {
  Session session = parse_session(small_session, "session.xml");
  session.observations.erase(session.observations.begin() + 1);
  Observation added = session.observations[0];
  added.id = 100;
  added.time = 50;
  session.observations.push_back(added);
  expect_same(session, reread(session));
  added.id = 101;
  added.time = 2;
  session.observations.insert(session.observations.begin() + 1, added);
  expect_same(session, reread(session));
}

TEST(SessionWriter, SavingReplacesTheFile) {
  const TemporaryFolder temporary;
  replace_file(temporary.path / "robot.urdf", small_robot);
  replace_file(temporary.path / "session.xml", small_session);
  Session session = read_session(temporary.path);
  session.observations[0].decision = Decision::accepted;
  save_session(session);
  expect_same(session, read_session(temporary.path));
  session.file = temporary.path / "no_folder" / "session.xml";
  EXPECT_THAT(find_refusal([&] { save_session(session); }), HasSubstr("cannot be written"));
}

TEST(SessionWriter, SharedSessionsSurviveSaving) {
  const std::filesystem::path shared = HANDSIGHT_SHARED_DIR;
  if (!std::filesystem::exists(shared / "examples")) GTEST_SKIP() << "no shared examples on this machine";
  for (const char* path : {"examples/nothing_hidden", "examples/sagging", "real/justin_right_even"}) {
    if (!std::filesystem::exists(shared / path)) continue;
    Session session = read_session(shared / path);
    expect_same(session, reread(session));
    session.source.reset();
    expect_same(session, reread(session));
  }
}

}  // namespace
}  // namespace handsight
