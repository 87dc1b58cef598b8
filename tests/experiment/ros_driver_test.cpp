// SPDX-License-Identifier: Apache-2.0
// The ROS driver of the examples in a whole experiment, against a real ROS master and a robot of ours on its topics.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include "base/files.h"
#include "cli/cli_runner.h"
#include "experiment/paths/collision_world.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

const std::string python = "/usr/bin/python3";  // Debian's, which has Debian's ROS

/// A program of its own that is ended with the test.
class Program {
 public:
  explicit Program(const std::string& command) : process_(fork()) {
    if (process_ != 0) return;
    setpgid(0, 0);
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    kill(-process_, SIGTERM);
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }

 private:
  pid_t process_;
};

/// A master and a robot on its topics, for the session of a board before one camera.
struct RosDriver : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    if (!has_modules("rospy, cv2, sensor_msgs.msg, trajectory_msgs.msg") ||
        std::system("command -v rosmaster >/dev/null") != 0)
      GTEST_SKIP() << "needs python3-rosmaster, python3-rospy, python3-trajectory-msgs and python3-opencv";
    std::filesystem::copy(source / "sample_sessions/one_camera", session, std::filesystem::copy_options::recursive);
    for (const char* name : {"rendered", "written"}) std::filesystem::create_directory(folder.path / name);
    before = read_session(session);
    camera = before.rig->at(0).name;
    const std::string port = std::to_string(20000 + getpid() % 20000);
    ::setenv("ROS_MASTER_URI", ("http://localhost:" + port).c_str(), 1);
    ::setenv("ROS_LOG_DIR", folder.path.c_str(), 1);
    ::setenv("PYTHONPATH", (source / "tests/experiment/ros").c_str(), 1);  // control_msgs
    master.emplace("exec rosmaster --core -p " + port + " >/dev/null 2>&1");
  }
  void TearDown() override { ::unsetenv("PYTHONPATH"); }

  static bool has_modules(const std::string& modules) {
    return std::system((python + " -c 'import " + modules + "' >/dev/null 2>&1").c_str()) == 0;
  }

  void start_robot(const std::string& seconds_a_move) {
    const std::string simulated = HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated " +
                                  test::quoted_argument(session.string()) + " --images " +
                                  test::quoted_argument((folder.path / "rendered").string());
    robot.emplace("sleep 2; exec " + python + " " +
                  test::quoted_argument((source / "tests/experiment/ros/robot.py").string()) + " " + camera + " " +
                  test::quoted_argument(simulated) + " " + test::quoted_argument((folder.path / "moves").string()) +
                  " " + seconds_a_move + " >/dev/null 2>&1");
  }

  /// `by`: how the driver tells the robot its ways.
  std::string driver(const std::string& by) const {
    std::string joints;
    for (const std::string& joint : before.joints) joints += " " + joint;
    return python + " " + test::quoted_argument((source / "docs/examples/drivers/ros.py").string()) + by + " --joints" +
           joints + " --image " + camera + "=/" + camera + "/image --limit 60 --out " +
           test::quoted_argument((folder.path / "written").string());
  }

  void expect_experiment(const std::string& by) {
    start_robot("0");
    const auto result = test::run_cli(folder.path, {"experiment", session.string(), "--driver", driver(by), "--yes",
                                                    "--speed", "2", "--wait", "90", "--until", "count=2"});
    EXPECT_EQ(result.exit_code, 0) << result.errors << result.output;
    EXPECT_EQ(read_session(session).observations.size(), before.observations.size() + 2);
  }

  /// Lines of the robot's log, once there are as many or after five seconds.
  std::string moves(std::ptrdiff_t count) const {
    std::string lines;
    for (int i = 0; i < 100 && std::count(lines.begin(), lines.end(), '\n') < count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      lines = test::read_text(folder.path / "moves");
    }
    return lines;
  }

  const TemporaryFolder folder;
  const std::filesystem::path source = HANDSIGHT_SOURCE_DIR, session = folder.path / "session";
  Session before;
  std::string camera;
  std::optional<Program> master, robot;
};

TEST_F(RosDriver, DrivesAnExperimentAgainstARealMaster) {
  expect_experiment(" --command /command");
  // And a halt where it stands, once nobody speaks to the driver any more.
  EXPECT_EQ(moves(3), "1 points\n1 points\n1 points\n");
}

struct RosActions : RosDriver {
  void SetUp() override {
    RosDriver::SetUp();
    if (!IsSkipped() && !has_modules("actionlib")) GTEST_SKIP() << "needs python3-actionlib";
  }
};

TEST_F(RosActions, DriveAnExperiment) {
  expect_experiment(" --action /follow_joint_trajectory");
  EXPECT_EQ(moves(2), "1 points\n1 points\n");
}

TEST_F(RosActions, AreCancelledWhereNobodySpeaksToTheDriverAnyMore) {
  start_robot("30");
  std::string there = "[";
  for (const double q : before.observations.back().position) there += (there.size() > 1 ? "," : "") + std::to_string(q);
  const std::string answers = test::quoted_argument((folder.path / "answers").string());
  const std::string speech = "printf '{\"do\":\"hello\",\"id\":1}\\n'; until grep -q joints " + answers +
                             " 2>/dev/null; do sleep 0.1; done; printf '{\"do\":\"move\",\"path\":[" + there +
                             "]],\"speed\":0.2,\"id\":2}\\n'; sleep 3";
  std::system(("(" + speech + ") | timeout 60 " + driver(" --action /follow_joint_trajectory") + " >" + answers +
               " 2>/dev/null")
                  .c_str());
  EXPECT_EQ(moves(1), "cancelled\n") << test::read_text(folder.path / "answers");
}

}  // namespace
}  // namespace handsight
