// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/wizard_scene.h"

#include <QObject>
#include <algorithm>

#include "robot/posture.h"
#include "widgets/scene/robot_view.h"

namespace handsight::app {
namespace {

const Vector3 usual_gravity(0, 0, -9.81);
constexpr double stand_distance = 1.0;  // m, of a camera on a stand whose place is not known

/// A camera at this place that looks at that one, upright.
Rigid looking_at(const Vector3& from, const Vector3& at) {
  const Vector3 forward = (at - from).normalized();
  Vector3 right = forward.cross(Vector3::UnitZ());
  if (right.norm() < 1e-6) right = Vector3::UnitX();
  right.normalize();
  Rigid pose;
  pose.rotation.col(0) = right;
  pose.rotation.col(1) = forward.cross(right);
  pose.rotation.col(2) = forward;
  pose.translation = from;
  return pose;
}

/// Where the board is: at the hand, or on the table below it.
Rigid root_from_board(const WizardScene& scene, const Rigid& root_from_target, const Vector3& hand) {
  if (!scene.is_on_table) return root_from_target;
  const double reach = std::hypot(hand.x(), hand.y());
  Rigid flat;
  flat.translation = reach > 0.2 ? Vector3(hand.x(), hand.y(), 0) : Vector3(0.5, 0, 0);
  return flat;
}

/// A grid of points round its middle.
std::vector<Vector3> board_points(const Rigid& root_from_board, double step) {
  std::vector<Vector3> points;
  for (int row = -1; row <= 1; ++row)
    for (int column = -2; column <= 2; ++column)
      points.push_back(root_from_board * Vector3(step * column, step * row, 0));
  return points;
}

}  // namespace

int joints_between(const Robot& robot, int link, int other) {
  const auto moving = [&](int to) {
    std::vector<int> joints;
    for (const int j : joints_to(robot, to))
      if (robot.joints[static_cast<std::size_t>(j)].moves()) joints.push_back(j);
    std::sort(joints.begin(), joints.end());
    return joints;
  };
  const std::vector<int> a = moving(link), b = moving(other);
  std::vector<int> apart;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(apart));
  return static_cast<int>(apart.size());
}

void show_scene(const WizardScene& scene, widgets::RobotView& view) {
  const Robot& robot = *scene.robot;
  std::vector<int> joints;
  for (const std::string& name : scene.joints) joints.push_back(find_joint(robot, name));
  const bool has_position = scene.position.size() == static_cast<Eigen::Index>(joints.size()) && !joints.empty();
  const Eigen::VectorXd position = has_position ? scene.position : Eigen::VectorXd(0);
  if (!has_position) joints.clear();
  const std::vector<Rigid> links =
      solve_posture(robot, joint_values(robot, joints, position), usual_gravity).root_from_link;
  const auto camera_link = static_cast<std::size_t>(find_link(robot, scene.camera_link));
  const auto target_link = static_cast<std::size_t>(find_link(robot, scene.target_link));
  view.set_posture(links);
  const Rigid& root_from_target = links[target_link];
  const Rigid board = root_from_board(scene, root_from_target, links[camera_link].translation);
  const Vector3 middle = board.translation;
  std::vector<widgets::SceneMarker> markers;
  for (const Vector3& point : board_points(board, 0.05))
    markers.push_back({.in_root = point, .role = widgets::SceneMarkerRole::predicted});
  Vector3 from = links[camera_link].translation;
  if (camera_link == 0) {  // on a stand, somewhere before the robot
    const Vector3 beside(middle.y(), -middle.x(), 0);
    const Vector3 aside = beside.norm() > 0.1 ? beside.normalized() : Vector3(0, -1, 0);
    from = middle + stand_distance * (aside + 0.4 * Vector3::UnitZ()).normalized();
  } else if ((middle - from).norm() < 0.02) {
    from += Vector3(0, 0, 0.1);
  }
  const Rigid root_from_camera =
      scene.mount_from_camera ? links[camera_link] * *scene.mount_from_camera : looking_at(from, middle);
  view.set_cameras({{QObject::tr("camera"), root_from_camera, scene.camera}});
  view.set_tcp(root_from_target);
  view.set_markers(std::move(markers));
}

}  // namespace handsight::app
