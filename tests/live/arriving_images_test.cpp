// SPDX-License-Identifier: Apache-2.0
// Images that arrive in a watched folder: whole pairs come in, everything else is named and waits.
#include <gmock/gmock.h>

#include <fstream>

#include "app/arriving_session.h"
#include "live/arrivals.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ArrivingImages : public testing::Test, protected test::ArrivingSession {
 protected:
  ArrivingImages() : ArrivingSession(8) { session = read_session(home); }
  /// Here nobody is writing any more, unless told.
  Arrivals watch(milliseconds settles_in = {}) { return {session, own_sources(session), settles_in}; }
  Arrivals::Look look_twice() {
    Arrivals arrivals = watch();
    EXPECT_THAT(arrivals.look().arrived, IsEmpty()) << "they may still be written";
    return arrivals.look();
  }
  Session session;
};

TEST_F(ArrivingImages, APairWithItsAnglesComesInAtTheSecondLook) {
  bring(8);
  table(header("number") + line(8, "8"));
  Arrivals arrivals = watch();
  const Arrivals::Look first = arrivals.look();
  EXPECT_THAT(first.arrived, IsEmpty()) << "it may still be written";
  EXPECT_THAT(first.remarks, IsEmpty());
  const Arrivals::Look second = arrivals.look();
  ASSERT_THAT(second.arrived, SizeIs(1));
  EXPECT_EQ(second.arrived[0].images[0], one(8).images[0]);
  EXPECT_EQ(second.arrived[0].position, one(8).position);
  EXPECT_EQ(second.arrived[0].time, session.observations.back().time + 1) << "where the table tells none";
  Arrivals patient = watch(std::chrono::hours(1));
  patient.look();
  EXPECT_THAT(patient.look().arrived, IsEmpty()) << "two looks in a hurry are no proof";
}

TEST_F(ArrivingImages, WhatIsHalfWrittenWaits) {
  table(header("number") + line(8, "8"));
  bring(8);
  const std::string whole = read_file(home / one(8).images[1]), name = fs::path(one(8).images[1]).filename().string();
  std::ofstream(home / one(8).images[1], std::ios::binary) << whole.substr(0, whole.size() / 2);
  Arrivals arrivals = watch();
  arrivals.look();
  const Arrivals::Look half = arrivals.look();
  EXPECT_THAT(half.arrived, IsEmpty()) << "it has stopped growing, but it is no image yet";
  EXPECT_THAT(half.remarks, ElementsAre(HasSubstr(name)));
  EXPECT_THAT(arrivals.look().remarks, IsEmpty()) << "said once";
  EXPECT_THAT(arrivals.standing(), ElementsAre(HasSubstr(name))) << "as long as it is so";
  std::ofstream(home / one(8).images[1], std::ios::binary) << whole;
  arrivals.look();
  EXPECT_THAT(arrivals.look().arrived, SizeIs(1));
  EXPECT_THAT(arrivals.standing(), IsEmpty());
}

/// Header and length are right, what lies between is not.
TEST_F(ArrivingImages, AnImageThatIsBrokenInsideIsNamed) {
  table(header("number") + line(8, "8"));
  bring(8);
  const std::string whole = read_file(home / one(8).images[1]);
  const std::string broken =
      whole.substr(0, 60) + std::string(whole.size() - 80, 'x') + whole.substr(whole.size() - 20);
  std::ofstream(home / one(8).images[1], std::ios::binary) << broken;
  const Arrivals::Look look = look_twice();
  EXPECT_THAT(look.arrived, IsEmpty());
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("is no image that can be read")));
}

TEST_F(ArrivingImages, ALineOfAnglesThatIsBeingWrittenIsNoLine) {
  bring(8);
  const std::string last = line(8, "8");
  table(header("number") + line(7, "7") + last.substr(0, last.size() - 4));
  const Arrivals::Look look = look_twice();
  EXPECT_THAT(look.arrived, IsEmpty());
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("waits for its joint angles in joints.csv (number 8)")));
}

TEST_F(ArrivingImages, AnImageWithoutAPartnerIsNamedAndHoldsUpNoOther) {
  bring(8, true, false);
  bring(9);
  table(header("number") + line(9, "9") + line(8, "8"));
  const Arrivals::Look look = look_twice();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].position, one(9).position) << "nor does it shift the angles";
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("waits for its right image")));
}

TEST_F(ArrivingImages, AWrongSizeIsNamedWithBothSizes) {
  table(header("number") + line(8, "8"));
  bring(8);
  session.rig->at(0).camera.width += 160;
  const Arrivals::Look look = look_twice();
  EXPECT_THAT(look.arrived, IsEmpty());
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr(std::to_string(session.rig->at(0).camera.width))));
}

TEST_F(ArrivingImages, WithoutNumbersLinesAreCountedOnlyWhereTheyAgreeWithTheSession) {
  bring(8);
  std::string text = header();
  for (int id = 0; id <= 8; ++id) text += line(id);
  table(text);
  EXPECT_THAT(look_twice().arrived, SizeIs(1));
  table(header() + line(8));
  Arrivals::Look look = look_twice();
  EXPECT_THAT(look.arrived, IsEmpty()) << "one line for nine pairs: whose is it?";
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("\"number\"")));
  text = header();
  for (int id = 8; id >= 0; --id) text += line(id);
  table(text);
  look = look_twice();
  EXPECT_THAT(look.arrived, IsEmpty()) << "as many lines, but not those of these images";
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("is not the posture")));
}

TEST_F(ArrivingImages, ATableWithoutAHeaderIsOneOfTheJoints) {
  bring(8);
  std::string text;
  for (int id = 0; id <= 8; ++id) text += line(id);
  std::replace(text.begin(), text.end(), ',', ' ');
  table(text);
  const Arrivals::Look look = look_twice();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].position, one(8).position);
}

/// A table that is mended in the middle, while it grows or with as many bytes, is read from its beginning.
TEST_F(ArrivingImages, ATableThatIsMendedIsReadAnew) {
  bring(8);
  bring(9);
  std::string broken = line(8, "8");
  broken.replace(broken.find(',') + 1, 1, "x");
  table(header("number") + broken + line(9, "9"));
  Arrivals arrivals = watch();
  arrivals.look();
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1)) << "one that is broken holds up no other";
  EXPECT_EQ(look.arrived[0].position, one(9).position);
  EXPECT_THAT(arrivals.standing(), testing::Contains(HasSubstr("finite number")));
  table(header("number") + line(8, "8") + line(9, "9"));
  const Arrivals::Look mended = arrivals.look();
  ASSERT_THAT(mended.arrived, SizeIs(1));
  EXPECT_EQ(mended.arrived[0].position, one(8).position);
  EXPECT_THAT(arrivals.standing(), IsEmpty());
}

TEST_F(ArrivingImages, ImagesOfAnotherFolderAreBroughtIntoTheSession) {
  const fs::path outside = folder.path / "camera";
  fs::create_directories(outside);
  fs::copy_file(sample / one(8).images[0], outside / fs::path(one(8).images[0]).filename());
  fs::copy_file(sample / one(8).images[1], outside / fs::path(one(8).images[1]).filename());
  replace_file(outside / "log.csv", header("time,number") + line(8, "77.5,8"));
  Arrivals arrivals(session, {{outside, outside}, outside / "log.csv"}, milliseconds(0));
  arrivals.look();
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1)) << testing::PrintToString(look.remarks);
  EXPECT_EQ(look.arrived[0].time, 77.5);
  EXPECT_EQ(read_file(home / look.arrived[0].images[0]), read_file(sample / one(8).images[0]));
}

TEST_F(ArrivingImages, OfOneCameraEveryImageIsAnInstant) {
  session.rig->cameras.resize(1);
  for (Observation& o : session.observations) o.images[1].clear();
  bring(8, true, false);
  fs::create_directories(home / "own");
  for (const auto& entry : fs::directory_iterator(home / "images"))
    if (entry.path().filename().string().find("left") != std::string::npos) fs::copy(entry.path(), home / "own");
  table(header("number") + line(8, "8"));
  Arrivals arrivals(session, {{home / "own"}, home / "joints.csv"}, milliseconds(0));
  arrivals.look();
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1)) << testing::PrintToString(look.remarks);
  EXPECT_EQ(look.arrived[0].images[1], "");
  EXPECT_EQ(look.arrived[0].position, one(8).position);
}

TEST_F(ArrivingImages, ThreeCamerasInOneFolderAreToldByTheirNames) {
  session.rig->cameras.push_back(session.rig->at(1));
  session.rig->cameras.back().name = "right_2";
  bring(8);
  table(header("number") + line(8, "8"));
  LiveSources sources = own_sources(session);
  sources.folders.back() = home / "images";
  Arrivals arrivals(session, sources, milliseconds(0));
  arrivals.look();
  EXPECT_THAT(arrivals.look().arrived, IsEmpty()) << "the third camera has none yet";
  fs::path third = home / one(8).images[1];
  third.replace_filename("008_right_2.png");
  fs::copy_file(home / one(8).images[1], third);
  arrivals.look();
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1)) << testing::PrintToString(look.remarks);
  EXPECT_EQ(look.arrived[0].images[0], one(8).images[0]);
  EXPECT_EQ(look.arrived[0].images[1], one(8).images[1]);
  EXPECT_EQ(look.arrived[0].images[2], "images/008_right_2.png");
}

/// As where a robot's program counts anew and calls its files otherwise.
TEST_F(ArrivingImages, ANumberMayComeAgainUnderOtherNames) {
  const auto again = [&](std::size_t camera) {
    const fs::path first = one(0).images[camera];
    return home / "images" / ("again_" + first.filename().string());
  };
  table(header("number,time") + line(0, "0," + format_number(one(0).time)));
  fs::copy_file(home / one(1).images[0], again(0));
  Arrivals arrivals = watch();
  arrivals.look();
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  EXPECT_THAT(arrivals.standing(), ElementsAre(HasSubstr("waits for its right image"))) << "the old one is not taken";
  fs::copy_file(home / one(1).images[1], again(1));
  arrivals.look();
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  EXPECT_THAT(arrivals.standing(), ElementsAre(HasSubstr("waits for its joint angles"))) << "nor is the old line";
  std::ofstream(home / "joints.csv", std::ios::app) << line(8, "0,1000");
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].position, one(8).position);
  EXPECT_EQ(home / look.arrived[0].images[0], again(0));
  EXPECT_EQ(home / look.arrived[0].images[1], again(1));
}

/// As after an undo, and as where it could not be written down.
TEST_F(ArrivingImages, WhatTheSessionHasNoLongerStaysAwayUnlessItIsForgotten) {
  bring(8);
  table(header("number") + line(8, "8"));
  Arrivals arrivals = watch();
  arrivals.look();
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  arrivals.know(session);
  arrivals.look();
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  arrivals.forget(look.arrived[0]);
  arrivals.look();
  const Arrivals::Look again = arrivals.look();
  ASSERT_THAT(again.arrived, SizeIs(1));
  EXPECT_EQ(again.arrived[0].position, one(8).position);
  EXPECT_EQ(again.arrived[0].time, look.arrived[0].time) << "times go on from what the session has";
}

}  // namespace
}  // namespace handsight
