// SPDX-License-Identifier: Apache-2.0
// One posture of the robot: where every link is and what gravity asks of every joint, at static equilibrium.
// Templated on the scalar so that tests may differentiate it automatically.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "robot/robot.h"

namespace handsight {

/// What may be changed at one joint, in SI units; all zero: the nominal joint. Sites of the physical effects.
template <class T>
struct JointChangeT {
  T angle{0.0};                             // rad (m): added to the sensor value; mimic joints follow it
  T multiplier_error{0.0};                  // mimic joint: added to each of its multipliers
  T share{0.0};                             // mimic joint: 0 moved by the motors before it, 1 held by a linkage
  Vector6T<T> frame = Vector6T<T>::Zero();  // small motion of the joint's frame, before its rotation
  Vector6T<T> after = Vector6T<T>::Zero();  // ... after its rotation and bending: of all that hangs on it
  T compliance{0.0};                        // rad/(N m) about the axis (m/N), beyond the declared stiffness
  T lateral_compliance{0.0};                // rad/(N m) across the axis
  T gap{0.0};                               // rad: backlash, gap * tanh(torque / 0.3 N m)
};

/// What may be changed in the whole robot; all zero: the nominal robot.
template <class T>
struct RobotChangeT {
  std::vector<JointChangeT<T>> joints;                // per joint of the robot; empty: no change
  T tilt_x{0.0}, tilt_y{0.0};                         // rad: gravity turned by (tilt_x, tilt_y, 0) in the root frame
  Vector3T<T> base_compliance = Vector3T<T>::Zero();  // rad/(N m): xx, xy, yy of the root's spring
  int payload_link = -1;                              // the link that carries the payload
  T payload_mass{0.0};                                // kg, at that link's declared centre of mass
  Vector3T<T> payload_moment = Vector3T<T>::Zero();   // kg m about it, in that link's frame
};
using JointChange = JointChangeT<double>;
using RobotChange = RobotChangeT<double>;

/// What loads add to the joints; the unknowns of the static equilibrium.
template <class T>
struct DeflectionT {
  std::vector<T> angle;                    // rad (m), per joint: of its spring and gap
  std::vector<Vector3T<T>> lateral;        // per joint: rotation vector in the joint's rotated frame
  Vector3T<T> base = Vector3T<T>::Zero();  // rotation vector of the whole robot about the root's origin
};
using Deflection = DeflectionT<double>;

/// A posture at static equilibrium. Frames in the root frame; moments are those of the gravity of everything distal
/// about the joint's origin, written in the root frame.
template <class T>
struct PostureT {
  std::vector<RigidT<T>> root_from_link;
  std::vector<RigidT<T>> root_from_joint;     // the joint's frame before its motion, its own change included
  std::vector<Matrix3T<T>> root_from_turned;  // ... after its motion, before it bends
  std::vector<T> value;                       // rad (m): the angle that the joint really has
  std::vector<T> torque;                      // N m (N): axis . moment (force), of what is distal
  std::vector<Vector3T<T>> moment;            // N m, in the root frame
  std::vector<T> distal_mass;                 // kg
  std::vector<Vector3T<T>> distal_center;     // m, in the root frame
  DeflectionT<T> deflection;
  int iterations = 0;  // passes of the equilibrium
  bool converged = true;
};
using Posture = PostureT<double>;

namespace posture_detail {

inline constexpr double backlash_torque = 0.3;  // N m, where the flanks of the gap are reached

template <class T>
double magnitude(const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    return std::abs(x);
  } else {  // a Jet: its derivatives have to settle too
    return std::max(std::abs(x.a), x.v.cwiseAbs().maxCoeff());
  }
}

/// Surely without effect, and without derivatives either.
template <class Vector>
bool is_nothing(const Vector& v) {
  if constexpr (std::is_same_v<typename Vector::Scalar, double>) {
    return v.isZero(0);
  } else {
    return false;
  }
}

/// What does not change from pass to pass of an equilibrium, and memory that all passes share.
template <class T>
struct Passes {
  std::vector<RigidT<T>> parent_from_joint;  // the joints' changes included
  std::vector<RigidT<T>> bent_from_child;    // ... from after the joint's motion and bending to its link
  std::vector<T> corrected, carried, mass;
  std::vector<char> is_corrected;
  std::vector<Vector3T<T>> first_moment;
  std::vector<T> turned_by;       // rad: the angles of these turns
  std::vector<Matrix3T<T>> turn;  // about the joints' axes
  DeflectionT<T> next;

  Passes(const Robot& robot, const RobotChangeT<T>& change)
      : parent_from_joint(robot.joints.size()),
        bent_from_child(robot.joints.size()),
        corrected(robot.joints.size()),
        mass(robot.links.size()),
        is_corrected(robot.joints.size()),
        first_moment(robot.links.size()),
        turned_by(robot.joints.size()),
        turn(robot.joints.size(), Matrix3T<T>::Identity()) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      parent_from_joint[j] = cast<T>(robot.joints[j].parent_from_joint);
      bent_from_child[j] = cast<T>(robot.joints[j].joint_from_child);
      if (change.joints.empty()) continue;
      const JointChangeT<T>& c = change.joints[j];
      if (!is_nothing(c.frame)) parent_from_joint[j] = parent_from_joint[j] * small_motion<T>(c.frame);
      if (!is_nothing(c.after)) bent_from_child[j] = small_motion<T>(c.after) * bent_from_child[j];
    }
  }
};

/// The values that the joints have: sensor values and changes, mimic sums of the corrected values of those they
/// follow, and the deflections.
template <class T>
void set_values(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChangeT<T>& change,
                const DeflectionT<T>& deflection, Passes<T>& passes, PostureT<T>& posture) {
  std::fill(passes.is_corrected.begin(), passes.is_corrected.end(), 0);
  auto corrected_value = [&](auto&& self, std::size_t j) -> const T& {
    if (passes.is_corrected[j]) return passes.corrected[j];
    passes.is_corrected[j] = 1;  // the reader has refused mimic loops
    const bool changes = !change.joints.empty();
    T value = changes ? change.joints[j].angle : T(0.0);
    for (const Mimic& m : robot.joints[j].mimics) {
      T followed = self(self, static_cast<std::size_t>(m.joint));
      T multiplier(m.multiplier);
      if (changes) {
        followed += change.joints[j].share * deflection.angle[m.joint];
        multiplier += change.joints[j].multiplier_error;
      }
      value += multiplier * followed + T(m.offset);
    }
    if (!robot.joints[j].is_mimic()) value += T(sensor[static_cast<Eigen::Index>(j)]);
    return passes.corrected[j] = value;
  };
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (robot.joints[j].moves()) posture.value[j] = corrected_value(corrected_value, j) + deflection.angle[j];
}

/// A joint's turn by an angle. Where no load bends a joint the angle is the same from pass to pass.
template <class T>
const Matrix3T<T>& turned(const Robot& robot, std::size_t joint, const T& angle, Passes<T>& passes) {
  if (!std::is_same_v<T, double> || passes.turned_by[joint] != angle) {
    passes.turn[joint] = rotation_about<T>(robot.joints[joint].axis, angle);
    passes.turned_by[joint] = angle;
  }
  return passes.turn[joint];
}

template <class T>
void set_frames(const Robot& robot, const DeflectionT<T>& deflection, bool elastic, Passes<T>& passes,
                PostureT<T>& posture) {
  posture.root_from_link[0] = RigidT<T>{};
  RigidT<T> root_from_base;
  if (!is_nothing(deflection.base)) root_from_base.rotation = rotation_from_vector<T>(deflection.base);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const RigidT<T>& parent = joint.parent_link == 0 ? root_from_base : posture.root_from_link[joint.parent_link];
    RigidT<T> frame = parent * passes.parent_from_joint[j];
    posture.root_from_joint[j] = frame;
    if (joint.kind == JointKind::prismatic) {
      frame.translation += frame.rotation * (joint.axis.cast<T>() * posture.value[j]);
    } else if (joint.moves()) {
      frame.rotation = frame.rotation * turned(robot, j, posture.value[j], passes);
    }
    posture.root_from_turned[j] = frame.rotation;
    if (elastic && !is_nothing(deflection.lateral[j]))
      frame.rotation = frame.rotation * rotation_from_vector<T>(deflection.lateral[j]);
    posture.root_from_link[joint.child_link] = frame * passes.bent_from_child[j];
  }
}

template <class T>
Vector3T<T> tilted_gravity(const Vector3& gravity, const RobotChangeT<T>& change) {
  return rotation_from_vector<T>(Vector3T<T>(change.tilt_x, change.tilt_y, T(0.0))) * gravity.cast<T>();
}

/// Distal masses and moments, joints visited from the tips to the root. Returns the moment of the whole robot about
/// the root's origin.
template <class T>
Vector3T<T> set_loads(const Robot& robot, const Vector3T<T>& gravity, const RobotChangeT<T>& change, Passes<T>& passes,
                      PostureT<T>& posture) {
  std::vector<T>& mass = passes.mass;
  std::vector<Vector3T<T>>& first_moment = passes.first_moment;  // mass * centre, root frame
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    mass[l] = T(link.mass);
    Vector3T<T> in_link = link.center_of_mass.template cast<T>() * mass[l];
    if (static_cast<int>(l) == change.payload_link) {
      mass[l] += change.payload_mass;
      in_link += link.center_of_mass.template cast<T>() * change.payload_mass + change.payload_moment;
    }
    const RigidT<T>& root_from_link = posture.root_from_link[l];
    first_moment[l] = root_from_link.rotation * in_link + root_from_link.translation * mass[l];
  }
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    const Joint& joint = robot.joints[j];
    const T distal_mass = mass[joint.child_link];
    const Vector3T<T> distal_moment = first_moment[joint.child_link];
    mass[joint.parent_link] += distal_mass;
    first_moment[joint.parent_link] += distal_moment;
    if (!joint.moves()) continue;
    const Vector3T<T> arm = distal_moment - posture.root_from_joint[j].translation * distal_mass;
    posture.distal_mass[j] = distal_mass;
    posture.distal_center[j] =
        distal_mass > T(0.0) ? Vector3T<T>(distal_moment / distal_mass) : posture.root_from_joint[j].translation;
    posture.moment[j] = arm.cross(gravity);
    const Vector3T<T> axis = posture.root_from_joint[j].rotation * joint.axis.cast<T>();
    posture.torque[j] =
        joint.kind == JointKind::prismatic ? T(axis.dot(gravity) * distal_mass) : T(axis.dot(posture.moment[j]));
  }
  return first_moment[0].cross(gravity);
}

/// The torque that a joint's own spring and gap carry: with a linkage (share), its mimic joints' loads too.
template <class T>
void set_carried_torques(const Robot& robot, const RobotChangeT<T>& change, const PostureT<T>& posture,
                         std::vector<T>& carried) {
  carried = posture.torque;
  if (change.joints.empty()) return;
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    for (const Mimic& m : robot.joints[j].mimics)
      carried[m.joint] +=
          change.joints[j].share * (T(m.multiplier) + change.joints[j].multiplier_error) * posture.torque[j];
}

/// The deflections that these loads make, into Passes::next.
template <class T>
void set_deflections(const Robot& robot, const RobotChangeT<T>& change, const PostureT<T>& posture,
                     const Vector3T<T>& root_moment, Passes<T>& passes) {
  using std::tanh;
  DeflectionT<T>& d = passes.next;
  d.angle.assign(robot.joints.size(), T(0.0));
  d.lateral.assign(robot.joints.size(), Vector3T<T>::Zero());
  set_carried_torques(robot, change, posture, passes.carried);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.moves()) continue;
    const T& carried = passes.carried[j];
    if (joint.stiffness > 0) d.angle[j] = carried / T(joint.stiffness);
    if (change.joints.empty()) continue;
    const JointChangeT<T>& c = change.joints[j];
    d.angle[j] += c.compliance * carried;
    if (magnitude(c.gap) != 0) d.angle[j] += c.gap * tanh(carried / T(backlash_torque));
    if (magnitude(c.lateral_compliance) == 0) continue;
    const Vector3T<T> axis = joint.axis.cast<T>();
    const Vector3T<T> moment = posture.root_from_turned[j].transpose() * posture.moment[j];
    d.lateral[j] = (moment - axis * axis.dot(moment)) * c.lateral_compliance;
  }
  const Vector3T<T>& b = change.base_compliance;
  d.base = Vector3T<T>(b.x() * root_moment.x() + b.y() * root_moment.y(),
                       b.y() * root_moment.x() + b.z() * root_moment.y(), T(0.0));
}

template <class T>
double largest_change(const DeflectionT<T>& a, const DeflectionT<T>& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.angle.size(); ++j) {
    largest = std::max(largest, magnitude(T(a.angle[j] - b.angle[j])));
    for (int k = 0; k < 3; ++k) largest = std::max(largest, magnitude(T(a.lateral[j][k] - b.lateral[j][k])));
  }
  for (int k = 0; k < 3; ++k) largest = std::max(largest, magnitude(T(a.base[k] - b.base[k])));
  return largest;
}

template <class T>
bool is_elastic(const Robot& robot, const RobotChangeT<T>& change) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (robot.joints[j].stiffness > 0) return true;
    if (change.joints.empty()) continue;
    const JointChangeT<T>& c = change.joints[j];
    if (magnitude(c.compliance) > 0 || magnitude(c.lateral_compliance) > 0 || magnitude(c.gap) > 0) return true;
  }
  for (int k = 0; k < 3; ++k)
    if (magnitude(change.base_compliance[k]) > 0) return true;
  return false;
}

}  // namespace posture_detail

/// The posture for sensor values (one per joint of the robot; those of fixed and mimic joints are not read) under
/// gravity (m/s^2, root frame). Deflection changes the load: iterated until nothing moves by more than 1e-11 rad, so
/// that what is left is below 1e-9 rad for springs that give way by less than 99 % of what would be unstable;
/// `converged` is false for softer ones. With `with_loads` false, loads are only computed where springs need them. A
/// `start` near the answer, such as the deflection before a small change, saves passes.
template <class T>
PostureT<T> solve_posture(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChangeT<T>& change,
                          const Vector3& gravity, bool with_loads = true, const DeflectionT<T>* start = nullptr) {
  namespace detail = posture_detail;
  const std::size_t joints = robot.joints.size();
  check(static_cast<std::size_t>(sensor.size()) == joints, "{} joint values for a robot of {} joints", sensor.size(),
        joints);
  PostureT<T> posture;
  posture.root_from_link.resize(robot.links.size());
  posture.root_from_joint.resize(joints);
  posture.root_from_turned.resize(joints);
  posture.value.assign(joints, T(0.0));
  posture.torque.assign(joints, T(0.0));
  posture.moment.assign(joints, Vector3T<T>::Zero());
  posture.distal_mass.assign(joints, T(0.0));
  posture.distal_center.assign(joints, Vector3T<T>::Zero());

  const bool elastic = detail::is_elastic(robot, change);
  const Vector3T<T> gravity_in_root = detail::tilted_gravity(gravity, change);
  DeflectionT<T>& deflection = posture.deflection;
  deflection.angle.assign(joints, T(0.0));
  deflection.lateral.assign(joints, Vector3T<T>::Zero());
  if (elastic && start && start->angle.size() == joints) deflection = *start;
  detail::Passes<T> passes(robot, change);
  constexpr int most_passes = 500;
  for (posture.iterations = 0; posture.iterations <= most_passes; ++posture.iterations) {
    detail::set_values(robot, sensor, change, deflection, passes, posture);
    detail::set_frames(robot, deflection, elastic, passes, posture);
    if (!elastic && !with_loads) return posture;
    const Vector3T<T> root_moment = detail::set_loads(robot, gravity_in_root, change, passes, posture);
    if (!elastic) return posture;
    detail::set_deflections(robot, change, posture, root_moment, passes);
    const double step = detail::largest_change(passes.next, deflection);
    if (step < 1e-11) return posture;
    if (!(step < 10)) break;  // unstable: springs too soft for the load
    std::swap(deflection, passes.next);
  }
  posture.converged = false;
  return posture;
}

/// The nominal robot, with its declared stiffness.
Posture solve_posture(const Robot& robot, const Eigen::VectorXd& sensor, const Vector3& gravity);

/// Values for all joints of the robot from those of `joints` (indices, in the order of `position`); others stand at
/// 0, mimic joints are at the sum of what they mimic.
Eigen::VectorXd joint_values(const Robot& robot, const std::vector<int>& joints, const Eigen::VectorXd& position);

}  // namespace handsight
