// SPDX-License-Identifier: Apache-2.0
// A joined session's fit, part by part: where it starts, and what it says of each part's body and mount.
#pragma once

#include <functional>

#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// Markers and mounts of a joined session from fits of its parts by themselves (`fit_alone`, a plain one); of a mount
/// or body that parts share from the first of them. The effects are the problem's own. InputError of a part that cannot
/// be fitted names it.
Unknowns start_of_parts(const Session& joined, const Problem& problem,
                        const std::function<Fit(const Session& part)>& fit_alone);

/// What a fit says of one part of a joined session.
struct FitPart {
  Rigid tcp_from_body;
  Matrix6 covariance = Matrix6::Zero();  // of xi in exp(xi) tcp_from_body
  bool rotation_is_observed = true;
  std::vector<Vector3> markers_in_body;  // m, of its body
  Rigid mount_from_sensor;
  std::optional<Matrix6> mount_covariance;  // of v in mount_from_sensor exp(v); absent: the mount is held
  bool place_is_determined = true;          // false of a fixture where no touch tells a number of its place
};

/// Part by part; empty where the session is none of several.
std::vector<FitPart> list_parts(const Session& session, const Fit& fit);

/// The frames in which slips of each body are measured, by the unknowns' markers: true where one has moved.
bool set_slip_frames(Problem& problem, const std::vector<Vector3>& markers_in_tcp);

/// The sides of a body (of the first one, where the session is none of several): as its shape is described where it is
/// one piece, else by the markers that were seen, as they are estimated.
BodySides sides_of_body(const Problem& problem, const std::vector<Vector3>& markers_in_tcp, int body);

}  // namespace handsight
