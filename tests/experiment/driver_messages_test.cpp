// SPDX-License-Identifier: Apache-2.0
#include "experiment/driver/driver_messages.h"

#include <gmock/gmock.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

using testing::HasSubstr;

TEST(DriverMessages, WhatIsSaidIsReadBackOnTheOtherSide) {
  Eigen::VectorXd a(2), b(2);
  a << 0.1, -2.5e-17;
  b << 1.0 / 3, 4;
  const DriverRequest move = driver_request(move_line(7, {a, b}, 0.25));
  EXPECT_EQ(move.id, 7);
  EXPECT_EQ(move.what, "move");
  ASSERT_EQ(move.path.size(), 2U);
  EXPECT_EQ(move.path[0], a);
  EXPECT_EQ(move.path[1], b);
  EXPECT_EQ(move.speed, 0.25);
  EXPECT_EQ(driver_request(hello_line(1)).what, "hello");
  EXPECT_EQ(driver_request(look_line(2)).what, "look");
  EXPECT_EQ(driver_request(stop_line(3)).what, "stop");
}

TEST(DriverMessages, AnswersAreReadBackBitForBit) {
  Eigen::VectorXd q(2), torque(2);
  q << 1.0 / 7, -3;
  torque << 5, 6e-3;
  const MoveAnswer moved = move_answer(answer_line(4, MoveAnswer{true, {}, q, torque, 12.5}), 2);
  EXPECT_TRUE(moved.ok);
  EXPECT_EQ(moved.position, q);
  EXPECT_EQ(moved.torque, torque);
  EXPECT_EQ(moved.time, 12.5);

  const Session stereo = fixture::stand_session();
  LookAnswer look{.ok = true};
  look.sightings = {seen_at(0, {1.5, 2.25}, Vector2(3, 1.0 / 3)), seen_at(2, {7, 8})};
  const LookAnswer seen = look_answer(answer_line(5, look, &*stereo.rig), &*stereo.rig, 3);
  ASSERT_EQ(seen.sightings.size(), 2U);
  EXPECT_EQ(seen.sightings[0].in_cameras[1].pixel, Vector2(3, 1.0 / 3));
  EXPECT_EQ(seen.sightings[1].marker, 2);
  EXPECT_EQ(seen.sightings[1].in_cameras.size(), 1U);

  LookAnswer points{.ok = true};
  points.sightings = {Sighting{.marker = 1}};
  points.sightings[0].point = Vector3(0.1, 0.2, 0.3);
  const LookAnswer seen_points = look_answer(answer_line(6, points, nullptr), nullptr, 3);
  ASSERT_EQ(seen_points.sightings.size(), 1U);
  EXPECT_EQ(seen_points.sightings[0].marker, 1);
  EXPECT_EQ(*seen_points.sightings[0].point, Vector3(0.1, 0.2, 0.3));

  LookAnswer pose{.ok = true};
  pose.target_pose = Rigid{rotation_from_rpy({0.1, 0.2, 0.3}), {1, 2, 3}};
  const LookAnswer seen_pose = look_answer(answer_line(7, pose, nullptr), nullptr, 6);
  EXPECT_NEAR((seen_pose.target_pose->rotation - pose.target_pose->rotation).norm(), 0, 1e-14);
}

TEST(DriverMessages, WhatIsNotAsItMustBeIsRefusedInOneSentence) {
  const Session stereo = fixture::stand_session();
  const Rig* rig = &*stereo.rig;
  struct Case {
    const char* line;
    const char* sentence;
  };
  const Case of_move[] = {{R"({"id":1})", "\"ok\""},
                          {R"({"id":1,"ok":"yes"})", "\"ok\""},
                          {R"({"id":1,"ok":false})", "\"why\""},
                          {R"({"id":1,"ok":true})", "\"position\""},
                          {R"({"id":1,"ok":true,"position":[1]})", "1 numbers"},
                          {R"({"id":1,"ok":true,"position":[1,"2"]})", "something else than numbers"},
                          {R"({"id":1,"ok":true,"position":[1,1e99]})", "something else than numbers"},
                          {R"({"id":1,"ok":true,"position":[1,2],"torque":[1]})", "torque"},
                          {R"({"id":1,"ok":true,"position":[1,2],"time":"now"})", "time"}};
  for (const Case& c : of_move) try {
      move_answer(c.line, 2);
      ADD_FAILURE() << c.line;
    } catch (const DriverFault& fault) {
      EXPECT_THAT(fault.what(), HasSubstr(c.sentence)) << c.line;
      EXPECT_LE(std::string(fault.what()).size(), 600U);
    }
  const Case of_look[] = {{R"({"id":1,"ok":true})", "none of"},
                          {R"({"id":1,"ok":true,"images":{"middle":"a.png"}})", "expected files of the cameras"},
                          {R"({"id":1,"ok":true,"images":["a.png"]})", "images"},
                          {R"({"id":1,"ok":true,"points":[[1,2,3],[1,2,3],[1,2,3],[1,2,3]]})", "at most 3"},
                          {R"({"id":1,"ok":true,"points":[[1,2]]})", "expected 3"},
                          {R"({"id":1,"ok":true,"markers":[{"index":3,"left":[1,2]}]})", "from 0 to 2"},
                          {R"({"id":1,"ok":true,"markers":[{"index":1},{"index":0}]})", "ascending"},
                          {R"({"id":1,"ok":true,"target_pose":{"xyz":[1,2,3]}})", "quaternion"},
                          {R"({"id":1,"ok":true,"target_pose":{"xyz":[1,2,3],"quaternion":[0,0,0,0]}})", "length"}};
  for (const Case& c : of_look) try {
      look_answer(c.line, rig, 3);
      ADD_FAILURE() << c.line;
    } catch (const DriverFault& fault) {
      EXPECT_THAT(fault.what(), HasSubstr(c.sentence)) << c.line;
    }
  for (const char* line : {"", "ok", "[1]", "{\"ok\":true}", "{\"id\":\"1\"}", "{\"id\":1.5}", "\xff\xfe{"})
    EXPECT_THROW(answered_id(line), DriverFault) << line;
  EXPECT_THROW(hello_answer(R"({"id":1,"can":["move"]})"), DriverFault);
  EXPECT_THROW(hello_answer(R"({"id":1,"joints":[1],"can":[]})"), DriverFault);
}

}  // namespace
}  // namespace handsight
