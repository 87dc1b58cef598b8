// SPDX-License-Identifier: Apache-2.0
// A robot that moves while the window watches what a sensor without images writes: poses of a target, a tracker's
// points.
#include <gtest/gtest.h>

#include <fstream>

#include "app/window/wizard_page.h"
#include "session/new_session.h"

namespace handsight::test {
namespace {

namespace fs = std::filesystem;

class LivePoses : public testing::Test {
 protected:
  LivePoses() {
    const auto like = fs::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/rigs/one_camera_board";
    EXPECT_EQ(run_cli(folder.path, {"simulate", "--like", like.string(), "--out", (folder.path / "simulated").string(),
                                    "--observations", "20", "--seed", "5"})
                  .exit_code,
              0);
    simulated = read_session(folder.path / "simulated");
    tcp_from_target = true_tcp_from_body(folder.path / "simulated");
  }
  Rigid flange(std::size_t i) { return root_from_link(simulated, simulated.observations[i], "hand"); }
  /// As a sensor tells it that errs by a tenth of a millimetre.
  Rigid target(std::size_t i) {
    Rigid pose = inverse(simulated.mount.mount_from_sensor) * flange(i) * tcp_from_target;
    pose.translation += 1e-4 * Vector3(std::sin(2.0 * i), std::cos(3.0 * i), std::sin(5.0 * i));
    return pose;
  }
  /// A session of the first poses; of the flange alone, or with the robot.
  void make(std::size_t count, bool is_flange) {
    NewSession parts{.folder = home};
    std::vector<Rigid> flanges;
    for (std::size_t i = 0; i < count; ++i) {
      parts.positions.push_back(simulated.observations[i].position);
      parts.target_poses.push_back(target(i));
      flanges.push_back(flange(i));
    }
    parts.urdf = fs::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/robots/six_axis.urdf";
    parts.joints = simulated.joints;
    if (is_flange) set_flange_poses(parts, flanges);
    parts.tcp = is_flange ? "flange" : "hand";
    parts.mount = is_flange ? "base" : "stand";
    make_session(parts);
  }
  void write(const char* file, const std::string& text) { std::ofstream(home / file, std::ios::app) << text; }
  static std::string pose_line(std::size_t number, const Rigid& pose) {
    const std::string table = pose_table({pose});
    return std::to_string(number) + "," + table.substr(table.find('\n') + 1);
  }
  std::string joint_line(std::size_t i) {
    std::string line = std::to_string(i);
    for (const double q : simulated.observations[i].position) line += "," + format_number(q);
    return line + "\n";
  }
  std::size_t count() { return desk.document().session().observations.size(); }
  QString said() { return desk.find<QLabel>("live_text")->text(); }
  void begin_to_watch() {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(home.string())));
    ASSERT_TRUE(desk.settle());
    calibrate.set_fastest();
    desk.press_button("watch");
    ASSERT_TRUE(desk.wait([this] { return calibrate.decisions() == first_count; })) << calibrate.decisions();
  }

  static constexpr int first_count = 8;
  TemporaryFolder folder;
  fs::path home = folder.path / "session";
  Session simulated;
  Rigid tcp_from_target;
  Desk desk;
  CalibratePage calibrate{desk};
};

TEST_F(LivePoses, PosesOfATargetAreTakenAndFittedAsTheyCome) {
  make(first_count, false);
  begin_to_watch();
  EXPECT_TRUE(said().startsWith("Waiting for the next pose of the target in poses.csv and its joint angles in"))
      << said().toStdString();
  EXPECT_FALSE(desk.find<QWidget>("live_sources")->isVisible()) << "it is the session's own folder";
  std::string header = "number";
  for (const std::string& joint : simulated.joints) header += "," + joint;
  write("joints.csv", header + "\n");
  write("poses.csv", "number,x,y,z,qx,qy,qz,qw\n");
  for (std::size_t i = first_count; i < 12; ++i) {
    write("poses.csv", pose_line(i, target(i)));
    write("joints.csv", joint_line(i));
    ASSERT_TRUE(desk.wait([&] { return count() == i + 1; })) << said().toStdString();
  }
  EXPECT_TRUE(said().contains("4 arrived")) << said().toStdString();
  ASSERT_TRUE(desk.wait([this] { return calibrate.decisions() == 12; })) << calibrate.decisions();
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().model(), nullptr);
  ASSERT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();
  EXPECT_EQ(desk.document().model()->report->used, 12);
  const Rigid& found = desk.document().model()->fit->tcp_from_body;
  EXPECT_LT((found.translation - tcp_from_target.translation).norm(), 1e-3);
  // What cannot be read is named and holds up nothing.
  write("poses.csv", "12,0.1,0.2,nan,0,0,0,1\n" + pose_line(13, target(13)));
  write("joints.csv", joint_line(12) + joint_line(13));
  ASSERT_TRUE(desk.wait([this] { return count() == 13; })) << said().toStdString();
  EXPECT_TRUE(said().contains("number 12")) << said().toStdString();
  // Saved, and watched anew: nothing comes twice.
  desk.key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(read_session(home).observations.size(), 13U);
  desk.press_button("watch");
  desk.press_button("watch");
  write("poses.csv", pose_line(14, target(14)));
  write("joints.csv", joint_line(14));
  ASSERT_TRUE(desk.wait([this] { return count() == 14; })) << count() << " " << said().toStdString();
  QTest::qWait(1000);
  EXPECT_EQ(count(), 14U);
}

TEST_F(LivePoses, WhereOnlyTheFlangeIsKnownItsPosesCome) {
  make(first_count, true);
  begin_to_watch();
  EXPECT_TRUE(said().contains("that of the flange in joints.csv")) << said().toStdString();
  write("joints.csv", "number,x,y,z,qx,qy,qz,qw\n" + pose_line(8, flange(8)));
  write("poses.csv", "number,x,y,z,qx,qy,qz,qw\n" + pose_line(8, target(8)));
  ASSERT_TRUE(desk.wait([this] { return count() == 9; })) << said().toStdString();
  const Rigid arrived = base_from_flange(desk.document().session().observations[8].position);
  EXPECT_LT((arrived.translation - flange(8).translation).norm(), 1e-12);
}

}  // namespace
}  // namespace handsight::test
