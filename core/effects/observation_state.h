// SPDX-License-Identifier: Apache-2.0
// What is known of an observation before any effect: angles, velocities, directions of approach, time.
#pragma once

#include <optional>
#include <vector>

#include "chain/chain.h"

namespace handsight {

struct ObservationState {
  const Chain* chain = nullptr;
  Eigen::VectorXd sensor;    // rad (m), per joint of the robot: readings; mimic joints at the sum of what they follow
  Eigen::VectorXd velocity;  // rad/s, per joint of the robot; 0 where not measured
  Eigen::VectorXd
      approach;            // per joint: the sign of its last motion, of `velocity`, else against the observation before
  Eigen::VectorXd torque;  // N m (N), per joint: of gravity, the nominal robot's; empty: not worked out
  std::optional<Vector3>
      tcp;              // m: the TCP in the frame of the sensor's link, the nominal robot's; absent: not worked out
  double elapsed = 0;   // s since the first observation
  double duration = 0;  // s from the first observation to the last
  int order = 0;        // observations counted from 0 in order of time; not the id
};

/// For every observation of the session, in the session's order; `chain` must outlive them. Order, approach and time
/// count all observations, used or not.
std::vector<ObservationState> observation_states(const Session& session, const Chain& chain);

/// For a pose outside any session: at rest, approached from nowhere, at the session's end where things drift.
ObservationState states_at(const Chain& chain, const Eigen::VectorXd& position);

/// Gravity torques of the nominal robot, per joint of the robot, at these sensor values (its springs included).
Eigen::VectorXd nominal_torques(const Chain& chain, const Eigen::VectorXd& sensor);

/// The TCP's place in the frame of the link that carries the sensor, of the nominal robot (its springs included), m.
Vector3 nominal_tcp(const Chain& chain, const Eigen::VectorXd& sensor);

/// A pose outside any session with what is known of how the robot comes there.
struct DrivenPose {
  Eigen::VectorXd position;    // rad or m, in the order of Chain::joints
  Eigen::VectorXd velocity;    // rad/s or m/s; empty: not known
  std::optional<double> time;  // s on the session's clock; absent: after the session
};

/// The times of all observations, ascending.
std::vector<double> list_times(const Session& session);

/// For poses driven to one after another. The approach is the sign of the velocity, where that is not known or 0 the
/// way from the pose before, at the first from nowhere. Where a pose has a time and `times` are those of the session,
/// what drifts and slips is where it was then: a slip has come once the first observation after it has been made.
std::vector<ObservationState> states_at(const Chain& chain, const std::vector<DrivenPose>& poses,
                                        const std::vector<double>& times = {});

/// The chain's ends in one observation with all sites moved: joints, mount and drift (the mount's own motion is part of
/// root_from_mount's end: see sensor_motion).
struct ObservedEnds {
  ChainEnds ends;
  Rigid mount_motion;  // mount_from_sensor * mount_motion is where the sensor truly sits: exp(mount) exp(drift)
};
ObservedEnds observed_ends(const ObservationState& states, const Sites& sites);

/// The rig with its own sites moved.
Rig moved_rig(const Rig& rig, const Sites& sites);

}  // namespace handsight
