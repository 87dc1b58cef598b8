// SPDX-License-Identifier: Apache-2.0
// Files as they came from the field: cameras, targets and bags.
#include "base/files.h"
#include "convert/brought.h"
#include "convert/convert_fixture.h"
#include "readers/kalibr_target.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

const fs::path field = fs::path(HANDSIGHT_SHARED_DIR) / "field";

TEST(FieldFiles, EveryCameraFileIsTheSameCamera) {
  if (!fs::exists(field)) GTEST_SKIP() << "no field sets on this machine";
  for (const char* name : {"ost.ini", "topic_echo.yaml", "topic_echo_ros1.yaml", "realsense.json", "camodocal.yaml"}) {
    std::vector<Message> notes;
    const Rig rig = rig_of_files({field / "cameras/camera_files" / name}, notes);
    ASSERT_EQ(rig.count(), 1) << name;
    const Camera& c = rig.at(0).camera;
    EXPECT_EQ(c.width, 1920) << name;
    EXPECT_EQ(c.height, 1080) << name;
    EXPECT_NEAR(c.fx, 734.46, 0.01) << name;
    EXPECT_NEAR(c.fy, 734.46, 0.01) << name;
    EXPECT_NEAR(c.cx, 987.46, 0.01) << name;
    EXPECT_NEAR(c.cy, 556.67, 0.01) << name;
  }
}

TEST(FieldFiles, KalibrsTargetIsRead) {
  const fs::path file = field / "cameras/kalibr_target/april_6x6.yaml";
  if (!fs::exists(file)) GTEST_SKIP() << "no field sets on this machine";
  const Brought b = bring({file}, nullptr, false);
  ASSERT_TRUE(b.target);
  EXPECT_EQ(b.target->kind, TargetKind::aprilgrid);
  EXPECT_EQ(b.target->columns, 6);
  EXPECT_EQ(b.target->rows, 6);
  EXPECT_EQ(b.target->tag, 0.088);
  EXPECT_EQ(b.target->spacing, 0.3);
}

TEST(FieldFiles, BagsWithNothingInThemAreNamed) {
  const fs::path bags = field / "cameras/bags";
  if (!fs::exists(bags)) GTEST_SKIP() << "no field sets on this machine";
  const auto refusal = [&](const char* name) {
    try {
      convert({bags / name}, {.out = TemporaryFolder().path / "made"});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  EXPECT_THAT(refusal("bag_mcap"), HasSubstr("bag_mcap_0.mcap: begins as MCAP does and holds no channel"));
  EXPECT_THAT(refusal("bag_zstd"), HasSubstr("bag_zstd_0.db3.zstd: is compressed with zstd, and damaged"));
}

/// The arm's log in per cent, with the calibration that LeRobot keeps beside it: every joint within its noise.
TEST_F(Convert, ReadingsInPerCentWithLerobotsCalibration) {
  std::string table = "a1.pos,a2.pos,a3.pos,a4.pos,a5.pos,a6.pos\n", servos = "{";
  for (std::size_t i = 0; i < truth.session.observations.size(); ++i)
    for (Eigen::Index j = 0; j < 6; ++j)
      table += fmt::format("{}{}", truth.session.observations[i].position[j] / (1024.0 * M_PI / 2048) * 100 / 1.5,
                           j < 5 ? "," : "\n");
  for (int j = 1; j <= 6; ++j)
    servos += fmt::format(
        "{}\"a{}\": {{\"id\": {}, \"drive_mode\": 0, \"homing_offset\": 0, \"range_min\": 512, "
        "\"range_max\": 3584}}",
        j > 1 ? ", " : "", j, j);
  std::string points = points_csv();
  const Conversion c =
      converted({write("arm.json", servos + "}"), write("joints.csv", table), write("points.csv", points)});
  EXPECT_THAT(c.notes, Contains(HasSubstr("per cent of the servos' ranges")));
  EXPECT_THAT(c.took, Contains(HasSubstr("servos of LeRobot")));
  for (std::size_t i = 0; i < c.session.observations.size(); ++i)
    EXPECT_LT((c.session.observations[i].position - truth.session.observations[i].position).norm(), 1e-9);
}

TEST_F(Convert, RigidBodiesOfMotiveBesideJointReadings) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  const auto poses = target_poses(truth, tcp_from_target);
  std::string text =
      "Format Version,1.23,Rotation Type,Quaternion,Length Units,Millimeters\n\n"
      ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body,"
      "Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body\n,Name,cart,cart,cart,cart,cart,cart,cart,gripper,gripper,gripper,gripper,"
      "gripper,gripper,gripper\n,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Rotation,Rotation,"
      "Rotation,"
      "Rotation,Position,Position,Position\nFrame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z,W,X,Y,Z\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Quaterniond q(poses[i].rotation);
    const Vector3 mm = 1e3 * poses[i].translation;
    text += fmt::format("{},{},0,0,0,1,{},0,0,{},{},{},{},{},{},{}\n", i, 10.0 * static_cast<double>(i), i, q.x(),
                        q.y(), q.z(), q.w(), mm.x(), mm.y(), mm.z());
  }
  const auto take = write("take.csv", text), joints = write("joints.csv", joints_csv());
  EXPECT_THAT(refusal({take, joints}), HasSubstr("--target-frame"));
  options_.target_frame = "gripper";
  options_.pairing.still_for = 0;
  const Conversion c = converted({take, joints});
  ASSERT_EQ(c.session.observations.size(), poses.size());
  const Fit f = fit(c.session);
  EXPECT_LT(small_motion_between(tcp_from_target, f.tcp_from_body).norm(), 1e-5);
}

/// The commands that the sentence holds make what convert reads.
TEST_F(Convert, AFolderForEachSampleIsSortedByTheCommandsThatAreNamed) {
  for (int i = 0; i < 11; ++i) {
    const std::string sample = "samples/sample_" + std::to_string(i) + "/";
    write(sample + "left.png", "\x89PNG\r\n\x1A\n");
    write(sample + "right.png", "\x89PNG\r\n\x1A\n");
    write(sample + "joints.csv", "a1,a2\n0." + std::to_string(i) + ",0\n");
  }
  std::string said;
  try {
    convert({folder.path / "samples"}, options_);
  } catch (const InputError& error) {
    said = error.what();
  }
  const std::size_t begin = said.find('`') + 1;
  const std::string commands = said.substr(begin, said.rfind('`') - begin);
  ASSERT_THAT(said, HasSubstr("a folder for each sample (sample_0)"));
  ASSERT_EQ(std::system(("cd '" + folder.path.string() + "' && " + commands).c_str()), 0) << commands;
  EXPECT_TRUE(std::filesystem::exists(folder.path / "left/sample_10.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path / "right/sample_0.png"));
  const std::string table = read_file(folder.path / "joints.csv");
  EXPECT_TRUE(table.starts_with("a1,a2\n0.0,0\n0.1,0\n")) << table;
  EXPECT_TRUE(table.ends_with("0.9,0\n0.10,0\n")) << table;
}

TEST_F(Convert, WhatIsNotReadIsNamedWithTheWayToReadIt) {
  using namespace std::string_literals;
  const std::vector<std::tuple<std::string, std::string, std::string>> files = {
      {"kinect.mkv", "\x1A\x45\xDF\xA3 ...", "ffmpeg -i kinect.mkv"},
      {"zed.svo2", "SVO ...", "svo_export"},
      {"phone.mp4",
       "\0\0\0\x18"
       "ftypisom"s,
       "ffmpeg -i phone.mp4"},
      {"web.avi", "RIFF\0\0\0\0AVI LIST"s, "ffmpeg -i web.avi"},
      {"episode.h5", "\x89HDF\r\n\x1A\n...", "h5dump"},
      {"poses.npy", "\x93NUMPY\x01\0"s, "savetxt"},
      {"poses.mat", "MATLAB 5.0 MAT-file", "writematrix"},
      {"data.parquet", "PAR1...", "read_parquet"},
      {"arm.step", "ISO-10303-21;\nHEADER;", "URDF"},
      {"scene.usda", "#usda 1.0\n", "Export to URDF"},
      {"table.xlsx", "PK\x03\x04...", "libreoffice --headless --convert-to csv table.xlsx"},
      {"all.zip", "PK\x03\x04...", "unzip all.zip"},
      {"all.tar.gz", "\x1F\x8B\x08...", "tar xzf all.tar.gz"},
      {"take.tak", "whatever", "CSV"},
      {"one.png", "\x89PNG\r\n\x1A\n", "name the folder"},
      {"robot.sdf", "<sdf version=\"1.7\"/>", "SDF of Gazebo"},
      {"old.bag", "#ROSBAG V1.2\n", "rosbag fix"},
      {"tf.jsonl",
       "{\"topic\":\"/tf\",\"sequence\":1,\"log_time\":1.5,\"publish_time\":1.5,\"data\":{\"transforms\":[]}}\n",
       "name the bag itself"},
      {"arm.xacro", "<robot name=\"a\" xmlns:xacro=\"x\"><link name=\"${n}\"/></robot>", "xacro"}};
  for (const auto& [name, content, way] : files) {
    std::filesystem::remove(folder.path / "robot.urdf");
    options_.robot = "";
    const auto file = write(name, content);
    try {
      convert({file}, options_);
      ADD_FAILURE() << name << " was read";
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_THAT(sentence, HasSubstr(way)) << name;
      EXPECT_THAT(sentence, HasSubstr(name));
      EXPECT_LE(sentence.size(), 600u);
    }
  }
}

}  // namespace
}  // namespace handsight
