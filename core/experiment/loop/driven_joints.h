// SPDX-License-Identifier: Apache-2.0
// The session's joints as a driver moves them: their order, and whether they are where they were sent.
#pragma once

#include "chain/chain.h"
#include "experiment/driver/driven_robot.h"

namespace handsight {

/// Where each joint of the session stands in what the driver sends and is sent.
struct JointOrder {
  std::vector<Eigen::Index> place_in_driver;

  Eigen::VectorXd to_session(const Eigen::VectorXd& of_driver) const;
  Eigen::VectorXd to_driver(const Eigen::VectorXd& of_session) const;
};

/// DriverFault where the driver does not move exactly the session's joints.
JointOrder joint_order(const Session& session, const DriverHello& hello);

/// DriverFault that names the first joint that stands more than 1 degree (10 mm) from where it was sent; both in the
/// order of `joints`, the session's.
void require_arrival(const Chain& chain, const std::vector<std::string>& joints, const Eigen::VectorXd& sent,
                     const Eigen::VectorXd& position);

}  // namespace handsight
