// SPDX-License-Identifier: Apache-2.0
#include "experiment/driver/child_driver.h"

#include <cmath>

#include "experiment/driver/driver_messages.h"

namespace handsight {
namespace {

double measure_length(const std::vector<Eigen::VectorXd>& path, const std::optional<Eigen::VectorXd>& from) {
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::VectorXd* const before = i > 0 ? &path[i - 1] : from ? &*from : nullptr;
    // From nowhere: half a turn.
    length += before ? (path[i] - *before).cwiseAbs().maxCoeff() : 3.2;
  }
  return length;
}

}  // namespace

ChildDriver::ChildDriver(const std::string& command, const Session& session, DriverPatience patience,
                         std::function<bool()> is_interrupted)
    : process_(command),
      rig_(session.rig),
      markers_(session.marker_count),
      patience_(patience),
      is_interrupted_(std::move(is_interrupted)) {}

ChildDriver::~ChildDriver() {
  if (is_moving_) stop();
}

void ChildDriver::fail(LineEnd end, const char* what, double seconds) {
  const Message ending = end == LineEnd::ended ? process_.ending() : Message();
  is_lost_ = end == LineEnd::ended;
  stop();
  switch (end) {
    case LineEnd::interrupted:
      throw DriverFault("The experiment was interrupted; the driver was told to stop.");
    case LineEnd::timed_out:
      throw DriverFault(message(
          "The driver has not answered \"{}\" for {:.3g} s, which is the limit; it was told to stop and the experiment "
          "ends.",
          verbatim(what), seconds));
    case LineEnd::too_long:
      throw DriverFault(
          message("The driver's answer to \"{}\" is longer than 16 MiB without an end of line.", verbatim(what)));
    default:
      throw DriverFault(message("The driver {} while it was asked to \"{}\"; the experiment stops.",
                                ending.empty() ? Message("closed its output") : ending, verbatim(what)));
  }
}

std::string ChildDriver::asked(const std::string& line, const char* what, double seconds) {
  if (is_lost_) throw DriverFault("The driver is lost already: nothing more is asked of it.");
  const std::int64_t id = next_id_++;
  if (const LineEnd end = process_.write_line(line, seconds, is_interrupted_); end != LineEnd::whole)
    fail(end, what, seconds);
  std::string answer;
  if (const LineEnd end = process_.read_line(answer, seconds, is_interrupted_); end != LineEnd::whole)
    fail(end, what, seconds);
  const auto stopped = [&](const DriverFault& fault) {
    stop();
    throw DriverFault(fault);
  };
  try {
    if (const std::int64_t answered = answered_id(answer); answered != id)
      throw DriverFault(message(
          "The driver answered message {} where {} (\"{}\") was asked: what it says belongs to something else, and the "
          "experiment stops.",
          answered, id, verbatim(what)));
  } catch (const DriverFault& fault) {
    stopped(fault);
  }
  return answer;
}

DriverHello ChildDriver::hello() {
  DriverHello hello = hello_answer(asked(hello_line(next_id_), "hello", patience_.hello));
  joints_ = hello.joints.size();
  last_ = hello.position;
  return hello;
}

MoveAnswer ChildDriver::move(const std::vector<Eigen::VectorXd>& path, double speed) {
  is_moving_ = true;
  const double seconds = patience_.move + 3 * measure_length(path, last_) / speed;
  const std::string line = asked(move_line(next_id_, path, speed), "move", seconds);
  is_moving_ = false;
  MoveAnswer answer = move_answer(line, joints_);
  if (answer.ok) last_ = answer.position;
  return answer;
}

LookAnswer ChildDriver::look() {
  return look_answer(asked(look_line(next_id_), "look", patience_.look), rig_ ? &*rig_ : nullptr, markers_);
}

TouchAnswer ChildDriver::touch(const TouchRequest& request) {
  return touch_answer(asked(touch_line(next_id_, request), "look", patience_.look), joints_, markers_);
}

void ChildDriver::stop() noexcept {
  is_moving_ = false;
  if (is_lost_) return;
  is_lost_ = true;
  try {
    const std::int64_t id = next_id_++;
    if (process_.write_line(stop_line(id), patience_.stop) != LineEnd::whole) return;
    std::string answer;
    // Answers to what was asked before may come first.
    for (int i = 0; i < 3; ++i)
      if (process_.read_line(answer, patience_.stop) != LineEnd::whole || answered_id(answer) == id) return;
  } catch (const std::exception&) {  // it is lost; its input is closed next, and then it is ended
  }
}

}  // namespace handsight
