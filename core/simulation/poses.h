// SPDX-License-Identifier: Apache-2.0
// Postures in which the sensor sees the whole marker body.
#pragma once

#include <optional>
#include <vector>

#include "session/session.h"
#include "simulation/random.h"
#include "simulation/simulation_options.h"

namespace handsight {

/// The marker body that poses must show to the sensor.
struct ShownBody {
  std::vector<Vector3> markers_in_tcp;
  Vector3 normal_in_tcp = Vector3::UnitZ();
  std::vector<Vector3> normals_in_tcp = {};  // by marker, where they differ: one face of the body is enough
};

/// The outward normal at a marker.
inline const Vector3& normal_at(const ShownBody& body, std::size_t marker) {
  return body.normals_in_tcp.empty() ? body.normal_in_tcp : body.normals_in_tcp[marker];
}

/// What poses of a joint are drawn from, rad (m).
struct JointSpan {
  double lower, upper;
};

/// What `like` took of the joint in its column, where it took much of it; else a share of its limits, or of a turn. Of
/// a sliding joint without limits, such as a flange's coordinate, what was taken and 100 mm about it at least.
JointSpan joint_span(const Session& like, const Joint& joint, Eigen::Index column, double share);

/// Joint positions in the order of the chain, each showing every marker to the cameras (of more than two to any two),
/// of a body of tags all of one face (in a tracker session: any pose). Drawn from a share of the limits, or from the
/// span of `like`'s observations. Throws InputError where 500 searches in a row find none.
class PoseSampler {
 public:
  PoseSampler(const Session& like, const Chain& chain, const ShownBody& body, const SimulationOptions& options);
  Eigen::VectorXd next(Random& random);

 private:
  double violation(const Eigen::VectorXd& position) const;
  double unseen(const Rigid& first_from_tcp, std::size_t marker) const;
  double unseen(const Camera& camera, const Vector3& x, const Vector3& normal) const;
  Eigen::VectorXd drawn(Random& random) const;
  Eigen::VectorXd moved(const Eigen::VectorXd& from, double share, Random& random) const;
  std::optional<Eigen::VectorXd> made_visible(Eigen::VectorXd position, Random& random) const;

  const Chain& chain_;
  const ShownBody& body_;
  const SimulationOptions& options_;
  Rigid mount_from_sensor_;
  Eigen::VectorXd lower_, upper_, last_;
};

}  // namespace handsight
