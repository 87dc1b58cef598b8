// SPDX-License-Identifier: Apache-2.0
// What arrives in a watched folder: whole pairs come in, everything else is named and waits. And the document with it.
#include <gtest/gtest.h>

#include <fstream>

#include "app/arriving_session.h"
#include "document/document.h"
#include "live/live_look.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

class Live : public testing::Test, protected test::ArrivingSession {
 protected:
  Live() : ArrivingSession(8) { session = read_session(home); }
  LiveTask task() {
    LiveTask t = task_of(session, own_sources(session));
    t.settles_in = {};  // here nobody is writing any more
    return t;
  }
  /// Two looks, the second with what the first saw.
  LiveLook look_twice() {
    LiveTask task = this->task();
    task.stamps = look_for_images(task).stamps;
    return look_for_images(task);
  }
  Session session;
};

TEST_F(Live, APairWithItsAnglesComesInAtTheSecondLook) {
  bring(8);
  table(header("number") + line(8, "8"));
  LiveTask task = this->task();
  const LiveLook first = look_for_images(task);
  EXPECT_TRUE(first.instants.empty()) << "it may still be written";
  EXPECT_TRUE(first.remarks.isEmpty()) << first.remarks.join(' ').toStdString();
  task.stamps = first.stamps;
  const LiveLook second = look_for_images(task);
  ASSERT_EQ(second.instants.size(), 1U);
  EXPECT_EQ(second.instants[0].images[0], one(8).images[0]);
  EXPECT_EQ(second.instants[0].position, one(8).position);
  EXPECT_FALSE(second.instants[0].time);
  task.settles_in = std::chrono::hours(1);
  EXPECT_TRUE(look_for_images(task).instants.empty()) << "two looks in a hurry are no proof";
}

TEST_F(Live, WhatIsHalfWrittenWaits) {
  table(header("number") + line(8, "8"));
  bring(8);
  const std::string whole = read_file(home / one(8).images[1]);
  std::ofstream(home / one(8).images[1], std::ios::binary) << whole.substr(0, whole.size() / 2);
  LiveLook look = look_twice();
  EXPECT_TRUE(look.instants.empty()) << "it has stopped growing, but it is no image yet";
  ASSERT_EQ(look.remarks.size(), 1);
  EXPECT_TRUE(look.remarks[0].contains(QString::fromStdString(fs::path(one(8).images[1]).filename().string())));
  std::ofstream(home / one(8).images[1], std::ios::binary) << whole;
  look = look_twice();
  EXPECT_EQ(look.instants.size(), 1U);
  EXPECT_TRUE(look.remarks.isEmpty());
}

TEST_F(Live, ALineOfAnglesThatIsBeingWrittenIsNoLine) {
  bring(8);
  const std::string last = line(8, "8");
  table(header("number") + line(7, "7") + last.substr(0, last.size() - 4));
  const LiveLook look = look_twice();
  EXPECT_TRUE(look.instants.empty());
  ASSERT_EQ(look.remarks.size(), 1);
  EXPECT_TRUE(look.remarks[0].contains("waits for its joint angles in joints.csv (number 8)"))
      << look.remarks[0].toStdString();
}

TEST_F(Live, AnImageWithoutAPartnerIsNamedAndHoldsUpNoOther) {
  bring(8, true, false);
  bring(9);
  table(header("number") + line(9, "9") + line(8, "8"));
  const LiveLook look = look_twice();
  ASSERT_EQ(look.instants.size(), 1U);
  EXPECT_EQ(look.instants[0].position, one(9).position) << "nor does it shift the angles";
  ASSERT_EQ(look.remarks.size(), 1);
  EXPECT_TRUE(look.remarks[0].contains("waits for its right image")) << look.remarks[0].toStdString();
}

TEST_F(Live, AWrongSizeIsNamedWithBothSizes) {
  table(header("number") + line(8, "8"));
  bring(8);
  session.rig->at(0).camera.width += 160;
  const LiveLook look = look_twice();
  EXPECT_TRUE(look.instants.empty());
  ASSERT_EQ(look.remarks.size(), 1);
  EXPECT_TRUE(look.remarks[0].contains(QString::number(session.rig->at(0).camera.width)))
      << look.remarks[0].toStdString();
}

TEST_F(Live, WithoutNumbersLinesAreCountedOnlyWhereTheyAgreeWithTheSession) {
  bring(8);
  std::string text = header();
  for (int id = 0; id <= 8; ++id) text += line(id);
  table(text);
  EXPECT_EQ(look_twice().instants.size(), 1U);
  table(header() + line(8));
  LiveLook look = look_twice();
  EXPECT_TRUE(look.instants.empty()) << "one line for nine pairs: whose is it?";
  EXPECT_TRUE(look.remarks.join(' ').contains("\"number\"")) << look.remarks.join(' ').toStdString();
  text = header();
  for (int id = 8; id >= 0; --id) text += line(id);
  table(text);
  look = look_twice();
  EXPECT_TRUE(look.instants.empty()) << "as many lines, but not those of these images";
  EXPECT_TRUE(look.remarks.join(' ').contains("is not the posture")) << look.remarks.join(' ').toStdString();
}

TEST_F(Live, ImagesOfAnotherFolderAreBroughtIntoTheSession) {
  const fs::path outside = folder.path / "camera";
  fs::create_directories(outside);
  fs::copy_file(sample / one(8).images[0], outside / fs::path(one(8).images[0]).filename());
  fs::copy_file(sample / one(8).images[1], outside / fs::path(one(8).images[1]).filename());
  replace_file(outside / "log.csv", header("time,number") + line(8, "77.5,8"));
  LiveTask task = this->task();
  task.sources = {{outside, outside}, outside / "log.csv"};
  task.stamps = look_for_images(task).stamps;
  const LiveLook look = look_for_images(task);
  ASSERT_EQ(look.instants.size(), 1U) << look.remarks.join(' ').toStdString();
  EXPECT_EQ(look.instants[0].time, 77.5);
  EXPECT_EQ(read_file(home / look.instants[0].images[0]), read_file(sample / one(8).images[0]));
}

TEST_F(Live, OfOneCameraEveryImageIsAnInstant) {
  session.rig->cameras.resize(1);
  for (Observation& o : session.observations) o.images[1].clear();
  bring(8, true, false);
  fs::create_directories(home / "own");
  for (const auto& entry : fs::directory_iterator(home / "images"))
    if (entry.path().filename().string().find("left") != std::string::npos) fs::copy(entry.path(), home / "own");
  table(header("number") + line(8, "8"));
  LiveTask task = this->task();
  task.sources.folders = {home / "own"};
  task.stamps = look_for_images(task).stamps;
  const LiveLook look = look_for_images(task);
  ASSERT_EQ(look.instants.size(), 1U) << look.remarks.join(' ').toStdString();
  ASSERT_EQ(look.instants[0].images.size(), 1U);
  EXPECT_EQ(look.instants[0].position, one(8).position);
}

TEST_F(Live, ThreeCamerasInOneFolderAreToldByTheirNames) {
  session.rig->cameras.push_back(session.rig->at(1));
  session.rig->cameras.back().name = "right_2";
  bring(8);
  table(header("number") + line(8, "8"));
  LiveTask task = this->task();
  task.sources.folders.back() = home / "images";
  EXPECT_TRUE(look_for_images(task).instants.empty()) << "the third camera has none yet";
  fs::path third = home / one(8).images[1];
  third.replace_filename("008_right_2.png");
  fs::copy_file(home / one(8).images[1], third);
  task.stamps = look_for_images(task).stamps;
  const LiveLook look = look_for_images(task);
  ASSERT_EQ(look.instants.size(), 1U) << look.remarks.join(' ').toStdString();
  EXPECT_EQ(look.instants[0].images,
            (std::vector<std::string>{one(8).images[0], one(8).images[1], "images/008_right_2.png"}));
}

TEST_F(Live, ArrivalsAreActionsThatOutliveAKillAndAreSaved) {
  bring(8);
  bring(9);
  const auto arrival = [&](std::int64_t id) {
    Observation o = one(id);
    o.sightings.clear();
    o.decision = Decision::none;
    o.reason.clear();
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
