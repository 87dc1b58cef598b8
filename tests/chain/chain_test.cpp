// SPDX-License-Identifier: Apache-2.0
#include "chain/chain.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

TEST(Chain, FramesCancel) {
  const Session session = fixture::stand_session();
  const Chain chain = make_chain(session);
  Eigen::VectorXd position(6);
  position << 0.3, 0.8, -0.7, 0.4, 0.9, -0.2;
  const ChainEnds ends = chain_ends(chain, position);
  const Rigid left_from_tcp = sensor_from_tcp(ends, session.mount.mount_from_sensor);
  const Vector3 x(0.01, 0.02, 0.03);
  const Vector3 in_root = ends.root_from_tcp * x;
  EXPECT_LT((ends.root_from_mount * (session.mount.mount_from_sensor * (left_from_tcp * x)) - in_root).norm(), 1e-14);
}

TEST(Chain, AMountOnTheRootDoesNotTurnWithItsSpring) {
  const Session session = fixture::stand_session();
  const Chain chain = make_chain(session);
  Sites sites;
  sites.robot.base_compliance = Vector3(3e-5, 0, 3e-5);
  Eigen::VectorXd position = Eigen::VectorXd::Zero(6);
  position[1] = 1.2;  // leaning forward: the robot tips over its foot
  const ChainEnds nominal = chain_ends(chain, position), bent = chain_ends(chain, position, sites);
  EXPECT_EQ(bent.root_from_mount.translation, nominal.root_from_mount.translation);
  EXPECT_LT(bent.root_from_tcp.translation.z(), nominal.root_from_tcp.translation.z() - 1e-4);
}

TEST(Chain, JointsThatAreNotNamedStandAtZero) {
  Session session = fixture::stand_session();
  session.joints = {"a2"};
  const Chain chain = make_chain(session);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(6);
  all[1] = 0.7;
  const Rigid named = chain_ends(chain, Eigen::VectorXd::Constant(1, 0.7)).root_from_tcp;
  const Rigid whole = chain_ends(make_chain(fixture::stand_session()), all).root_from_tcp;
  EXPECT_EQ(named.translation, whole.translation);
}

TEST(Chain, SaysWhichNameIsNotInTheRobot) {
  for (const std::string part : {"tcp", "mount", "joint"}) {
    Session session = fixture::stand_session();
    if (part == "tcp") session.tcp = "gripper";
    if (part == "mount") session.mount.link = "gripper";
    if (part == "joint") session.joints[2] = "gripper";
    try {
      make_chain(session);
      ADD_FAILURE() << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("\"gripper\""), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace handsight
