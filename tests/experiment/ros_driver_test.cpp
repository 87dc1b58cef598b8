// SPDX-License-Identifier: Apache-2.0
// The ROS driver of the examples in a whole experiment, against a real ROS master and a robot of ours on its topics.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
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

TEST(RosDriver, DrivesAnExperimentAgainstARealMaster) {
  if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  const std::string needed = python +
                             " -c 'import rospy, cv2, sensor_msgs.msg, trajectory_msgs.msg' >/dev/null 2>&1 && "
                             "command -v rosmaster >/dev/null";
  if (std::system(needed.c_str()) != 0)
    GTEST_SKIP() << "needs python3-rosmaster, python3-rospy, python3-trajectory-msgs and python3-opencv";
  const TemporaryFolder folder;
  const std::filesystem::path source = HANDSIGHT_SOURCE_DIR, session = folder.path / "session";
  std::filesystem::copy(source / "sample_sessions/one_camera", session, std::filesystem::copy_options::recursive);
  for (const char* name : {"rendered", "written"}) std::filesystem::create_directory(folder.path / name);
  const Session before = read_session(session);
  const std::string camera = before.rig->at(0).name, port = std::to_string(20000 + getpid() % 20000);
  ::setenv("ROS_MASTER_URI", ("http://localhost:" + port).c_str(), 1);
  ::setenv("ROS_LOG_DIR", folder.path.c_str(), 1);
  const Program master("exec rosmaster --core -p " + port + " >/dev/null 2>&1");
  const std::string simulated = HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated " +
                                test::quoted_argument(session.string()) + " --images " +
                                test::quoted_argument((folder.path / "rendered").string());
  const Program robot("sleep 2; exec " + python + " " +
                      test::quoted_argument((source / "tests/experiment/ros_robot.py").string()) + " " + camera + " " +
                      test::quoted_argument(simulated) + " " +
                      test::quoted_argument((folder.path / "commands").string()) + " >/dev/null 2>&1");
  std::string joints;
  for (const std::string& joint : before.joints) joints += " " + joint;
  const auto result = test::run_cli(
      folder.path, {"experiment", session.string(), "--driver",
                    python + " " + test::quoted_argument((source / "docs/examples/drivers/ros.py").string()) +
                        " --command /command --joints" + joints + " --image " + camera + "=/" + camera +
                        "/image --limit 60 --out " + test::quoted_argument((folder.path / "written").string()),
                    "--yes", "--speed", "2", "--wait", "90", "--until", "count=2"});
  EXPECT_EQ(result.exit_code, 0) << result.errors << result.output;
  EXPECT_EQ(read_session(session).observations.size(), before.observations.size() + 2);
  // Two moves, and a halt where it stands once nobody speaks to the driver any more.
  const auto commands = [&] {
    const std::string lines = test::read_text(folder.path / "commands");
    return std::count(lines.begin(), lines.end(), '\n');
  };
  for (int i = 0; i < 100 && commands() < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(commands(), 3);
}

}  // namespace
}  // namespace handsight
