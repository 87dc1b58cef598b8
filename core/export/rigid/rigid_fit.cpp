// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/rigid_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "export/rigid/export_poses.h"
#include "export/rigid/held_sites.h"
#include "robot/posture_memory.h"
#include "robot/posture_tangent.h"

namespace handsight {
namespace {

constexpr double length_of_radian = 0.1;  // m: the lever of a tool
constexpr double usual_left = 1e-4;       // m, of a coordinate of the hand: what the numbers' own freedom is weighed by
constexpr double usual_change = 2e-3;     // m or rad, of a number

/// A number of the change that is fitted: 0 to 5 of the joint's frame, 6 its angle.
struct FreeNumber {
  int joint = 0;
  int number = 0;
};
constexpr int angle_number = 6;

void add_to(RobotChange& change, const FreeNumber& n, double value) {
  JointChange& c = change.joints[static_cast<std::size_t>(n.joint)];
  if (n.number == angle_number)
    c.angle += value;
  else
    c.frame[n.number] += value;
}

double value_of(const RobotChange& change, const FreeNumber& n) {
  const JointChange& c = change.joints[static_cast<std::size_t>(n.joint)];
  return n.number == angle_number ? c.angle : c.frame[n.number];
}

JointChange find_unit(const FreeNumber& n) {
  RobotChange change;
  change.joints.resize(1);
  add_to(change, {0, n.number}, 1);
  return change.joints[0];
}

/// A link that joints move, and where the whole model has it in each pose.
struct End {
  int link = 0;
  Rigid link_from_hand;
  std::vector<Rigid> wanted;
};

struct Task {
  Robot robot;  // without springs
  Vector3 gravity;
  std::vector<Eigen::VectorXd> sensors;
  std::vector<End> ends;  // that of the hand first
  std::size_t measured = 0;
};

bool is_moved(const Robot& robot, int link) {
  const std::vector<int> joints = joints_to(robot, link);
  return std::any_of(joints.begin(), joints.end(),
                     [&](int j) { return robot.joints[static_cast<std::size_t>(j)].moves(); });
}

std::vector<End> ends_of(const CalibratedRobot& robot, const Rigid& hand) {
  const Chain& c = robot.chain;
  std::vector<End> ends;
  if (is_moved(c.robot, c.tcp_link)) ends.push_back({c.tcp_link, hand, {}});
  if (is_moved(c.robot, c.mount_link) && c.mount_link != c.tcp_link) ends.push_back({c.mount_link, {}, {}});
  if (robot.of_hand && ends.size() > 1) std::swap(ends[0], ends[1]);
  return ends;
}

Task task_of(const CalibratedRobot& robot, const ExportPoses& poses, const Rigid& hand) {
  Task task{robot.chain.robot, robot.chain.gravity, {}, ends_of(robot, hand), poses.measured.size()};
  for (Joint& joint : task.robot.joints) joint.stiffness = 0;
  for (const std::vector<ObservationState>* some : {&poses.measured, &poses.between})
    for (const ObservationState& c : *some) {
      const ChainEnds wanted = observed_ends(c, moved_sites(c, robot.model.effects)).ends;
      task.sensors.push_back(c.sensor);
      for (End& end : task.ends)
        end.wanted.push_back(end.link == robot.chain.tcp_link ? wanted.root_from_tcp : wanted.root_from_mount);
    }
  return task;
}

Posture posture_of(const Task& task, const RobotChange& change, std::size_t pose) {
  return solve_equilibrium(task.robot, task.sensors[pose], change, task.gravity, true);
}

Rigid hand_of(const End& end, const Posture& posture) {
  return posture.root_from_link[static_cast<std::size_t>(end.link)] * end.link_from_hand;
}

/// `is_nominal`: the hand is where the link itself is.
Missed missed(const Task& task, const RobotChange& change, bool is_nominal = false) {
  Missed m;
  if (task.ends.empty()) return m;
  End end = task.ends.front();
  if (is_nominal) end.link_from_hand = Rigid{};
  double squares = 0;
  for (std::size_t p = 0; p < task.measured; ++p) {
    const double length = (hand_of(end, posture_of(task, change, p)).translation - end.wanted[p].translation).norm();
    squares += length * length;
    m.largest = std::max(m.largest, length);
  }
  m.rms = task.measured ? std::sqrt(squares / static_cast<double>(task.measured)) : 0;
  return m;
}

/// Normal equations of one step; the cost is that of the change as it is.
struct Step {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double cost = 0;
};

void add_pose(const Task& task, const RobotChange& change, std::size_t pose, const std::vector<FreeNumber>& numbers,
              Step& step) {
  const Posture posture = posture_of(task, change, pose);
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_number(6, static_cast<Eigen::Index>(numbers.size()));
  for (const End& end : task.ends) {
    const Rigid hand = hand_of(end, posture);
    const PostureTangent tangent(task.robot, change, task.gravity, posture, end.link, 0);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const Vector6 motion = tangent.motion_by_joint(static_cast<std::size_t>(numbers[n].joint), find_unit(numbers[n]));
      const Vector3 turn = motion.tail<3>();
      by_number.col(static_cast<Eigen::Index>(n)) << motion.head<3>() + turn.cross(hand.translation),
          length_of_radian * turn;
    }
    Vector6 way;
    way << end.wanted[pose].translation - hand.translation,
        length_of_radian * vector_from_rotation(end.wanted[pose].rotation * hand.rotation.transpose());
    step.information += by_number.transpose() * by_number;
    step.gradient += by_number.transpose() * way;
    step.cost += way.squaredNorm();
  }
}

Step step_at(const Task& task, const RobotChange& change, const RobotChange& start,
             const std::vector<FreeNumber>& numbers) {
  constexpr double own_weight = (usual_left / usual_change) * (usual_left / usual_change);
  const auto count = static_cast<Eigen::Index>(numbers.size());
  Step step{Eigen::MatrixXd::Identity(count, count) * own_weight, Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FreeNumber& n = numbers[static_cast<std::size_t>(i)];
    const double away = value_of(change, n) - value_of(start, n);
    step.gradient[i] = -own_weight * away;
    step.cost += own_weight * away * away;
  }
  for (std::size_t p = 0; p < task.sensors.size(); ++p) add_pose(task, change, p, numbers, step);
  return step;
}

/// Steps of Gauss and Newton, as long as they come nearer.
RobotChange nearest(const Task& task, const RobotChange& start, const std::vector<FreeNumber>& numbers) {
  constexpr int most_steps = 10;
  constexpr double settled = 1e-12;  // m, rad
  if (numbers.empty() || task.ends.empty()) return start;
  RobotChange best = start, change = start;
  double lowest = 1e300;
  for (int i = 0; i < most_steps; ++i) {
    const Step step = step_at(task, change, start, numbers);
    if (!(step.cost < lowest)) break;
    lowest = step.cost;
    best = change;
    const Eigen::VectorXd by = step.information.ldlt().solve(step.gradient);
    if (!by.allFinite() || by.cwiseAbs().maxCoeff() < settled) break;
    for (std::size_t n = 0; n < numbers.size(); ++n) add_to(change, numbers[n], by[static_cast<Eigen::Index>(n)]);
  }
  return best;
}

std::vector<FreeNumber> free_numbers(const Task& task, Holds holds) {
  std::vector<FreeNumber> numbers;
  const Robot& r = task.robot;
  for (int j = 0; j < static_cast<int>(r.joints.size()); ++j) {
    const Joint& joint = r.joints[static_cast<std::size_t>(j)];
    const bool bears_an_end =
        std::any_of(task.ends.begin(), task.ends.end(), [&](const End& e) { return is_distal(r, j, e.link); });
    const bool is_free = holds == Holds::origins          ? bears_an_end
                         : holds == Holds::moving_origins ? bears_an_end && joint.moves()
                                                          : joint.moves() && !joint.is_mimic();
    if (!is_free) continue;
    if (holds == Holds::offsets) numbers.push_back({j, angle_number});
    for (int n = 0; n < angle_number && holds != Holds::offsets; ++n) numbers.push_back({j, n});
  }
  return numbers;
}

bool is_same(const RobotChange& a, const RobotChange& b) {
  return std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(),
                    [](const JointChange& x, const JointChange& y) {
                      return x.angle == y.angle && x.multiplier_error == y.multiplier_error && x.frame == y.frame &&
                             x.after == y.after;
                    });
}

/// Of the model's own change what such a file has a place for.
RobotChange kept(RobotChange change, const Robot& robot, Holds holds) {
  if (holds == Holds::origins) return change;
  for (std::size_t j = 0; j < change.joints.size(); ++j) {
    JointChange& c = change.joints[j];
    c.after.setZero();
    c.multiplier_error = 0;
    if (holds == Holds::offsets || !robot.joints[j].moves()) c.frame.setZero();
    if (robot.joints[j].is_mimic() && holds == Holds::offsets) c.angle = 0;
  }
  return change;
}

}  // namespace

RigidFit rigid_fit(const CalibratedRobot& robot, Holds holds) {
  HeldSites held = held_sites(robot);
  RigidFit fit{kept(held.sites.robot, robot.chain.robot, holds), held.sites, held.left_out, held.remarks};
  const ExportPoses poses = export_poses(robot);
  fit.poses = static_cast<int>(poses.measured.size());
  fit.are_measured = poses.are_measured;
  if (holds != Holds::origins) fit.sites.hand.setZero();
  const Task task = task_of(robot, poses, small_motion<double>(fit.sites.hand));
  const bool lacks_some =
      !held.left_out.empty() || !is_same(fit.change, held.sites.robot) || fit.sites.hand != held.sites.hand;
  if (lacks_some) fit.change = nearest(task, fit.change, free_numbers(task, holds));
  fit.sites.robot = fit.change;
  RobotChange none;
  none.joints.resize(robot.chain.robot.joints.size());
  fit.left = missed(task, fit.change);
  fit.nominal = missed(task, none, true);
  return fit;
}

Missed missed_with(const CalibratedRobot& robot, const RobotChange& change) {
  return missed(task_of(robot, export_poses(robot), Rigid{}), change);
}

Message missed_text(const RigidFit& fit) {
  return message("{:.3f} mm rms and {:.3f} mm at most over {}", 1e3 * fit.left.rms, 1e3 * fit.left.largest,
                 fit.are_measured ? message("the {} poses of the session", fit.poses)
                                  : message("{} poses drawn within the joints' limits", fit.poses));
}

}  // namespace handsight
