// SPDX-License-Identifier: Apache-2.0
// What a fit works on: the used observations in order of time, with both ends of their chains, and the normal
// equations of all of them by the markers' positions in the TCP frame and the mount.
#pragma once

#include <span>
#include <vector>

#include "effects/effect.h"
#include "model/sighting.h"

namespace handsight {

struct ProblemObservation {
  int index = 0;  // into Session::observations
  Rigid root_from_tcp;
  Rigid root_from_mount;
  std::vector<Sighting> sightings;
  std::vector<Matrix3> point_covariances;  // per sighting, only where points stand in for images: per unit px^2, m^2
  std::vector<double> weights;             // per sighting; empty: all 1
  bool springs_hold = true;                // false: the declared springs are too soft for the load
};

/// The whole chain of an observation for a mount of the sensor.
inline Rigid sensor_from_tcp_at(const ProblemObservation& o, const Rigid& mount_from_sensor) {
  return inverse(o.root_from_mount * mount_from_sensor) * o.root_from_tcp;
}

struct Problem {
  std::vector<ProblemObservation> observations;
  std::optional<StereoRig> rig;  // absent: sightings are points
  int marker_count = 0;
  bool mount_is_estimated = false;
  std::vector<char> marker_is_seen;  // per marker, in any used observation

  const StereoRig* rig_or_null() const { return rig ? &*rig : nullptr; }
  /// Columns of the normal equations: 3 a marker, then 6 for the mount where it is estimated.
  Eigen::Index columns() const { return 3 * marker_count + (mount_is_estimated ? 6 : 0); }
};

/// The used observations of a session, `terms` moving the chain's ends. In order of time (then id), whatever the
/// order in memory.
Problem make_problem(const Session& session, const Chain& chain, const std::vector<EffectTerm>& terms = {});

/// The same with every marker that both cameras saw as a triangulated point, for the 3D objective (thesis 4.41).
/// Markers seen by one camera only cannot take part: `left_out` counts them.
Problem as_points(const Problem& problem, int& left_out);

/// The unknowns: markers in the TCP frame (m), and the mount.
struct Unknowns {
  std::vector<Vector3> markers_in_tcp;
  Rigid mount_from_sensor;
};

/// Applies a step: markers move by their three numbers (m, TCP frame), the mount by mount_from_sensor * exp(v).
Unknowns moved(const Unknowns& unknowns, const Eigen::VectorXd& step, bool mount_is_estimated);

/// H = J^T W J, gradient = J^T W error by the problem's columns; cost = error^T W error.
struct NormalEquations {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double cost = 0;
  int rows = 0;
  bool in_front = true;

  explicit NormalEquations(Eigen::Index columns = 0)
      : information(Eigen::MatrixXd::Zero(columns, columns)), gradient(Eigen::VectorXd::Zero(columns)) {}
};

/// Adds one observation's normal equations at these unknowns. Only the lower triangle of marker-marker and
/// mount-mount blocks and the mount-marker block are written; `complete` fills the rest.
void add_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                     NormalEquations& normal);

/// Mirrors the lower triangle of the information matrix.
void complete(NormalEquations& normal);

/// The normal equations of the observations at these places of Problem::observations; all where empty.
NormalEquations normal_equations(const Problem& problem, const Unknowns& unknowns, std::span<const int> places = {});

}  // namespace handsight
