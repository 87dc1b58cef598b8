// SPDX-License-Identifier: Apache-2.0
// The example drivers in Python, as a user would fill them in, in whole experiments: behind each is a simulated robot.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "cli/cli_runner.h"
#include "experiment/paths/collision_world.h"
#include "experiment/written_session.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

/// Speaks with handsight-driver-simulated, whose command is in the environment.
const char* const robot_module = R"(
import json, os, subprocess
process = subprocess.Popen(os.environ["ROBOT"], shell=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
count = 0


def ask(what, **more):
    global count
    count += 1
    process.stdin.write(json.dumps({"do": what, "id": count, **more}) + "\n")
    process.stdin.flush()
    answer = json.loads(process.stdout.readline())
    answer.pop("id")
    return answer


hello = ask("hello")
position = hello["position"]


def drive(path, speed):
    global position
    print("Words that a library prints are no answer.")
    position = ask("move", path=path, speed=speed)["position"]


def see():
    answer = ask("look")
    answer.pop("ok")
    return answer
)";

/// The robot's program on the other side of files.py.
const char* const files_program = R"(
import json, os, sys, time
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot
folder = sys.argv[1]


def write(name, content):
    with open(os.path.join(folder, "." + name), "w") as file:
        json.dump(content, file)
    os.replace(os.path.join(folder, "." + name), os.path.join(folder, name))


write("where.json", robot.position)
number = 1
while not os.path.exists(os.path.join(folder, "over")):
    order = os.path.join(folder, f"order_{number}.json")
    if not os.path.exists(order):
        time.sleep(0.01)
        continue
    with open(order) as file:
        asked = json.load(file)
    if asked["do"] == "move":
        robot.drive(asked["path"], asked["speed"])
        write(f"answer_{number}.json", {"ok": True, "position": robot.position})
    else:
        write(f"answer_{number}.json", {"ok": True, **robot.see()})
    number += 1
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

struct PythonDrivers : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
    if (std::system("python3 -c 'import json' >/dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed";
    session = fixture::written_session(fixture::tracker_session(), folder.path);
    replace_file(folder.path / "robot.py", robot_module);
    ::setenv(
        "ROBOT",
        (HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated " + test::quoted_argument(session.string())).c_str(),
        1);
  }
  void TearDown() override { ::unsetenv("ROBOT"); }

  test::CliResult experiment(const std::string& driver) const {
    return test::run_cli(folder.path, {"experiment", session.string(), "--driver", driver, "--yes", "--speed", "10",
                                       "--until", "count=4"});
  }
  static std::string example(const char* name) {
    return read_file(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "docs/examples/drivers" / name);
  }
  std::string joints(const char* before, const char* between, const char* after) const {
    std::string text;
    for (const std::string& joint : read_session(session).joints)
      text += (text.empty() ? "" : between) + std::string(before) + joint + after;
    return text;
  }

  TemporaryFolder folder;
  std::filesystem::path session;
};

TEST_F(PythonDrivers, TheTemplateFilledInDrivesAnExperiment) {
  std::string text = example("template.py");
  const auto from = text.find("JOINTS = ["), to = text.find(']', from);
  ASSERT_NE(from, std::string::npos);
  text.replace(from, to - from + 1, "import robot\nJOINTS = [" + joints("\"", ", ", "\"") + "]");
  for (const char* body : {"return robot.position", "robot.drive(path, speed)", "return robot.see()", "pass"})
    text = replaced(text, "raise NotImplementedError", body);
  replace_file(folder.path / "my_driver.py", text);
  const auto result = experiment("python3 " + test::quoted_argument((folder.path / "my_driver.py").string()));
  EXPECT_EQ(result.exit_code, 0) << result.errors << result.output;
  EXPECT_EQ(read_session(session).observations.size(), 7U);
}

TEST_F(PythonDrivers, TheTemplateAsItIsSaysWhatIsMissing) {
  replace_file(folder.path / "my_driver.py", example("template.py"));
  const auto result = experiment("python3 " + test::quoted_argument((folder.path / "my_driver.py").string()));
  EXPECT_EQ(result.exit_code, 2) << result.errors;
  EXPECT_EQ(read_session(session).observations.size(), 3U);
}

/// A move is under way, for `shows` has the word "move", when the program that speaks to the driver is gone.
void lose_during_a_move(const std::string& driver, const std::filesystem::path& shows) {
  const std::string speech =
      "(printf '{\"do\":\"move\",\"path\":[[0.1]],\"speed\":0.2,\"id\":1}\\n'; for i in $(seq 500); do "
      "grep -qs move " +
      test::quoted_argument(shows.string()) + " && break; sleep 0.02; done) | timeout 20 python3 ";
  EXPECT_EQ(std::system((speech + driver + " >/dev/null 2>&1").c_str()), 0);
}

TEST_F(PythonDrivers, TheTemplateHaltsTheRobotWhenNobodySpeaksAnyMore) {
  std::string text = example("template.py");
  const auto halted = folder.path / "halted", moving = folder.path / "moving";
  for (const char* body : {"return [0.0]", "open(sys.argv[2], 'w').write('move'), threading.Event().wait(1)",
                           "return {}", "open(sys.argv[1], 'w').write('at once')"})
    text = replaced(text, "raise NotImplementedError", body);
  replace_file(folder.path / "my_driver.py", text);
  lose_during_a_move(test::quoted_argument((folder.path / "my_driver.py").string()) + " " +
                         test::quoted_argument(halted.string()) + " " + test::quoted_argument(moving.string()),
                     moving);
  EXPECT_TRUE(std::filesystem::exists(halted));
}

TEST_F(PythonDrivers, FilesSayStopWhenNobodyOrdersAnyMoreAndNothingOldIsAnAnswer) {
  const auto exchange = folder.path / "exchange";
  std::filesystem::create_directory(exchange);
  for (const char* old : {"stop", "order_1.json", "answer_1.json", "answer_2.json"})
    replace_file(exchange / old, R"({"ok": true, "position": [0.1]})");
  const auto program = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "docs/examples/drivers/files.py";
  lose_during_a_move(test::quoted_argument(program.string()) + " " + test::quoted_argument(exchange.string()) + " a1",
                     exchange / "order_1.json");
  EXPECT_THAT(test::read_text(exchange / "order_1.json"), testing::HasSubstr("move"));
  EXPECT_EQ(test::read_text(exchange / "stop"), "true");
  for (const char* old : {"answer_1.json", "answer_2.json"}) EXPECT_FALSE(std::filesystem::exists(exchange / old));
}

TEST_F(PythonDrivers, AProgramThatReadsAndWritesFilesIsDriven) {
  const auto exchange = folder.path / "exchange";
  std::filesystem::create_directory(exchange);
  replace_file(folder.path / "program.py", files_program);
  replace_file(folder.path / "files.py", example("files.py"));
  const std::string program = test::quoted_argument((folder.path / "program.py").string());
  const std::string place = test::quoted_argument(exchange.string());
  ASSERT_EQ(std::system(("python3 " + program + " " + place + " &").c_str()), 0);
  const auto where = exchange / "where.json";
  for (int i = 0; i < 500 && !std::filesystem::exists(where); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(std::filesystem::exists(where)) << "the robot's program does not begin";
  const auto result = experiment("python3 " + test::quoted_argument((folder.path / "files.py").string()) + " " + place +
                                 " " + joints("", " ", ""));
  replace_file(exchange / "over", "");
  EXPECT_EQ(result.exit_code, 0) << result.errors << result.output;
  EXPECT_EQ(read_session(session).observations.size(), 7U);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // the program ends before its folder goes
}

}  // namespace
}  // namespace handsight
