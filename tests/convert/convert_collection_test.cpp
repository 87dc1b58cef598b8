// SPDX-License-Identifier: Apache-2.0
// Collections from one recording of two hands, or of several sensors.
#include "convert/convert_collection.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "convert/bag_fixture.h"
#include "convert/bags/bag_sessions.h"
#include "convert/own_files.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/fit_parts.h"
#include "estimation/fit/joined_collection.h"
#include "fixtures/robot_texts.h"
#include "fixtures/two_arms.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A robot of two arms that stood in thirty postures.
class ConvertCollection : public testing::Test {
 protected:
  ConvertCollection() {
    write("robot.urdf", fixture::urdf_text(robot));
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(-0.8, 0.8);
    for (int i = 0; i < 30; ++i) {
      std::vector<double>& q = positions.emplace_back();
      for (const Joint& joint : robot.joints) q.push_back(share(random) * joint.upper);
    }
    options.out = folder.path / "both";
    options.sessions.resize(2);
    options.sessions[0].tcp = "left_hand", options.sessions[1].tcp = "right_hand";
  }

  fs::path write(const std::string& name, const std::string& text) {
    fs::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Joint& joint : robot.joints) all.push_back(joint.name);
    return all;
  }

  /// sensor_from_tcp of a session in the i-th posture.
  Rigid seen(const Session& s, std::size_t i) const {
    Eigen::VectorXd q(static_cast<Eigen::Index>(s.joints.size()));
    for (std::size_t j = 0; j < s.joints.size(); ++j)
      q[static_cast<Eigen::Index>(j)] = positions[i][static_cast<std::size_t>(find_joint(robot, s.joints[j]))];
    return sensor_from_tcp(chain_ends(make_chain(s), q), s.mount.mount_from_sensor);
  }

  /// The robot stands 1.5 s in each posture; a camera in the head tells both tags, a tracker the left hand's body.
  fs::path tags_in_a_bag() {
    fixture::BagWriter bag(folder.path / "bag");
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
              tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage");
    const Session left = fixture::head_session('l'), right = fixture::head_session('r'),
                  tracked = fixture::hand_session('l');
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double t = 100 + 3 * static_cast<double>(i);
      for (double s = 0; s < 1.5; s += 0.05)
        bag.message(joints, t + s, fixture::joint_state(t + s, names(), positions[i]));
      const auto tell = [&](const char* parent, const char* child, const Rigid& pose) {
        bag.message(tf, t + 0.7, fixture::transform(t + 0.7, parent, child, pose));
      };
      tell("head_camera", "tag_l", seen(left, i) * left_tag);
      tell("head_camera", "tag_r", seen(right, i) * right_tag);
      tell("tracker", "body_l", seen(tracked, i) * left_tag);
    }
    return folder.path / "bag";
  }

  /// A line a posture: all joints.
  std::string joints_csv() const {
    std::string text = fmt::format("{}\n", fmt::join(names(), ","));
    for (const auto& q : positions) text += fmt::format("{}\n", fmt::join(q, ","));
    return text;
  }

  /// Three markers of a hand as a tracker tells them.
  std::string points_csv(char side) const {
    const Session s = fixture::hand_session(side);
    std::string text = "m0_x,m0_y,m0_z,m1_x,m1_y,m1_z,m2_x,m2_y,m2_z\n";
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (int m = 0; m < 3; ++m) {
        const Vector3 p = seen(s, i) * Vector3(0.05 * m, 0.04 * (m == 1), 0.1);
        text += fmt::format("{},{},{}{}", p.x(), p.y(), p.z(), m < 2 ? "," : "\n");
      }
    return text;
  }

  /// Two pairs of cameras; the robot stands before each of three images. `carrier`: of one camera more, raw and
  /// compressed, in a frame that /tf hangs from this link.
  fs::path pairs_in_a_bag(const std::string& carrier = "") {
    fixture::BagWriter bag(folder.path / "pairs");
    const Camera camera = fixture::small_camera();
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
              tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage");
    std::vector<int> images;
    for (const std::string pair : {"/head", "/chest"})
      for (const std::string side : {"/left", "/right"}) {
        images.push_back(bag.topic(pair + side + "/image_raw", "sensor_msgs/msg/Image"));
        const int info = bag.topic(pair + side + "/camera_info", "sensor_msgs/msg/CameraInfo");
        const double apart = side == "/left" ? 0 : pair == "/head" ? -0.12 : -0.3;
        bag.message(info, 0, fixture::camera_info(camera, Matrix3::Identity(), 800 * apart));
      }
    if (!carrier.empty()) {
      images.push_back(bag.topic("/wrist/image_raw", "sensor_msgs/msg/Image"));
      images.push_back(bag.topic("/wrist/image_raw/again", "sensor_msgs/msg/Image"));
      const int info = bag.topic("/wrist/camera_info", "sensor_msgs/msg/CameraInfo");
      bag.message(info, 0, fixture::camera_info(camera, Matrix3::Identity(), 0, "wrist_optical"));
      bag.message(tf, 0, fixture::transform(0, carrier, "wrist_optical", Rigid{}));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double t = 100 + 3 * static_cast<double>(i);
      for (double s = 0; s < 1.5; s += 0.05)
        bag.message(joints, t + s, fixture::joint_state(t + s, names(), positions[i]));
      for (const int topic : images) bag.message(topic, t + 0.7, fixture::small_image(t + 0.7, "mono8", 8));
      const Rigid body = seen(fixture::hand_session('l'), i) * left_tag;
      bag.message(tf, t + 0.7, fixture::transform(t + 0.7, "tracker", "body_l", body));
    }
    return folder.path / "pairs";
  }

  ConvertedCollection converted(const std::vector<fs::path>& files) {
    fs::remove_all(options.out);
    std::vector<fs::path> all = files;
    all.push_back(folder.path / "robot.urdf");
    return convert_collection(all, options);
  }

  /// What is said; nothing of it stays.
  std::string refusal(const std::vector<fs::path>& files) {
    try {
      converted(files);
    } catch (const InputError& error) {
      EXPECT_FALSE(fs::exists(options.out)) << error.what();
      return error.what();
    }
    return "nothing was refused";
  }

  Session together() const {
    return join_collection(read_collection(options.out),
                           [](const std::string& one) { return read_session(fs::path(one)); });
  }

  TemporaryFolder folder;
  const Robot robot = fixture::two_armed_robot();
  std::vector<std::vector<double>> positions;
  CollectionOptions options;
  const Rigid left_tag{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}},
      right_tag{rotation_from_rpy({-0.3, 0.1, 2}), {0.01, -0.05, 0.12}};
};

TEST_F(ConvertCollection, TwoHandsInABagHaveOneCameraAndABodyEach) {
  options.sessions[0].target_frame = "tag_l", options.sessions[1].target_frame = "tag_r";
  for (ConvertOptions& o : options.sessions) o.mount = "head";
  const ConvertedCollection made = converted({tags_in_a_bag()});
  const Collection read = read_collection(options.out);
  ASSERT_EQ(read.entries.size(), 2U);
  EXPECT_EQ(read.entries[0].folder, "left_hand");
  EXPECT_EQ(read.entries[1].title, "right_hand");
  EXPECT_EQ(read.entries[0].rig, "head");
  EXPECT_EQ(read.entries[1].rig, "head");
  EXPECT_EQ(read.entries[0].body, "");
  EXPECT_THAT(made.notes, Contains(HasSubstr("left_hand, right_hand have one sensor at one place")));
  const Session s = together();
  const Fit f = fit(s);
  const std::vector<FitPart> parts = list_parts(s, f);
  EXPECT_LT(small_motion_between(left_tag, parts[0].tcp_from_body).norm(), 1e-5);
  EXPECT_LT(small_motion_between(right_tag, parts[1].tcp_from_body).norm(), 1e-5);
  EXPECT_EQ(parts[0].mount_from_sensor.translation, parts[1].mount_from_sensor.translation);
}

TEST_F(ConvertCollection, ATrackerBesideACameraIsASensorOfItsOwn) {
  options.sessions[0].target_frame = "tag_l", options.sessions[0].mount = "head";
  options.sessions[1] = options.sessions[0];
  options.sessions[1].target_frame = "body_l", options.sessions[1].mount = "base";
  const ConvertedCollection made = converted({tags_in_a_bag()});
  EXPECT_EQ(made.collection.entries[0].title, "tag_l");
  EXPECT_EQ(made.collection.entries[1].title, "body_l");
  for (const CollectionEntry& entry : made.collection.entries) {
    EXPECT_EQ(entry.rig, "");
    EXPECT_EQ(entry.body, "");
  }
  EXPECT_EQ(made.sessions[1].session.mount.link, "base");
  EXPECT_EQ(together().parts.size(), 2U);
}

TEST_F(ConvertCollection, PairsOfCamerasThatAreNotOneRigAreAskedFor) {
  const fs::path bag = pairs_in_a_bag();
  for (ConvertOptions& o : options.sessions) o.tcp = "left_hand";
  options.sessions[0].title = "a", options.sessions[1].title = "b";
  options.sessions[1].mount = "chest";
  EXPECT_THAT(refusal({bag}), AllOf(HasSubstr("2 pairs of cameras (/chest/, /head/)"), HasSubstr("--camera")));
  options.sessions[0].camera = "/nowhere/";
  EXPECT_THAT(refusal({bag}), AllOf(HasSubstr("Session \"a\""), HasSubstr("/chest/left/image_raw")));
  options.sessions[0].camera = "/head/", options.sessions[0].mount = "head";
  options.sessions[1].camera = "/chest/";
  const ConvertedCollection made = converted({bag});
  EXPECT_NEAR(made.sessions[0].session.rig->at(1).camera_from_first.translation.norm(), 0.12, 1e-9);
  EXPECT_NEAR(made.sessions[1].session.rig->at(1).camera_from_first.translation.norm(), 0.3, 1e-9);
  EXPECT_EQ(made.collection.entries[0].rig, "");
  EXPECT_EQ(made.sessions[0].sensor, "/head/left/image_raw, /head/right/image_raw");
  options.sessions[1].target_frame = "tag_l";
  EXPECT_THAT(refusal({bag}), HasSubstr("are two sensors"));
}

TEST_F(ConvertCollection, ABagWithTwoPairsBecomesACollectionOfItself) {
  const fs::path bag = pairs_in_a_bag();
  ConvertOptions one;
  one.tcp = "left_hand";
  std::vector<Message> notes;
  options.sessions = sessions_of_bag({bag, folder.path / "robot.urdf"}, {one}, notes);
  ASSERT_EQ(options.sessions.size(), 2U);
  EXPECT_THAT(notes, Contains(HasSubstr("several cameras (/chest/, /head/)")));
  const ConvertedCollection made = converted({bag});
  EXPECT_EQ(made.collection.entries[0].folder, "chest");
  EXPECT_EQ(made.collection.entries[1].folder, "head");
  EXPECT_NEAR(made.sessions[0].session.rig->at(1).camera_from_first.translation.norm(), 0.3, 1e-9);
  EXPECT_NEAR(made.sessions[1].session.rig->at(1).camera_from_first.translation.norm(), 0.12, 1e-9);
  EXPECT_EQ(made.sessions[0].session.observations.size(), 3U);
  one.camera = "/head/";
  EXPECT_EQ(sessions_of_bag({bag}, {one}, notes).size(), 1U) << "one was chosen";
}

TEST_F(ConvertCollection, EachHandOfABagGetsThePairsOfItsOwn) {
  std::vector<Message> notes;
  EXPECT_EQ(sessions_of_bag({pairs_in_a_bag()}, options.sessions, notes).size(), 4U);
}

TEST_F(ConvertCollection, ACameraOnTheHandBesideAPairIsCarriedByItsFramesLink) {
  const fs::path bag = pairs_in_a_bag("left_hand");
  ConvertOptions one;
  one.tcp = "left_hand";
  one.target = Target{};
  one.target->kind = TargetKind::chessboard;
  one.target->columns = 9, one.target->rows = 6, one.target->square = 0.025;
  std::vector<Message> notes;
  options.sessions = sessions_of_bag({bag}, {one}, notes);
  ASSERT_EQ(options.sessions.size(), 3U);
  const ConvertedCollection made = converted({bag});
  const auto wrist = std::find_if(made.sessions.begin(), made.sessions.end(),
                                  [](const Conversion& c) { return c.session.title == "wrist"; });
  ASSERT_NE(wrist, made.sessions.end());
  EXPECT_EQ(wrist->session.mount.link, "left_hand");
  EXPECT_EQ(wrist->session.tcp, robot.links.front().name) << "the target stands beside the robot";
  EXPECT_EQ(wrist->session.rig->count(), 1);
  EXPECT_THAT(wrist->notes, Contains(HasSubstr("is on the link \"left_hand\"")));
}

TEST_F(ConvertCollection, TagsThatNameTheirSideGoToTheirHands) {
  const fs::path bag = tags_in_a_bag();
  std::vector<Message> notes;
  for (ConvertOptions& o : options.sessions) o.mount = "head";
  options.sessions = sessions_of_bag({bag}, options.sessions, notes);
  ASSERT_EQ(options.sessions.size(), 2U);
  EXPECT_EQ(options.sessions[0].target_frame, "tag_l");
  EXPECT_EQ(options.sessions[1].target_frame, "tag_r");
  const ConvertedCollection made = converted({bag});
  EXPECT_EQ(made.collection.entries[0].rig, "head");
  const Session s = together();
  const std::vector<FitPart> parts = list_parts(s, fit(s));
  EXPECT_LT(small_motion_between(left_tag, parts[0].tcp_from_body).norm(), 1e-5);
  EXPECT_LT(small_motion_between(right_tag, parts[1].tcp_from_body).norm(), 1e-5);
}

TEST_F(ConvertCollection, SeveralTagsOfTheOnlyHandAreASessionEach) {
  std::vector<Message> notes;
  ConvertOptions one;
  one.tcp = "tool";
  const auto sessions = sessions_of_bag({tags_in_a_bag()}, {one}, notes);
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[1].target_frame, "tag_r");
  EXPECT_THAT(notes, Contains(HasSubstr("several targets in /tf (tag_l, tag_r)")));
}

TEST_F(ConvertCollection, OneRigSeesBothHands) {
  const fs::path bag = pairs_in_a_bag();
  for (ConvertOptions& o : options.sessions) o.camera = "/head/", o.mount = "head";
  const ConvertedCollection made = converted({bag});
  EXPECT_EQ(made.collection.entries[0].rig, "head");
  EXPECT_EQ(made.collection.entries[1].rig, "head");
  std::vector<JoinedMember> members;
  for (const CollectionEntry& entry : made.collection.entries)
    members.push_back({read_session(options.out / entry.folder), entry.title, entry.rig, entry.body});
  EXPECT_EQ(joined(members, "both").rig->count(), 2) << "not four";
}

TEST_F(ConvertCollection, ATrackerBesideAPairOfCameras) {
  const fs::path bag = pairs_in_a_bag();
  for (ConvertOptions& o : options.sessions) o.tcp = "left_hand";
  options.sessions[0].camera = "/head/", options.sessions[0].mount = "head";
  options.sessions[1].target_frame = "body_l", options.sessions[1].mount = "base";
  const ConvertedCollection made = converted({bag});
  EXPECT_EQ(made.collection.entries[0].title, "head");
  EXPECT_EQ(made.collection.entries[1].title, "body_l");
  EXPECT_TRUE(made.sessions[0].session.rig);
  EXPECT_TRUE(made.sessions[1].session.pose_sensor);
  EXPECT_EQ(made.sessions[1].session.observations.size(), 3U);
}

TEST_F(ConvertCollection, BodiesOfOneTakeHaveOneTracker) {
  std::string take =
      "Format Version,1.23,Capture Frame Rate,100,Rotation Type,Quaternion,Length Units,Meters\n\n"
      ",Type,{0},{0},{0},{0},{0},{0},{0},{0},{0},{0},{0},{0},{0},{0}\n"
      ",Name,LeftHand,LeftHand,LeftHand,LeftHand,LeftHand,LeftHand,LeftHand,"
      "RightHand,RightHand,RightHand,RightHand,RightHand,RightHand,RightHand\n"
      ",ID,1,1,1,1,1,1,1,2,2,2,2,2,2,2\n"
      ",,{1},{1},{1},{1},{2},{2},{2},{1},{1},{1},{1},{2},{2},{2}\n"
      "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z,W,X,Y,Z\n";
  take = fmt::format(fmt::runtime(take), "Rigid Body", "Rotation", "Position");
  for (std::size_t i = 0; i < positions.size(); ++i) {
    take += fmt::format("{},{}", i, 0.01 * static_cast<double>(i));
    for (const char side : {'l', 'r'}) {
      const Rigid pose = seen(fixture::hand_session(side), i) * (side == 'l' ? left_tag : right_tag);
      const Eigen::Quaterniond q(pose.rotation);
      const Vector3& t = pose.translation;
      take += fmt::format(",{},{},{},{},{},{},{}", q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z());
    }
    take += "\n";
  }
  options.sessions[0].target_frame = "LeftHand", options.sessions[1].target_frame = "RightHand";
  const ConvertedCollection made = converted({write("joints.csv", joints_csv()), write("take.csv", take)});
  EXPECT_EQ(made.collection.entries[0].rig, "base");
  EXPECT_EQ(made.collection.entries[1].rig, "base");
  EXPECT_EQ(made.collection.entries[0].body, "");
  const Session s = together();
  const Fit f = fit(s);
  const std::vector<FitPart> parts = list_parts(s, f);
  EXPECT_LT(small_motion_between(left_tag, parts[0].tcp_from_body).norm(), 1e-5);
  EXPECT_LT(small_motion_between(right_tag, parts[1].tcp_from_body).norm(), 1e-5);
}

TEST_F(ConvertCollection, TablesThatNameAHandAreOfItsSession) {
  const auto joints = write("joints.csv", joints_csv()), left = write("left_hand.csv", points_csv('l')),
             right = write("right_hand.csv", points_csv('r'));
  const ConvertedCollection apart = converted({joints, left, right});
  EXPECT_EQ(apart.collection.entries[0].rig, "");
  EXPECT_THAT(apart.notes, Contains(HasSubstr("left_hand is made of 3 of the 4 files")));
  options.one_sensor = true;
  const ConvertedCollection made = converted({joints, left, right});
  EXPECT_EQ(made.collection.entries[0].rig, "base");
  EXPECT_EQ(made.collection.entries[1].rig, "base");
  const Session s = together();
  const Fit f = fit(s);
  EXPECT_LT(f.residual_rms, 1e-6);
  const std::vector<FitPart> parts = list_parts(s, f);
  EXPECT_LT(small_motion_between(fixture::hand_session('l').mount.mount_from_sensor, parts[1].mount_from_sensor).norm(),
            1e-5);
}

TEST_F(ConvertCollection, OneSensorMustBeOne) {
  const auto joints = write("joints.csv", joints_csv()), left = write("left_hand.csv", points_csv('l')),
             right = write("right_hand.csv", points_csv('r'));
  options.one_sensor = true;
  options.sessions[1].mount = "chest";
  EXPECT_THAT(refusal({joints, left, right}), AllOf(HasSubstr("--one-sensor"), HasSubstr("\"chest\"")));
}

TEST_F(ConvertCollection, SessionsThatCannotBeAreRefusedAndNothingStays) {
  const auto joints = write("joints.csv", joints_csv()), left = write("left_hand.csv", points_csv('l'));
  EXPECT_THAT(refusal({joints, left}), AllOf(HasSubstr("Session \"right_hand\""), HasSubstr("nothing that a sensor")));
  options.sessions[1].tcp = "left_hand";
  EXPECT_THAT(refusal({joints, left}), HasSubstr("would be the same"));
  options.sessions[1].tcp = "third_hand";
  const auto third = write("third_hand.csv", points_csv('r'));
  EXPECT_THAT(refusal({joints, left, third}), HasSubstr("the robot has no such link"));
}

TEST_F(ConvertCollection, WhatIsThereStaysAsItIs) {
  const auto joints = write("joints.csv", joints_csv()), left = write("left_hand.csv", points_csv('l')),
             right = write("right_hand.csv", points_csv('r')), mine = write("both/left_hand/notes.txt", "mine");
  const std::vector<fs::path> files{joints, left, right, folder.path / "robot.urdf"};
  EXPECT_THROW(convert_collection(files, options), InputError);
  EXPECT_TRUE(fs::exists(mine));
  fs::remove_all(mine.parent_path());
  const auto other = write("both/other.txt", "mine");
  convert_collection(files, options);
  EXPECT_TRUE(fs::exists(other));
  EXPECT_THROW(convert_collection(files, options), InputError) << "there is one already";
  EXPECT_EQ(read_collection(options.out).entries.size(), 2U);
}

TEST_F(ConvertCollection, HandsOfWhichOnlyFlangesAreKnownAreNoRobot) {
  {
    fixture::BagWriter bag(folder.path / "poses");
    const int tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage");
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double t = 100 + static_cast<double>(i);
      for (const auto& [side, hand, tag] : {std::tuple('l', "left_tool", "tag_l"), {'r', "right_tool", "tag_r"}}) {
        const Rigid pose = seen(fixture::hand_session(side), i);
        bag.message(tf, t, fixture::transform(t, "base", hand, pose));
        bag.message(tf, t, fixture::transform(t, "camera", tag, inverse(pose)));
      }
    }
  }
  options.sessions[0].tcp = "left_tool", options.sessions[0].target_frame = "tag_l";
  options.sessions[1].tcp = "right_tool", options.sessions[1].target_frame = "tag_r";
  for (ConvertOptions& o : options.sessions) o.pairing.still_for = 0;
  const std::vector<fs::path> files{folder.path / "poses"};
  try {
    convert_collection(files, options);
    ADD_FAILURE() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no robot is known"), HasSubstr("--robot")));
  }
  EXPECT_FALSE(fs::exists(options.out));
}

TEST(OwnFiles, TheLongestWordInTheNameTellsWhoseItIs) {
  const std::vector<fs::path> files{"/a/left_hand/joints.csv", "/a/hand.csv", "/a/LEFT-hand.csv", "/a/left_hands.csv",
                                    "/a/left_hand.urdf"};
  const auto own = files_of_sessions(files, {{"left_hand", ""}, {"hand", "/head/"}});
  EXPECT_THAT(own[0], ElementsAre(files[0], files[2], files[3], files[4]));
  EXPECT_THAT(own[1], ElementsAre(files[1], files[3], files[4]));
  const auto in_one_folder =
      files_of_sessions({"/left_hand/a.csv", "/left_hand/b.csv"}, {{"left_hand"}, {"right_hand"}});
  EXPECT_EQ(in_one_folder[0].size(), 2U);
  EXPECT_EQ(in_one_folder[1].size(), 2U) << "the folder of all says nothing";
}

}  // namespace
}  // namespace handsight
