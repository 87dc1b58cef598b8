// SPDX-License-Identifier: Apache-2.0
#include "chain/chain.h"

namespace handsight {
namespace {

int link_named(const Session& session, const std::string& name, const char* what) {
  const int link = find_link(session.robot, name);
  if (link < 0)
    throw InputError(fmt::format("{}: the {} link \"{}\" is not in the robot {}; name one of its links.",
                                 session.file.filename().string(), what, name, session.robot_file));
  return link;
}

}  // namespace

Chain chain_of(const Session& session) {
  Chain chain;
  chain.robot = session.robot;
  chain.gravity = session.gravity;
  chain.tcp_link = link_named(session, session.tcp, "tcp");
  chain.mount_link = link_named(session, session.mount.link, "mount");
  chain.rig = session.rig;
  chain.marker_count = session.marker_count;
  chain.is_one_target = session.pose_sensor || session.target;
  for (const std::string& name : session.joints) {
    const int joint = find_joint(session.robot, name);
    if (joint < 0)
      throw InputError(fmt::format("{}: the joint \"{}\" named in <joints> is not in the robot {}.",
                                   session.file.filename().string(), name, session.robot_file));
    chain.joints.push_back(joint);
  }
  return chain;
}

ChainEnds chain_ends(const Chain& chain, const Eigen::VectorXd& position, const Sites& sites) {
  const Eigen::VectorXd sensor = joint_values(chain.robot, chain.joints, position);
  const Posture posture = solve_posture<double>(chain.robot, sensor, sites.robot, chain.gravity, false);
  return {posture.root_from_link[chain.tcp_link], posture.root_from_link[chain.mount_link], posture.converged};
}

}  // namespace handsight
