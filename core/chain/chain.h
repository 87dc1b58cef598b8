// SPDX-License-Identifier: Apache-2.0
// The measurement chain of a session, names resolved to indices once:
//   sensor_from_tcp = mount_from_sensor^-1 * root_from_mount(q~)^-1 * root_from_tcp(q~)
// where the sensor is the first camera or the tracker.
#pragma once

#include <vector>

#include "chain/sites.h"
#include "session/session.h"

namespace handsight {

struct Chain {
  Robot robot;
  Vector3 gravity = Vector3::Zero();  // m/s^2, root frame
  int tcp_link = 0;
  int mount_link = 0;
  std::vector<int> joints;  // indices into robot.joints, in the order of Observation::position
  std::optional<Rig> rig;   // absent: a tracker
  int marker_count = 0;
  bool is_one_target = false;         // the markers are points of a target: none slips by itself
  int part = 0, mount = 0, body = 0;  // of the chain of a part of a joined session: which of its parts, mounts, bodies
  int first_marker = 0;               // of that part's body
  std::vector<std::string> own = {};  // SessionPart::own
  bool is_touch = false;              // the parts are fixtures that are touched in one session
  bool is_fixture = false;            // of a part: it is one of them, there or among sessions of other kinds
  std::vector<Chain> parts = {};      // of a joined session: the chains of its parts
  std::vector<std::string> part_names = {};  // and what they are called
  std::vector<int> first_cameras = {};       // of each of their rigs, in `rig`
};

/// Of a joined session that of its first part, with those of all parts in it. Throws InputError where a name of the
/// session is not in its robot.
Chain make_chain(const Session& session);

/// The two ends of the chain in one posture.
struct ChainEnds {
  Rigid root_from_tcp;
  Rigid root_from_mount;
  bool converged = true;  // of the static equilibrium
};

/// The chain's ends for joint sensor values in the order of Chain::joints. A mount on the root link stands on the
/// floor: the root's own spring does not turn it.
ChainEnds chain_ends(const Chain& chain, const Eigen::VectorXd& position, const Sites& sites = {});

/// sensor_from_tcp of the ends and a mount.
inline Rigid sensor_from_tcp(const ChainEnds& ends, const Rigid& mount_from_sensor) {
  return inverse(ends.root_from_mount * mount_from_sensor) * ends.root_from_tcp;
}

}  // namespace handsight
