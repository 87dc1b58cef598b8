// SPDX-License-Identifier: Apache-2.0
#include "chain/chain.h"

#include <algorithm>

#include "robot/posture_memory.h"

namespace handsight {
namespace {

int link_named(const Session& session, const std::string& name, const char* what) {
  const int link = find_link(session.robot, name);
  if (link < 0)
    throw InputError(message("{}: the {} link \"{}\" is not in the robot {}; name one of its links.",
                             session.file.filename().string(), what, name, session.robot_file));
  return link;
}

/// The chains of a joined session's parts: they differ in their two ends.
void add_parts(const Session& session, Chain& chain) {
  std::vector<Chain> parts;
  for (std::size_t p = 0; p < session.parts.size(); ++p) {
    const SessionPart& part = session.parts[p];
    const Mount& mount =
        part.mount == 0 ? session.mount : session.other_mounts[static_cast<std::size_t>(part.mount - 1)];
    Chain& one = parts.emplace_back(chain);
    one.part = static_cast<int>(p);
    one.mount = part.mount;
    one.body = part.body;
    one.first_marker = part.first_marker;
    one.own = part.own;
    one.is_fixture = part.fixture >= 0;
    one.tcp_link = link_named(session, part.tcp, "tcp");
    one.mount_link = link_named(session, mount.link, "mount");
    chain.part_names.push_back(part.title);
    const auto& firsts = chain.first_cameras;
    const bool is_known = std::find(firsts.begin(), firsts.end(), part.first_camera) != firsts.end();
    if (part.camera_count > 0 && !is_known) chain.first_cameras.push_back(part.first_camera);
  }
  chain.parts = std::move(parts);
}

}  // namespace

Chain make_chain(const Session& session) {
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
      throw InputError(message("{}: the joint \"{}\" named in <joints> is not in the robot {}.",
                               session.file.filename().string(), name, session.robot_file));
    chain.joints.push_back(joint);
  }
  chain.is_touch = session.is_touch();
  add_parts(session, chain);
  return chain;
}

ChainEnds chain_ends(const Chain& chain, const Eigen::VectorXd& position, const Sites& sites) {
  const Eigen::VectorXd sensor = joint_values(chain.robot, chain.joints, position);
  const Posture posture = solve_equilibrium(chain.robot, sensor, sites.robot, chain.gravity, false);
  return {posture.root_from_link[chain.tcp_link], posture.root_from_link[chain.mount_link], posture.converged};
}

}  // namespace handsight
