// SPDX-License-Identifier: Apache-2.0
#include "experiment/simulated/simulated_robot.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "estimation/fit/fit.h"
#include "session/fixtures/fixture_kind.h"
#include "session/touch_xml.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

constexpr double looking_time = 1;  // s
constexpr std::uint64_t repeatability_stream = 7001;

}  // namespace

SimulatedRobotOptions make_simulated_robot(const Session& session, SimulatedRobotOptions options, Session& like) {
  like = session;
  try {
    const Fit f = fit(session, {.effects = options.truth.effects});
    const std::vector<char>& seen = f.problem.marker_is_seen;
    if (std::find(seen.begin(), seen.end(), 0) != seen.end()) return options;
    options.truth.markers_in_tcp = estimate(f).markers_in_tcp;
    like.mount.mount_from_sensor = estimate(f).mount_from_sensor;
    for (std::size_t m = 0; m < like.other_mounts.size(); ++m)
      like.other_mounts[m].mount_from_sensor = estimate(f).mount(static_cast<int>(m) + 1);
  } catch (const InputError&) {  // nothing was seen yet
  }
  return options;
}

SimulatedRobot::SimulatedRobot(const Session& like, SimulatedRobotOptions options)
    : like_(like),
      options_(std::move(options)),
      random_(Random(options_.truth.seed).child(repeatability_stream)),
      position_(like.observations.back().position),
      true_position_(position_) {
  like_.observations.resize(1);
}

DriverHello SimulatedRobot::hello() {
  return {"a simulated " + like_.robot.name, like_.joints, {"move", "look"}, position_};
}

MoveAnswer SimulatedRobot::move(const std::vector<Eigen::VectorXd>& path, double speed) {
  for (const Eigen::VectorXd& point : path) {
    for (Eigen::Index j = 0; j < point.size(); ++j) {
      const std::string& name = like_.joints[static_cast<std::size_t>(j)];
      const Joint& joint = like_.robot.joints[static_cast<std::size_t>(find_joint(like_.robot, name))];
      if (point[j] < joint.lower || point[j] > joint.upper)
        return {.why = message("{} cannot go to {:.4g}: its limits are {:.4g} and {:.4g}", name, point[j], joint.lower,
                               joint.upper)};
    }
    time_ += (point - position_).cwiseAbs().maxCoeff() / std::max(speed, 1e-3);
    position_ = point;
  }
  true_position_ = position_;
  for (double& q : true_position_) q += options_.repeatability * random_.gaussian();
  MoveAnswer answer{.ok = true, .position = position_};
  answer.time = time_;
  return answer;
}

TouchAnswer SimulatedRobot::touch(const TouchRequest& request) {
  time_ += looking_time;
  const auto fixture = std::find_if(like_.fixtures.begin(), like_.fixtures.end(),
                                    [&](const Fixture& f) { return f.id == request.fixture; });
  if (fixture == like_.fixtures.end()) return {.why = message("there is no fixture {}", in_quotes(request.fixture))};
  if (request.position.size() != position_.size()) return {.why = "it is not said in which posture"};
  Observation o;
  o.id = static_cast<std::int64_t>(looks_.size());
  o.time = time_;
  o.part = static_cast<int>(fixture - like_.fixtures.begin());
  const Eigen::VectorXd off = true_position_ - position_;
  o.position = request.position + off;
  looks_.push_back(o);
  const auto touched = simulate_touch(like_, options_.truth, looks_);
  if (!touched) {
    looks_.pop_back();
    return {.why = message("the tip does not come to {}", request.fixture)};
  }
  looks_.back() = *touched;
  TouchAnswer answer{.ok = true};
  answer.fixture = request.fixture;
  if (is_instrument(*fixture->kind)) answer.value = touch_value(touched->sightings.front());
  answer.position = touched->position - off;
  answer.time = time_;
  return answer;
}

LookAnswer SimulatedRobot::look() {
  time_ += looking_time;
  Observation o;
  o.id = static_cast<std::int64_t>(looks_.size());
  o.time = time_;
  o.position = true_position_;
  looks_.push_back(o);
  simulated_ = simulate_at(like_, options_.truth, looks_);
  LookAnswer answer{.ok = true};
  if (like_.pose_sensor) {
    answer.target_pose = simulated_.session.observations.back().target_pose;
    return answer;
  }
  if (like_.rig && !options_.images_to.empty()) {
    const SimulatedSession first = simulate_at(like_, options_.truth, {looks_.front()});
    write_images(first, options_.truth, {.distractors = 0}, looks_.size() - 1, options_.images_to, simulated_);
    for (int c = 0; c < like_.rig->count(); ++c)
      answer.images[like_.rig->at(c).name] =
          (options_.images_to / simulated_.session.observations.back().images[static_cast<std::size_t>(c)]).string();
    return answer;
  }
  answer.sightings = simulated_.session.observations.back().sightings;
  return answer;
}

}  // namespace handsight
