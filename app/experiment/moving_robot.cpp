// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/moving_robot.h"

#include <algorithm>
#include <cmath>

#include "words/core_words.h"
#include "workbench/observation_views.h"

namespace handsight::app {
namespace {

constexpr int between_pictures = 40;  // ms
constexpr int points_a_piece = 12;    // of a path's piece, which is no straight line in space

}  // namespace

MovingRobot::MovingRobot(Workbench& workbench, widgets::RobotView& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
  connect(&timer_, &QTimer::timeout, this, &MovingRobot::go_on);
}

void MovingRobot::set_session() {
  timer_.stop();
  planned_.clear();
  path_.clear();
  at_.resize(0);
  if (!workbench_.document.is_open()) return;
  const Session& s = workbench_.document.session();
  view_.set_robot(s.robot, (folder(s) / s.robot_file).parent_path());
  view_.set_ghost_magnification(1);
  outline_.reset();
  if (s.observations.empty() || s.robot.is_of_poses) return;
  at_ = s.observations.back().position;
  draw();
  draw_paths();
}

void MovingRobot::stand(const Eigen::VectorXd& position) {
  timer_.stop();
  path_.clear();
  at_ = position;
  draw();
  draw_paths();
}

void MovingRobot::plan(const std::vector<PlannedMove>& moves) {
  planned_ = moves;
  draw_paths();
  point_at(0);
}

void MovingRobot::forget_plan() {
  planned_.clear();
  set_outline(std::nullopt);
  draw_paths();
}

void MovingRobot::point_at(int place) {
  const bool is_there = place >= 0 && place < static_cast<int>(planned_.size());
  set_outline(is_there ? std::optional(planned_[static_cast<std::size_t>(place)].pose.position) : std::nullopt);
}

std::optional<ChosenPose> MovingRobot::move(const std::vector<Eigen::VectorXd>& path, double speed) {
  if (path.empty() || at_.size() != path.back().size()) return std::nullopt;
  path_ = path;
  path_.insert(path_.begin(), at_);
  speed_ = std::max(speed, 1e-6);
  std::optional<ChosenPose> planned;
  std::erase_if(planned_, [&](const PlannedMove& m) {
    const bool is_it = (m.pose.position - path.back()).isZero(1e-12);
    if (is_it) planned = m.pose;
    return is_it;
  });
  set_outline(path.back());
  draw_paths();
  clock_.start();
  timer_.start(between_pictures);
  return planned;
}

void MovingRobot::halt() { timer_.stop(); }

/// Where it would be by now if it kept to its speed; that it has arrived, the driver says.
void MovingRobot::go_on() {
  double left = 1e-3 * static_cast<double>(clock_.elapsed()) * speed_;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const Eigen::VectorXd step = path_[i] - path_[i - 1];
    const double length = step.cwiseAbs().maxCoeff();
    if (left < length) {
      at_ = path_[i - 1] + left / length * step;
      return draw();
    }
    left -= length;
  }
  at_ = path_.back();
  timer_.stop();
  draw();
}

/// As an observation that nothing was seen in, with the cameras where they are then.
void MovingRobot::draw() {
  Observation here;
  here.id = widgets::no_observation;
  here.position = at_;
  show_pose(workbench_.document, here, nullptr, view_);
  view_.set_ghost(outline_);
}

void MovingRobot::set_outline(const std::optional<Eigen::VectorXd>& position) {
  outline_.reset();
  if (position) outline_ = link_motions(workbench_.document.session(), *position);
  view_.set_ghost(outline_);
}

Vector3 MovingRobot::tcp_at(const Eigen::VectorXd& position) const {
  const Session& s = workbench_.document.session();
  return link_motions(s, position)[static_cast<std::size_t>(find_link(s.robot, s.tcp))].translation;
}

std::vector<Vector3> MovingRobot::tcp_along(const Eigen::VectorXd& from,
                                            const std::vector<Eigen::VectorXd>& way) const {
  std::vector<Vector3> points{tcp_at(from)};
  Eigen::VectorXd last = from;
  for (const Eigen::VectorXd& next : way) {
    for (int i = 1; i <= points_a_piece; ++i)
      points.push_back(tcp_at(last + static_cast<double>(i) / points_a_piece * (next - last)));
    last = next;
  }
  return points;
}

void MovingRobot::draw_paths() {
  std::vector<widgets::ScenePath> paths;
  Eigen::VectorXd from = at_;
  if (!path_.empty()) {
    paths.push_back({tcp_along(path_.front(), {path_.begin() + 1, path_.end()}), true});
    from = path_.back();
  }
  for (const PlannedMove& move : planned_) {
    paths.push_back({tcp_along(from, move.way), path_.empty() && &move == &planned_.front()});
    from = move.pose.position;
  }
  view_.set_paths(std::move(paths));
}

}  // namespace handsight::app
