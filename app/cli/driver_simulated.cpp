// SPDX-License-Identifier: Apache-2.0
// handsight-driver-simulated: a robot with known truth that speaks as drivers do, and goes wrong on demand.
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <string>

#include "base/text.h"
#include "effects/own_effect.h"
#include "experiment/driver/driver_messages.h"
#include "experiment/simulated/faults.h"
#include "experiment/simulated/simulated_robot.h"
#include "session/session_xml.h"

namespace {

using namespace handsight;

struct Arguments {
  std::string session, images_to, fault;
  std::vector<std::string> effects, changes, curves;
  double repeatability = 0, noise = -1;
  bool in_real_time = false, new_body = false;
  SimulatedRobotOptions robot;
};

class Driver {
 public:
  Driver(const Session& session, const Arguments& arguments)
      : session_(session), robot_(session, arguments.robot), in_real_time_(arguments.in_real_time) {
    if (!arguments.fault.empty()) fault_ = parse_fault(arguments.fault);
    at_ = session.observations.back().position;
  }

  int run() {
    for (std::string line; std::getline(std::cin, line);) answer(driver_request(line));
    return 0;
  }

 private:
  void answer(const DriverRequest& request) {
    if (request.what == "hello") {
      if (is_wrong("dies_at_hello", 0)) std::_Exit(3);
      return say(answer_line(request.id, robot_.hello()));
    }
    if (request.what == "move") return move(request);
    if (request.what == "look") return look(request);
    if (request.what == "stop") return say(stopped_line(request.id));
    throw InputError(
        message("The driver is asked to {}; expected hello, move, look or stop.", in_quotes(request.what)));
  }

  void move(const DriverRequest& request) {
    ++moves_;
    if (is_wrong("dies")) std::_Exit(3);
    if (is_wrong("hangs")) return;
    if (is_wrong("closes")) {
      close(STDOUT_FILENO);
      return;
    }
    if (is_wrong("endless")) return endless();
    if (is_wrong("nonsense")) return say("robot> moved, 100 %");
    std::vector<Eigen::VectorXd> path = request.path;
    if (is_wrong("lies")) path.back()[0] -= 0.1;
    if (in_real_time_ && !arrives(path, request.speed))
      return say(answer_line(request.id, MoveAnswer{.why = "stopped on the way"}));
    MoveAnswer moved = robot_.move(path, request.speed);
    at_ = path.back();
    if (is_wrong("refuses")) moved = {.why = "the arm is locked"};
    say(spoiled(
        answer_line(is_wrong("wrong_id") ? request.id - 1 : request.id, disguised(moved, request.path.back()))));
  }

  MoveAnswer disguised(MoveAnswer moved, const Eigen::VectorXd& sent) const {
    if (!moved.ok) return moved;
    if (is_wrong("lies")) moved.position = sent;
    if (is_wrong("elsewhere")) moved.position[0] += 0.035;
    if (is_wrong("too_few_joints")) moved.position.conservativeResize(moved.position.size() - 1);
    return moved;
  }

  std::string spoiled(const std::string& line) const {
    const auto place = line.find("\"position\":");
    if (place == std::string::npos) return line;
    const auto end = line.find(']', place);
    if (is_wrong("not_a_number")) return line.substr(0, place) + "\"position\":[null]" + line.substr(end + 1);
    if (is_wrong("no_position")) return line.substr(0, place) + "\"place\":[]" + line.substr(end + 1);
    return line;
  }

  void look(const DriverRequest& request) {
    if (is_wrong("dies_at_look")) std::_Exit(3);
    if (is_wrong("hangs_at_look")) return;
    if (request.touch) {
      TouchAnswer touched = robot_.touch(*request.touch);
      if (is_wrong("blind")) touched = {.why = "the probe is off"};
      return say(answer_line(request.id, touched));
    }
    LookAnswer seen = robot_.look();
    if (is_wrong("blind")) seen = {.why = "the lens is covered"};
    if (is_wrong("no_image") && session_.rig) seen.images = {{session_.rig->at(0).name, "/nowhere/to_be_found.png"}};
    say(answer_line(request.id, seen, session_.rig ? &*session_.rig : nullptr));
  }

  /// False where it was asked to stop on its way.
  bool arrives(const std::vector<Eigen::VectorXd>& path, double speed) const {
    double way = 0;
    for (std::size_t i = 0; i < path.size(); ++i) way += (path[i] - (i > 0 ? path[i - 1] : at_)).cwiseAbs().maxCoeff();
    // What comes meanwhile is a stop.
    pollfd next{STDIN_FILENO, POLLIN, 0};
    return poll(&next, 1, static_cast<int>(1e3 * way / std::max(speed, 1e-3))) == 0;
  }

  static void endless() {
    for (const std::string much(1 << 16, 'x'); std::cout << much << std::flush;) {
    }
  }

  bool is_wrong(const char* name, int from = -1) const {
    return fault_ && fault_->name == name && moves_ >= (from < 0 ? fault_->from_move : from);
  }

  static void say(const std::string& line) { std::cout << line << '\n' << std::flush; }

  const Session& session_;
  SimulatedRobot robot_;
  std::optional<Fault> fault_;
  bool in_real_time_;
  Eigen::VectorXd at_;
  int moves_ = 0;
};

std::string faults_text() {
  std::string text = "What goes wrong, from the second move on or from move N with @N: ";
  for (const FaultKind& kind : fault_kinds()) text += fmt::format("{} ({}); ", kind.name, kind.what);
  return text.substr(0, text.size() - 2);
}

int run(int argc, char** argv) {
  Arguments a;
  CLI::App program("A robot with known truth that is driven by JSON lines on its standard input (docs/experiment.md)",
                   "handsight-driver-simulated");
  program.set_version_flag("--version", "handsight " HANDSIGHT_VERSION);
  program.add_option("SESSION", a.session, "The session that it is a robot of: folder or session.xml")->required();
  program.add_option("--effect", a.effects, "What is hidden in it: id:joint.parameter=value");
  program.add_option("--change", a.changes, "What has changed since the session was measured: as --effect");
  program.add_option("--curve", a.curves, "A deviation that no effect describes: \"JOINT: SIZE*sin(ORDERq)\", or cos");
  program.add_option("--noise", a.noise, "px (m with a tracker) of one coordinate; the session's where it is left out");
  program.add_option("--scatter", a.repeatability,
                     "rad (m): how far a joint stands from what it reads, anew after each move");
  program.add_option("--seed", a.robot.truth.seed, "Every random thing follows from it");
  program.add_option("--images", a.images_to, "Render images into images/ in this folder, in place of told markers");
  program.add_option("--body-size", a.robot.truth.body_size, "m: longest side of the markers, about");
  program.add_flag("--new-body", a.new_body, "The markers are another body than that of the session's observations");
  program.add_flag("--in-real-time", a.in_real_time, "Moves take as long as their speed makes them");
  program.add_option("--fault", a.fault, faults_text());
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  const Session session = read_session(a.session);
  const OwnEffects own = list_own_effects(session, make_chain(session));
  for (const std::string& effect : a.effects) add_effect_value(effect, session.robot, a.robot.truth.effects, own);
  for (const std::string& curve : a.curves) a.robot.truth.curves.push_back(parse_curve(curve, session.robot));
  if (a.noise >= 0) a.robot.truth.noise = a.noise;
  a.robot.repeatability = a.repeatability;
  a.robot.images_to = a.images_to;
  Session like = session;
  if (!a.new_body) a.robot = make_simulated_robot(session, a.robot, like);
  for (const std::string& change : a.changes) add_effect_value(change, session.robot, a.robot.truth.effects, own);
  return Driver(like, a).run();
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << printable(shortened(error.what(), 600)) << '\n';
    return 2;
  }
}
